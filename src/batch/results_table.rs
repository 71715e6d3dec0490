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

/// The columns behind the varied paths.
const COLUMNS: [(&str, Kind); 24] = [
    ("load_case", Kind::Text),
    ("N_kN", Kind::Number),
    ("V_kN", Kind::Number),
    ("M_kNm", Kind::Number),
    ("outcome", Kind::Text),
    ("verdict", Kind::Text),
    ("route", Kind::Text),
    ("by_code", Kind::Text),
    ("by_analysis", Kind::Text),
    ("lambda_low", Kind::Number),
    ("lambda_up", Kind::Number),
    ("utilisation_low", Kind::Number),
    ("utilisation_up", Kind::Number),
    ("M_j_Rd_kNm", Kind::Number),
    ("component_factor", Kind::Number),
    ("S_j_ini_kNm_per_rad", Kind::Number),
    ("governing", Kind::Text),
    ("clause", Kind::Text),
    ("governing_utilisation", Kind::Number),
    ("mass_kg", Kind::Number),
    ("bolts", Kind::Integer),
    ("seconds", Kind::Number),
    ("result", Kind::Text),
    ("cause", Kind::Text),
];

/// The columns of the choice.
const CHOICE: [(&str, Kind); 2] = [("choice", Kind::Text), ("cost", Kind::Number)];

impl Kind {
    /// The kind of a column; those of the varied paths are texts.
    pub fn of(column: &str) -> Self {
        let known = COLUMNS.iter().chain(&CHOICE).find(|(name, _)| *name == column);
        known.map_or(Kind::Text, |(_, kind)| *kind)
    }
}

/// A row of the tables: names of columns with their values; null where there is none. `choice`: the
/// columns of the choice; `derived`: those of the values of `set`. `known` is the record, or what
/// the checks of an unfinished case have found.
fn row(
    plan: &Plan,
    case: &Case,
    (record, known): (Option<&Record>, Option<&Record>),
    load: Option<&LoadRow>,
    choice: Option<&[Value; 2]>,
    derived: &[(String, Value)],
) -> Map<String, Value> {
    let mut row = Map::new();
    row.insert("case".into(), json!(case.name));
    for (path, value) in plan.header.expansion.values(case.index) {
        row.insert(path.into(), json!(value));
    }
    row.extend(derived.iter().cloned());
    let utilisation = load.and_then(|l| bracket_codes::verdict::utilisation(l.lower, l.upper));
    let governing = load.and_then(|l| l.governing.as_ref());
    let with_elements = record.filter(|r| r.result);
    let actions = load.and_then(|l| l.actions);
    // the checks of a case that waits for finite elements are no verdict yet
    let verdict = load.filter(|_| record.is_some()).map(|l| l.verdict);
    let cause = match record {
        Some(record) => record.cause.clone(),
        None => load.map(|_| "by the checks; the analysis is not finished".to_owned()),
    };
    let values = [
        json!(load.map(|l| &l.case)),
        json!(actions.map(|a| 1e-3 * a[0])),
        json!(actions.map(|a| 1e-3 * a[1])),
        json!(actions.map(|a| 1e-6 * a[2])),
        json!(record.map_or("open", |r| r.outcome.word())),
        json!(verdict),
        json!(load.filter(|_| record.is_some()).and_then(|l| l.route)),
        json!(load.map(|l| l.by_code)),
        json!(load.map(|l| l.by_analysis)),
        json!(load.and_then(|l| l.lower)),
        json!(load.and_then(|l| l.upper)),
        json!(utilisation.map(|u| u[0])),
        json!(utilisation.map(|u| u[1])),
        json!(load.and_then(|l| l.moment_resistance).map(|m| 1e-6 * m)),
        json!(load.and_then(|l| l.component_factor)),
        json!(load.and_then(|l| l.component_stiffness).map(|s| 1e-6 * s)),
        json!(governing.map(|g| &g.what)),
        json!(governing.map(|g| &g.clause)),
        json!(governing.and_then(|g| g.utilisation).map(|u| u[1])),
        json!(known.and_then(|r| r.mass)),
        json!(known.and_then(|r| r.bolts)),
        json!(record.and_then(|r| r.seconds)),
        json!(with_elements.map(Record::folder)),
        json!(cause),
    ];
    let names = |columns: &[(&str, Kind)]| -> Vec<String> {
        columns.iter().map(|(name, _)| (*name).to_string()).collect()
    };
    row.extend(names(&COLUMNS).into_iter().zip(values));
    row.extend(names(&CHOICE).into_iter().zip(choice.into_iter().flatten().cloned()));
    row
}

/// The columns of the choice for each case: `choice` is `chosen`, or `not needed` where a cheaper
/// joint holds; `cost` is known of those that can be chosen.
fn of_choice(merged: &Merged) -> Vec<[Value; 2]> {
    let mut out = vec![[Value::Null, Value::Null]; merged.records.len()];
    for d in &merged.decisions {
        for (i, c) in d.candidates.iter().enumerate() {
            let word = match d.chosen {
                Some(k) if k == i => json!("chosen"),
                Some(k) if k < i => json!("not needed"),
                _ => Value::Null,
            };
            out[c.case] = [word, finite(c.cost)];
        }
    }
    out
}

/// A number; null if it is not finite.
pub fn finite(value: f64) -> Value {
    serde_json::Number::from_f64(value).map_or(Value::Null, Value::Number)
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
        let one = |load: Option<&LoadRow>| {
            row(plan, case, (record, known), load, choice.as_ref().map(|c| &c[i]), &derived)
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
