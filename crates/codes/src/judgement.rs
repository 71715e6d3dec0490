//! The verdict on the demands of a spec: what the complete routes prove, with a reason.
//!
//! NOT OK if a binding check fails or a strict upper bound is below the demand: no route overrules
//! that. OK by code if every check that the code asks of the joint has a method and holds, strength
//! by the component method included, whatever an unfinished or wide bracket says. OK by analysis
//! if the route of analysis is complete ([`crate::route`]) and every binding check that has a
//! method holds; or if the code has a method for all but the strength of the joint, the lower bound
//! of limit analysis carries the load, and every binding check of what limit analysis does not know
//! holds: buckling, fracture, slenderness. Otherwise UNDECIDED.

mod analysed;
mod governing;
mod reason;

pub use analysed::Analysed;
pub use governing::Governing;

use super::check::{Binding, Check, Status};
use super::end_plate::HandChecks;
use super::route::RouteStep;
use super::verdict::{Route, Verdict};
use bracket_base::say;
use bracket_base::words::Text;
use serde::{Deserialize, Serialize};
use std::{iter, ptr};

/// The verdict on a load case, or on all of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Judgement {
    /// What the complete routes prove.
    pub verdict: Verdict,
    /// The route that proves `ok`; absent otherwise. Of several load cases: `analysis` if one of
    /// them needs it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub route: Option<Route>,
    /// By the code's checks.
    pub by_code: Verdict,
    /// By strict bounds, or by the complete route of analysis; none where no analysis brackets a
    /// resistance.
    pub by_analysis: Verdict,
    /// Reason, in a sentence. Of `undecided`: the first missing step, and what would supply it.
    pub reason: Text,
    /// Check or bound that governs; absent where none has a utilisation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub governing: Option<Governing>,
    /// The steps of the route of analysis; of several load cases none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub steps: Vec<RouteStep>,
}

/// Judges each load case, and all of them together. Where a limit analysis decides a case and no
/// component may buckle, strength by the component method becomes information in `checks`.
pub fn judge(checks: &mut HandChecks, cases: &[Analysed]) -> (Judgement, Vec<Judgement>) {
    // with strength by the component method, before an analysis stands in for it
    let complete: Vec<bool> =
        cases.iter().map(|a| by_code(&binding(checks, a)) == Verdict::Ok).collect();
    let decided =
        |a: &&Analysed| matches!(a.verdict, Verdict::Ok | Verdict::NotOk) || a.route_holds();
    for a in cases.iter().filter(decided) {
        checks.beside_analysis(&a.case);
    }
    let each: Vec<Judgement> =
        cases.iter().zip(complete).map(|(a, complete)| of_case(checks, a, complete)).collect();
    let mut all = together(&each, cases);
    let service = |a: &Analysed| checks.serviceability.contains(&a.case);
    if matches!(all.verdict, Verdict::Ok | Verdict::None) && cases.iter().all(service) {
        all.verdict = Verdict::Undecided;
        all.route = None;
        all.reason = "Every load case is one of serviceability: give one with `state: ULS`".into();
        all.governing = None;
    }
    (all, each)
}

/// The checks that can decide the verdict on a load case.
fn binding<'a>(checks: &'a HandChecks, a: &Analysed) -> Vec<&'a Check> {
    let of_case = |c: &&Check| c.case.as_ref().is_none_or(|case| *case == a.case);
    checks.checks.iter().filter(of_case).filter(|c| binds(c)).collect()
}

/// The verdict by these checks.
fn by_code(binding: &[&Check]) -> Verdict {
    // without any check of the load there is no verdict by code, but a check that fails without a
    // load still fails
    let loaded = binding.iter().any(|c| c.case.is_some());
    let word = |c: &&Check| match c.status {
        Status::Failed => Verdict::NotOk,
        Status::Undecided => Verdict::Undecided,
        _ => Verdict::Ok,
    };
    match Verdict::worst(binding.iter().map(word)) {
        Verdict::Ok if !loaded => Verdict::None,
        verdict => verdict,
    }
}

