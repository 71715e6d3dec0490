//! Slip of preloaded bolts by their category, and the kind of bolt assemblies.

use super::hole_checks::holes;
use crate::check::{Check, CheckId, Status, Topic, Unit, within};
use crate::eurocode::holes::Clearance;
use crate::eurocode::slip::{demanded, preload, slip_resistance};
use crate::formula::{Derivation, Formula, Traced};
use crate::subject::{Place, Subject};
use crate::worked::Worked;
use bracket_base::say;
use bracket_joint::assembly::{EndPlate, PlaneActions};
use bracket_joint::catalog::{BoltGrade, BoltSize};
use bracket_joint::spec::code::PartialFactors;
use bracket_joint::spec::connection::BoltCategory;
use bracket_joint::spec::loads::LimitState;

/// Preloaded bolts whose slip is checked.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Preloaded<'a> {
    /// Size.
    pub bolt: &'a BoltSize,
    /// Grade.
    pub grade: &'a BoltGrade,
    /// Diameter of the holes \[mm\].
    pub hole: f64,
    /// Preload of a bolt \[N\]; `None`: the bolts are not preloaded.
    pub preload: Option<f64>,
    /// Category of the bolts, if the spec gives it.
    pub category: Option<BoltCategory>,
    /// Friction coefficient of the contact surfaces.
    pub mu: f64,
    /// Partial factors.
    pub factors: &'a PartialFactors,
}

impl<'a> From<&'a EndPlate> for Preloaded<'a> {
    fn from(e: &'a EndPlate) -> Self {
        Self {
            bolt: &e.bolt,
            grade: &e.grade,
            hole: e.hole,
            preload: e.preload,
            category: e.category,
            mu: e.mu,
            factors: &e.factors,
        }
    }
}

impl Preloaded<'_> {
    /// Slip of one bolt with a number of friction surfaces under a tension \[N\] and the force
    /// that the last formula of `demand` gives. The check binds where the spec names category B or
    /// C. Otherwise the joint need not resist slip, and exceeding the resistance is a warning.
    ///
    /// # Source
    /// EN 1993-1-8:2005 3.4.1, Table 3.2, 3.9.
    pub fn slip(
        &self,
        state: LimitState,
        subject: Subject,
        (surfaces, tension): (u32, f64),
        demand: Derivation,
    ) -> Option<Check> {
        let (id, otherwise) = demanded(self.category, state)?;
        // with a category that must not slip, no friction means no resistance; without a category
        // there is nothing to check
        let preload = self.preload.filter(|_| self.mu > 0.0 || self.category.is_some())?;
        let gamma = match state.is_ultimate() {
            true => ("γ_M3", self.factors.gamma_m3),
            false => ("γ_M3,ser", self.factors.gamma_m3_ser),
        };
        let Some(hole) = Clearance::of(self.bolt, self.hole).slip() else {
            let why = "Table 3.6 has no k_s for holes wider than oversize";
            let (clause, step) =
                ("EN 1993-1-8:2005 Table 3.6", "smaller holes (`parameters.hole_clearance`)");
            let mut check = Check::undecided(Topic::Bolts, subject, clause, id, why, step);
            if otherwise != Status::Failed {
                check.status = Status::Warning;
            }
            return Some(check);
        };
        let mut worked = slip_resistance(hole, surfaces, self.mu, preload, tension, gamma);
        worked.id = id;
        let force = demand.formulas().last().map_or(0.0, |f| f.value);
        Some(worked.after(demand).against(Topic::Bolts, subject, force, otherwise))
    }
}

/// Slip of all preloaded bolts of a plate. The compression of a moment balances the clamping force
/// that its tension takes (3.9.2(3)); an axial tension is shared by the bolts.
///
/// # Source
/// EN 1993-1-8:2005 3.9.
pub(super) fn slip(e: &EndPlate, a: &PlaneActions) -> Option<Check> {
    let [axial, vy, vz] = a.at(1.0)[0];
    let bolts = 2.0 * e.rows.len() as f64;
    let shear = Traced::force("V_Ed", vy.hypot(vz)) / Traced::number("n_b", bolts);
    let demand = Formula::new("", shear, Unit::Force).into();
    let of_bolt = (1, axial.max(0.0) / bolts);
    Preloaded::from(e).slip(a.state, Subject::end(&a.end), of_bolt, demand)
}

/// Slip factor of class A, EN 1993-1-8:2005 Table 3.7.
const HIGHEST_CLASS: f64 = 0.5;

/// Kind of the holes, preloaded assemblies, and the load cases that a category requires.
pub(super) fn assembly(e: &EndPlate) -> Vec<Check> {
    let mut out = holes(e);
    out.extend(Preloaded::from(e).assembly(e.actions.iter().map(|a| a.state)));
    out
}

impl Preloaded<'_> {
    /// Preloaded assemblies, and the load cases that a category requires; `states` are those of
    /// the load cases.
    pub fn assembly(&self, states: impl Iterator<Item = LimitState>) -> Vec<Check> {
        let subject = Place::Bolt { size: self.bolt.size.clone(), grade: self.grade.grade.clone() };
        let (states, mut out): (Vec<_>, _) = (states.collect(), Vec::new());
        if self.category == Some(BoltCategory::B)
            && !states.is_empty()
            && states.iter().all(LimitState::is_ultimate)
        {
            let id = CheckId::SlipNoCase;
            let why = "the spec has no load case of serviceability";
            let (clause, step) = ("EN 1993-1-8:2005 3.4.1(3)", "a load case with `state: SLS`");
            out.push(Check::undecided(Topic::Bolts, subject.clone(), clause, id, why, step));
        }
        let Some(force) = self.preload else { return out };
        if self.category.is_some() && !within(self.mu, HIGHEST_CLASS) {
            let id = CheckId::SlipFactor;
            let (clause, mu) = ("EN 1993-1-8:2005 Table 3.7", Traced::number("μ", self.mu));
            let words = Derivation::from("μ of the spec").then("Table 3.7 has at most 0.5");
            let worked = Worked::of(clause, id, "μ", mu, Unit::Number).after(words);
            let check = worked.information(Topic::Bolts, subject.clone());
            out.push(Check { status: Status::Warning, ..check });
        }
        if self.bolt.system == "ISO 4014" {
            let id = CheckId::PreloadedAssemblies;
            let clause = "EN 1993-1-8:2005 3.1.2(1), 1.2.4";
            let worked = Worked::of(clause, id, "F_p", Traced::force("F_p", force), Unit::Force)
                .after(say!("{} is of {}", &self.bolt.size, &self.bolt.standard));
            let check = worked.information(Topic::Bolts, subject.clone());
            out.push(Check { status: Status::Warning, ..check });
        }
        let full = preload(self.bolt, self.grade);
        if self.category.is_some_and(|c| matches!(c, BoltCategory::B | BoltCategory::C))
            && !within(force, full.value)
        {
            let mut worked = full;
            worked.id = CheckId::PreloadLimit;
            out.push(worked.against(Topic::Bolts, subject, force, Status::Failed));
        }
        out
    }
}
