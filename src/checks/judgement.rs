//! The verdict on the demands of a spec: by code, by analysis, and the two combined with a reason.
//!
//! By code: every binding check, and the strength part of the component method where no limit
//! analysis decides the case. By analysis: the strict bracket of the load factor. The combined
//! verdict is the worse of the two, so that a bound never overrules a check of what limit analysis
//! does not model: buckling, fracture, slenderness.

use super::check::{Check, Status, Topic, Unit, number};
use super::end_plate::HandChecks;
use super::verdict::Verdict;
use serde::{Deserialize, Serialize};

/// Result of the analyses of a load case.
#[derive(Clone, Debug, PartialEq)]
pub struct Analysed {
    /// Load case with a demand.
    pub case: String,
    /// Verdict by strict bounds of limit analysis: `None` for an analysis that brackets no
    /// resistance, undecided where the requested analysis gave no certificate.
    pub verdict: Verdict,
    /// Bracket of demand over capacity.
    pub utilisation: Option<[f64; 2]>,
    /// Whether bounds that would decide do not, because no rule of rotation capacity holds.
    pub brittle: bool,
    /// Whether no rule of rotation capacity holds, so that no lower bound can give OK.
    pub no_rule: bool,
}

impl Analysed {
    /// A case that no analysis brackets.
    pub fn not(case: impl Into<String>) -> Self {
        Self {
            case: case.into(),
            verdict: Verdict::None,
            utilisation: None,
            brittle: false,
            no_rule: false,
        }
    }
}

/// Check or bound that decides a verdict.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Governing {
    /// The load case; absent for a check that needs no load.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub case: Option<String>,
    /// Check and place, in words.
    pub what: String,
    /// Clause, or `limit analysis`.
    pub clause: String,
    /// Demand over resistance, lower and upper bound; both equal for a hand check, absent where
    /// there is no number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<[f64; 2]>,
}

/// The verdict on a load case, or on all of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Judgement {
    /// The worse of the two verdicts.
    pub verdict: Verdict,
    /// By the code's checks.
    pub by_code: Verdict,
    /// By strict bounds; none where no analysis brackets a resistance.
    pub by_analysis: Verdict,
    /// Reason, in a sentence.
    pub reason: String,
    /// Check or bound that governs; absent where none has a utilisation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub governing: Option<Governing>,
}

/// Judges each load case, and all of them together. Where a limit analysis decides a case and no
/// component may buckle, strength by the component method becomes information in `checks`.
pub fn judge(checks: &mut HandChecks, cases: &[Analysed]) -> (Judgement, Vec<Judgement>) {
    for a in cases.iter().filter(|a| matches!(a.verdict, Verdict::Ok | Verdict::NotOk)) {
        checks.beside_analysis(&a.case);
    }
    let each: Vec<Judgement> = cases.iter().map(|a| of_case(checks, a)).collect();
    let mut all = together(&each);
    let service = |a: &Analysed| checks.serviceability.contains(&a.case);
    if matches!(all.verdict, Verdict::Ok | Verdict::None) && cases.iter().all(service) {
        all.verdict = Verdict::Undecided;
        all.reason = "Every load case is one of serviceability: give one with `state: ULS`".into();
        all.governing = None;
    }
    (all, each)
}

