//! Verdicts and capacities of the load cases with a demand, and the actions on the joint.

use crate::document::Doc;
use crate::document::table::{Table, cells, dash};
use crate::figures::{Rounding, bracket, significant, utilisation};
use crate::markdown::report_data::GivenActions;
use crate::result::demand::{Demand, EndAction};
use crate::result::result_file::CaseResult;
use crate::result::result_file::ResultFile;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::check::{Unit, number};
use bracket_joint::assembly::PlaneActions;

/// Verdicts and capacities, one row per case and one row per action; empty without a demand.
pub(crate) fn demands(doc: &mut Doc, result: &ResultFile, given: &[GivenActions]) {
    let judged: Vec<(&CaseResult, &Demand)> =
        result.cases.iter().filter_map(|c| Some((c, c.demand.as_ref()?))).collect();
    if judged.len() > 1 {
        let rows = judged.iter().map(|(c, d)| {
            let between = c.utilisation.map_or_else(dash, |[l, u]| {
                let (l, u) = (utilisation(l, Rounding::Down), utilisation(u, Rounding::Up));
                format!("{l} … {u}").into()
            });
            [Text::given(&c.name), d.verdict.words().into(), between]
        });
        doc.table(&Table::new(["load case", "verdict", "utilisation"], rows));
    }
    let of_ends = actions(result, given);
    if !of_ends.rows.is_empty() {
        doc.table(&of_ends);
    }
}

/// The actions at member ends, with what the joint carries of them; of cases without an analysis
/// those that are `given`.
pub(crate) fn actions(result: &ResultFile, given: &[GivenActions]) -> Table {
    let mut rows: Vec<Vec<Text>> = Vec::new();
    let judged: Vec<&CaseResult> = result.cases.iter().filter(|c| c.demand.is_some()).collect();
    for case in &judged {
        let bounds = case.factor_bounds();
        let actions = case.demand.iter().flat_map(|d| &d.actions);
        rows.extend(actions.map(|a| action_row(&case.name, a, bounds)));
    }
    for g in given.iter().filter(|g| judged.iter().all(|c| c.name != g.case)) {
        rows.extend(g.actions.iter().map(|a| action_row(&g.case, a, (None, None))));
    }
    let columns =
        ["load case", "member end", "action", "given", "carried at least", "carried at most"];
    let mut columns = Table::columns(columns);
    // without a bound the last two columns say nothing
    if rows.iter().all(|r| r[4..].iter().all(|c| *c == dash())) {
        columns.truncate(4);
        rows.iter_mut().for_each(|r| r.truncate(4));
    }
    Table { columns, rows }
}

/// The actions at the bolt planes, with which the checks are made. The components that are zero in
/// every case are left out; N, Vz and My stay.
pub fn on_planes(actions: &[PlaneActions]) -> Table {
    let names = ["N", "Vy", "Vz", "T", "My", "Mz"];
    let of = |a: &PlaneActions| {
        let [force, moment] = a.at(1.0);
        [force[0], force[1], force[2], moment[0], moment[1], moment[2]]
    };
    let shown = |k: &usize| [0, 2, 4].contains(k) || actions.iter().any(|a| of(a)[*k] != 0.0);
    let shown: Vec<usize> = (0..names.len()).filter(shown).collect();
    let row = |a: &PlaneActions| {
        let unit = |k: usize| if k < 3 { Unit::Force } else { Unit::Moment };
        let values = shown.iter().map(|k| unit(*k).show(of(a)[*k]).replace('-', "−"));
        let distance = |d: f64| format!("{} mm", number(d).replace('-', "−"));
        let place = [a.case.clone(), a.end.clone(), distance(a.from_node)];
        let above = raised(actions).then(|| distance(a.above_node));
        place.into_iter().chain(above).chain(values).map(Text::from).collect()
    };
    let mut columns = Table::columns(["load case", "member end", "d, from the node"]);
    if raised(actions) {
        columns.push("h, above the node".into());
    }
    columns.extend(shown.iter().map(|k| Text::from(names[*k])));
    Table { columns, rows: actions.iter().map(row).collect() }
}

/// Whether the plane of a joint lies above or below its node.
fn raised(actions: &[PlaneActions]) -> bool {
    actions.iter().any(|a| a.above_node != 0.0)
}

/// What the table of [`on_planes`] is.
pub fn about_planes(actions: &[PlaneActions]) -> Text {
    if raised(actions) {
        return "Actions at the middle of the depth in the bolt plane, N normal to it and Vz along \
                it, with which the checks are made: My = My,node + d Vz − h N"
            .into();
    }
    "Actions at the bolt plane, with which the checks are made: My = My,node + d Vz".into()
}

fn action_row(case: &str, a: &EndAction, (lower, upper): (Option<f64>, Option<f64>)) -> Vec<Text> {
    let (value, unit) = a.value.shown();
    let sign = if value < 0.0 { "−" } else { "" };
    let size = |factor: f64, rounding| {
        format!("{sign}{} {unit}", significant(factor * value.abs(), 3, rounding))
    };
    let (low, high) = match (lower, upper) {
        (Some(l), Some(u)) if a.factored && value != 0.0 => {
            let (l, u) = bracket((l * value.abs()).next_down(), (u * value.abs()).next_up(), 3);
            (format!("{sign}{l} {unit}").into(), format!("{sign}{u} {unit}").into())
        }
        _ if !a.factored => ("fixed".into(), "fixed".into()),
        // words state whether a single bound is a lower or an upper one
        (Some(l), None) if value != 0.0 => {
            (say!("at least {}", size(l.next_down(), Rounding::Down)), dash())
        }
        (None, Some(u)) if value != 0.0 => {
            (dash(), say!("at most {}", size(u.next_up(), Rounding::Up)))
        }
        _ => (dash(), dash()),
    };
    let given = format!("{sign}{} {unit}", (1e9 * value.abs()).round() / 1e9);
    cells![Text::given(case), say!("{} at {}", &a.end, &a.at), a.action.clone(), given, low, high]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::english;
    use crate::result::demand::ActionValue;
    use crate::result::fixtures::limit_case;
    use bracket_codes::HandChecks;
    use bracket_codes::verdict::Verdict;

    /// If one bound is missing, the other is reported, and words state its side.
    #[test]
    fn one_bound_alone_is_named_as_lower_or_upper() {
        let action = |value| EndAction {
            end: "beam_right".into(),
            at: "node".into(),
            action: "My".into(),
            value: ActionValue::Moment(value),
            factored: true,
        };
        let text = |lower: Option<f64>, upper: Option<f64>| {
            let mut case = limit_case(lower, upper);
            let actions = vec![action(40e6), action(-10e6)];
            case.demand = Some(Demand::new(&case, actions, &HandChecks::default()));
            let mut result = ResultFile::new("", 1, Verdict::Undecided);
            result.cases.push(case);
            english(|doc| demands(doc, &result, &[]))
        };
        let page = text(None, Some(1.2));
        assert!(
            page.contains("| – | at most 48.1 kN m |")
                && page.contains("| – | at most −12.1 kN m |"),
            "{page}"
        );
        let page = text(Some(0.8), None);
        assert!(
            page.contains("| at least 31.9 kN m | – |")
                && page.contains("| at least −7.99 kN m | – |"),
            "{page}"
        );
        let page = text(None, None);
        assert!(page.contains("| given |") && page.lines().all(|l| l.matches('|').count() <= 5));
    }
}
