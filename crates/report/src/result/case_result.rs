//! One load case under one kind of analysis: its entry in `result.json`.

use crate::result::certificate::Certificate;
use crate::result::demand::{Demand, EndAction};
use crate::result::face_motion::FaceMotion;
use crate::result::forces::StaticForces;
use crate::result::history::HistoryRow;
use crate::result::interface_use::{GroundUse, ResultantUse, SupportSlip, TieSlip};
use crate::result::load_step::LoadStep;
use crate::result::proved_by::ProvedBy;
use crate::result::quantity::{FrictionModel, LoadSize, Quantity, RawBracket, Upper};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::route::{CriticalFactors, Evidence};
use bracket_codes::verdict::Verdict;
use bracket_codes::{HandChecks, JointStiffness};
use bracket_engine::analysis::cone_shift::FixedPointRun;
use bracket_engine::analysis::preloaded_bolt::PreloadedBolt;
use bracket_engine::model::AnalysisKind;
use bracket_engine::solve::SolveStatus;
use serde::{Deserialize, Serialize};

/// One load case under one kind of analysis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaseResult {
    /// Name of the load case.
    pub name: String,
    /// Kind of analysis.
    pub analysis: AnalysisKind,
    /// The bracketed quantity.
    pub quantity: Quantity,
    /// The problem whose solution is bracketed.
    pub problem: FrictionModel,
    /// Lower bound of the whole structure (−Π_c \[N mm\] or load factor); an estimate unless the
    /// certificate is strict.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Upper bound of the whole structure (Π_p \[N mm\] or load factor); an estimate unless the
    /// certificate is strict.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<Upper>,
    /// Relative gap, a fraction (docs/theory.md).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// Bracket of demand over capacity, lower first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<[f64; 2]>,
    /// The demand of the load case and the verdict on it, where a demand is judged (`run`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub demand: Option<Demand>,
    /// Raw bracket of the frictionless problem.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frictionless: Option<RawBracket>,
    /// Raw bracket of the problem with associated friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub associated: Option<RawBracket>,
    /// Limit analysis, if requested: the load factor of the fixed point for Coulomb's law, an
    /// estimate. Under that law one structure may have several load factors; this is one of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coulomb_estimate: Option<f64>,
    /// The preloaded bolts of an elastic or elastic, perfectly plastic analysis.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub preload: Vec<PreloadedBolt>,
    /// Coulomb friction: course of the fixed point. In limit analysis it is the fixed point of the
    /// estimate, if that was reached.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fixed_point: Option<FixedPointRun>,
    /// The only load, at load factor 1, on the whole structure: its displacement or the collapse
    /// under it is bracketed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<LoadSize>,
    /// Bracket of the load's own displacement −2Π/F at load factor 1 \[mm; rad for a moment\],
    /// lower first; only if it is rigorous.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_displacement: Option<[f64; 2]>,
    /// Forces of the bolts and between the parts of a joint, from the stress of the lower bound.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub static_forces: Option<StaticForces>,
    /// Estimates for the route of analysis, from the fields that are stored.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub evidence: Option<Evidence>,
    /// The same from the meshes before, whose fields are not stored.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub evidence_before: Vec<Evidence>,
    /// Critical factors of linear buckling, for the route of analysis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub critical: Option<CriticalFactors>,
    /// Why they are not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub critical_unknown: Option<Text>,
    /// Elastic analysis of a joint under one moment: the bracket of its initial stiffness.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joint_stiffness: Option<JointStiffness>,
    /// Limit analysis: where the bounds come from, of a load case without an analysis of its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub proved_by: Option<ProvedBy>,
    /// Residuals of the two fields.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub certificate: Option<Certificate>,
    /// Elastic, perfectly plastic analysis: lower bound of the load's own displacement at load
    /// factor 1 \[mm; rad for a moment\]; only if it is rigorous.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_displacement_at_least: Option<f64>,
    /// One row for each mesh.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub history: Vec<HistoryRow>,
    /// Limit analysis: share of each body in the dissipation of the upper bound's mechanism, in the
    /// order of the bodies.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub dissipation: Vec<PartShare>,
    /// Elastic, perfectly plastic analysis: plastic state of each body that can yield, in the order
    /// of the bodies.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub yielding: Vec<PartYield>,
    /// Elastic, perfectly plastic analysis: motion of each rigid face that carries an action, in
    /// the field of the upper bound; an estimate.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub face_motions: Vec<FaceMotion>,
    /// Elastic, perfectly plastic analysis: the load steps that the spec asks for.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub load_steps: Vec<LoadStep>,
    /// Limit analysis: the body whose stress is nearest to the yield surface at the lower bound;
    /// absent if a weld or a resultant limit is nearer to its strength.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limiting_part: Option<String>,
    /// Each weld of finite strength.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub welds: Vec<WeldUse>,
    /// Limit analysis: each support along whose faces the mechanism of the upper bound slips.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub support_slip: Vec<SupportSlip>,
    /// Limit analysis: each pair of bodies tied together along whose common faces the mechanism of
    /// the upper bound slips.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tie_slip: Vec<TieSlip>,
    /// Limit analysis: each contact with ground that crushes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub crushing: Vec<GroundUse>,
    /// Limit analysis: each limit on the resultants of cuts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub resultants: Vec<ResultantUse>,
    /// Largest contact pressure on the last mesh, from both sides: estimates, not bounds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peak_contact_pressure: Option<PeakPressure>,
    /// Warnings about this case.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<Text>,
}

