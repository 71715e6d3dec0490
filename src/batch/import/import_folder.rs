//! The folder of an import: a sweep, its base spec, its table, and the load cases of each joint.

use super::end_loads::EndLoads;
use super::joint_row::{JointRow, MemberAt};
use super::joints_table::JointsTable;
use super::residuals_table;
use crate::batch::column::NOTE_MARK;
use crate::batch::worker::absolute;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::yaml;
use bracket_joint::spec::table_loads::written;
use bracket_report::result::file_names::file_stem;
use bracket_report::result::folder::{Content, ResultFolder};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Name of the sweep, by which a folder of an earlier import is known.
pub const SWEEP: &str = "sweep.yaml";

/// Name of the base spec.
const BASE: &str = "base.yaml";

/// Name of the table of joints.
const JOINTS: &str = "joints.csv";

/// Folder of the tables of load cases.
const LOADS: &str = "loads";

/// Starts the folder, which must not exist, or be one of an earlier import.
pub fn begin(target: &Path) -> Result<ResultFolder, Diagnostics> {
    let content = Content::Files { mark: SWEEP, command: "import" };
    Ok(ResultFolder::begin_with(target, content)?)
}

/// File names of the load cases of each joint: no two differ by case alone.
fn files(table: &JointsTable) -> Vec<String> {
    let mut taken: Vec<String> = Vec::new();
    for row in &table.rows {
        let stem = file_stem(&row.name);
        let free = |name: &String| !taken.iter().any(|t| t.eq_ignore_ascii_case(name));
        let name = (1..)
            .map(|n| if n == 1 { stem.clone() } else { format!("{stem}-{n}") })
            .find(free)
            .unwrap_or_default();
        taken.push(name);
    }
    taken.into_iter().map(|name| format!("{LOADS}/{name}.csv")).collect()
}

/// The table of joints as the sweep reads it.
fn joints(table: &JointsTable, files: &[String]) -> Result<String, Diagnostics> {
    let fault = |e: &dyn std::fmt::Display| {
        Diagnostics::from(Diagnostic::environment("import/write", e.to_string()))
    };
    let mut out = csv::Writer::from_writer(Vec::new());
    let expect = table.expect.iter().map(|_| "expect");
    let words = ["name", "loads.table"].into_iter().chain(expect);
    let notes = notes(table);
    let headers = words.chain(notes.iter().map(|(header, _)| header.as_str()));
    let headers = headers.chain(table.headers.iter().map(String::as_str));
    out.write_record(headers).map_err(|e| fault(&e))?;
    for (i, row) in table.rows.iter().enumerate() {
        let expect = table.expect.iter().map(|e| e[i].as_str());
        let words = [row.name.as_str(), files[i].as_str()].into_iter().chain(expect);
        let words = words.chain(notes.iter().map(|(_, texts)| texts[i].as_str()));
        let cells = words.chain(table.cells[i].iter().map(String::as_str));
        out.write_record(cells).map_err(|e| fault(&e))?;
    }
    let bytes = out.into_inner().map_err(|e| fault(&e))?;
    String::from_utf8(bytes).map_err(|e| fault(&e))
}

/// The members at the ends of each joint, under the names of the table of forces: columns of notes,
/// which the tables of results repeat. Columns that are empty or that the user gives are left out.
fn notes(table: &JointsTable) -> Vec<(String, Vec<String>)> {
    let name = |at: &MemberAt| at.member.clone();
    let texts = |row: &JointRow| -> [Option<String>; 6] {
        let (first, second) = (row.ends.first(), row.ends.get(1));
        [
            first.map(|e| e.end.clone()),
            first.map(|e| name(&e.member)),
            second.map(|e| e.end.clone()),
            second.map(|e| name(&e.member)),
            row.below.as_ref().map(name),
            row.above.as_ref().map(name),
        ]
    };
    let names = ["end", "member", "end2", "member2", "column_below", "column_above"];
    let mut out = Vec::new();
    for (i, name) in names.into_iter().enumerate() {
        let header = format!("{NOTE_MARK}{name}");
        let texts: Vec<String> =
            table.rows.iter().map(|row| texts(row)[i].clone().unwrap_or_default()).collect();
        let given = table.headers.iter().any(|h| h.eq_ignore_ascii_case(&header));
        if !given && texts.iter().any(|t| !t.is_empty()) {
            out.push((header, texts));
        }
    }
    out
}

/// The base spec with the load cases of the first joint. `from`: the folder of its paths.
fn base(spec: &Value, from: &Path, first: &str) -> Result<String, Diagnostics> {
    let from = if from.as_os_str().is_empty() { Path::new(".") } else { from };
    let from = std::path::absolute(from).unwrap_or_else(|_| from.to_path_buf());
    let mut spec = absolute(spec.clone(), &from);
    if let Some(keys) = spec.as_object_mut() {
        keys.insert("loads".into(), json!({"table": first}));
    }
    yaml::to_string(&spec)
}

/// Writes the folder and moves it into place; returns the path of the sweep. `residuals`: the table
/// of what the members at the nodes leave.
pub fn finish(
    folder: ResultFolder,
    table: &JointsTable,
    (loads, residuals): (&[EndLoads], Option<&str>),
    (spec, from): (&Value, &Path),
) -> Result<PathBuf, Diagnostics> {
    let files = files(table);
    let first = files.first().map_or("", String::as_str);
    let sweep = format!(
        "# Written by `bracket import`, which replaces it. `then: {{limit: undecided}}` adds limit \
         analysis.\nbase: {BASE}\ntable: {JOINTS}\nfirst: checks\n"
    );
    folder.write(SWEEP, sweep.as_bytes())?;
    folder.write(BASE, base(spec, from, first)?.as_bytes())?;
    folder.write(JOINTS, joints(table, &files)?.as_bytes())?;
    for (file, loads) in files.iter().zip(loads) {
        folder.write(file, written(&loads.listed()).as_bytes())?;
    }
    if let Some(residuals) = residuals {
        folder.write(residuals_table::FILE, residuals.as_bytes())?;
    }
    Ok(folder.finish()?.join(SWEEP))
}
