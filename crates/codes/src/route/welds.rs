//! Fillet welds under their lines of force.

use super::evidence::Evidence;
use super::facts::RouteFacts;
use super::step::{RouteStep, RouteUse, StepId, StepState};
use crate::eurocode::welds::{PairForce, directional_pair};
use crate::unit::Unit;
use bracket_base::say;

const SOURCE: &str = "EN 1993-1-8:2005 4.5.3.2, 4.9";

/// The step: every weld by the directional method, with the forces of short lengths.
pub(super) fn welds(facts: &RouteFacts, evidence: &Evidence, copies: usize) -> RouteStep {
    let mut uses = Vec::new();
    for weld in &facts.welds {
        // the welds beyond a plane of symmetry are those before it
        let Some(found) = evidence.welds.iter().find(|w| w.weld == weld.name) else { continue };
        for s in &found.segments {
            let [normal, across, along, couple] = [s.normal, s.across, s.along, s.couple];
            // one weld round a hollow section carries what a pair of welds does on a plate; its
            // eccentricity need not be considered (4.12(3))
            let force = match weld.closed {
                true => PairForce {
                    normal: 2.0 * normal,
                    across: 2.0 * across,
                    along: 2.0 * along,
                    couple: 0.0,
                },
                false => PairForce { normal, across, along, couple },
            };
            let [from, to] = s.from_to.map(|x| Unit::Length.show(x));
            uses.push(RouteUse {
                what: say!("{}, from {} to {} along it", &weld.name, from, to),
                value: directional_pair(&force, weld.thickness, weld.throat, &weld.steel).value,
                spread: None,
                limit: 1.0,
                unit: Unit::Number,
                source: SOURCE.into(),
            });
        }
    }
    let known = evidence.welds.iter().filter(|w| !w.segments.is_empty()).count();
    // every copy of the meshed part has the same welds
    if copies * known < facts.welds.len() {
        let (finding, next) = ("the forces of the welds are not known", "more time (`time_limit`)");
        return RouteStep::open(StepId::Welds, finding.into(), SOURCE, next);
    }
    if uses.is_empty() {
        let finding =
            "there is no fillet weld: the parts are joined by butt welds of full strength";
        return RouteStep::proved(StepId::Welds, finding.into(), SOURCE);
    }
    let next = "thicker welds, or butt welds";
    RouteStep::of_uses(StepId::Welds, StepState::Estimated, uses, SOURCE, next)
}
