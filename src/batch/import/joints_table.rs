//! Reads the table of joints: which members meet at each, and values of the spec.

use super::joint_columns::{Cells, NAMES};
use super::joint_row::JointRow;
use crate::batch::column::{self, Column, Decimals};
use crate::batch::dimension::Dimension;
use crate::batch::spec_path::SpecPath;
use crate::batch::table;
use bracket_base::diag::{Diagnostic, Diagnostics, Place, did_you_mean};
use bracket_base::grid::{self, Comments, Grid, Row};
use bracket_base::units::with_point;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Faults that are reported at once; a wrong column has one in every row.
const SHOWN: usize = 5;

/// Sheet of a workbook with several that holds the joints.
const SHEET: &str = "joints";

/// Keys of a spec that a joint may have of its own.
const KEYS: [&str; 12] = [
    "project",
    "code",
    "template",
    "members",
    "plate",
    "bolts",
    "parameters",
    "welds",
    "friction",
    "polygon",
    "analysis",
    "expect",
];

/// The joints, and the values of the spec that they have.
#[derive(Clone, Debug)]
pub struct JointsTable {
    /// The file.
    pub file: PathBuf,
    /// The joints.
    pub rows: Vec<JointRow>,
    /// Headers of the paths, with units.
    pub headers: Vec<String>,
    /// Cells of each joint below these headers, with points before decimals.
    pub cells: Vec<Vec<String>>,
    /// The same as values of a sweep.
    pub values: Dimension,
    /// Cells of the column `expect`.
    pub expect: Option<Vec<String>>,
}

/// What a column holds: one of [`NAMES`], or `None` for a value of the spec.
type Kind = Option<&'static str>;

fn fault(
    file: &Path,
    line: usize,
    column: Option<&str>,
    message: String,
    help: &str,
) -> Diagnostic {
    let path = column.map(str::to_owned);
    let place = Place { file: Some(file.into()), line: Some(line), column: None, path };
    Diagnostic { place, ..Diagnostic::input("import/joints", message).help(help) }
}

impl JointsTable {
    /// Reads a table.
    pub fn read(file: &Path) -> Result<Self, Diagnostics> {
        let grid = grid::read(file, None, &[SHEET], Comments::Hash, |e| {
            let message = format!("the table of joints cannot be read: {e}");
            Diagnostic::input("import/joints", message)
                .file(file)
                .help("`--joints` is the path of a CSV table or a workbook")
        })?;
        Self::of_grid(&grid, file)
    }

    fn of_grid(grid: &Grid, file: &Path) -> Result<Self, Diagnostics> {
        let Some((first, rest)) = grid.rows.split_first() else {
            let help = "the first row holds `joint`, `end`, `member`, `station`, each further row \
                        a joint";
            return Err(fault(file, 1, None, "the table is empty".into(), help).into());
        };
        let kinds = kinds(first, file)?;
        if rest.is_empty() {
            let message = "the table has a header but no rows".into();
            return Err(fault(file, first.line, None, message, "write a row for each joint").into());
        }
        let (mut rows, mut faults) = (Vec::new(), Vec::new());
        let mut named: BTreeMap<String, usize> = BTreeMap::new();
        for row in rest {
            match joint(row, &kinds, file) {
                Err(found) => faults.extend(found.iter().cloned()),
                Ok(joint) => {
                    if let Some(earlier) = named.insert(joint.name.clone(), row.line) {
                        let message =
                            format!("the joint `{}` stands in line {earlier} too", joint.name);
                        let help = "give every joint a name of its own; a second member of a \
                                    joint has the columns `end2`, `member2`, `station2`";
                        faults.push(fault(file, row.line, Some("joint"), message, help));
                    }
                    rows.push(joint);
                }
            }
            if faults.len() >= SHOWN {
                break;
            }
        }
        Diagnostics::refuse(faults)?;
        let values = table::of_grid(&of_spec(grid, &kinds), file)?;
        let column = |i: usize| rest.iter().map(move |r| &r.cells[i]);
        let text = |i: usize| first.cells[i].trim().to_owned();
        let is_expect = |i: &usize| matches!(Column::parse(&text(*i)), Ok(Column::Expect));
        let of_spec: Vec<usize> = (0..kinds.len()).filter(|i| kinds[*i].is_none()).collect();
        let expect = of_spec.iter().find(|i| is_expect(i)).map(|i| column(*i).cloned().collect());
        let paths: Vec<usize> = of_spec.into_iter().filter(|i| !is_expect(i)).collect();
        let commas = matches!(grid.separator, Some('\t' | ';'));
        let plain = |r: &Row| paths.iter().map(|i| pointed(&r.cells[*i], commas)).collect();
        Ok(Self {
            file: file.into(),
            rows,
            headers: paths.iter().map(|i| text(*i)).collect(),
            cells: rest.iter().map(plain).collect(),
            values,
            expect,
        })
    }

