//! The reason of a verdict, in a sentence.

use super::analysed::Analysed;
use super::governing::Governing;
use crate::check::Check;
use crate::verdict::{Route, Verdict};
use bracket_base::say;
use bracket_base::words::Text;

/// What would supply a missing lower bound.
const FINISH: &str = "more time (`time_limit`), more memory or a coarser mesh (a larger \
                      `--size-factor`)";

/// What would narrow a bracket.
const NARROW: &str = "narrower bounds by more meshes or time (`max_passes`, `time_limit`), or a \
                      finer mesh (a smaller `--size-factor`)";

/// What would give a lower bound its weight.
const RULE: &str = "a thinner plate or stronger bolts, so that a rule of rotation capacity holds";

/// The reason of the verdict on a load case; `open`: the undecided checks, the one that governs
/// first.
pub(super) fn sentence(
    a: &Analysed,
    (by_code, open): (Verdict, &[&Check]),
    (verdict, route): (Verdict, Option<Route>),
    governing: Option<&Governing>,
) -> Text {
    let (case, by_analysis) = (&a.case, a.verdict);
    let what = governing.map_or_else(|| "nothing that could be checked".into(), Governing::words);
    match (verdict, by_code, by_analysis) {
        (Verdict::Ok, ..) if route == Some(Route::Code) && by_analysis == Verdict::Ok => say!(
            "{}: every binding check holds, and the lower bound carries the load; governing: {}",
            case,
            what
        ),
        (Verdict::Ok, ..) if route == Some(Route::Code) => {
            say!("{}: every binding check holds; governing: {}{}", case, what, beside(a))
        }
        (Verdict::Ok, ..) if a.route_holds() => {
            say!("{}: every step of the route of analysis holds: {}", case, steps(a))
        }
        (Verdict::Ok, Verdict::Ok, _) => say!(
            "{}: the lower bound carries the load in place of the component method, and every \
             check of what limit analysis does not know holds; governing: {}",
            case,
            what
        ),
        // a case without checks is only carried by the route of analysis
        (Verdict::Ok, ..) => say!("{}: the lower bound carries the load", case),
        (Verdict::NotOk, Verdict::NotOk, Verdict::Ok) => say!(
            "{}: the lower bound carries the load, but a check of what limit analysis does not \
             know fails: {}",
            case,
            what
        ),
        (Verdict::NotOk, Verdict::NotOk, _) => say!("{}: a check fails: {}", case, what),
        (Verdict::NotOk, ..) => say!("{}: the load is above the upper bound: {}", case, what),
        (Verdict::Undecided, ..) => undecided(a, open, what),
        (Verdict::None, ..) => {
            say!("{}: a load case of serviceability, of which nothing is checked", case)
        }
    }
}

/// The reason of an undecided case, with what would decide it.
fn undecided(a: &Analysed, open: &[&Check], what: Text) -> Text {
    let first = first_open(a, open.first().copied(), what);
    let mut others: Vec<Text> = Vec::new();
    for check in open.iter().skip(1) {
        let title = check.title.text();
        if open[0].title != check.title && !others.contains(&title) {
            others.push(title);
        }
    }
    match others.is_empty() {
        true => first,
        false => say!("{}; also open: {}", first, Text::joined(", ", others)),
    }
}

/// The first thing that leaves a case undecided, with what would decide it.
fn first_open(a: &Analysed, open: Option<&Check>, what: Text) -> Text {
    let (case, state) = (&a.case, state(a));
    if let Some(step) = a.first_open().filter(|_| open.is_none_or(Check::is_without_method)) {
        let next = step.next.clone().unwrap_or_default();
        let title: Text = step.step.title().into();
        return match open {
            Some(check) => say!(
                "{}: the code has no method for {}; the route of analysis lacks a step, {}: {}; \
                 what would decide it: {}",
                case,
                check.title.text(),
                title,
                &step.finding,
                next
            ),
            None => say!(
                "{}: no check of the code covers the load; the route of analysis lacks a step, {}: \
                 {}; what would decide it: {}",
                case,
                title,
                &step.finding,
                next
            ),
        };
    }
    let Some(check) = open else {
        return say!(
            "{}: no check of the code covers the load; {}; what would decide it: {}",
            case,
            state,
            supply(a)
        );
    };
    let (why, supply) = match check.open() {
        // without a limit analysis there are no steps of its route
        Some((why, step)) if check.is_without_method() && a.steps.is_empty() => {
            (why, say!("{}; or the route of analysis (`bracket run`, `kind: limit`)", step))
        }
        Some((why, step)) => (why, step.clone()),
        None => (check.formula(), supply(a).into()),
    };
    match check.utilisation {
        // a value with its derivation is in the check
        Some(_) => say!(
            "{}: not decided by the code: {}; {}; what would decide it: {}",
            case,
            what,
            state,
            supply
        ),
        None => say!(
            "{}: not decided by the code: {}: {}; {}; what would decide it: {}",
            case,
            what,
            why,
            state,
            supply
        ),
    }
}

/// What the analyses beside a complete route of the code leave open.
fn beside(a: &Analysed) -> Text {
    match (&a.missing, a.verdict) {
        (Some(missing), _) => say!("; beside it {}", missing),
        (None, Verdict::Undecided) if a.brittle => {
            "; beside it the lower bound carries the load, but no rule of rotation capacity holds"
                .into()
        }
        (None, Verdict::Undecided) => "; beside it the bounds do not decide".into(),
        _ => Text::default(),
    }
}

/// What the analyses of an undecided case have given.
fn state(a: &Analysed) -> Text {
    let words = match (&a.missing, a.verdict) {
        (Some(missing), _) => return missing.clone(),
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
    };
    words.into()
}

/// What would supply a bound that decides.
fn supply(a: &Analysed) -> &'static str {
    match a.verdict {
        _ if a.missing.is_some() => FINISH,
        Verdict::None => "a limit analysis (`kind: limit`)",
        Verdict::Ok => "the route of analysis (`decide: true`)",
        _ if a.no_rule => RULE,
        _ => NARROW,
    }
}

/// The steps of the route with their largest values.
fn steps(a: &Analysed) -> Text {
    let each = a.steps.iter().filter(|s| s.utilisation.is_some());
    Text::joined("; ", each.map(|s| say!("{}, {}", Text::from(s.step.title()), &s.finding)))
}
