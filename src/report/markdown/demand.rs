//! Verdicts and capacities of the load cases with a demand.

use crate::report::figures::{Rounding, bracket, significant};
use crate::report::markdown::markup::{inline, strings, table};
use crate::report::markdown::report_data::Table;
use crate::result::demand::Demand;
use crate::result::result_file::CaseResult;
use crate::result::result_file::ResultFile;

/// Verdicts and capacities, one row per case and one row per action; empty without a demand.
pub(crate) fn demands(page: &mut String, result: &ResultFile) {
    let judged: Vec<(&CaseResult, &Demand)> =
        result.cases.iter().filter_map(|c| Some((c, c.demand.as_ref()?))).collect();
    if judged.len() > 1 {
        let rows = judged.iter().map(|(c, d)| {
            let between = c.utilisation.map_or("–".into(), |[l, u]| {
                let (l, u) = bracket(l, u, 3);
                format!("{l} … {u}")
            });
            vec![inline(&c.name), d.verdict.words().into(), between]
        });
        table(
            page,
            &Table {
                columns: strings(["load case", "verdict", "utilisation"]),
                rows: rows.collect(),
            },
        );
    }
    let mut rows = Vec::new();
    for (case, demand) in &judged {
        let (lower, upper) = case.factor_bounds();
        for a in &demand.actions {
            let (value, unit) = a.value.shown();
            let size = |factor: f64, rounding| {
                let sign = if value < 0.0 { "−" } else { "" };
                format!("{sign}{}", significant(factor * value.abs(), 3, rounding))
            };
            let (low, high) = match (lower, upper) {
                (Some(l), Some(u)) if a.factored && value != 0.0 => {
                    let (l, u) =
                        bracket((l * value.abs()).next_down(), (u * value.abs()).next_up(), 3);
                    let sign = if value < 0.0 { "−" } else { "" };
                    (format!("{sign}{l}"), format!("{sign}{u}"))
                }
                _ if !a.factored => ("fixed".into(), "fixed".into()),
                // words state whether a single bound is a lower or an upper one
                (Some(l), None) if value != 0.0 => {
                    (format!("at least {}", size(l.next_down(), Rounding::Down)), "–".into())
                }
                (None, Some(u)) if value != 0.0 => {
                    ("–".into(), format!("at most {}", size(u.next_up(), Rounding::Up)))
                }
                _ => ("–".into(), "–".into()),
            };
            let place = format!("{} at {}", a.end, a.at);
            rows.push(vec![
                inline(&case.name),
                inline(&place),
                a.action.clone(),
                format!("{} {unit}", (1e9 * value).round() / 1e9),
                low,
                high,
            ]);
        }
    }
    if !rows.is_empty() {
        let columns =
            ["load case", "member end", "action", "given", "carried at least", "carried at most"];
        table(page, &Table { columns: strings(columns), rows });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::HandChecks;
    use crate::checks::verdict::Verdict;
    use crate::result::demand::{ActionValue, EndAction};
    use crate::result::fixtures::limit_case;

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
            case.demand = Some(Demand::new(&case, true, actions, &HandChecks::default()));
            let mut result = ResultFile::new("", 1, Verdict::Undecided);
            result.cases.push(case);
            let mut page = String::new();
            demands(&mut page, &result);
            page
        };
        let page = text(None, Some(1.2));
        assert!(
            page.contains("| – | at most 48.1 |") && page.contains("| – | at most −12.1 |"),
            "{page}"
        );
        let page = text(Some(0.8), None);
        assert!(
            page.contains("| at least 31.9 | – |") && page.contains("| at least −7.99 | – |"),
            "{page}"
        );
        let page = text(None, None);
        assert!(page.contains("| – | – |"), "{page}");
    }
}
