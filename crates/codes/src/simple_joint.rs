//! Hand checks of a simple joint: a fin plate, or a header (partial-depth end) plate.
//!
//! The joint is nominally pinned. A fin plate is checked for N, Vz and My in its plane, a header
//! plate for Vz and tension. The code has no formula for the rest: these checks are undecided. The
//! clauses of EN 1993-1-8 are put together as in Steel Buildings in Europe, Part 5, which follows
//! them but for the rules that its name stands beside.

mod actions;
mod bolt_checks;
mod detailing;
mod header_bolts;
mod header_tension;
mod notch_checks;
mod plate_checks;
mod plies;
mod range_checks;
mod resistance;
mod rotation_rules;
mod shear_resistances;
mod slip;
mod support_checks;
mod tension_checks;
mod tying;
mod web_checks;
mod weld_checks;
mod without_formula;

use crate::check::Check;
use crate::end_plate::{HandChecks, beyond_a_beam};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::{PlaneActions, SimpleJoint, SimpleKind};

/// All hand checks of a simple joint.
pub fn simple_checks(e: &SimpleJoint) -> HandChecks {
    let mut out = HandChecks { checks: detailing::detailing(e), ..HandChecks::default() };
    out.checks.extend(range_checks::checks(e));
    out.checks.extend(bolt_checks::resistances(e));
    out.checks.extend(slip::assembly(e));
    out.checks.extend(weld_checks::sizes(e));
    out.checks.extend(notch_checks::stability(e));
    out.checks.extend(support_checks::punching(e));
    out.checks.extend(tying::tying(e));
    let rules = rotation_rules::RotationRules::new(e);
    out.brittle = rules.brittle();
    out.checks.extend(rules.checks());
    let service = e.actions.iter().filter(|a| !a.state.is_ultimate());
    out.serviceability.extend(service.map(|a| a.case.clone()));
    if !e.actions.iter().any(|a| a.state.is_ultimate()) {
        let shear = shear_resistances::shear_resistances(e, true);
        out.checks.extend(shear.into_iter().map(resistance::Resistance::information));
    }
    for a in &e.actions {
        let noted = |what: Text| say!("{}, {}: {}", &a.case, &a.end, what);
        let beam = (&e.beam, &e.beam_steel);
        out.notes.extend(beyond_a_beam(beam, e.factors.gamma_m0, a).map(noted));
        let mut checks: Vec<Check> = slip::slip(e, a).into_iter().collect();
        if a.state.is_ultimate() {
            checks.extend(under_load(e, a));
        }
        out.checks.extend(checks.into_iter().map(|c| c.of_case(&a.case)));
    }
    out.checks.sort_by_key(|c| c.topic);
    out
}

/// The checks of strength and stability under a load case.
fn under_load(e: &SimpleJoint, a: &PlaneActions) -> Vec<Check> {
    let mut out = without_formula::checks(e, a);
    let vz = a.at(1.0)[0][2];
    if vz != 0.0 {
        let shear = shear_resistances::shear_resistances(e, vz < 0.0);
        out.extend(shear.into_iter().map(|r| r.against(&a.end, vz.abs())));
    }
    match e.kind {
        SimpleKind::FinPlate => {
            out.extend(bolt_checks::in_group(e, a));
            out.extend(plate_checks::bending(e, a));
            out.extend(plate_checks::buckling(e, a));
            out.extend(web_checks::around_bolts(e, a));
            out.extend(tension_checks::checks(e, a));
        }
        SimpleKind::HeaderPlate => out.extend(header_tension::checks(e, a)),
    }
    out.extend(notch_checks::bending(e, a));
    out.extend(weld_checks::under_load(e, a));
    out.extend(support_checks::under_load(e, a));
    out
}

#[cfg(test)]
mod tests;
