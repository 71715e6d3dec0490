//! Capacity tables: what the joints of a family carry, with a proof.
//!
//! A capacity is the load of the case times the load factor. The lower bound is proved by a stress
//! field, the upper one by a mechanism; the component method stands beside them.

use super::dimension::words;
use super::expansion::typed;
use super::plan::Plan;
use super::row::{LoadRow, Outcome, Record};
use super::screen::Kit;
use super::sweep::CapacityTable;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::verdict::Verdict;
use bracket_joint::spec::connection::ConnectionSpec;
use bracket_joint::spec::loads::Action;
use bracket_report::document::Doc;
use bracket_report::document::table::Table;
use bracket_report::figures::{Rounding, fixed};

/// A cell: capacities in kN or kN m.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cell {
    /// At least this much is carried: strict lower bound.
    pub lower: Option<f64>,
    /// At most this much is carried: strict upper bound.
    pub upper: Option<f64>,
    /// By the component method.
    pub component: Option<f64>,
    /// What became of the case; the worst if several cases share the cell.
    pub outcome: Option<Outcome>,
    /// Whether a check of the code fails under the given load: the bounds do not overrule it.
    pub code_fails: bool,
    /// Whether a case of the cell has no lower bound: then the cell has none.
    pub open: bool,
}

/// A capacity table with its values.
#[derive(Clone, Debug, PartialEq)]
pub struct Filled {
    /// Heading.
    pub title: String,
    /// Path over the rows.
    pub row_path: String,
    /// Path over the columns.
    pub column_path: String,
    /// Action and unit: `My in kN m`.
    pub what: Text,
    /// Heads of the rows.
    pub rows: Vec<String>,
    /// Heads of the columns.
    pub columns: Vec<String>,
    /// The cells by row and column.
    pub cells: Vec<Vec<Cell>>,
}

/// The different values of a path, in the order of the plan.
fn heads(plan: &Plan, path: &str) -> Vec<String> {
    let expansion = &plan.header.expansion;
    let mut out: Vec<String> = Vec::new();
    for case in &plan.cases {
        let values = expansion.values(case.index);
        if let Some((_, v)) = values.into_iter().find(|(p, _)| *p == path)
            && !out.contains(&v)
        {
            out.push(v);
        }
    }
    out
}

/// Fills a table. A cell that several cases share shows the least capacity of them.
pub fn fill(table: &CapacityTable, plan: &Plan, kit: &Kit, records: &[Option<Record>]) -> Filled {
    let (rows, columns) = (heads(plan, &table.rows), heads(plan, &table.columns));
    let mut cells = vec![vec![Cell::default(); columns.len()]; rows.len()];
    let expansion = &plan.header.expansion;
    for (case, record) in plan.cases.iter().zip(records) {
        let values = expansion.values(case.index);
        let at = |path: &str, heads: &[String]| {
            let value = values.iter().find(|(p, _)| *p == path)?;
            heads.iter().position(|h| *h == value.1)
        };
        let (Some(r), Some(c)) = (at(&table.rows, &rows), at(&table.columns, &columns)) else {
            continue;
        };
        let is = |(path, wanted): (&String, &serde_json::Value)| {
            values.iter().any(|(p, v)| p == path && *v == words(wanted))
        };
        if !table.only.iter().all(is) {
            continue;
        }
        let cell = &mut cells[r][c];
        let Some(record) = record else {
            cell.unproved();
            continue;
        };
        let spec = kit.spec(expansion, case.index).ok();
        let spec = spec.and_then(|s| typed(&s, &kit.file).ok());
        let of_case = |l: &&LoadRow| table.case.as_ref().is_none_or(|name| *name == l.case);
        let load = record.loads.iter().find(of_case);
        let size = spec.zip(load).and_then(|(s, l)| size(&s, &l.case, table.action));
        cell.outcome = cell.outcome.max(Some(record.outcome));
        cell.code_fails |= load.is_some_and(|l| l.by_code == Verdict::NotOk);
        let least = |old: Option<f64>, new: Option<f64>| match (old, new) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        };
        let of = |factor: Option<f64>| Some(factor? * size?);
        // a joint without rotation capacity does not reach the load of limit analysis
        let lower = load.filter(|l| !l.brittle).and_then(|l| l.lower);
        match of(lower) {
            Some(lower) if !cell.open => cell.lower = least(cell.lower, Some(lower)),
            Some(_) => {}
            None => cell.unproved(),
        }
        cell.upper = least(cell.upper, of(load.and_then(|l| l.upper)));
        // the component method gives a moment
        let method = load.filter(|_| table.action == Action::My).and_then(|l| l.component_factor);
        cell.component = least(cell.component, of(method));
    }
    let unit = if table.action.direction().1 { "kN m" } else { "kN" };
    Filled {
        title: table.title.clone(),
        row_path: table.rows.clone(),
        column_path: table.columns.clone(),
        what: say!("{} in {}", table.action.word().to_owned(), unit.to_owned()),
        rows,
        columns,
        cells,
    }
}

