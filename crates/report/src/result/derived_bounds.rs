//! Bounds of a load case that follow from the limit analyses of others, without one of its own.

use crate::result::case_result::CaseResult;
use crate::result::certificate::Certificate;
use crate::result::proved_by::ProvedBy;
use crate::result::quantity::{FrictionModel, Quantity, RawBracket, Upper};
use bracket_engine::certify::combination::{Part, combined};
use bracket_engine::certify::half_space::{Actions, HalfSpace};
use bracket_engine::model::AnalysisKind;

/// A limit analysis from which bounds of other load cases follow.
#[derive(Clone, Debug)]
pub struct Run {
    /// Its entry.
    pub entry: CaseResult,
    /// The live actions of its model.
    pub actions: Actions,
    /// What its mechanism proves of other actions.
    pub half_space: Option<HalfSpace>,
}

impl Run {
    /// The strict lower bound of its load factor.
    pub fn lower(&self) -> Option<f64> {
        self.entry.factor_bounds().0
    }
}

/// The entry of a load case whose bounds come from `runs` by `proved_by`; `actions`: those of the
/// case. `None` where they prove less than it claims.
pub fn derived_case(
    name: &str,
    actions: &[[f64; 6]],
    proved_by: ProvedBy,
    runs: &[Run],
) -> Option<CaseResult> {
    let run = |name: &String| runs.iter().find(|r| r.entry.name == *name);
    let used: Vec<&Run> =
        proved_by.lower.iter().map(|w| run(&w.analysis)).collect::<Option<_>>()?;
    let mut parts = Vec::new();
    for (w, r) in proved_by.lower.iter().zip(&used) {
        parts.push(Part { actions: &r.actions, factor: r.lower()?, weight: w.weight });
    }
    let lower = match parts.is_empty() {
        true => None,
        false => Some(combined(&parts, actions)?),
    };
    let mechanism = match &proved_by.upper {
        Some(name) => Some(run(name)?),
        None => None,
    };
    let upper = match mechanism {
        Some(r) => Some(r.half_space.as_ref()?.factor(actions)?),
        None => None,
    };
    let all = used.iter().copied().chain(mechanism);
    let certificates = all.filter_map(|r| r.entry.certificate);
    let certificate = certificates.reduce(|a, b| Certificate::with(&a, &b));
    let problem = runs.first().map_or(FrictionModel::Frictionless, |r| r.entry.problem);
    // the stresses that add up are those without friction
    let frictionless = (problem == FrictionModel::Associated && lower.is_some())
        .then_some(RawBracket { lower, upper: None });
    let gap = lower.zip(upper).map(|(l, u)| (u - l) / l).filter(|g| g.is_finite());
    Some(CaseResult {
        lower,
        upper: upper.map(Upper::Finite),
        gap,
        certificate,
        frictionless,
        proved_by: Some(proved_by),
        ..CaseResult::empty(name, AnalysisKind::Limit, (Quantity::LoadFactor, problem))
    })
}
