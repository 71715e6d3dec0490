//! Slip of preloaded bolts by their category, and the kind of bolt assemblies.

use super::hole_checks::holes;
use crate::check::{Check, CheckId, Status, Topic, Unit, within};
use crate::eurocode::holes::Clearance;
use crate::eurocode::slip::{preload, slip_resistance};
use crate::formula::{Derivation, Formula, Traced};
use crate::subject::{Place, Subject};
use crate::worked::Worked;
use bracket_base::say;
use bracket_joint::assembly::{EndPlate, PlaneActions};
use bracket_joint::catalog::{BoltGrade, BoltSize};
use bracket_joint::spec::code::PartialFactors;
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

/// Preloaded bolts of a joint.
pub(crate) struct Preloaded<'a> {
    /// Size and grade.
    pub bolt: (&'a BoltSize, &'a BoltGrade),
    /// Diameter of the holes \[mm\].
    pub hole: f64,
    /// Preload of a bolt \[N\]; `None`: not preloaded.
    pub preload: Option<f64>,
    /// Category, if the spec gives it.
    pub category: Option<BoltCategory>,
    /// Friction coefficient.
    pub mu: f64,
    /// Partial factors.
    pub factors: &'a PartialFactors,
}

impl<'a> From<&'a EndPlate> for Preloaded<'a> {
    fn from(e: &'a EndPlate) -> Self {
        let EndPlate { bolt, grade, hole, preload, category, mu, factors, .. } = e;
        let bolt = (bolt, grade);
        let (hole, preload, category, mu) = (*hole, *preload, *category, *mu);
        Self { bolt, hole, preload, category, mu, factors }
    }
}

/// Slip of all preloaded bolts of a plate. The compression of a moment balances the clamping force
/// that its tension takes (3.9.2(3)); an axial tension is shared by the bolts.
pub(super) fn slip(e: &EndPlate, a: &PlaneActions) -> Option<Check> {
    let [axial, vy, vz] = a.at(1.0)[0];
    let bolts = 2.0 * e.rows.len() as f64;
    let shear = Traced::force("V_Ed", vy.hypot(vz)) / Traced::number("n_b", bolts);
    Preloaded::from(e).slip(a, axial.max(0.0) / bolts, Formula::new("", shear, Unit::Force))
}

impl Preloaded<'_> {
    /// Slip of a bolt on one surface under a tension ≥ 0 \[N\] and a shear force. The check binds
    /// where the spec names category B or C. Otherwise the joint need not resist slip, and
    /// exceeding the resistance is a warning. `None` where nothing demands it.
    ///
    /// # Source
    /// EN 1993-1-8:2005 3.4.1, Table 3.2, 3.9.
    pub(crate) fn slip(&self, a: &PlaneActions, tension: f64, shear: Formula) -> Option<Check> {
        let (id, otherwise) = demanded(self.category, a.state)?;
        // with a category that must not slip, no friction means no resistance; without a category
        // there is nothing to check
        let preload = self.preload.filter(|_| self.mu > 0.0 || self.category.is_some())?;
        let gamma = match a.state.is_ultimate() {
            true => ("γ_M3", self.factors.gamma_m3),
            false => ("γ_M3,ser", self.factors.gamma_m3_ser),
        };
        let Some(hole) = Clearance::of(self.bolt.0, self.hole).slip() else {
            let why = "Table 3.6 has no k_s for holes wider than oversize";
            let (clause, step) =
                ("EN 1993-1-8:2005 Table 3.6", "smaller holes (`parameters.hole_clearance`)");
            let end = Subject::end(&a.end);
            let mut check = Check::undecided(Topic::Bolts, end, clause, id, why, step);
            if otherwise != Status::Failed {
                check.status = Status::Warning;
            }
            return Some(check);
        };
        let mut worked = slip_resistance(hole, 1, self.mu, preload, tension, gamma);
        worked.id = id;
        let demand = shear.value;
        let worked = worked.after(shear);
        Some(worked.against(Topic::Bolts, Subject::end(&a.end), demand, otherwise))
    }
}

/// Slip factor of class A, EN 1993-1-8:2005 Table 3.7.
const HIGHEST_CLASS: f64 = 0.5;

/// Kind of the holes, preloaded assemblies, and the load cases that a category requires.
pub(super) fn assembly(e: &EndPlate) -> Vec<Check> {
    let mut out = holes(e);
    out.extend(assemblies(&e.into(), &e.actions));
    out
}

/// Preloaded assemblies, and the load cases that a category requires.
pub(crate) fn assemblies(e: &Preloaded<'_>, actions: &[PlaneActions]) -> Vec<Check> {
    let (size, grade) = e.bolt;
    let subject = Place::bolt(size, grade);
    let mut out = Vec::new();
    if e.category == Some(BoltCategory::B)
        && !actions.is_empty()
        && actions.iter().all(|a| a.state.is_ultimate())
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
    if size.system == "ISO 4014" {
        let id = CheckId::PreloadedAssemblies;
        let clause = "EN 1993-1-8:2005 3.1.2(1), 1.2.4";
        let worked = Worked::of(clause, id, "F_p", Traced::force("F_p", force), Unit::Force)
            .after(say!("{} is of {}", &size.size, &size.standard));
        let check = worked.information(Topic::Bolts, subject.clone());
        out.push(Check { status: Status::Warning, ..check });
    }
    let full = preload(size, grade);
    if e.category.is_some_and(|c| matches!(c, BoltCategory::B | BoltCategory::C))
        && !within(force, full.value)
    {
        let mut worked = full;
        worked.id = CheckId::PreloadLimit;
        out.push(worked.against(Topic::Bolts, subject, force, Status::Failed));
    }
    out
}
