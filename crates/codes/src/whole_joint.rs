//! The checks and design strengths of a whole joint.

use super::check::{Check, Topic};
use super::column_base::{base_checks, ground_stiffness};
use super::cover_splice::splice_checks;
use super::end_plate::{HandChecks, hand_checks};
use super::simple_joint::simple_checks;
use super::worked::Worked;
use crate::check::{CheckId, Status, Unit};
use crate::design_code::DesignCode;
use crate::formula::Traced;
use crate::subject::Part;
use bracket_joint::assembly::{Facts, Idle, Joint};
use bracket_joint::strength::DesignStrengths;

/// The hand checks of a joint, with those of the load cases in which nothing acts.
pub fn joint_checks(joint: &Joint) -> HandChecks {
    let of_code = match DesignCode::of(joint) {
        DesignCode::En1993_2005(_) => of_family,
    };
    let mut out = joint.facts.as_ref().map(of_code).unwrap_or_default();
    let demands = || joint.idle.iter().filter(|i| i.demand);
    out.checks.extend(demands().map(nothing_acts));
    out.checks.sort_by_key(|c| c.topic);
    let service = demands().filter(|i| !i.state.is_ultimate());
    out.serviceability.extend(service.map(|i| i.case.clone()));
    out.neglected.clone_from(&joint.neglected);
    out
}

/// Design strengths of a joint by the code by which it was built, with the stiffness of the ground
/// under a column base.
pub fn design_strengths(joint: &Joint) -> DesignStrengths {
    let mut strengths = DesignCode::of(joint).strengths(&joint.assembly);
    if let Some(Facts::ColumnBase(base)) = &joint.facts {
        let stiffness = (!base.foundation.rigid).then(|| ground_stiffness(base));
        strengths.ground.values_mut().for_each(|bearing| bearing.stiffness = stiffness);
    }
    strengths
}

/// The hand checks of a family of connections by EN 1993.
fn of_family(facts: &Facts) -> HandChecks {
    match facts {
        Facts::EndPlate(e) => hand_checks(e),
        Facts::Simple(e) => simple_checks(e),
        Facts::CoverSplice(e) => splice_checks(e),
        Facts::ColumnBase(e) => base_checks(e),
    }
}

/// The check of a load case in which nothing acts. It always holds.
fn nothing_acts(idle: &Idle) -> Check {
    let (clause, used) = ("EN 1990:2002 6.4.2(3)", Traced::from(0.0));
    Worked::of(clause, CheckId::NothingActs, "E_d/R_d", used, Unit::Number)
        .after("every action at the member ends is zero or neglected")
        .utilised(Topic::Member, Part::MemberEnds, Status::Failed)
        .of_case(&idle.case)
}
