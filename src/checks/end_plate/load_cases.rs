//! Checks of every load case with actions at a member end.

use super::beam_checks::{beam, beyond_the_beam};
use super::bolt_forces::BoltForces;
use super::class_checks::classes;
use super::comparison::Comparison;
use super::hand_checks::HandChecks;
use super::joint_checks;
use super::joint_stiffness::PureMoment;
use super::member_end::{LoadedEnd, MemberEnd, subject};
use super::sense::Sense;
use super::slip_checks::slip;
use super::stiffener_checks::{doubler_welds, stiffeners};
use super::transformation::beta;
use super::weld_checks;
use crate::assembly::{EndPlate, PlaneActions};
use crate::checks::check::{Check, Topic, Unit};

/// Adds the checks of every load case and member end.
pub(super) fn checks(e: &EndPlate, out: &mut HandChecks) {
    for a in &e.actions {
        let place = format!("{}, {}", a.case, a.end);
        out.notes.extend(beyond_the_beam(e, a).map(|what| format!("{place}: {what}")));
        let ultimate = a.state.is_ultimate();
        let mut alone: Vec<Check> = slip(e, a).into_iter().collect();
        if ultimate {
            alone.extend(no_formula(a));
            alone.extend(beam(e, a));
        }
        out.checks.extend(alone.into_iter().map(|c| c.of_case(&a.case)));
        let end = match MemberEnd::new(e, a) {
            Ok(end) => end,
            Err(fault) => {
                let (clause, title) =
                    ("EN 1993-1-8:2005 6.2", "resistance by the component method");
                let check = Check::undecided(
                    Topic::ComponentMethod,
                    subject(a, Sense::of_moment(a.at(1.0)[1][1])),
                    clause,
                    title,
                    fault.to_string(),
                );
                out.checks.extend(ultimate.then(|| check.of_case(&a.case)));
                continue;
            }
        };
        let method = end.method();
        if ultimate {
            let loaded = LoadedEnd::new(&end, &method);
            let stability = joint_checks::stability(&loaded);
            if !stability.is_empty() && !out.unstable.contains(&a.case) {
                out.unstable.push(a.case.clone());
            }
            let mut found = vec![joint_checks::moment_and_axial(&loaded)];
            found.extend(stability);
            found.extend(BoltForces::new(&loaded).checks());
            found.extend(joint_checks::panel(&end));
            found.extend(weld_checks::under_load(e, a));
            found.extend(weld_checks::tension_zone(&loaded));
            found.extend(stiffeners(&loaded));
            found.extend(doubler_welds(&end));
            found.extend(classes(&end));
            out.checks.extend(found.into_iter().map(|c| c.of_case(&a.case)));
        }
        out.comparisons.push(Comparison::new(e, a, &method, &end.assessment));
        out.moments.extend(PureMoment::new(e, a, beta(e, a), &end.assessment));
    }
}

/// Torsion, weak-axis moment and horizontal shear: the hand checks of bolts, plates and welds leave
/// them out, and a bracket does not replace them.
fn no_formula(a: &PlaneActions) -> Option<Check> {
    let [[_, vy, _], [torsion, _, mz]] = a.at(1.0);
    let moments = [("T", torsion, Unit::Moment), ("Mz", mz, Unit::Moment), ("Vy", vy, Unit::Force)];
    let acts = moments.into_iter().filter(|(_, v, _)| v.abs() > 1e-6);
    let names: Vec<String> =
        acts.map(|(name, v, unit)| format!("{name} = {}", unit.show(v))).collect();
    (!names.is_empty()).then(|| {
        let why = format!(
            "the checks of bolts, plates and welds leave {} out: EN 1993-1-8 6.2 has no formula",
            names.join(" and ")
        );
        let (clause, title) =
            ("EN 1993-1-8:2005 6.2", "torsion, weak-axis moment and horizontal shear");
        Check::undecided(Topic::Bolts, a.end.clone(), clause, title, why)
    })
}