    /// Gives a joint the value of a path, unless its row has one. True if it did.
    pub fn fill(&mut self, joint: usize, path: &str, text: &str) -> Result<bool, Diagnostics> {
        let wrong = |e: String| Diagnostics::from(Diagnostic::input("import/joints", e));
        let k = match self.values.paths.iter().position(|p| p.text() == path) {
            Some(k) => k,
            None => {
                self.values.paths.push(SpecPath::parse(path).map_err(wrong)?);
                self.values.steps.iter_mut().for_each(|s| s.values.push(None));
                self.headers.push(path.into());
                self.cells.iter_mut().for_each(|c| c.push(String::new()));
                self.headers.len() - 1
            }
        };
        if self.values.steps[joint].values[k].is_some() {
            return Ok(false);
        }
        let value = column::value(text, None, Decimals::Point).map_err(wrong)?;
        self.values.steps[joint].values[k] = value;
        self.cells[joint][k] = text.into();
        Ok(true)
    }

    /// Whether the row of a joint gives a value of this path.
    pub fn gives(&self, joint: usize, path: &str) -> bool {
        let at = self.values.paths.iter().position(|p| p.text() == path);
        at.is_some_and(|k| self.values.steps[joint].values[k].is_some())
    }
}

/// What each column holds.
fn kinds(header: &Row, file: &Path) -> Result<Vec<Kind>, Diagnostics> {
    let mut kinds: Vec<Kind> = Vec::new();
    for cell in &header.cells {
        let refused =
            |message: String, help: &str| fault(file, header.line, Some(cell), message, help);
        let own = NAMES.into_iter().find(|n| n.eq_ignore_ascii_case(cell.trim()));
        if own.is_some() && kinds.contains(&own) {
            let message = format!("the column `{cell}` is there twice");
            return Err(refused(message, "delete one of them").into());
        }
        if own.is_none() {
            let key = cell.split(['.', '[', ' ']).next().unwrap_or_default();
            match key {
                "loads" => {
                    let message = format!("the column `{cell}`: the loads come from the forces");
                    let help = "leave it out; `--cases` chooses load cases, `--sls` their state";
                    return Err(refused(message, help).into());
                }
                key if KEYS.contains(&key) => {}
                _ => {
                    let hint = did_you_mean(cell, NAMES.into_iter().chain(KEYS));
                    let message = format!("unknown column `{cell}`{hint}");
                    let help = "columns are `joint`, `end`, `member`, `station`, `node`, `at`, \
                                the same with a 2 behind them, `column_below`, `column_above` \
                                with `station_…` and `node_…`, `expect`, and paths of the spec \
                                such as `plate.thickness`";
                    return Err(refused(message, help).into());
                }
            }
        }
        kinds.push(own);
    }
    for wanted in ["joint", "end", "member", "station"] {
        if !kinds.contains(&Some(wanted)) {
            let message = format!("the table has no column `{wanted}`");
            let help = "it needs `joint` (a name), `end` (a member end of the template), `member` \
                        (its name in the table of forces) and `station` (`start` or `end`)";
            return Err(fault(file, header.line, None, message, help).into());
        }
    }
    Ok(kinds)
}

/// The joint of a row.
fn joint(row: &Row, kinds: &[Kind], file: &Path) -> Result<JointRow, Diagnostics> {
    if row.cells.len() != kinds.len() {
        let message = format!("the row has {} cells, the header {}", row.cells.len(), kinds.len());
        let help = "a decimal comma or a comma in a name splits a cell: write points, and put \
                    names into quotes";
        return Err(fault(file, row.line, None, message, help).into());
    }
    let given = kinds.iter().zip(&row.cells).filter(|(_, c)| !c.is_empty());
    let cells = Cells(given.filter_map(|(k, c)| Some(((*k)?, c.as_str()))).collect());
    cells.joint(row.line).map_err(|(column, message, help)| {
        let name = cells.0.get("joint").map_or_else(String::new, |n| format!("joint `{n}`: "));
        fault(file, row.line, Some(column), format!("{name}{message}"), help).into()
    })
}

/// The table without the columns that say which members meet.
fn of_spec(grid: &Grid, kinds: &[Kind]) -> Grid {
    let kept = |i: &usize| matches!(kinds[*i], None | Some("joint"));
    let cells = |row: &Row| -> Vec<String> {
        (0..kinds.len()).filter(kept).map(|i| row.cells[i].clone()).collect()
    };
    let mut rows: Vec<Row> =
        grid.rows.iter().map(|r| Row { line: r.line, cells: cells(r) }).collect();
    let name = (0..kinds.len()).filter(kept).position(|i| kinds[i].is_some());
    if let (Some(row), Some(name)) = (rows.first_mut(), name) {
        row.cells[name] = "name".into();
    }
    Grid { rows, separator: grid.separator, sheet: grid.sheet.clone() }
}

/// A cell with points before decimals. `commas`: commas may stand there.
fn pointed(cell: &str, commas: bool) -> String {
    if !commas {
        return cell.into();
    }
    let list = cell.strip_prefix('[').and_then(|c| c.strip_suffix(']'));
    let number = |text: &str| with_point(text).unwrap_or_else(|| text.into());
    match list.filter(|inner| inner.contains(';')) {
        Some(inner) => {
            let entries = inner.split([';', ' ']).filter(|e| !e.is_empty());
            format!("[{}]", entries.map(number).collect::<Vec<_>>().join("; "))
        }
        None if list.is_some() => cell.into(),
        None => number(cell),
    }
}
