//! Slip of preloaded bolts by their category, and the kind of bolt assemblies.

use super::bolt_rows::bolt;
use super::hole_checks::holes;
use crate::check::{Check, CheckId, Status, Topic, Unit, within};
use crate::eurocode::holes::Clearance;
use crate::eurocode::slip::{preload, slip_resistance};
use crate::formula::{Derivation, Formula, Number, Traced};
use crate::subject::Subject;
use crate::worked::Worked;
use bracket_base::say;
use bracket_joint::assembly::{EndPlate, PlaneActions};
use bracket_joint::spec::connection::BoltCategory;
use bracket_joint::spec::loads::LimitState;

/// Limit state in which slip is checked, as the id of the check, and its status where it fails.
fn demanded(category: Option<BoltCategory>, state: LimitState) -> Option<(CheckId, Status)> {
    const ULTIMATE: CheckId = CheckId::SlipUltimate;
    const SERVICEABILITY: CheckId = CheckId::SlipServiceability;
    match (category, state) {
        (Some(BoltCategory::B), LimitState::Serviceability) => {
            Some((SERVICEABILITY, Status::Failed))
        }
        (Some(BoltCategory::C), LimitState::Ultimate) => Some((ULTIMATE, Status::Failed)),
        (Some(_), _) => None,
        // no category is given, so slip need not be prevented
        (None, LimitState::Serviceability) => Some((SERVICEABILITY, Status::Warning)),
        (None, LimitState::Ultimate) => Some((ULTIMATE, Status::Warning)),
    }
}

/// Slip of all preloaded bolts of a plate. The compression of a moment balances the clamping force
/// that its tension takes (3.9.2(3)); an axial tension is shared by the bolts. The check binds
/// where the spec names category B or C. Otherwise the joint need not resist slip, and exceeding
/// the resistance is a warning.
///
/// # Source
/// EN 1993-1-8:2005 3.4.1, Table 3.2, 3.9.
pub(super) fn slip(e: &EndPlate, a: &PlaneActions) -> Option<Check> {
    let (id, otherwise) = demanded(e.category, a.state)?;
    // with a category that must not slip, no friction means no resistance; without a category there
    // is nothing to check
    let preload = e.preload.filter(|_| e.mu > 0.0 || e.category.is_some())?;
    let gamma = match a.state.is_ultimate() {
        true => ("γ_M3", e.factors.gamma_m3),
        false => ("γ_M3,ser", e.factors.gamma_m3_ser),
    };
    let [axial, vy, vz] = a.at(1.0)[0];
    let bolts = 2.0 * e.rows.len() as f64;
    let Some(hole) = Clearance::of(&e.bolt, e.hole).slip() else {
        let why = "Table 3.6 has no k_s for holes wider than oversize";
        let (clause, step) =
            ("EN 1993-1-8:2005 Table 3.6", "smaller holes (`parameters.hole_clearance`)");
        let mut check = Check::undecided(Topic::Bolts, Subject::end(&a.end), clause, id, why, step);
        if otherwise != Status::Failed {
            check.status = Status::Warning;
        }
        return Some(check);
    };
    let mut worked = slip_resistance(hole, 1, e.mu, preload, axial.max(0.0) / bolts, gamma);
    worked.id = id;
    let shear = Traced::force("V_Ed", vy.hypot(vz)) / Traced::number("n_b", bolts);
    let demand = shear.value();
    let worked = worked.after(Formula::new("", shear, Unit::Force));
    Some(worked.against(Topic::Bolts, Subject::end(&a.end), demand, otherwise))
}

/// Slip factor of class A, EN 1993-1-8:2005 Table 3.7.
const HIGHEST_CLASS: f64 = 0.5;

/// Kind of the holes, preloaded assemblies, and the load cases that a category requires.
pub(super) fn assembly(e: &EndPlate) -> Vec<Check> {
    let subject = bolt(e);
    let mut out = holes(e);
    if e.category == Some(BoltCategory::B)
        && !e.actions.is_empty()
        && e.actions.iter().all(|a| a.state.is_ultimate())
    {
        let id = CheckId::SlipNoCase;
        let why = "the spec has no load case of serviceability";
        let (clause, step) = ("EN 1993-1-8:2005 3.4.1(3)", "a load case with `state: SLS`");
        out.push(Check::undecided(Topic::Bolts, subject.clone(), clause, id, why, step));
    }
    let Some(force) = e.preload else { return out };
    if e.category.is_some() && !within(e.mu, HIGHEST_CLASS) {
        let id = CheckId::SlipFactor;
        let (clause, mu) = ("EN 1993-1-8:2005 Table 3.7", Traced::number("μ", e.mu));
        let words = Derivation::from("μ of the spec").then("Table 3.7 has at most 0.5");
        let worked = Worked::of(clause, id, "μ", mu, Unit::Number).after(words);
        let check = worked.information(Topic::Bolts, subject.clone());
        out.push(Check { status: Status::Warning, ..check });
    }
    if e.bolt.system == "ISO 4014" {
        let id = CheckId::PreloadedAssemblies;
        let clause = "EN 1993-1-8:2005 3.1.2(1), 1.2.4";
        let worked = Worked::of(clause, id, "F_p", Traced::force("F_p", force), Unit::Force)
            .after(say!("{} is of {}", &e.bolt.size, &e.bolt.standard));
        let check = worked.information(Topic::Bolts, subject.clone());
        out.push(Check { status: Status::Warning, ..check });
    }
    let full = preload(&e.bolt, &e.grade);
    if e.category.is_some_and(|c| matches!(c, BoltCategory::B | BoltCategory::C))
        && !within(force, full.value)
    {
        let mut worked = full;
        worked.id = CheckId::PreloadLimit;
        out.push(worked.against(Topic::Bolts, subject, force, Status::Failed));
    }
    out
}
