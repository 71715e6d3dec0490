//! The chosen joints: a row for each group.

use super::chosen_joints::ChosenJoint;
use super::merged::Merged;
use super::plan::Plan;
use super::row::{LoadRow, Record};
use bracket_base::math::figures::{Rounding, fixed, utilisation};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_report::document::Doc;
use bracket_report::document::table::Table;
use serde_json::{Map, Value, json};

/// The rows of the chosen joints: names of columns with their values; null where there is none.
pub fn rows(
    plan: &Plan,
    merged: &Merged,
    joints: &[Option<ChosenJoint>],
) -> Vec<Map<String, Value>> {
    let mut out = Vec::new();
    for (d, joint) in merged.decisions.iter().zip(joints) {
        let choice = d.choice();
        let record = choice.and_then(|c| merged.records[c.case].as_ref());
        let loads = record.map_or(&[][..], |r| &r.loads);
        let least =
            |of: fn(&LoadRow) -> Option<f64>| loads.iter().filter_map(of).min_by(f64::total_cmp);
        let used = |l: &&LoadRow| l.governing.as_ref().and_then(|g| g.utilisation).map(|u| u[1]);
        let worst = loads
            .iter()
            .filter(|l| l.governing.is_some())
            .max_by(|a, b| used(a).unwrap_or(0.0).total_cmp(&used(b).unwrap_or(0.0)));
        let by = record.map(|r| if r.result { "limit analysis" } else { "checks" });
        let values = [
            ("group", json!(d.group)),
            ("outcome", json!(if d.open { "open" } else { d.outcome().word() })),
            ("chosen", json!(choice.map(|c| &plan.cases[c.case].name))),
            ("cost", json!(choice.map(|c| c.cost))),
            ("mass_kg", json!(record.and_then(|r| r.mass))),
            ("bolts", json!(record.and_then(|r| r.bolts))),
            ("proved_by", json!(by)),
            ("lambda_low", json!(least(|l| l.lower))),
            ("lambda_up", json!(least(|l| l.upper))),
            ("governing", json!(worst.and_then(|l| l.governing.as_ref()).map(|g| &g.what))),
            ("governing_utilisation", json!(worst.as_ref().and_then(used))),
            ("cheaper_undecided", json!(d.undecided)),
            ("analysed", json!(d.analysed)),
            ("joints", json!(d.joints)),
            ("result", json!(record.filter(|r| r.result).map(Record::folder))),
            ("values", json!(joint.as_ref().map(|j| &j.values))),
            ("spec", json!(joint.as_ref().map(|j| &j.spec))),
            ("report", json!(joint.as_ref().and_then(|j| j.report.as_ref()))),
        ];
        out.push(values.into_iter().map(|(k, v)| (k.to_string(), v)).collect());
    }
    out
}

/// Heads of the table for people, with the columns that they show.
const SHOWN: [(&str, &str); 9] = [
    ("group", "group"),
    ("chosen", "chosen"),
    ("values", "values"),
    ("cost", "cost"),
    ("mass_kg", "mass [kg]"),
    ("bolts", "bolts"),
    ("governing", "governing"),
    ("governing_utilisation", "utilisation"),
    ("proved_by", "proved by"),
];

/// The table for people: heads and cells as text, and the sentence below it.
pub struct Shown {
    /// Heads of the columns.
    pub heads: Vec<&'static str>,
    /// The cells by rows.
    pub cells: Vec<Vec<Text>>,
    /// What is least.
    pub least: String,
    /// How many joints were analysed, and what was left undecided.
    pub sentence: Text,
}

/// The table for people; `meshes`: whether limit analysis follows the checks.
pub fn shown(rows: &[Map<String, Value>], least: &str, meshes: bool) -> Shown {
    let cell = |row: &Map<String, Value>, key: &str| -> Text {
        match &row[key] {
            Value::Null if key == "chosen" => match row["outcome"].as_str() {
                _ if row["joints"] == 0 => "`where` leaves none".into(),
                Some("not_ok") => "none holds".into(),
                Some("open") => "not finished".into(),
                _ => "none is certain to hold".into(),
            },
            Value::Null => Text::default(),
            Value::String(s) if key == "proved_by" => {
                Text::word_of(&["limit analysis", "checks"], s)
            }
            Value::String(s) => Text::given(s),
            // rounded so that nothing looks cheaper or less used than it is
            v => match v.as_f64() {
                Some(x) if key == "governing_utilisation" => utilisation(x, Rounding::Up).into(),
                Some(x) if v.is_f64() => fixed(x, 3, Rounding::Up).into(),
                _ => v.to_string().into(),
            },
        }
    };
    let cells = rows.iter().map(|r| SHOWN.iter().map(|(key, _)| cell(r, key)).collect()).collect();
    let sum = |key: &str| rows.iter().filter_map(|r| r[key].as_u64()).sum::<u64>();
    let analysed = match meshes {
        true => say!("{} of {} joints were analysed.", sum("analysed"), sum("joints")),
        false => say!("{} joints by their checks.", sum("joints")),
    };
    let undecided = match sum("cheaper_undecided") {
        0 => Text::default(),
        1 => "One cheaper joint is undecided: it may hold.".into(),
        n => say!("{} cheaper joints are undecided: they may hold.", n),
    };
    let sentence = Text::joined(" ", [analysed, undecided]);
    let heads = SHOWN.map(|(_, head)| head).to_vec();
    Shown { heads, cells, least: least.into(), sentence }
}

impl Shown {
    /// The chosen joints as lines of text, of the first groups, and the sentence.
    pub fn lines(&self, most: usize) -> Vec<String> {
        let one = |row: &Vec<Text>| {
            let [group, chosen, _, cost, ..] = &row[..] else { return String::new() };
            let [group, cost] = [group, cost].map(Text::to_string);
            let group = if group.is_empty() { group } else { format!("{group}: ") };
            let cost = if cost.is_empty() { cost } else { format!(", cost {cost}") };
            format!("{group}{chosen}{cost}")
        };
        let mut out: Vec<String> = self.cells.iter().take(most).map(one).collect();
        if self.cells.len() > most {
            out.push(format!("and {} more groups", self.cells.len() - most));
        }
        out.push(format!("least {}; {}", self.least, self.sentence));
        out
    }

    /// Writes the table.
    pub fn write(&self, doc: &mut Doc) {
        doc.heading("Chosen joints");
        doc.paragraph(say!("Least `{}`. {}", self.least.replace('`', "'"), &self.sentence));
        let columns = self.heads.iter().map(|h| Text::from(*h)).collect();
        doc.table(&Table { columns, rows: self.cells.clone() });
    }
}
