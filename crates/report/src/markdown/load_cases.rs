//! Many load cases: their envelope, a line for each of them, and every check in its worst one.

use crate::document::Doc;
use crate::document::table::{Table, cells, dash};
use crate::figures::{Rounding, utilisation};
use crate::markdown::report_data::{GivenActions, ReportData};
use crate::result::demand::EndAction;
use crate::result::judged_case::JudgedCase;
use crate::result::result_file::ResultFile;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::subject::{Place, Subject};
use bracket_codes::verdict::Verdict;
use bracket_codes::{Check, CheckId, Status, Unit};
use bracket_joint::spec::loads::Action;
use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};

/// Load cases up to which a report shows every check of each.
const EACH: usize = 12;

/// What the table of [`envelope`] is.
pub(crate) const ENVELOPE: &str = "Largest and smallest value of each action; each row holds the \
                                   actions of one load case, which act together:";
/// What the table of [`lines`] is.
pub(crate) const LINES: &str = "Each load case, the worst first:";

/// What the checks of a report of many load cases are.
pub(crate) const WORST: &str = "Each check stands in its worst load case, the component method \
                                with the β of the least and of the greatest M_j,Rd; result.json \
                                has those of every load case.";

/// Whether a report shows its load cases as a table and each check in its worst one.
pub(crate) fn are_many(data: &ReportData) -> bool {
    data.result.load_cases.len() > EACH
}

/// Of many load cases what a report shows of them: each check in its worst one, and the actions of
/// those. Data of few cases stay as they are.
pub(crate) fn condensed(data: &ReportData) -> Cow<'_, ReportData> {
    if !are_many(data) {
        return Cow::Borrowed(data);
    }
    let mut data = data.clone();
    data.result.checks = in_worst_case(&data.result.checks);
    of_few_betas(&mut data.result);
    let directions = &data.result.directions;
    data.result
        .cases
        .retain(|c| c.proved_by.is_none() && directions.iter().all(|d| d.name != c.name));
    let shown: BTreeSet<&str> =
        data.result.checks.iter().filter_map(|c| c.case.as_deref()).collect();
    data.input.demands.retain(|d| shown.contains(d.case.as_str()));
    let cases: BTreeSet<Text> = shown.iter().map(|c| Text::given(*c)).collect();
    data.input.plane_actions.rows.retain(|r| r.first().is_some_and(|c| cases.contains(c)));
    Cow::Owned(data)
}

/// Checks that differ in nothing but their load case as one, the worst of them, in their order.
fn in_worst_case(checks: &[Check]) -> Vec<Check> {
    let rank = |c: &Check| match c.status {
        Status::Failed => 4,
        Status::Undecided => 3,
        Status::Warning => 2,
        Status::Ok => 1,
        Status::Information => 0,
    };
    let size = |c: &Check| (rank(c), c.utilisation.unwrap_or(0.0));
    let worse = |a: &Check, b: &Check| {
        let ((ra, ua), (rb, ub)) = (size(a), size(b));
        ra > rb || ra == rb && ua > ub
    };
    let mut worst: Vec<&Check> = Vec::new();
    let mut first: HashMap<String, usize> = HashMap::new();
    for c in checks {
        let key = format!("{:?} {:?} {}", c.title, c.subject, c.clause);
        match first.get(&key) {
            Some(&i) if c.case.is_some() => {
                if worse(c, worst[i]) {
                    worst[i] = c;
                }
            }
            _ => {
                first.insert(key, worst.len());
                worst.push(c);
            }
        }
    }
    worst.into_iter().cloned().collect()
}

/// Leaves of each sense of bending the β with the least and with the greatest moment resistance.
fn of_few_betas(result: &mut ResultFile) {
    let is_beta = |p: &Place| matches!(p, Place::Beta(_));
    let sense =
        |s: &Subject| -> Vec<Place> { s.places.iter().filter(|p| !is_beta(p)).cloned().collect() };
    let size = |c: &Check| c.resistance.unwrap_or(0.0);
    // the sense with its weakest and its strongest check
    let mut senses: Vec<(Vec<Place>, [&Check; 2])> = Vec::new();
    for c in result.checks.iter().filter(|c| c.id() == CheckId::MomentResistance) {
        let of = sense(&c.subject);
        match senses.iter_mut().find(|(s, _)| *s == of) {
            Some((_, [least, _])) if size(c) < size(least) => *least = c,
            Some((_, [_, most])) if size(c) >= size(most) => *most = c,
            Some(_) => {}
            None => senses.push((of, [c, c])),
        }
    }
    let kept: Vec<Subject> =
        senses.iter().flat_map(|(_, ends)| ends.map(|c| c.subject.clone())).collect();
    let of_kept = |s: &Subject| {
        let within = |k: &Subject| k.places.iter().all(|p| s.places.contains(p));
        !s.places.iter().any(is_beta) || kept.iter().any(within)
    };
    let texts: BTreeSet<Text> = kept.iter().map(Subject::text).collect();
    result.checks.retain(|c| of_kept(&c.subject));
    result.component_method.retain(|m| texts.contains(&m.subject));
}

