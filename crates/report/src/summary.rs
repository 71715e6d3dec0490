//! The table that a checker reads first: every check with a demand, the worst first.

use crate::figures::{Rounding, significant, utilisation};
use crate::result::result_file::Quantity;
use crate::result::result_file::{CaseResult, ResultFile};
use bracket_base::words::Text;
use bracket_codes::Governing;
use bracket_codes::verdict::Verdict;
use bracket_codes::{Check, CheckId, Status, Topic, Unit};
use serde::Serialize;

/// Clause of the row of a bracket.
const LIMIT_ANALYSIS: &str = "limit analysis";

/// Status of strength by the component method that is exceeded where a limit analysis decides.
pub const EXCEEDED: &str = "exceeded, information";

/// Status of a recommendation that is not followed.
const NOT_FOLLOWED: &str = "warning";

/// What a row of the summary is about.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RowKind {
    /// A check.
    #[default]
    Check,
    /// Strength by the component method that is exceeded where a limit analysis decides.
    Exceeded,
    /// A recommendation that is not followed.
    NotFollowed,
    /// The bracket of a limit analysis.
    Bracket,
}

/// Colour of a word of judgement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Tone {
    /// Holds.
    Good,
    /// Fails.
    Bad,
    /// Not decided.
    Open,
    /// Information.
    #[default]
    Quiet,
}

impl From<Verdict> for Tone {
    fn from(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Ok => Tone::Good,
            Verdict::NotOk => Tone::Bad,
            Verdict::Undecided => Tone::Open,
            Verdict::None => Tone::Quiet,
        }
    }
}

/// A row of the summary of checks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SummaryRow {
    /// Load case, or `all`.
    pub case: Text,
    /// Check and place.
    pub check: Text,
    /// Demand with its unit.
    pub demand: String,
    /// Resistance with its unit.
    pub resistance: String,
    /// Demand over resistance.
    pub utilisation: String,
    /// Clause.
    pub clause: Text,
    /// Status.
    pub status: Text,
    /// Its colour.
    pub tone: Tone,
    /// What it is about.
    pub kind: RowKind,
    /// True for a row that governs.
    pub governs: bool,
    /// Utilisation by which it may govern; absent if the row decides nothing.
    pub governs_by: Option<f64>,
    /// Utilisation by which it is sorted.
    pub size: f64,
}

impl SummaryRow {
    /// True for the row of what governs the verdict.
    fn is(&self, g: &Governing) -> bool {
        let here = g.case.as_ref().is_none_or(|case| self.case == Text::given(case));
        let same = self.check == g.what || self.kind == RowKind::Bracket;
        here && same && self.clause == g.clause
    }
}

/// The rows: what fails, what is open, strength by the component method that is exceeded beside an
/// analysis, then by utilisation; information last. Empty without a demand.
pub fn summary_rows(result: &ResultFile) -> Vec<SummaryRow> {
    let mut rows: Vec<SummaryRow> = result.cases.iter().filter_map(bracket_row).collect();
    let loaded: Vec<&Check> =
        result.checks.iter().filter(|c| c.case.is_some() && c.demand.is_some()).collect();
    if rows.is_empty() && loaded.is_empty() {
        return rows;
    }
    rows.extend(worst_limits(&result.checks).into_iter().map(row));
    // checks that decide without a load case; the limits have their own rows
    let alone = |c: &&Check| {
        let decides = match c.status {
            Status::Failed | Status::Undecided => true,
            Status::Ok => c.measures_strength(),
            Status::Warning | Status::Information => false,
        };
        decides && c.case.is_none() && !c.is_limit()
    };
    rows.extend(result.checks.iter().filter(alone).map(row));
    rows.extend(loaded.into_iter().map(row));
    let governing = result.judgement.as_ref().and_then(|j| j.governing.as_ref());
    let most = rows.iter().filter_map(|r| r.governs_by).fold(f64::NEG_INFINITY, f64::max);
    rows.iter_mut().for_each(|r| {
        r.governs = match governing {
            Some(g) => r.is(g),
            None => r.governs_by.is_some_and(|u| u >= most),
        }
    });
    let rank = |r: &SummaryRow| match r.tone {
        Tone::Bad => 0,
        Tone::Open => 1,
        Tone::Quiet if matches!(r.kind, RowKind::Exceeded | RowKind::NotFollowed) => 2,
        Tone::Good => 3,
        Tone::Quiet => 4,
    };
    // a stable sort: equal rows keep the order of the checks
    rows.sort_by(|a, b| {
        let by_size = b.size.total_cmp(&a.size);
        rank(a).cmp(&rank(b)).then(b.governs.cmp(&a.governs)).then(by_size)
    });
    rows
}

