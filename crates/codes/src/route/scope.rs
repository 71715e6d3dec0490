//! Steels, bolts and holes within the range of the rules.

use super::facts::RouteFacts;
use super::step::{RouteStep, StepId};
use crate::eurocode::bolts::is_listed;
use crate::eurocode::holes::Clearance;
use crate::eurocode::yielding::STRONGEST;
use bracket_base::say;

const SOURCE: &str = "EN 1993-1-1:2005 3.2.2, EN 1993-1-8:2005 1.1, Table 3.1";
/// Least f_u/f_y, EN 1993-1-1:2005 3.2.2(1).
const LEAST_RATIO: f64 = 1.10;

/// The step: every steel is at most S460 and hardens, every bolt is of Table 3.1, every hole has a
/// bearing resistance on every ply.
pub(super) fn scope(facts: &RouteFacts) -> RouteStep {
    let open = |finding, next: &'static str| RouteStep::open(StepId::Scope, finding, SOURCE, next);
    for (name, [fy, fu]) in &facts.steels {
        if fy.mpa() > STRONGEST {
            return open(say!("{} is above S460", name.clone()), "a steel up to S460");
        }
        if fu.mpa() < LEAST_RATIO * fy.mpa() {
            let finding = say!("f_u of {} is less than 1.10 f_y", name.clone());
            return open(finding, "a steel with f_u ≥ 1.10 f_y");
        }
    }
    for (grip, limits) in &facts.bolts {
        if !is_listed(&grip.grade) {
            let finding = say!("the bolt grade {} is not in Table 3.1", &grip.grade.grade);
            return open(finding, "a grade of Table 3.1");
        }
        if Clearance::of(&grip.size, grip.hole) == Clearance::Beyond {
            let finding = say!("the hole of {} is wider than an oversize hole", &grip.part);
            return open(finding, "a hole of at most that size (`parameters.hole_clearance`)");
        }
        let without = grip.plies.iter().zip(&limits.bearing).find(|(_, b)| b.is_none());
        if let Some((ply, _)) = without {
            let finding = say!("{} has no bearing resistance on {}", &grip.part, &ply.part);
            return open(finding, "a bolt through a plate, a flange or a web");
        }
    }
    let finding = "steels up to S460 that harden, bolts of Table 3.1, holes of EN 1090-2";
    RouteStep::proved(StepId::Scope, finding.into(), SOURCE)
}