/// The section: envelope and lines, for the cases of `all`.
pub(crate) fn section(doc: &mut Doc, all: &ReportData) {
    if !are_many(all) {
        return;
    }
    doc.paragraph(ENVELOPE);
    doc.table(&envelope(&all.input.demands));
    doc.paragraph(LINES);
    doc.table(&lines(&all.result.load_cases, usize::MAX).0);
    if let Some(proof) = proof(&all.result) {
        doc.paragraph(proof);
    }
    doc.paragraph(WORST);
}

/// How many analyses bound how many load cases; `None` where each has its own.
pub(crate) fn proof(result: &ResultFile) -> Option<Text> {
    let derived = result.cases.iter().filter(|c| c.proved_by.is_some()).count();
    let runs = result.cases.len() - derived;
    (derived > 0).then(|| {
        say!(
            "{} limit analyses bound {} load cases; {} of them are of actions that no load case \
             has. The actions that a joint carries are a convex set, so that an analysis bounds \
             other load cases too; `proved_by` in result.json has the weights.",
            runs,
            result.cases.len() - result.directions.len(),
            result.directions.len()
        )
    })
}

/// The value of an action of a load case at a member end \[N, N mm\].
fn value(actions: &[EndAction], end: &str, action: Action) -> f64 {
    let here = actions.iter().filter(|a| a.end == end && a.action == action.word());
    here.map(|a| a.value.value()).sum()
}

/// The load cases with the largest and the smallest value of each action at each member end.
pub(crate) fn envelope(demands: &[GivenActions]) -> Table {
    let ends: BTreeSet<&str> =
        demands.iter().flat_map(|d| &d.actions).map(|a| a.end.as_str()).collect();
    let acts =
        |a: &Action| ends.iter().any(|e| demands.iter().any(|d| value(&d.actions, e, *a) != 0.0));
    let shown: Vec<Action> = Action::ALL.into_iter().filter(acts).collect();
    let mut rows = Vec::new();
    for end in &ends {
        let here: Vec<&GivenActions> =
            demands.iter().filter(|d| d.actions.iter().any(|a| a.end == *end)).collect();
        for action in &shown {
            let of = |d: &&GivenActions| value(&d.actions, end, *action);
            let by = |a: &&&GivenActions, b: &&&GivenActions| of(a).total_cmp(&of(b));
            let extremes =
                [("largest", here.iter().max_by(by)), ("smallest", here.iter().min_by(by))];
            for (word, found) in extremes {
                let Some(found) = found else { continue };
                let what = say!("{} {}", word, action.word().to_owned());
                let mut row = cells![Text::given(*end), what, Text::given(&found.case)];
                row.extend(shown.iter().map(|a| shown_value(value(&found.actions, end, *a), *a)));
                rows.push(row);
            }
        }
    }
    let mut columns = Table::columns(["member end", "extreme", "load case"]);
    columns.extend(shown.iter().map(|a| Text::given(a.word())));
    if ends.len() < 2 {
        columns.remove(0);
        rows.iter_mut().for_each(|r| drop(r.remove(0)));
    }
    Table { columns, rows }
}

fn shown_value(value: f64, action: Action) -> Text {
    let unit = if action.direction().1 { Unit::Moment } else { Unit::Force };
    Text::given(unit.show(value).replace('-', "−"))
}

