//! `results.csv` and `results.jsonl`: a row for each case and load case.

use super::case::Case;
use super::derived::Derived;
use super::dimension::words;
use super::merged::Merged;
use super::plan::Plan;
use super::row::{LoadRow, Record};
use super::screen::Kit;
use super::spec_path::SpecPath;
use bracket_base::diag::Diagnostic;
use bracket_codes::judgement::Governing;
use bracket_codes::verdict;
use bracket_report::escaped::csv_cell;
use rayon::prelude::*;
use serde_json::{Map, Value, json};

/// Kind of the values of a column. It depends on the name alone, so that the tables of all sweeps
/// have the same types.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A number.
    Number,
    /// An integer.
    Integer,
    /// A text.
    Text,
}

/// A column of the tables.
pub struct Column {
    /// Its name without the unit.
    pub name: &'static str,
    /// Unit as the header has it; empty if there is none or the name is it.
    pub unit: &'static str,
    /// Kind of its values.
    pub kind: Kind,
    /// Its value in a row; null where there is none.
    value: fn(&Found<'_>) -> Value,
}

/// What the columns of a row are read from.
struct Found<'a> {
    /// The record of a finished case.
    record: Option<&'a Record>,
    /// The record, or what the checks of an unfinished case have found.
    known: Option<&'a Record>,
    /// The load case.
    load: Option<&'a LoadRow>,
    /// What the choice made of the case.
    choice: Option<&'a Chosen>,
}

/// What the choice made of a case.
#[derive(Clone, Default)]
struct Chosen {
    /// `chosen`, or `not needed` where a cheaper joint holds.
    word: Option<&'static str>,
    /// Cost, known of a joint that can be chosen.
    cost: Option<f64>,
}

/// The columns behind the varied paths.
static COLUMNS: [Column; 26] = [
    text("load_case", |f| json!(f.load.map(|l| &l.case))),
    number("N", "kN", |f| json!(f.action(0).map(|n| shown(n / 1e3)))),
    number("V", "kN", |f| json!(f.action(1).map(|v| shown(v / 1e3)))),
    number("M", "kNm", |f| json!(f.action(2).map(|m| shown(m / 1e6)))),
    text("outcome", |f| json!(f.record.map_or("open", |r| r.outcome.word()))),
    text("verdict", |f| json!(f.judged().map(|l| l.verdict))),
    text("route", |f| json!(f.judged().and_then(|l| l.route))),
    text("by_code", |f| json!(f.load.map(|l| l.by_code))),
    text("by_analysis", |f| json!(f.load.map(|l| l.by_analysis))),
    number("lambda_low", "", |f| json!(f.load.and_then(|l| l.lower))),
    number("lambda_up", "", |f| json!(f.load.and_then(|l| l.upper))),
    number("utilisation_low", "", |f| json!(f.utilisation().map(|u| u[0]))),
    number("utilisation_up", "", |f| json!(f.utilisation().map(|u| u[1]))),
    number("M_j_Rd", "kNm", |f| json!(f.load.and_then(|l| l.moment_resistance).map(|m| m / 1e6))),
    number("component_factor", "", |f| json!(f.load.and_then(|l| l.component_factor))),
    number("S_j_ini", "kNm_per_rad", |f| {
        json!(f.load.and_then(|l| l.component_stiffness).map(|s| s / 1e6))
    }),
    text("governing", |f| json!(f.governing().map(|g| &g.what))),
    text("clause", |f| json!(f.governing().map(|g| &g.clause))),
    number("governing_utilisation", "", |f| {
        json!(f.governing().and_then(|g| g.utilisation).map(|u| u[1]))
    }),
    number("mass", "kg", |f| json!(f.known.and_then(|r| r.mass))),
    Column { kind: Kind::Integer, ..number("bolts", "", |f| json!(f.known.and_then(|r| r.bolts))) },
    number("seconds", "", |f| json!(f.record.and_then(|r| r.seconds))),
    text("result", |f| json!(f.record.filter(|r| r.result).map(Record::folder))),
    text("cause", |f| json!(f.cause())),
    text("end", |f| json!(f.load.and_then(|l| l.end.as_ref()))),
    text("reason", |f| json!(f.judged().and_then(|l| l.reason.as_ref()))),
];

/// The columns of the choice.
static CHOICE: [Column; 2] = [
    text("choice", |f| json!(f.choice.and_then(|c| c.word))),
    number("cost", "", |f| json!(f.choice.and_then(|c| c.cost))),
];

const fn number(name: &'static str, unit: &'static str, value: fn(&Found<'_>) -> Value) -> Column {
    Column { name, unit, kind: Kind::Number, value }
}

const fn text(name: &'static str, value: fn(&Found<'_>) -> Value) -> Column {
    Column { name, unit: "", kind: Kind::Text, value }
}

/// An action at another point without the noise of its last digits: it has 12.
fn shown(action: f64) -> f64 {
    format!("{action:.11e}").parse().unwrap_or(action)
}

/// All columns but the case and the paths that a sweep varies or sets.
pub fn columns() -> impl Iterator<Item = &'static Column> {
    COLUMNS.iter().chain(&CHOICE)
}

impl Column {
    /// The header: name and unit.
    pub fn header(&self) -> String {
        let join = if self.unit.is_empty() { "" } else { "_" };
        [self.name, join, self.unit].concat()
    }
}

impl Kind {
    /// The kind of the column with this header; those of the varied paths are texts.
    pub fn of(header: &str) -> Self {
        columns().find(|c| c.header() == header).map_or(Kind::Text, |c| c.kind)
    }
}

