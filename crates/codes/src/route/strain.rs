//! Strain of the plates.

use super::evidence::Evidence;
use super::step::{RouteStep, RouteUse, StepId, StepState};
use crate::unit::Unit;
use bracket_base::say;

const SOURCE: &str = "EN 1993-1-5:2006 Annex C.8, Note 1";
/// Largest principal membrane strain, a fraction.
pub const LARGEST_STRAIN: f64 = 0.05;
/// Largest difference between the last two meshes, a fraction.
const SPREAD: f64 = 0.01;
const NARROW: &str = "a second, finer mesh (`max_passes`, `time_limit`)";

/// The step: the largest mean membrane strain of every plate on the last mesh, with its difference
/// from the mesh before.
pub(super) fn strain(meshes: &[Evidence]) -> RouteStep {
    let open = |finding| RouteStep::open(StepId::Strain, finding, SOURCE, NARROW);
    let pair = match meshes {
        [.., before, last] if before.tets < last.tets => Some((before, last)),
        _ => None,
    };
    let Some((before, last)) = pair else {
        return open("strains of one mesh alone are no evidence".into());
    };
    if last.plates.is_empty() {
        return open("the strains are not known".into());
    }
    let uses = last.plates.iter().map(|p| {
        let same = |q: &&super::PlateStrain| q.part == p.part && q.thickness == p.thickness;
        // the largest of the plates that share part and thickness: the flanges of a profile
        let earlier = before.plates.iter().filter(same).map(|q| q.membrane).reduce(f64::max);
        let now = last.plates.iter().filter(same).map(|q| q.membrane).fold(0.0, f64::max);
        let spread = earlier.map_or(f64::NAN, |e| (now - e).abs());
        RouteUse {
            what: say!("membrane strain of {}", &p.part),
            value: p.membrane + spread,
            spread: Some(spread),
            limit: LARGEST_STRAIN,
            unit: Unit::Number,
            source: SOURCE.into(),
        }
    });
    let uses: Vec<RouteUse> = uses.collect();
    let widest = uses.iter().filter_map(|u| u.spread).fold(0.0, f64::max);
    let next = "a thicker part, or less load";
    let step = RouteStep::of_uses(StepId::Strain, StepState::Estimated, uses, SOURCE, next);
    if step.holds() && widest > SPREAD {
        let finding = say!("the last two meshes differ by a strain of {} %", percent(widest));
        return step.left_open(finding, NARROW);
    }
    step
}

fn percent(x: f64) -> String {
    format!("{:.2}", 100.0 * x)
}