/// A line for each load case, the worst first, at most `most` of them, and the number of the
/// others.
pub(crate) fn lines(cases: &[JudgedCase], most: usize) -> (Table, usize) {
    let rank = |c: &JudgedCase| match c.judgement.verdict {
        Verdict::NotOk => 0,
        Verdict::Undecided => 1,
        Verdict::Ok | Verdict::None => 2,
    };
    let used = |c: &JudgedCase| c.utilisation().map_or(f64::NEG_INFINITY, |u| u[1]);
    let mut sorted: Vec<&JudgedCase> = cases.iter().collect();
    sorted.sort_by(|a, b| rank(a).cmp(&rank(b)).then(used(b).total_cmp(&used(a))));
    let interval = |[l, u]: [f64; 2]| match l == u {
        true => utilisation(u, Rounding::Nearest),
        false => {
            let (l, u) = (utilisation(l, Rounding::Down), utilisation(u, Rounding::Up));
            format!("{l} … {u}")
        }
    };
    let row = |c: &&JudgedCase| {
        let j = &c.judgement;
        let used = c.utilisation().map_or_else(dash, |u| interval(u).into());
        let by_analysis = match c.by_bounds {
            Some(u) => say!("{} ({})", j.by_analysis.words(), interval(u)),
            None => j.by_analysis.words().into(),
        };
        let governing = j.governing.as_ref().map_or_else(dash, |g| g.what.clone());
        [
            Text::given(&c.case),
            used,
            governing,
            j.by_code.words().into(),
            by_analysis,
            j.verdict.words().into(),
        ]
    };
    let columns = ["load case", "utilisation", "governing", "by code", "by analysis", "verdict"];
    let table = Table::new(columns, sorted.iter().take(most).map(row));
    (table, sorted.len().saturating_sub(most))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::result::demand::ActionValue;
    use bracket_codes::formula::Traced;
    use bracket_codes::subject::Part;
    use bracket_codes::{Topic, Worked};

    fn given(case: &str, n: f64, my: f64) -> GivenActions {
        let action = |action: Action, v: f64| EndAction {
            end: "beam_right".into(),
            at: "node".into(),
            action: action.word().into(),
            value: ActionValue::of(action, v),
            factored: true,
        };
        GivenActions {
            case: case.into(),
            actions: vec![action(Action::N, n), action(Action::My, my)],
        }
    }

    /// A row of the envelope is one load case: its other actions are those that act with the
    /// extreme, not extremes themselves.
    #[test]
    fn an_envelope_has_concurrent_actions() {
        let all = [given("A", 10e3, 5e6), given("B", -20e3, 40e6), given("C", 0.0, -3e6)];
        let table = envelope(&all);
        let text = |row: &Vec<Text>| row.iter().map(ToString::to_string).collect::<Vec<_>>();
        let rows: Vec<Vec<String>> = table.rows.iter().map(text).collect();
        assert_eq!(rows[0], ["largest N", "A", "10 kN", "5 kN m"]);
        assert_eq!(rows[1], ["smallest N", "B", "−20 kN", "40 kN m"]);
        assert_eq!(rows[2], ["largest My", "B", "−20 kN", "40 kN m"]);
        assert_eq!(rows[3], ["smallest My", "C", "0 kN", "−3 kN m"]);
        assert_eq!(rows.len(), 4);
    }

    /// Each check stands in its worst case; a check that fails is worse than any that holds,
    /// and one without a load case stays.
    #[test]
    fn each_check_in_its_worst_case() {
        let check = |id, u: f64, case: &str| {
            Worked::of("6.2", id, "u", Traced::from(u), Unit::Number)
                .utilised(Topic::Bolts, Part::BoltRows, Status::Failed)
                .of_case(case)
        };
        let alone = Check { case: None, ..check(CheckId::LeastThroat, 0.1, "") };
        let undecided =
            Check { status: Status::Undecided, ..check(CheckId::MomentAndAxial, 0.2, "C") };
        let all = [
            alone.clone(),
            check(CheckId::MomentAndAxial, 0.7, "A"),
            check(CheckId::MomentResistance, 0.4, "A"),
            check(CheckId::MomentAndAxial, 0.9, "B"),
            check(CheckId::MomentResistance, 0.3, "B"),
            undecided,
        ];
        let worst = in_worst_case(&all);
        let told: Vec<(Option<&str>, Option<f64>)> =
            worst.iter().map(|c| (c.case.as_deref(), c.utilisation)).collect();
        assert_eq!(told, [(None, Some(0.1)), (Some("C"), Some(0.2)), (Some("A"), Some(0.4))]);
    }
}