/// Size of an action in a load case \[kN, kN m\]; `None` if the load factor does not multiply it.
fn size(spec: &ConnectionSpec, case: &str, action: Action) -> Option<f64> {
    let loads = spec.loads.iter().filter(|l| l.name == case && l.multiplies(action));
    let mut sizes = loads.flat_map(|l| l.actions()).filter(|(a, _)| *a == action);
    // of several member ends none is the capacity
    let (value, None) = (sizes.next()?.1, sizes.next()) else { return None };
    let scale = if action.direction().1 { 1e-6 } else { 1e-3 };
    Some(scale * value.abs())
}

/// A capacity with one decimal, rounded down where it is a lower bound, up where it is an upper.
pub fn shown(value: Option<f64>, rounding: Rounding) -> String {
    value.map_or_else(String::new, |v| fixed(v, 1, rounding))
}

impl Filled {
    /// True if no cell has a capacity.
    pub fn is_empty(&self) -> bool {
        let has = |c: &Cell| c.lower.or(c.upper).or(c.component).is_some();
        !self.cells.iter().flatten().any(has)
    }

    /// Writes the table: lower bound bold, upper bound beside it, component method in brackets.
    pub fn write(&self, doc: &mut Doc) {
        doc.heading(Text::given(&self.title));
        doc.paragraph(say!("{}: **at least** to at most (component method).", &self.what));
        let corner = Text::given(format!("{} \\ {}", self.row_path, self.column_path));
        let columns = std::iter::once(corner).chain(self.columns.iter().map(Text::given));
        let rows = self.rows.iter().zip(&self.cells).map(|(head, cells)| {
            std::iter::once(Text::given(head)).chain(cells.iter().map(Cell::text)).collect()
        });
        doc.table(&Table { columns: columns.collect(), rows: rows.collect() });
    }
}

impl Cell {
    /// Removes the lower bound: it would not hold for every case of the cell.
    fn unproved(&mut self) {
        (self.open, self.lower) = (true, None);
    }

    fn text(&self) -> Text {
        let number = |v: f64, rounding| shown(Some(v), rounding);
        let ended = |o: &Outcome| *o >= Outcome::TimedOut;
        let parts = [
            self.lower.map(|v| say!("**{}**", number(v, Rounding::Down))),
            self.upper.map(|v| say!("to {}", number(v, Rounding::Up))),
            self.component.map(|v| Text::given(format!("({})", number(v, Rounding::Down)))),
            self.outcome.filter(ended).map(|o| o.plain().into()),
            self.code_fails.then(|| "(a check fails)".into()),
        ];
        match Text::joined(" ", parts.into_iter().flatten()) {
            text if text.is_empty() => Text::given("–"),
            text => text,
        }
    }
}