/// The row of the bracket of a load case.
fn bracket_row(case: &CaseResult) -> Option<SummaryRow> {
    let demand = case.demand.as_ref().filter(|_| case.quantity == Quantity::LoadFactor)?;
    let (down, up) =
        (|x: f64| significant(x, 3, Rounding::Down), |x: f64| significant(x, 3, Rounding::Up));
    let used = case.utilisation.map(|[l, u]| {
        format!("{} … {}", utilisation(l, Rounding::Down), utilisation(u, Rounding::Up))
    });
    let bounds = match case.factor_bounds() {
        (Some(l), Some(u)) => format!("{} … {}", down(l), up(u)),
        (Some(l), None) => format!("≥ {}", down(l)),
        (None, Some(u)) => format!("≤ {}", up(u)),
        (None, None) => "–".into(),
    };
    let undecided = (demand.by_analysis == Verdict::Undecided).then_some(1.0);
    let governs_by = case.utilisation.map(|u| u[1]).or(undecided);
    Some(SummaryRow {
        case: Text::given(&case.name),
        check: "joint at collapse, load factor".into(),
        demand: "1".into(),
        resistance: bounds,
        utilisation: used.unwrap_or_else(|| "–".into()),
        clause: LIMIT_ANALYSIS.into(),
        status: demand.by_analysis.words().into(),
        tone: demand.by_analysis.into(),
        kind: RowKind::Bracket,
        governs: false,
        governs_by,
        size: governs_by.unwrap_or(0.0),
    })
}

/// The limits that decide without a load: of each clause the one with the largest utilisation.
fn worst_limits(checks: &[Check]) -> Vec<&Check> {
    let used = |c: &Check| c.utilisation.unwrap_or(f64::INFINITY);
    // greatest distances bind only exposed or compressed steel, room for tools is practice
    let binds = |c: &&Check| match c.topic {
        Topic::Detailing => matches!(
            c.id(),
            CheckId::EndDistance
                | CheckId::EdgeDistance
                | CheckId::PitchOfRows
                | CheckId::GaugeOfColumns
        ),
        _ => c.topic == Topic::Welds,
    };
    let decides = |c: &&Check| matches!(c.status, Status::Ok | Status::Failed) && binds(c);
    let limit = |c: &&Check| c.case.is_none() && c.demand.is_some() && c.is_limit();
    let mut out: Vec<&Check> = Vec::new();
    for c in checks.iter().filter(limit).filter(decides) {
        match out.iter_mut().find(|o| o.clause == c.clause) {
            Some(o) if used(c) > used(o) => *o = c,
            Some(_) => {}
            None => out.push(c),
        }
    }
    out
}

fn row(c: &Check) -> SummaryRow {
    let show = |v: Option<f64>| v.map_or("–".into(), |v| c.unit.show(v));
    // a sum of shares is limited by 1
    let [demand, resistance] = match (c.unit, c.utilisation) {
        (Unit::Number, Some(sum)) => [utilisation(sum, Rounding::Nearest), "1".into()],
        (Unit::Number, None) => ["–".into(), "–".into()],
        _ => [show(c.demand), show(c.resistance)],
    };
    let decides = matches!(c.status, Status::Ok | Status::Failed | Status::Undecided) && !c.advice;
    let (status, tone) = match (c.status, c.utilisation) {
        (Status::Failed, _) => ("FAILED", Tone::Bad),
        (Status::Undecided, _) => ("UNDECIDED", Tone::Open),
        (Status::Ok, _) if c.advice => ("OK, information", Tone::Quiet),
        (Status::Ok, _) => ("OK", Tone::Good),
        (Status::Warning, _) if c.advice => (NOT_FOLLOWED, Tone::Quiet),
        // a limit analysis decides the case
        (Status::Warning, _) => (EXCEEDED, Tone::Quiet),
        (Status::Information, Some(_)) => ("OK, information", Tone::Quiet),
        (Status::Information, None) => ("information", Tone::Quiet),
    };
    let kind = match c.status {
        Status::Warning if c.advice => RowKind::NotFollowed,
        Status::Warning => RowKind::Exceeded,
        _ => RowKind::Check,
    };
    // a minimum distance or throat decides, but does not measure strength
    let kept = c.is_limit() && c.status == Status::Ok;
    let strength = decides && !kept;
    let used = c.utilisation.unwrap_or(f64::INFINITY);
    SummaryRow {
        case: c.case.as_ref().map_or_else(|| "all".into(), Text::given),
        check: Text::joined(", ", [c.title.text(), c.subject.text()]),
        demand,
        resistance,
        utilisation: used_words(c),
        clause: c.clause.clone(),
        status: status.into(),
        tone,
        kind,
        governs: false,
        governs_by: strength.then_some(used),
        // behind every strength
        size: if kept { f64::NEG_INFINITY } else { used },
    }
}

/// Demand over resistance of a check, as every table prints it.
pub fn used_words(c: &Check) -> String {
    c.utilisation.map_or_else(|| "–".into(), |u| utilisation(u, Rounding::Nearest))
}