/// The verdict on one load case.
fn of_case(checks: &HandChecks, a: &Analysed) -> Judgement {
    let binding: Vec<&Check> = checks
        .checks
        .iter()
        .filter(|c| c.case.as_ref().is_none_or(|case| *case == a.case) && binds(c))
        .collect();
    // without any check of the load there is no verdict by code, but a check that fails without a
    // load still fails
    let loaded = binding.iter().any(|c| c.case.is_some());
    let word = |c: &&Check| match c.status {
        Status::Failed => Verdict::NotOk,
        Status::Undecided => Verdict::Undecided,
        _ => Verdict::Ok,
    };
    let by_code = match Verdict::worst(binding.iter().map(word)) {
        Verdict::Ok if !loaded => Verdict::None,
        verdict => verdict,
    };
    let service = checks.serviceability.contains(&a.case);
    let verdict = match Verdict::worst([by_code, a.verdict]) {
        // of a case at serviceability only slip is checked, if anything
        Verdict::None if service => Verdict::None,
        Verdict::None => Verdict::Undecided,
        verdict => verdict,
    };
    let code = governing_check(&binding, by_code);
    let analysis = (a.verdict != Verdict::None).then(|| Governing {
        case: Some(a.case.clone()),
        what: "load factor at collapse".into(),
        clause: "limit analysis".into(),
        utilisation: a.utilisation,
    });
    // where both verdicts are equal, the larger utilisation governs
    let used = |g: &Option<Governing>| g.as_ref().and_then(|g| g.utilisation).map_or(0.0, |u| u[1]);
    // the numbers of a bracket that rotation capacity rules out govern nothing
    let more = used(&analysis) > used(&code) && !a.brittle;
    let by_bracket = by_code != verdict || (a.verdict == verdict && more);
    let governing = if by_bracket { analysis.clone().or(code.clone()) } else { code.clone() };
    let reason = reason(a, by_code, verdict, governing.as_ref());
    Judgement { verdict, by_code, by_analysis: a.verdict, reason, governing }
}

/// The verdict on all cases, with the reason of the worst one.
fn together(each: &[Judgement]) -> Judgement {
    let worst = |of: fn(&Judgement) -> Verdict| Verdict::worst(each.iter().map(of));
    let verdict = worst(|j| j.verdict);
    let used = |j: &&Judgement| {
        j.governing.as_ref().and_then(|g| g.utilisation).map_or(f64::INFINITY, |u| u[1])
    };
    let speaker = each
        .iter()
        .filter(|j| j.verdict == verdict)
        .reduce(|a, b| if used(&b) > used(&a) { b } else { a });
    Judgement {
        verdict,
        by_code: worst(|j| j.by_code),
        by_analysis: worst(|j| j.by_analysis),
        reason: speaker.map_or_else(String::new, |j| j.reason.clone()),
        governing: speaker.and_then(|j| j.governing.clone()),
    }
}

/// Whether a check can decide a verdict.
fn binds(c: &Check) -> bool {
    !matches!(c.status, Status::Information | Status::Warning)
}

/// The check that governs a verdict by code: a strength rather than a least length, with the
/// largest utilisation.
fn governing_check(binding: &[&Check], by_code: Verdict) -> Option<Governing> {
    let status = match by_code {
        Verdict::NotOk => Status::Failed,
        Verdict::Undecided => Status::Undecided,
        Verdict::Ok | Verdict::None => Status::Ok,
    };
    // a least distance that is kept does not describe the strength
    let speaks = |c: &&&Check| {
        c.status == status && (status != Status::Ok || (c.case.is_some() && c.unit != Unit::Length))
    };
    let used = |c: &Check| c.utilisation.unwrap_or(f64::INFINITY);
    let c = binding.iter().filter(speaks).reduce(|a, b| if used(b) > used(a) { b } else { a })?;
    Some(Governing {
        case: c.case.clone(),
        what: format!("{}, {}", c.title, c.subject),
        clause: c.clause.clone(),
        utilisation: c.utilisation.map(|u| [u, u]),
    })
}

