//! The reason of a verdict, in a sentence.

use super::analysed::Analysed;
use super::governing::Governing;
use crate::check::Check;
use crate::formula::DECIDED_BY;
use crate::verdict::{Route, Verdict};

/// What would supply a missing lower bound.
const FINISH: &str = "more time (`time_limit`), more memory or a coarser mesh (a larger \
                      `--size-factor`)";

/// What would narrow a bracket.
const NARROW: &str = "narrower bounds by more meshes or time (`max_passes`, `time_limit`), or a \
                      finer mesh (a smaller `--size-factor`)";

/// What would give a lower bound its weight.
const RULE: &str = "a thinner plate or stronger bolts, so that a rule of rotation capacity holds";

/// The reason of the verdict on a load case; `open`: the undecided check that governs.
pub(super) fn sentence(
    a: &Analysed,
    (by_code, open): (Verdict, Option<&Check>),
    (verdict, route): (Verdict, Option<Route>),
    governing: Option<&Governing>,
) -> String {
    let (case, by_analysis) = (&a.case, a.verdict);
    let what = governing.map_or_else(|| "nothing that could be checked".into(), Governing::words);
    match (verdict, by_code, by_analysis) {
        (Verdict::Ok, ..) if route == Some(Route::Code) && by_analysis == Verdict::Ok => format!(
            "{case}: every binding check holds, and the lower bound carries the load; governing: \
             {what}"
        ),
        (Verdict::Ok, ..) if route == Some(Route::Code) => format!(
            "{case}: every binding check holds, the component method included; governing: \
             {what}{}",
            beside(a)
        ),
        (Verdict::Ok, Verdict::Ok, _) => format!(
            "{case}: the lower bound carries the load in place of the component method, and every \
             check of what limit analysis does not know holds; governing: {what}"
        ),
        (Verdict::Ok, ..) => {
            format!("{case}: the lower bound carries the load; no check of the code covers it")
        }
        (Verdict::NotOk, Verdict::NotOk, Verdict::Ok) => format!(
            "{case}: the lower bound carries the load, but a check of what limit analysis does \
             not know fails: {what}"
        ),
        (Verdict::NotOk, Verdict::NotOk, _) => format!("{case}: a check fails: {what}"),
        (Verdict::NotOk, ..) => format!("{case}: the load is above the upper bound: {what}"),
        (Verdict::Undecided, ..) => {
            let (step, supply) = match open {
                Some(check) => {
                    let (why, supply) =
                        check.open().unwrap_or_else(|| (check.formula(), supply(a)));
                    // a value with its derivation is in the check
                    let why = match check.utilisation {
                        Some(_) => String::new(),
                        None => format!(": {why}"),
                    };
                    (format!("not decided by the code: {what}{why}"), supply)
                }
                None => ("no check of the code covers the load".into(), supply(a)),
            };
            format!("{case}: {step}; {}; {DECIDED_BY}: {supply}", state(a))
        }
        (Verdict::None, ..) => {
            format!("{case}: a load case of serviceability, of which nothing is checked")
        }
    }
}

/// What the analyses beside a complete route of the code leave open.
fn beside(a: &Analysed) -> String {
    match (&a.missing, a.verdict) {
        (Some(missing), _) => format!("; beside it {missing}"),
        (None, Verdict::Undecided) if a.brittle => {
            "; beside it the lower bound carries the load, but no rule of rotation capacity holds"
                .into()
        }
        (None, Verdict::Undecided) => "; beside it the bounds do not decide".into(),
        _ => String::new(),
    }
}

/// What the analyses of an undecided case have given.
fn state(a: &Analysed) -> &str {
    match (&a.missing, a.verdict) {
        (Some(missing), _) => missing,
        (None, Verdict::Ok) => {
            "the lower bound carries the load, but replaces no check of what limit analysis does \
             not know"
        }
        (None, Verdict::None) => "no limit analysis was run",
        _ if a.brittle => {
            "the lower bound carries the load, but no rule of rotation capacity holds"
        }
        _ if a.no_rule => {
            "the bounds do not decide, and no rule of rotation capacity holds, so that no mesh \
             gives OK"
        }
        _ => "the bounds do not decide",
    }
}

/// What would supply a bound that decides.
fn supply(a: &Analysed) -> &'static str {
    match a.verdict {
        _ if a.missing.is_some() => FINISH,
        Verdict::None => "a limit analysis (`kind: limit`)",
        _ if a.no_rule => RULE,
        _ => NARROW,
    }
}