/// Share of a body in the dissipation of a mechanism.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartShare {
    /// Name of the body.
    pub part: String,
    /// Its share, a fraction.
    pub share: f64,
}

/// Use of a weld: its traction over its strength, and its dissipation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WeldUse {
    /// Name of the weld.
    pub weld: String,
    /// Largest traction of the static field over the strength, a fraction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<f64>,
    /// Upper bound of the mean magnitude of that traction over the strength, a fraction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mean_utilisation: Option<f64>,
    /// Strength of the throat, to which both utilisations refer \[MPa\]; absent if the model gives
    /// the strength as a traction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub throat_strength: Option<f64>,
    /// Limit analysis: its share in the dissipation of the mechanism, a fraction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub share: Option<f64>,
    /// Elastic kinds of analysis: work dissipated in the weld of the meshed part under the
    /// displacements of the upper bound \[N mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub work: Option<f64>,
}

/// Plastic state of a body that can yield.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartYield {
    /// Name of the body.
    pub part: String,
    /// Largest `‖dev σ‖/(√(2/3) f_y)` of the lower bound's stress.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<f64>,
    /// Fraction of its volume where the upper bound's field has plastic strain; an estimate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yielded: Option<f64>,
    /// Plastic work of that field in all copies of the body \[N mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dissipation: Option<f64>,
    /// Largest equivalent plastic strain, as the mean of a tetrahedron, in that field, a fraction;
    /// an estimate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plastic_strain: Option<f64>,
    /// Centroid of that tetrahedron \[mm\]; absent without plastic strain.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strain_at: Option<[f64; 3]>,
}

/// Largest contact pressure \[MPa\], positive in compression. The values are estimates, because the
/// bounds do not apply to local values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PeakPressure {
    /// From the stress of the displacement field, at the vertices of contact faces.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub kinematic: Option<f64>,
    /// From the tractions of the static program.
    #[serde(default, skip_serializing_if = "Option::is_none", rename = "static")]
    pub static_: Option<f64>,
}

impl CaseResult {
    /// An entry without any number.
    pub fn empty(
        name: &str,
        analysis: AnalysisKind,
        (quantity, problem): (Quantity, FrictionModel),
    ) -> Self {
        Self {
            name: name.into(),
            analysis,
            quantity,
            problem,
            lower: None,
            upper: None,
            gap: None,
            utilisation: None,
            demand: None,
            frictionless: None,
            associated: None,
            coulomb_estimate: None,
            preload: Vec::new(),
            fixed_point: None,
            load: None,
            load_displacement: None,
            static_forces: None,
            evidence: None,
            evidence_before: Vec::new(),
            critical: None,
            critical_unknown: None,
            joint_stiffness: None,
            proved_by: None,
            certificate: None,
            load_displacement_at_least: None,
            history: Vec::new(),
            dissipation: Vec::new(),
            yielding: Vec::new(),
            face_motions: Vec::new(),
            load_steps: Vec::new(),
            limiting_part: None,
            welds: Vec::new(),
            support_slip: Vec::new(),
            tie_slip: Vec::new(),
            crushing: Vec::new(),
            resultants: Vec::new(),
            peak_contact_pressure: None,
            warnings: Vec::new(),
        }
    }

    /// True if both numbers are bounds: every residual of the certificate is within its tolerance.
    pub fn is_strict(&self) -> bool {
        self.certificate.is_some_and(|c| c.strict)
    }

    /// The estimates for the route of analysis, mesh after mesh.
    pub fn evidence_of_meshes(&self) -> Vec<Evidence> {
        self.evidence_before.iter().chain(&self.evidence).cloned().collect()
    }

    /// The strict lower bound without friction beside an answer with associated friction.
    pub fn safe_lower(&self) -> Option<f64> {
        (self.problem == FrictionModel::Associated)
            .then(|| self.frictionless.and_then(|f| f.lower))
            .flatten()
    }

    /// The strict bounds that a verdict is based on. With associated friction the lower bound is
    /// the one without friction. `None` if there is no such bound.
    pub fn safe_bounds(&self) -> (Option<f64>, Option<f64>) {
        if !self.is_strict() {
            return (None, None);
        }
        let lower = match self.problem {
            FrictionModel::Associated => self.safe_lower(),
            _ => self.lower,
        };
        let upper = match self.upper {
            Some(Upper::Finite(u)) => Some(u),
            _ => None,
        };
        (lower, upper)
    }

