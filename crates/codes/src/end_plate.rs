//! Hand checks of a bolted end plate, computed from the values of a resolved spec.
//!
//! Detailing is always checked and can fail. Where a load case has actions at member ends, the
//! forces in bolts, plates and welds are checked as well (`load_cases.rs`), and the component
//! method is compared with the analysis (`comparison.rs`). Without such actions the resistances,
//! the component method and the stiffness are information: pressures on sections do not determine
//! the force of a bolt.

mod assumptions;
mod at_plate;
mod beam_checks;
mod beam_cuts;
mod bolt_checks;
mod bolt_forces;
mod bolt_group;
mod bolt_rows;
mod capacity;
mod clamped_plates;
mod class_checks;
mod column_checks;
mod column_flexibility;
mod column_forces;
mod comparison;
mod component_joint;
mod component_tables;
mod detailing;
mod diagram;
mod doubler;
mod hand_checks;
mod haunch_checks;
mod haunch_tip;
mod hole_checks;
mod joint_checks;
mod joint_stiffness;
mod load_cases;
mod loaded_welds;
mod member_end;
mod method_record;
mod national_annex;
mod outside_range;
mod parts_list;
mod rotation_rules;
mod sense;
mod slip_checks;
mod stiffener_checks;
mod transformation;
mod tying;
mod weld_checks;
mod weld_lengths;
mod welded_steel;
mod welds_list;

pub use capacity::Capacity;
pub use clamped_plates::stocked_length;
pub use class_checks::stiffness_class_limits;
pub use comparison::Comparison;
pub use diagram::{Curve, MomentAxial, Point, moment_axial};
pub use hand_checks::HandChecks;
pub use joint_stiffness::{FrameClass, JointStiffness, PureMoment};
pub use method_record::{LimitRecord, MethodRecord, RowRecord, StubRecord, WebRecord};
pub use parts_list::{PartItem, PartSize, parts_list, total_mass};
pub use welds_list::{WeldItem, welds_list};

// what the checks of other families share
pub(crate) use assumptions::{not_checked, unseen_loads, without_strength};
pub(crate) use beam_checks::beyond_a_beam;
pub(crate) use hole_checks::kind_of_holes;
pub(crate) use national_annex::of_any_joint;
pub(crate) use outside_range::{Piece, beyond};
pub(crate) use slip_checks::Preloaded;
pub(crate) use tying::GAMMA_MU;

use bracket_joint::assembly::EndPlate;
use rotation_rules::RotationRules;

/// All hand checks of an end plate.
pub fn hand_checks(e: &EndPlate) -> HandChecks {
    let mut out = HandChecks { checks: detailing::detailing(e), ..HandChecks::default() };
    out.checks.extend(bolt_checks::resistances(e));
    out.checks.extend(weld_checks::full_strength_throats(e));
    out.checks.extend(weld_checks::least_sizes(e));
    out.checks.extend(stiffener_checks::least_sizes(e));
    out.checks.extend(stiffener_checks::rib_weld(e));
    out.checks.extend(slip_checks::assembly(e));
    out.checks.extend(outside_range::outside_range(e));
    out.checks.extend(haunch_checks::rules(e));
    out.checks.extend(tying::tying(e));
    out.checks.extend(assumptions::assumptions(e));
    out.checks.extend(assumptions::no_weld_strength(e));
    out.checks.extend(weld_lengths::rule(e));
    out.checks.extend(national_annex::checks(e));
    out.checks.extend(assumptions::unseen_loads(&e.unseen));
    out.checks.extend(assumptions::not_checked(&e.not_checked));
    out.notes.extend(component_tables::left_out(e));
    let senses = component_tables::senses(e, &mut out);
    let rules = RotationRules::new(e);
    if !rules.ductile(e, &senses) {
        out.brittle = Some(rules.brittle(&senses));
    }
    out.checks.extend(rules.checks(&senses));
    let service = e.actions.iter().filter(|a| !a.state.is_ultimate());
    out.serviceability.extend(service.map(|a| a.case.clone()));
    out.checks.extend(column_checks::given(e));
    out.notes.extend(column_checks::beyond_the_column(e));
    load_cases::checks(e, &mut out);
    if e.outer_gauge > 0.0 {
        out.checks.iter_mut().for_each(assumptions::by_inner_bolts);
    }
    out.checks.sort_by_key(|c| c.topic);
    out
}

#[cfg(test)]
mod tests;