impl Found<'_> {
    /// The load case of a finished case: the checks of a case that waits for finite elements are no
    /// verdict yet.
    fn judged(&self) -> Option<&LoadRow> {
        self.load.filter(|_| self.record.is_some())
    }

    /// N \[N\], Vz \[N\] or My \[N mm\] at the bolt plane.
    fn action(&self, i: usize) -> Option<f64> {
        self.load?.actions.map(|a| a[i])
    }

    /// Demand over capacity by the bounds.
    fn utilisation(&self) -> Option<[f64; 2]> {
        self.load.and_then(|l| verdict::utilisation(l.lower, l.upper))
    }

    fn governing(&self) -> Option<&Governing> {
        self.load?.governing.as_ref()
    }

    fn cause(&self) -> Option<String> {
        match self.record {
            Some(record) => record.cause.clone(),
            None => self.load.map(|_| "by the checks; the analysis is not finished".to_owned()),
        }
    }
}

/// A row of the tables: headers with their values; null where there is none. `derived`: the columns
/// of the values of `set`.
fn row(
    plan: &Plan,
    case: &Case,
    found: &Found<'_>,
    derived: &[(String, Value)],
) -> Map<String, Value> {
    let mut row = Map::new();
    row.insert("case".into(), json!(case.name));
    for (header, text) in plan.header.expansion.notes(case.index) {
        row.insert(header.into(), json!(text));
    }
    for (path, value) in plan.header.expansion.values(case.index) {
        row.insert(path.into(), json!(value));
    }
    row.extend(derived.iter().cloned());
    let chosen = CHOICE.iter().filter(|_| found.choice.is_some());
    row.extend(COLUMNS.iter().chain(chosen).map(|c| (c.header(), (c.value)(found))));
    row
}

/// What the choice made of each case.
fn of_choice(merged: &Merged) -> Vec<Chosen> {
    let mut out = vec![Chosen::default(); merged.records.len()];
    for d in &merged.decisions {
        for (i, c) in d.candidates.iter().enumerate() {
            let word = match d.chosen {
                Some(k) if k == i => Some("chosen"),
                Some(k) if k < i => Some("not needed"),
                _ => None,
            };
            out[c.case] = Chosen { word, cost: Some(c.cost) };
        }
    }
    out
}

/// The values of `set` in a case, as text; null where they have none.
fn of_set(plan: &Plan, kit: &Kit, case: &Case) -> Vec<(String, Value)> {
    let expansion = &plan.header.expansion;
    if expansion.derived.is_empty() {
        return Vec::new();
    }
    let spec = kit.spec(expansion, case.index).ok();
    let value = |p: &SpecPath| spec.as_ref().and_then(|s| p.get(s)).map(words);
    let one = |d: &Derived| (d.path.text().to_string(), json!(value(&d.path)));
    expansion.derived.iter().map(one).collect()
}

/// The rows of all cases; a case without load cases has one row. `kit` is needed for the values of
/// `set`.
pub fn rows(plan: &Plan, merged: &Merged, kit: Option<&Kit>) -> Vec<Map<String, Value>> {
    let choice = plan.header.choose.as_ref().map(|_| of_choice(merged));
    let of_case = |i: usize| -> Vec<Map<String, Value>> {
        let (case, record) = (&plan.cases[i], merged.records[i].as_ref());
        let known = record.or(merged.checked[i].as_ref());
        let derived = kit.map_or_else(Vec::new, |kit| of_set(plan, kit, case));
        let choice = choice.as_ref().map(|c| &c[i]);
        let one = |load: Option<&LoadRow>| {
            row(plan, case, &Found { record, known, load, choice }, &derived)
        };
        match known.map_or(&[][..], |r| &r.loads) {
            [] => vec![one(None)],
            loads => loads.iter().map(|l| one(Some(l))).collect(),
        }
    };
    (0..plan.cases.len()).into_par_iter().flat_map_iter(of_case).collect()
}

/// The rows as CSV. A text that a spreadsheet would take for a formula gets an apostrophe.
pub fn csv(rows: &[Map<String, Value>]) -> Result<Vec<u8>, Box<Diagnostic>> {
    let fault = |e: String| {
        Box::new(Diagnostic::environment(
            "sweep/write",
            format!("the table cannot be written: {e}"),
        ))
    };
    let mut out = csv::Writer::from_writer(Vec::new());
    if let Some(first) = rows.first() {
        out.write_record(first.keys().map(|k| csv_cell(k))).map_err(|e| fault(e.to_string()))?;
    }
    for row in rows {
        let cells = row.values().map(|v| match v {
            Value::Null => String::new(),
            Value::String(s) => csv_cell(s),
            other => other.to_string(),
        });
        out.write_record(cells).map_err(|e| fault(e.to_string()))?;
    }
    out.into_inner().map_err(|e| fault(e.to_string()))
}

/// The rows as JSON, one a line; values that are absent have no key.
pub fn jsonl(rows: &[Map<String, Value>]) -> String {
    let mut out = String::new();
    for row in rows {
        let present: Map<String, Value> =
            row.iter().filter(|(_, v)| !v.is_null()).map(|(k, v)| (k.clone(), v.clone())).collect();
        out.push_str(&Value::Object(present).to_string());
        out.push('\n');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_texts() {
        let row = |text: &str| {
            let mut m = Map::new();
            m.insert("a".into(), json!(text));
            m
        };
        for (text, cell) in [
            ("=1+1", "'=1+1"),
            ("@x", "'@x"),
            ("-43.2 kN m", "-43.2 kN m"),
            ("-cmd|x", "'-cmd|x"),
            ("-2+cmd|x", "'-2+cmd|x"),
            ("IPE200", "IPE200"),
        ] {
            let out = csv(&[row(text)]).expect("a table");
            assert_eq!(String::from_utf8_lossy(&out), format!("a\n{cell}\n"));
        }
    }
}
