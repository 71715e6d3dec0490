//! What the anchors need of the concrete: the matter of EN 1992-4.

use super::case_end::at;
use crate::check::{Check, CheckId, Topic, Unit};
use crate::subject::Part;
use bracket_base::say;
use bracket_joint::assembly::{ColumnBase, PlaneActions};

/// The forces of an anchor that its anchorage must carry, tension and shear \[N\]; `None` where the
/// anchors carry nothing. It leaves the case undecided until the engineer has checked it.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.12: bond, cone, pull-out, splitting and edge of EN 1992-4 are not in
/// these checks.
pub(super) fn check(e: &ColumnBase, a: &PlaneActions, forces: [f64; 2]) -> Option<Check> {
    if forces.iter().all(|f| *f == 0.0) {
        return None;
    }
    let shown = |force: f64| match force.is_finite() {
        true => Unit::Force.show(force),
        false => "?".to_owned(),
    };
    let why = say!(
        "an anchor brings N_Ed = {} and V_Ed = {} into the concrete: bond, pull-out, concrete \
         cone, splitting and concrete edge are not covered",
        shown(forces[0]),
        shown(forces[1])
    );
    let (topic, clause, id) = (Topic::Bolts, "EN 1992-4:2018", CheckId::Anchorage);
    let subject = at(a).and(Part::Anchors);
    if e.anchorage_checked && forces.iter().all(|f| f.is_finite()) {
        return Some(Check::assumption(topic, subject, clause, id, why));
    }
    let step = "a check of the anchorage by EN 1992-4, and `anchorage_checked` true";
    Some(Check::undecided(topic, subject, clause, id, why, step))
}
