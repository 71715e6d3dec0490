//! What the printed summary of a sweep says: counts, chosen joints, capacity tables, cases.

use super::capacity::Filled;
use super::choice_table::Shown;
use super::counts::Counts;
use super::row::Outcome;
use super::summary::worst_first;
use bracket_base::math::figures::{Rounding, significant, utilisation};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_report::document::block::Block;
use bracket_report::document::section;
use bracket_report::document::table::Table;
use bracket_report::result::result_file::Tool;
use bracket_report::sheet::Section;
use bracket_report::sheet::head::{Head, Paper};
use bracket_report::sheet::sweep::SweepSheet;
use bracket_report::words::Words;
use serde_json::{Map, Value};

/// Cases that are printed: more pages than these nobody reads.
const MOST_ROWS: usize = 400;

/// Key of the utilisation.
const USED: &str = "governing_utilisation";

/// Columns of the table of cases: key of a row, title, rounding of numbers.
const COLUMNS: [(&str, &str, Option<Rounding>); 10] = [
    ("case", "joint", None),
    ("load_case", "load case", None),
    ("N_kN", "N [kN]", Some(Rounding::Nearest)),
    ("V_kN", "V [kN]", Some(Rounding::Nearest)),
    ("M_kNm", "M [kN m]", Some(Rounding::Nearest)),
    ("outcome", "outcome", None),
    ("lambda_low", "load factor ≥", Some(Rounding::Down)),
    ("lambda_up", "≤", Some(Rounding::Up)),
    ("governing", "governing", None),
    (USED, "utilisation", Some(Rounding::Nearest)),
];

/// The sheet of a sweep. `project` is the title block of its base.
pub fn sheet(
    title: &str,
    project: &Value,
    words: &Words,
    counts: &Counts,
    broken: &[String],
    (choice, tables): (Option<&Shown>, &[Filled]),
    rows: &[Map<String, Value>],
) -> SweepSheet {
    let value = |name: &str| match &project[name] {
        Value::Null => None,
        Value::String(s) => Some(s.clone()),
        other => Some(other.to_string()),
    };
    let names = ["number", "author", "checker", "date", "revision"];
    let project = names.iter().filter_map(|n| Some((n.to_string(), value(n)?))).collect();
    let outcomes = Section {
        title: words.say(&"Cases by outcome".into()),
        blocks: outcomes(counts, broken, words),
    };
    // the first block is the heading of the text
    let titled = |blocks: Vec<Block>| {
        let mut blocks = blocks.into_iter();
        let Some(Block::Heading { text, .. }) = blocks.next() else { return None };
        let title = text.into_iter().map(|s| s.text).collect();
        Some(Section { title, blocks: blocks.collect() })
    };
    let choice = choice.and_then(|c| titled(section(words, |doc| c.write(doc))));
    let table = |t: &Filled| titled(section(words, |doc| t.write(doc)));
    let paper = Paper::default();
    SweepSheet {
        head: Head::new(paper, title.into(), project, words, &Tool::this(), String::new()),
        overview: [Some(outcomes), choice].into_iter().flatten().collect(),
        tables: tables.iter().filter_map(table).collect(),
        cases: Section { title: words.say(&"Cases".into()), blocks: cases(rows, words) },
    }
}

fn outcomes(counts: &Counts, broken: &[String], words: &Words) -> Vec<Block> {
    let found = Outcome::ALL.iter().filter(|o| counts.with(**o) > 0);
    let row = |word: &'static str, count: usize| [word.into(), count.to_string().into()];
    let mut rows: Vec<[Text; 2]> = found.map(|o| row(o.plain(), counts.with(*o))).collect();
    if counts.open > 0 {
        rows.push(row("not finished", counts.open));
    }
    rows.push(row("all", counts.all()));
    section(words, |doc| {
        doc.table(&Table::new(["outcome", "cases"], rows));
        if !broken.is_empty() {
            doc.paragraph(say!("{}:", "Expected, and not so"));
            doc.list(broken.iter().map(Text::given));
        }
    })
}

/// The cases, or the worst of them.
fn cases(rows: &[Map<String, Value>], words: &Words) -> Vec<Block> {
    let shown = worst_first(rows, MOST_ROWS);
    let cell = |row: &Map<String, Value>, key: &str, rounding: Option<Rounding>| -> Text {
        let value = row.get(key).unwrap_or(&Value::Null);
        match (value.as_f64(), rounding, value) {
            (Some(x), Some(r), _) if key == USED => utilisation(x, r).into(),
            (Some(x), Some(r), _) => significant(x, 4, r).replace('-', "−").into(),
            (_, _, Value::String(s)) if key == "outcome" => {
                let named = |word: &str| Outcome::ALL.into_iter().find(|o| o.word() == word);
                // the outcome is that of the joint, the row that of one of its load cases
                let verdict = row.get("verdict").and_then(Value::as_str);
                let own = verdict.and_then(named);
                let outcome = match named(s) {
                    Some(Outcome::Ok | Outcome::NotOk) if verdict == Some("none") => {
                        return Text::given("–");
                    }
                    Some(Outcome::Ok | Outcome::NotOk | Outcome::Undecided) => own.or(named(s)),
                    other => other,
                };
                outcome.map_or_else(|| Text::given(s), |o| o.plain().into())
            }
            (_, _, Value::String(s)) => Text::given(s),
            _ => Text::given("–"),
        }
    };
    let row = |row: &&Map<String, Value>| COLUMNS.map(|(key, _, r)| cell(row, key, r)).to_vec();
    let table = Table {
        columns: COLUMNS.map(|c| Text::from(c.1)).to_vec(),
        rows: shown.iter().map(row).collect(),
    };
    section(words, |doc| {
        if shown.len() < rows.len() {
            doc.paragraph(say!(
                "{} of {} rows, the worst first; results.csv has all.",
                shown.len(),
                rows.len()
            ));
        }
        doc.table(&table);
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;
    use std::collections::BTreeMap;

    /// A joint with two load cases, of which one is not carried; and one that was ended.
    #[test]
    fn a_row_has_the_outcome_of_its_load_case() {
        let row = |load: &str, outcome: &str, verdict: Value| -> Map<String, Value> {
            let values = [
                ("case", json!("a")),
                ("load_case", json!(load)),
                ("outcome", json!(outcome)),
                ("verdict", verdict),
            ];
            values.map(|(k, v)| (k.to_string(), v)).into_iter().collect()
        };
        let rows = [
            row("U1", "not_ok", json!("not_ok")),
            row("U2", "not_ok", json!("ok")),
            row("U3", "timed_out", json!("ok")),
            row("U4", "undecided", json!("none")),
            row("S1", "not_ok", json!("none")),
        ];
        let blocks = cases(&rows, &Words::default());
        let [Block::Table { table }] = &blocks[..] else { panic!("{blocks:?}") };
        let text = |cell: &[bracket_report::document::block::Span]| cell[0].text.clone();
        let found: BTreeMap<String, String> =
            table.rows.iter().map(|r| (text(&r[1]), text(&r[5]))).collect();
        let want =
            [("U1", "not ok"), ("U2", "ok"), ("U3", "timed out"), ("U4", "undecided"), ("S1", "–")];
        assert_eq!(found, want.map(|(k, v)| (k.into(), v.into())).into());
    }
}
