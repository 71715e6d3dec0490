//! The result of several passes: the largest lower bound and the smallest upper one, each with all
//! that belongs to it.

use crate::certify::bracket::Contradiction;
use crate::result::data::{
    CaseResult, Certificate, FrictionModel, PartYield, PeakPressure, Quantity, RawBracket, Upper,
};

/// The passes that give the best bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Best {
    /// Whose lower bound is the largest.
    pub lower: usize,
    /// Whose upper bound is the smallest.
    pub upper: usize,
}

/// The best of the entries of passes, in their order; strict bounds before estimates. `None`
/// without any entry.
///
/// Where every pass has a problem of its own, its contact cones shifted or its preloaded cuts
/// frozen, bounds of two passes bracket nothing: then both are of the pass with the smallest gap.
pub fn best(entries: &[CaseResult]) -> Option<Best> {
    let strict = |c: &CaseResult| c.certificate.is_some_and(|x| x.strict);
    let any = entries.iter().any(strict);
    let counts = |c: &&CaseResult| !any || strict(c);
    let apart = |c: &CaseResult| c.problem == FrictionModel::ShiftedCones || !c.preload.is_empty();
    if entries.iter().any(apart) {
        let gaps = entries
            .iter()
            .enumerate()
            .filter(|(_, c)| counts(c))
            .filter_map(|(i, c)| Some((c.gap?, i)));
        let narrowest = gaps.min_by(|a, b| a.0.total_cmp(&b.0)).map(|g| g.1);
        let bounded =
            || entries.iter().rposition(|c| counts(&c) && (c.lower.is_some() || c.upper.is_some()));
        let one = narrowest.or_else(bounded).or_else(|| entries.len().checked_sub(1))?;
        return Some(Best { lower: one, upper: one });
    }
    // of equals the first
    let place = |value: &dyn Fn(&CaseResult) -> Option<f64>| {
        let mut found: Option<(f64, usize)> = None;
        for (i, c) in entries.iter().enumerate().filter(|(_, c)| counts(c)) {
            if let Some(x) = value(c).filter(|x| found.is_none_or(|(y, _)| *x > y)) {
                found = Some((x, i));
            }
        }
        found.map(|f| f.1)
    };
    let lower = place(&|c| c.lower);
    let upper = place(&|c| c.upper.and_then(Upper::finite).map(|u| -u));
    let some = lower.or(upper).or_else(|| (!entries.is_empty()).then_some(0))?;
    Some(Best { lower: lower.unwrap_or(some), upper: upper.unwrap_or(some) })
}

fn worse(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    [a, b].into_iter().flatten().reduce(f64::max)
}

/// One entry with the upper bound of the first and the lower bound of the second; both are of one
/// structure.
pub fn join(upper: CaseResult, lower: CaseResult) -> Result<CaseResult, Contradiction> {
    let raw = |l: Option<RawBracket>, u: Option<RawBracket>| {
        let joined = RawBracket { lower: l.and_then(|l| l.lower), upper: u.and_then(|u| u.upper) };
        (l.is_some() || u.is_some()).then_some(joined)
    };
    let certificate = match (upper.certificate, lower.certificate) {
        (Some(u), Some(l)) => Some(Certificate {
            strict: u.strict && l.strict,
            equilibrium: l.equilibrium,
            traction_jump: l.traction_jump,
            yield_: l.yield_,
            contact: worse(l.contact, u.contact),
            compatibility: u.compatibility,
            volume: u.volume,
        }),
        (u, l) => u.or(l),
    };
    let numbers = (lower.lower, upper.upper.and_then(Upper::finite));
    let gap = match numbers {
        (Some(l), Some(u)) => {
            if l > u + 1e-9 * l.abs().max(u.abs()) {
                return Err(Contradiction { lower: l, upper: u });
            }
            let scale = if l == 0.0 { u.abs() } else { l.abs() };
            let bracketed = upper.quantity == Quantity::PotentialEnergy || l > 0.0;
            (bracketed && scale > 0.0).then_some((u - l) / scale)
        }
        _ => None,
    };
    let load_displacement =
        match (numbers, upper.load_displacement.or(lower.load_displacement), upper.load) {
            ((Some(l), Some(u)), Some(_), Some(f)) => {
                Some([-2.0 * u / f.value(), -2.0 * l / f.value()])
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
    // what a stress tells is of the lower bound, what a motion tells of the upper one
    let stress_of =
        |name: &str| lower.yielding.iter().find(|l| l.part == name).and_then(|l| l.utilisation);
    let yielding = upper
        .yielding
        .into_iter()
        .map(|u| PartYield { utilisation: stress_of(&u.part), ..u })
        .collect();
    let mut warnings = upper.warnings;
    for w in lower.warnings {
        if !warnings.contains(&w) {
            warnings.push(w);
        }
    }
    Ok(CaseResult {
        lower: lower.lower,
        gap,
        load_displacement,
        certificate,
        frictionless: raw(lower.frictionless, upper.frictionless),
        associated: raw(lower.associated, upper.associated),
        limiting_part: lower.limiting_part,
        yielding,
        peak_contact_pressure,
        warnings,
        ..upper
    })
}
