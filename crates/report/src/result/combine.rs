//! Combines several passes: the largest lower bound and the smallest upper bound, each with the
//! results that belong to it.

use crate::result::bounds::CaseBounds;
use crate::result::case_result::CaseResult;
use crate::result::case_result::PartYield;
use crate::result::case_result::{PeakPressure, WeldUse};
use crate::result::interface_use::ResultantUse;
use crate::result::quantity::{FrictionModel, Quantity, RawBracket, Upper};
use bracket_engine::certify::bracket::Contradiction;
use bracket_engine::model::AnalysisKind;

/// Result of one pass for a load case: its own entry, and the bounds behind it.
#[derive(Clone, Debug)]
pub struct PassResult {
    /// The entry of `result.json`.
    pub entry: CaseResult,
    /// The bounds with their certificates.
    pub bounds: CaseBounds,
}

/// The passes that give the best bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Best {
    /// Index of the pass with the largest lower bound.
    pub lower: usize,
    /// Index of the pass with the smallest upper bound.
    pub upper: usize,
    /// Index of the pass with the largest strict lower bound without friction, beside an answer
    /// with associated friction; otherwise that with the largest lower bound.
    pub frictionless: usize,
}

/// The best bounds of the passes, which are given in their order; strict bounds take precedence
/// over estimates. `None` if there is no pass.
///
/// If every pass solves its own problem, with shifted contact cones or frozen preloaded cuts,
/// bounds of two passes do not form a bracket. Both bounds are then taken from the pass with the
/// smallest gap.
pub fn best(passes: &[PassResult]) -> Option<Best> {
    let strict = |p: &PassResult| p.entry.is_strict();
    let any = passes.iter().any(strict);
    let counts = |p: &&PassResult| !any || strict(p);
    let apart = |p: &PassResult| {
        p.entry.problem == FrictionModel::ShiftedCones || !p.entry.preload.is_empty()
    };
    if passes.iter().any(apart) {
        let gaps = passes
            .iter()
            .enumerate()
            .filter(|(_, p)| counts(p))
            .filter_map(|(i, p)| Some((p.entry.gap?, i)));
        let narrowest = gaps.min_by(|a, b| a.0.total_cmp(&b.0)).map(|g| g.1);
        let has_bound = |p: &PassResult| p.bounds.lower().is_some() || p.bounds.upper().is_some();
        let bounded = || passes.iter().rposition(|p| counts(&p) && has_bound(p));
        let one = narrowest.or_else(bounded).or_else(|| passes.len().checked_sub(1))?;
        return Some(Best { lower: one, upper: one, frictionless: one });
    }
    // the first of equal bounds wins
    let place = |value: &dyn Fn(&CaseBounds) -> Option<f64>| {
        let mut found: Option<(f64, usize)> = None;
        for (i, p) in passes.iter().enumerate().filter(|(_, p)| counts(p)) {
            if let Some(x) = value(&p.bounds).filter(|x| found.is_none_or(|(y, _)| *x > y)) {
                found = Some((x, i));
            }
        }
        found.map(|f| f.1)
    };
    let lower = place(&CaseBounds::lower);
    let upper = place(&|b| b.upper().and_then(Upper::finite).map(|u| -u));
    let some = lower.or(upper).or_else(|| (!passes.is_empty()).then_some(0))?;
    let (lower, upper) = (lower.unwrap_or(some), upper.unwrap_or(some));
    // the pass of the lower bound if it has the largest one; else the last of equals, whose fields
    // are still there: those of earlier ones went when another pass had the same
    let of_answer = passes[lower].entry.safe_lower();
    let mut frictionless = (of_answer, lower);
    for (i, p) in passes.iter().enumerate() {
        let safe = p.entry.safe_lower();
        if safe > of_answer && safe >= frictionless.0 {
            frictionless = (safe, i);
        }
    }
    Some(Best { lower, upper, frictionless: frictionless.1 })
}

/// One entry with the upper bound of the first and the lower bound of the second pass. Both passes
/// must be of the same structure.
pub fn join(upper: PassResult, lower: PassResult) -> Result<CaseResult, Contradiction> {
    let joined = upper.bounds.join(&lower.bounds)?;
    let sides = (
        upper.bounds.upper_certificate().or(upper.entry.certificate),
        lower.bounds.lower_certificate().or(lower.entry.certificate),
    );
    let (upper, lower) = (upper.entry, lower.entry);
    let raw = |l: Option<RawBracket>, u: Option<RawBracket>| {
        let joined = RawBracket { lower: l.and_then(|l| l.lower), upper: u.and_then(|u| u.upper) };
        (l.is_some() || u.is_some()).then_some(joined)
    };
    // a field that gives no bound of the answer has no part in its certificate
    let certificate = match sides {
        (Some(u), Some(l)) => Some(u.with(&l)),
        (u, l) => u.or(l),
    };
    let strict = certificate.is_some_and(|c| c.strict);
    let gap = joined.and_then(|b| b.gap);
    let estimated = upper.quantity == Quantity::PotentialEnergy && !strict;
    let load = upper.load.or(lower.load).filter(|_| !estimated);
    let load_displacement = match (joined, load) {
        (Some(b), Some(f)) if upper.analysis == AnalysisKind::Elastic => {
            Some([-2.0 * b.upper / f.value(), -2.0 * b.lower / f.value()])
        }
        _ => None,
    };
    let peak = (upper.peak_contact_pressure, lower.peak_contact_pressure);
    let peak_contact_pressure = match peak {
        (None, None) => None,
        (u, l) => Some(PeakPressure {
            kinematic: u.and_then(|p| p.kinematic),
            static_: l.and_then(|p| p.static_),
        }),
    };
    // values computed from a stress belong to the lower bound, those computed from a motion to the
    // upper one
    let stress_of =
        |name: &str| lower.yielding.iter().find(|l| l.part == name).and_then(|l| l.utilisation);
    let yielding = upper
        .yielding
        .into_iter()
        .map(|u| PartYield { utilisation: stress_of(&u.part), ..u })
        .collect();
    let used = |name: &str| lower.welds.iter().find(|l| l.weld == name);
    let weld = |u: WeldUse| WeldUse {
        utilisation: used(&u.weld).and_then(|l| l.utilisation),
        mean_utilisation: used(&u.weld).and_then(|l| l.mean_utilisation),
        ..u
    };
    let welds = upper.welds.into_iter().map(weld).collect();
    let limited = |name: &str| lower.resultants.iter().find(|l| l.limit == name);
    let resultant = |u: ResultantUse| ResultantUse {
        force: limited(&u.limit).and_then(|l| l.force),
        utilisation: limited(&u.limit).and_then(|l| l.utilisation),
        ..u
    };
    let resultants = upper.resultants.into_iter().map(resultant).collect();
    let mut warnings = upper.warnings;
    for w in lower.warnings {
        if !warnings.contains(&w) {
            warnings.push(w);
        }
    }
    Ok(CaseResult {
        lower: lower.lower,
        gap,
        load,
        load_displacement,
        certificate,
        frictionless: raw(lower.frictionless, upper.frictionless),
        associated: raw(lower.associated, upper.associated),
        limiting_part: lower.limiting_part,
        yielding,
        welds,
        resultants,
        peak_contact_pressure,
        warnings,
        ..upper
    })
}
