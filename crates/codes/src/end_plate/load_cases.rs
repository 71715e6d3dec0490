//! Checks of every load case with actions at a member end.

use super::beam_checks::{beam, beyond_the_beam};
use super::bolt_forces::BoltForces;
use super::capacity::Capacity;
use super::class_checks::classes;
use super::column_checks;
use super::comparison::Comparison;
use super::hand_checks::HandChecks;
use super::haunch_tip;
use super::joint_checks;
use super::joint_stiffness::PureMoment;
use super::loaded_welds;
use super::member_end::{LoadedEnd, MemberEnd, subject};
use super::method_record::MethodRecord;
use super::slip_checks::slip;
use super::stiffener_checks::{doubler_welds, stiffeners};
use super::transformation::beta;
use super::weld_checks;
use crate::check::{Check, CheckId, Status, Topic, Unit, within};
use crate::eurocode::yielding::plastic_shear;
use crate::subject::{Sense, Subject};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::{EndPlate, PlaneActions};

/// Adds the checks of every load case and member end.
pub(super) fn checks(e: &EndPlate, out: &mut HandChecks) {
    for a in &e.actions {
        let noted = |what: Text| say!("{}, {}: {}", &a.case, &a.end, what);
        out.notes.extend(beyond_the_beam(e, a).map(noted));
        let ultimate = a.state.is_ultimate();
        let mut alone: Vec<Check> = slip(e, a).into_iter().collect();
        if ultimate {
            alone.extend(no_formula(a));
            alone.extend(beam(e, a));
            let first = e.actions.iter().find(|o| o.case == a.case);
            if first.is_some_and(|first| std::ptr::eq(first, a)) {
                alone.extend(column_checks::under_load(e, &a.case));
            }
        }
        out.checks.extend(alone.into_iter().map(|c| c.of_case(&a.case)));
        let end = match MemberEnd::new(e, a) {
            Ok(end) => end,
            Err(fault) => {
                let (clause, id) = ("EN 1993-1-8:2005 6.2", CheckId::MethodResistance);
                let check = Check::undecided(
                    Topic::ComponentMethod,
                    subject(a, Sense::of_moment(a.at(1.0)[1][1])),
                    clause,
                    id,
                    fault.text(),
                    fault.step(),
                );
                out.checks.extend(ultimate.then(|| check.of_strength().of_case(&a.case)));
                continue;
            }
        };
        let method = end.method();
        if let Some(check) = no_moment(&end, method.moment) {
            out.checks.extend(ultimate.then(|| check.of_case(&a.case)));
            continue;
        }
        let own = of_its_own(&end, out.methods());
        out.capacities.extend(own.map(Capacity::Moment));
        if ultimate {
            let loaded = LoadedEnd::new(&end, &method);
            let stability = joint_checks::stability(&loaded);
            if !stability.is_empty() && !out.unstable.contains(&a.case) {
                out.unstable.push(a.case.clone());
            }
            let mut found = vec![joint_checks::moment_and_axial(&loaded)];
            found.extend(joint_checks::left_out_axial(&loaded));
            found.extend(stability);
            found.extend(BoltForces::new(&loaded).checks());
            found.extend(joint_checks::panel(&end));
            found.extend(haunch_tip::under_load(&loaded));
            found.extend(loaded_welds::under_load(e, a));
            found.extend(weld_checks::tension_zone(&loaded));
            found.extend(stiffeners(&loaded));
            found.extend(doubler_welds(&end));
            found.extend(classes(&end));
            out.checks.extend(found.into_iter().map(|c| c.of_case(&a.case)));
        }
        let comparison = Comparison::new(e, a, &method, &end.assessment);
        let moment = PureMoment::new(e, a, beta(e, a), &end.assessment);
        out.capacities.push(Capacity::UnderLoad(comparison));
        out.capacities.extend(moment.map(Capacity::Stiffness));
    }
}

/// The component method of a member end whose forces change M_j,Rd: the shear force of the beam
/// above half of its resistance. `None` where it is that of the sense of bending, or of an earlier
/// case.
fn of_its_own<'a>(
    end: &MemberEnd<'_>,
    known: impl Iterator<Item = &'a MethodRecord>,
) -> Option<MethodRecord> {
    let turned = end.joint.turned(end.sense);
    let mut own = MethodRecord::new(Text::default(), true, end.sense, &turned, &end.assessment);
    for o in known {
        own.subject.clone_from(&o.subject);
        if own == *o {
            return None;
        }
    }
    let subject = say!("{}, {}", &end.a.case, end.subject().text());
    Some(MethodRecord { subject, ..own })
}

/// Torsion and weak-axis moment of the joint: no rule of the code brings them into the rows of
/// bolts and the plate. Small ones are neglected before (`assembly::small_actions`).
fn no_formula(a: &PlaneActions) -> Vec<Check> {
    let [_, [torsion, _, mz]] = a.at(1.0);
    let steps = [
        (
            "Mz",
            mz,
            CheckId::WeakAxisOfJoint,
            "6.2 has no resistance of the joint to it: the rows would pull with one column of \
             bolts each, for which Tables 6.4 and 6.6 have no effective lengths",
            "a detail that carries Mz beside the joint",
        ),
        (
            "T",
            torsion,
            CheckId::TorsionOfJoint,
            "6.2 has no resistance of end plate and welds to it, and the restraint of warping at \
             the plate is not known",
            "a detail that carries T beside the joint",
        ),
    ];
    let acts = steps.into_iter().filter(|(_, moment, ..)| *moment != 0.0);
    let check = |(name, moment, id, why, step): (_, _, _, &'static str, &'static str)| {
        let (clause, value) = ("EN 1993-1-8:2005 6.2", Unit::Moment.show(moment));
        let why = say!("{} = {}: {}", name, value, why);
        Check::undecided(Topic::Bolts, Subject::end(&a.end), clause, id, why, step).without_method()
    };
    acts.map(check).collect()
}

/// Whether the shear force leaves the joint no moment resistance beside which its rows could carry
/// the moment; the check of that moment.
///
/// # Source
/// EN 1993-1-1:2005 6.2.8: a shear force at V_pl,Rd leaves a section of class 3 nothing.
fn no_moment(end: &MemberEnd<'_>, moment: f64) -> Option<Check> {
    let [[_, vy, vz], [_, my, _]] = end.a.at(1.0);
    if my == 0.0 || moment > 0.0 {
        return None;
    }
    let (clause, id) = ("EN 1993-1-1:2005 6.2.8", CheckId::MomentAndAxial);
    let why = say!(
        "the components leave M_j,Rd = 0 beside V_Ed = {}: the rows cannot carry M_j,Ed = {}",
        Unit::Force.show(vy.hypot(vz)),
        Unit::Moment.show(my.abs())
    );
    let step = "a beam with more shear resistance, or less shear force";
    let none = Check::undecided(Topic::ComponentMethod, end.subject(), clause, id, why, step);
    // beyond V_pl,Rd the check of the shear force fails, with its number
    let e = end.e;
    let beam = &end.joint.beam;
    let plastic = plastic_shear(beam.section.shear_area(), beam.fy, e.factors.gamma_m0);
    let status = if within(vz.abs(), plastic) { Status::Failed } else { none.status };
    Some(Check { status, ..none }.of_strength())
}
