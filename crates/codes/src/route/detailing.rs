//! Distances of the holes from edges and from each other.

use super::facts::RouteFacts;
use super::step::{RouteStep, RouteUse, StepId, StepState};
use crate::unit::Unit;
use bracket_base::say;

const SOURCE: &str = "EN 1993-1-8:2005 Table 3.3";
/// Least e1 and e2 over d0.
const EDGE: f64 = 1.2;
/// Least pitch over d0: the larger one, across the force, because a force may have any direction.
const PITCH: f64 = 2.4;

/// The step: of every ply the least distance to an edge, and to another hole.
pub(super) fn detailing(facts: &RouteFacts) -> RouteStep {
    let mut uses = Vec::new();
    for (grip, _) in &facts.bolts {
        for ply in &grip.plies {
            let Some(room) = ply.room else { continue };
            let least = |x: [[f64; 2]; 2]| x.into_iter().flatten().fold(f64::INFINITY, f64::min);
            let (bolt, part) = (&grip.part, &ply.part);
            let edge = say!("edge of {} beside {}", part, bolt);
            let pitch = say!("pitch of the holes of {} at {}", part, bolt);
            for (what, factor, provided) in
                [(edge, EDGE, least(room.edge)), (pitch, PITCH, least(room.pitch))]
            {
                if provided.is_finite() {
                    // the distance that is needed against the one that is there
                    let (value, limit) = (factor * grip.hole, provided);
                    let source = SOURCE.into();
                    uses.push(RouteUse {
                        what,
                        value,
                        spread: None,
                        limit,
                        unit: Unit::Length,
                        source,
                    });
                }
            }
        }
    }
    let next = "larger distances between holes and edges";
    RouteStep::of_uses(StepId::Detailing, StepState::Proved, uses, SOURCE, next)
}