/// The reason of a verdict, in a sentence.
fn reason(
    a: &Analysed,
    by_code: Verdict,
    verdict: Verdict,
    governing: Option<&Governing>,
) -> String {
    let (case, by_analysis) = (&a.case, a.verdict);
    let what = governing.map_or_else(|| "nothing that could be checked".into(), Governing::words);
    match (verdict, by_code, by_analysis) {
        (Verdict::Ok, Verdict::Ok, Verdict::Ok) => {
            format!(
                "{case}: every binding check holds, and the lower bound carries the load; \
                 governing: {what}"
            )
        }
        (Verdict::Ok, Verdict::Ok, _) => {
            format!(
                "{case}: every binding check holds, the component method included; governing: \
                 {what}"
            )
        }
        (Verdict::Ok, ..) => {
            format!("{case}: the lower bound carries the load; no check of the code covers it")
        }
        (Verdict::NotOk, Verdict::NotOk, Verdict::Ok) => format!(
            "{case}: the lower bound carries the load, but a check of what limit analysis does \
             not know fails: {what}"
        ),
        (Verdict::NotOk, Verdict::NotOk, _) => format!("{case}: a check fails: {what}"),
        (Verdict::NotOk, ..) => format!("{case}: the load is above the upper bound: {what}"),
        (Verdict::Undecided, Verdict::Undecided, Verdict::Ok) => format!(
            "{case}: the lower bound carries the load, but the code gives no resistance for what \
             limit analysis does not know: {what}"
        ),
        (Verdict::Undecided, Verdict::Undecided, _) => {
            format!("{case}: the code gives no resistance: {what}")
        }
        (Verdict::Undecided, _, Verdict::Undecided) if a.brittle => format!(
            "{case}: the lower bound carries the load, but no rule of rotation capacity holds; \
             the checks of the code are {}",
            by_code.words()
        ),
        (Verdict::Undecided, _, Verdict::Undecided) if a.no_rule => format!(
            "{case}: the bounds do not decide, and no rule of rotation capacity holds, so that no \
             mesh gives OK; the checks of the code are {}",
            by_code.words()
        ),
        (Verdict::Undecided, _, Verdict::Undecided) => {
            format!(
                "{case}: the bounds do not decide; the checks of the code are {}",
                by_code.words()
            )
        }
        (Verdict::None, ..) => {
            format!("{case}: a load case of serviceability, of which nothing is checked")
        }
        _ => format!("{case}: no check of the code covers the load, and no limit analysis was run"),
    }
}

impl Governing {
    /// The governing check with its utilisation and clause.
    pub fn words(&self) -> String {
        let used = match self.utilisation {
            Some([l, u]) if l == u => format!(", utilisation {}", number(u)),
            Some(between) => {
                let [l, u] = outwards(between).map(number);
                format!(", utilisation {l} … {u}")
            }
            None => String::new(),
        };
        format!("{}{used} ({})", self.what, self.clause)
    }
}

/// A bracket with three digits, rounded outwards.
fn outwards([low, up]: [f64; 2]) -> [f64; 2] {
    /// A product that is a whole number but for rounding error is one.
    const WHOLE: f64 = 1e-9;
    let scale = |x: f64| 10f64.powf(2.0 - x.log10().floor());
    let sized = |x: f64| x.is_finite() && x > 0.0;
    [
        if sized(low) { (low * scale(low) + WHOLE).floor() / scale(low) } else { low },
        if sized(up) { (up * scale(up) - WHOLE).ceil() / scale(up) } else { up },
    ]
}

impl Judgement {
    /// The verdict of a run in one line.
    pub fn line(&self, code: u8, meaning: Option<&str>) -> String {
        let governs = self.governing.as_ref().map_or_else(
            || format!("; {}", self.reason),
            |g| {
                let case = g.case.as_ref().map_or_else(String::new, |c| format!("{c}, "));
                format!("; governing: {case}{}", g.words())
            },
        );
        format!(
            "verdict: {} (by code {}, by analysis {}){governs}; exit code {code}: {}",
            self.verdict.words(),
            self.by_code.words(),
            self.by_analysis.words(),
            meaning.unwrap_or_else(|| exit_meaning(code))
        )
    }
}

/// Meaning of an exit code of a run with a verdict (docs/contract.md).
fn exit_meaning(code: u8) -> &'static str {
    match code {
        0 => "verified",
        1 => "verified not OK",
        3 => "undecided",
        _ => "no result",
    }
}

impl HandChecks {
    /// Turns strength by the component method into information in a case that a limit analysis
    /// decides, unless a component may buckle.
    fn beside_analysis(&mut self, case: &str) {
        if self.unstable.iter().any(|c| c == case) {
            return;
        }
        let of_case =
            |c: &&mut Check| c.topic == Topic::ComponentMethod && c.case.as_deref() == Some(case);
        for c in self.checks.iter_mut().filter(of_case) {
            c.status = match c.status {
                Status::Failed => Status::Warning,
                Status::Ok => Status::Information,
                other => other,
            };
        }
    }
}

#[cfg(test)]
mod tests;
