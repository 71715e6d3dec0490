//! What a load case demands, and what the joint can carry of it.

use crate::checks::verdict::Verdict;
use crate::checks::{Comparison, HandChecks, Judgement};
use crate::report::figures::{Rounding, bracket, significant};
use crate::report::markdown::page::Table;
use crate::report::markdown::text::{inline, strings, table};
use crate::result::data::{CaseResult, FrictionModel, Quantity, ResultFile, Upper};
use crate::spec::loads::Action;
use serde::{Deserialize, Serialize};

/// The demand of a load case and the verdict on it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Demand {
    /// The verdict at load factor 1, the worse of the next two.
    pub verdict: Verdict,
    /// By the code's checks of the load case.
    pub by_code: Verdict,
    /// By the strict bounds of this entry; `none` of an analysis that brackets no resistance.
    pub by_analysis: Verdict,
    /// Forces and moments at member ends, in the order of the spec.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub actions: Vec<EndAction>,
    /// What the component method says of the case, an entry a member end.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub component_method: Vec<Comparison>,
    /// Why the verdict may not be `ok`: no rule of rotation capacity holds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub brittle: Option<String>,
}

impl Demand {
    /// The demand of a load case under one kind of analysis. In limit analysis strict bounds judge
    /// it; a joint that may not yield as limit analysis takes it to is at most undecided.
    /// `certified`: the analysis gave what was asked of it.
    pub fn new(
        entry: &CaseResult,
        certified: bool,
        actions: Vec<EndAction>,
        checks: &HandChecks,
    ) -> Self {
        let (lower, upper) = entry.safe_bounds();
        let by_analysis = match (entry.quantity, Verdict::of(lower, upper)) {
            (Quantity::LoadFactor, Verdict::Ok) if checks.brittle.is_some() => Verdict::Undecided,
            (Quantity::LoadFactor, verdict) => verdict,
            (Quantity::PotentialEnergy, _) if certified => Verdict::None,
            (Quantity::PotentialEnergy, _) => Verdict::Undecided,
        };
        let component_method =
            checks.comparisons.iter().filter(|c| c.case == entry.name).cloned().collect();
        // the rule of rotation capacity is one of limit analysis
        let brittle = checks.brittle.clone().filter(|_| entry.quantity == Quantity::LoadFactor);
        Self {
            verdict: by_analysis,
            by_code: Verdict::None,
            by_analysis,
            actions,
            component_method,
            brittle,
        }
    }

    /// Takes the verdicts of the load case.
    pub fn judged(&mut self, judgement: &Judgement) {
        (self.by_code, self.verdict) = (judgement.by_code, judgement.verdict);
    }
}

/// A force or moment at a member end.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EndAction {
    /// Member end: `beam_right`.
    pub end: String,
    /// The point it refers to: `column_face`.
    pub at: String,
    /// `N`, `Vy`, `Vz`, `T`, `My` or `Mz`.
    pub action: String,
    /// Its value at load factor 1, in the member's own axes.
    pub value: ActionValue,
    /// The load factor multiplies it.
    pub factored: bool,
}

/// Value of an action.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ActionValue {
    /// \[N\].
    Force(f64),
    /// \[N mm\].
    Moment(f64),
}

impl ActionValue {
    /// Of an action with this value \[N, N mm\].
    pub fn of(action: Action, value: f64) -> Self {
        if action.direction().1 { Self::Moment(value) } else { Self::Force(value) }
    }

    /// Value \[N, N mm\].
    pub fn value(self) -> f64 {
        match self {
            ActionValue::Force(v) | ActionValue::Moment(v) => v,
        }
    }

    /// Value in the unit of the report, and the unit.
    pub(crate) fn shown(self) -> (f64, &'static str) {
        match self {
            ActionValue::Force(v) => (1e-3 * v, "kN"),
            ActionValue::Moment(v) => (1e-6 * v, "kN m"),
        }
    }
}

impl CaseResult {
    /// The strict bounds a verdict stands on: with friction, the lower one is that without it.
    /// `None`: no such bound.
    pub fn safe_bounds(&self) -> (Option<f64>, Option<f64>) {
        if !self.certificate.is_some_and(|c| c.strict) {
            return (None, None);
        }
        let lower = match self.problem {
            FrictionModel::Associated => self.frictionless.and_then(|f| f.lower),
            _ => self.lower,
        };
        let upper = match self.upper {
            Some(Upper::Finite(u)) => Some(u),
            _ => None,
        };
        (lower, upper)
    }
}

/// Verdicts and capacities, a row a case and a row an action; nothing where nothing is demanded.
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
        // an energy bounds no multiple of the load
        let bounds =
            if case.quantity == Quantity::LoadFactor { case.safe_bounds() } else { (None, None) };
        let (lower, upper) = bounds;
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
                // one side alone says in words which it is
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

    /// A case of limit analysis with these bounds.
    fn limit_case(lower: Option<f64>, upper: Option<f64>) -> CaseResult {
        let mut case = crate::result::data::tests::case();
        case.quantity = Quantity::LoadFactor;
        (case.problem, case.lower, case.upper) =
            (FrictionModel::Frictionless, lower, upper.map(Upper::Finite));
        case
    }

    /// Where no rule of rotation capacity holds, strict bounds above 1 do not make a joint OK;
    /// bounds below 1 still refuse it. Energies judge nothing, but an analysis without a
    /// certificate leaves the case open.
    #[test]
    fn a_brittle_joint_is_at_most_undecided() {
        let brittle =
            HandChecks { brittle: Some("t is too thick".into()), ..HandChecks::default() };
        let verdict = |checks: &HandChecks, l, u| {
            Demand::new(&limit_case(Some(l), Some(u)), true, Vec::new(), checks).by_analysis
        };
        assert_eq!(verdict(&HandChecks::default(), 1.1, 1.2), Verdict::Ok);
        assert_eq!(verdict(&brittle, 1.1, 1.2), Verdict::Undecided);
        assert_eq!(verdict(&brittle, 0.8, 0.9), Verdict::NotOk);
        let elastic = |certified| {
            let case = CaseResult {
                quantity: Quantity::PotentialEnergy,
                ..limit_case(Some(1.1), Some(1.2))
            };
            Demand::new(&case, certified, Vec::new(), &brittle)
        };
        assert_eq!(
            [true, false].map(|c| elastic(c).by_analysis),
            [Verdict::None, Verdict::Undecided]
        );
        assert_eq!(elastic(true).brittle, None);
    }

    /// Where one bound is missing the other is told, with its side in words.
    #[test]
    fn one_bound_alone_is_told_as_what_it_is() {
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