/// The verdict on one load case. `complete`: the code's route is complete and holds.
fn of_case(checks: &HandChecks, a: &Analysed, complete: bool) -> Judgement {
    let mut binding = binding(checks, a);
    let shown = a.route_holds();
    let unanswered = |c: &&Check| !(shown && c.is_without_method());
    let rest = self::by_code(&binding.iter().copied().filter(unanswered).collect::<Vec<_>>());
    let by_code = if complete { Verdict::Ok } else { by_code(&binding) };
    let service = checks.serviceability.contains(&a.case);
    let (verdict, route) = match (by_code, a.verdict) {
        (Verdict::NotOk, _) | (_, Verdict::NotOk) => (Verdict::NotOk, None),
        _ if complete => (Verdict::Ok, Some(Route::Code)),
        _ if shown && rest != Verdict::Undecided => (Verdict::Ok, Some(Route::Analysis)),
        (Verdict::Ok, Verdict::Ok) => (Verdict::Ok, Some(Route::Analysis)),
        // of a case at serviceability only slip is checked, if anything
        (Verdict::None, _) if service => (Verdict::None, None),
        _ => (Verdict::Undecided, None),
    };
    if verdict == Verdict::Ok {
        binding.retain(unanswered);
    }
    let check = governing_check(&binding, if verdict == Verdict::Ok { rest } else { by_code });
    let code = check.map(Governing::by_check);
    let analysis = (a.verdict != Verdict::None).then(|| Governing {
        case: Some(a.case.clone()),
        what: "load factor at collapse".into(),
        clause: "limit analysis".into(),
        utilisation: a.utilisation,
    });
    // where both verdicts are equal, the larger utilisation governs
    let used = |g: &Option<Governing>| g.as_ref().and_then(|g| g.utilisation).map_or(0.0, |u| u[1]);
    let more = verdict != Verdict::Undecided && used(&analysis) > used(&code);
    let by_bracket = by_code != verdict || (a.verdict == verdict && more);
    let governing = if by_bracket { analysis.or(code) } else { code };
    let undecided = |c: &&Check| c.status == Status::Undecided;
    let others = binding.iter().copied().filter(undecided);
    let open: Vec<&Check> = match check.filter(undecided) {
        Some(first) => iter::once(first).chain(others.filter(|c| !ptr::eq(*c, first))).collect(),
        None => Vec::new(),
    };
    let reason = reason::sentence(a, (by_code, &open), (verdict, route), governing.as_ref());
    // the steps stand for the rule of rotation capacity that the bounds alone lack
    let by_analysis = match a.verdict {
        Verdict::Undecided if shown => Verdict::Ok,
        by_bounds => by_bounds,
    };
    let steps = a.steps.clone();
    Judgement { verdict, route, by_code, by_analysis, reason, governing, steps }
}

/// The verdict on all cases, with the reason of the worst one and the names of those without a
/// lower bound.
fn together(each: &[Judgement], cases: &[Analysed]) -> Judgement {
    let worst = |of: fn(&Judgement) -> Verdict| Verdict::worst(each.iter().map(of));
    let verdict = worst(|j| j.verdict);
    let used = |j: &Judgement| {
        j.governing.as_ref().and_then(|g| g.utilisation).map_or(f64::INFINITY, |u| u[1])
    };
    let speaker = (0..each.len())
        .filter(|&i| each[i].verdict == verdict)
        .reduce(|a, b| if used(&each[b]) > used(&each[a]) { b } else { a });
    let mut reason = speaker.map_or_else(Text::default, |i| each[i].reason.clone());
    let others =
        cases.iter().enumerate().filter(|(i, a)| Some(*i) != speaker && a.missing.is_some());
    let others: Vec<&str> = others.map(|(_, a)| a.case.as_str()).collect();
    if !others.is_empty() {
        reason = say!("{}; without a lower bound: {}", reason, others.join(", "));
    }
    let mut routes = each.iter().filter_map(|j| j.route);
    let proved = verdict == Verdict::Ok;
    let by_bounds = routes.any(|r| r == Route::Analysis);
    let route = if by_bounds { Route::Analysis } else { Route::Code };
    Judgement {
        verdict,
        route: proved.then_some(route),
        by_code: worst(|j| j.by_code),
        by_analysis: worst(|j| j.by_analysis),
        reason,
        governing: speaker.and_then(|i| each[i].governing.clone()),
        steps: Vec::new(),
    }
}

/// Whether a check can decide a verdict.
fn binds(c: &Check) -> bool {
    c.binding != Binding::Information && !matches!(c.status, Status::Information | Status::Warning)
}

/// The check that governs a verdict by code: a strength rather than a least length, with the
/// largest utilisation.
fn governing_check<'a>(binding: &[&'a Check], by_code: Verdict) -> Option<&'a Check> {
    let status = match by_code {
        Verdict::NotOk => Status::Failed,
        Verdict::Undecided => Status::Undecided,
        Verdict::Ok | Verdict::None => Status::Ok,
    };
    // a least distance that is kept does not describe the strength
    let speaks =
        |c: &&&Check| c.status == status && (status != Status::Ok || c.measures_strength());
    // a resistance of zero says less than the check whose number fails beside it
    let without = if status == Status::Failed { 0.0 } else { f64::INFINITY };
    let used = |c: &Check| c.utilisation.unwrap_or(without);
    let speaking = binding.iter().copied().filter(|c| speaks(&c));
    speaking.reduce(|a, b| if used(b) > used(a) { b } else { a })
}

impl Judgement {
    /// The verdict as a report prints it, with the route that proves it.
    pub fn words(&self) -> &'static str {
        self.verdict.words_by(self.route)
    }

    /// The verdict of a run in one line.
    pub fn line(&self, code: u8, meaning: Option<&str>) -> String {
        let governs = match self.governing.as_ref().filter(|_| self.verdict != Verdict::Undecided) {
            Some(g) => {
                let case = g.case.as_ref().map_or_else(String::new, |c| format!("{c}, "));
                format!("; governing: {case}{}", g.words())
            }
            None => format!("; {}", self.reason),
        };
        format!(
            "verdict: {} (by code {}, by analysis {}){governs}; exit code {code}: {}",
            self.words(),
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
            |c: &&mut Check| c.binding == Binding::Strength && c.case.as_deref() == Some(case);
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
