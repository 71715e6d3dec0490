//! Transformation parameter β of a member end.

use bracket_joint::assembly::{EndPlate, PlaneActions};

/// Steps of β in 1: what is less is rounding of the moments.
const STEPS: f64 = 1e9;

/// Transformation parameter β of a member end: `|1 − M_j,b2/M_j,b1| ≤ 2` with the moments at the
/// node, that of the other beam in the numerator; 1 where no other beam acts, 0 in a splice.
///
/// # Source
/// EN 1993-1-8:2005 5.3(8), formulas 5.4a and 5.4b. Moments are in the members' own axes, so that
/// equal moments of two beams balance.
pub(super) fn beta(e: &EndPlate, a: &PlaneActions) -> f64 {
    if e.column.is_none() {
        return 0.0;
    }
    let other: f64 = other_ends(e, a).map(PlaneActions::moment_at_node).sum();
    let own = a.moment_at_node();
    match (own, other) {
        (_, 0.0) => 1.0,
        (0.0, _) => 2.0,
        // equal moments balance, whatever unit each was given in
        _ => ((1.0 - other / own).abs().min(2.0) * STEPS).round() / STEPS,
    }
}

/// Actions of the same load case at the other member ends.
pub(super) fn other_ends<'a>(
    e: &'a EndPlate,
    a: &'a PlaneActions,
) -> impl Iterator<Item = &'a PlaneActions> {
    e.actions.iter().filter(|o| o.case == a.case && o.end != a.end)
}