    /// The strict bounds of the load factor, as in [`CaseResult::safe_bounds`]; none if an energy
    /// is bracketed.
    pub fn factor_bounds(&self) -> (Option<f64>, Option<f64>) {
        match self.quantity {
            Quantity::LoadFactor => self.safe_bounds(),
            Quantity::PotentialEnergy => (None, None),
        }
    }
}

impl CaseResult {
    /// What the strict bounds of the load factor say of the load itself.
    pub fn by_bounds(&self) -> Verdict {
        let (lower, upper) = self.factor_bounds();
        Verdict::of(lower, upper)
    }

    /// How the last solve without a solution ended, that for the lower bound before that for the
    /// upper one: `time limit`.
    pub fn ended_by(&self) -> Option<&Text> {
        let mut ended = self.history.iter().rev().flat_map(|row| {
            let runs = [&row.static_frictionless, &row.static_, &row.kinematic];
            runs.into_iter().flatten().map(|r| &r.status)
        });
        ended.find(|s| !SolveStatus::SOLUTIONS.iter().any(|status| **s == status.words()))
    }

    /// Which strict bound limit analysis did not give, as text with the reason; `None` where it
    /// gave a lower bound or proved that the loads can grow without limit.
    pub fn lacking(&self) -> Option<Text> {
        let bounds = self.factor_bounds();
        let no_limit = matches!(self.upper, Some(Upper::Unbounded(_)));
        if bounds.0.is_some() || no_limit {
            return None;
        }
        let what = if bounds.1.is_some() { "lower bound" } else { "bound" };
        Some(match self.ended_by() {
            Some(status) => say!("limit analysis gave no {} ({})", what, status),
            None => say!("limit analysis gave no {}", what),
        })
    }
}

impl Demand {
    /// The demand of a load case under one kind of analysis. In limit analysis the strict bounds
    /// decide the verdict; a lower bound decides nothing in a joint without the rotation capacity
    /// that limit analysis assumes. No other kind brackets a resistance.
    pub fn new(entry: &CaseResult, actions: Vec<EndAction>, checks: &HandChecks) -> Self {
        let (lower, upper) = entry.safe_bounds();
        let by_analysis = match (entry.quantity, Verdict::of(lower, upper)) {
            (Quantity::LoadFactor, Verdict::Ok) if checks.brittle.is_some() => Verdict::Undecided,
            (Quantity::LoadFactor, verdict) => verdict,
            (Quantity::PotentialEnergy, _) => Verdict::None,
        };
        let component_method =
            checks.comparisons().filter(|c| c.case == entry.name).cloned().collect();
        // only limit analysis needs rotation capacity
        let brittle = checks.brittle.clone().filter(|_| entry.quantity == Quantity::LoadFactor);
        Self {
            verdict: by_analysis,
            route: None,
            by_code: Verdict::None,
            by_analysis,
            actions,
            component_method,
            brittle,
            steps: Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::result::fixtures::limit_case;
    use crate::result::history::ProgramRun;

    /// If no rule of rotation capacity holds, a strict lower bound above 1 decides nothing, while
    /// an upper bound below 1 still refuses the joint. Energies give no verdict, finished or not.
    #[test]
    fn a_lower_bound_decides_nothing_in_a_brittle_joint() {
        let brittle =
            HandChecks { brittle: Some("t is too thick".into()), ..HandChecks::default() };
        let verdict = |checks: &HandChecks, l, u| {
            Demand::new(&limit_case(Some(l), Some(u)), Vec::new(), checks).by_analysis
        };
        assert_eq!(verdict(&HandChecks::default(), 1.1, 1.2), Verdict::Ok);
        assert_eq!(verdict(&brittle, 1.1, 1.2), Verdict::Undecided);
        assert_eq!(verdict(&brittle, 0.8, 0.9), Verdict::NotOk);
        for (lower, upper) in [(Some(1.1), Some(1.2)), (None, None)] {
            let case =
                CaseResult { quantity: Quantity::PotentialEnergy, ..limit_case(lower, upper) };
            let elastic = Demand::new(&case, Vec::new(), &brittle);
            assert_eq!((elastic.by_analysis, elastic.brittle), (Verdict::None, None));
        }
    }

    /// A bound that is missing is named with the end of its solver.
    #[test]
    fn a_missing_bound_is_named_with_its_cause() {
        let run = |status: &'static str| {
            Some(ProgramRun { status: status.into(), ..ProgramRun::default() })
        };
        let row = HistoryRow {
            kinematic: run("optimal"),
            static_: run("time limit"),
            ..HistoryRow::default()
        };
        let of = |l, u| CaseResult { history: vec![row.clone()], ..limit_case(l, u) }.lacking();
        assert_eq!(
            of(None, Some(1.2)).map(|t| t.to_string()).as_deref(),
            Some("limit analysis gave no lower bound (time limit)")
        );
        assert_eq!(of(None, None), Some("limit analysis gave no bound (time limit)".into()));
        assert_eq!(of(Some(0.9), None), None);
        let estimate = CaseResult { certificate: None, ..limit_case(Some(1.2), Some(1.3)) };
        assert_eq!(estimate.lacking(), Some("limit analysis gave no bound".into()));
    }
}
