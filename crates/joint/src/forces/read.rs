//! Reads the rows of a table of forces.

use super::asked::Asked;
use super::force_row::{ForceRow, Forces};
use super::headers::{Column, HeaderFault, Headers};
use super::iom;
use super::program::{Program, Quantity};
use bracket_base::diag::{Diagnostic, Diagnostics, Place};
use bracket_base::grid::{self, Comments, Grid, Row};
use bracket_base::xml::is_xml;
use std::collections::BTreeMap;
use std::path::Path;

/// Faults that are reported at once; a wrong column has one in every row.
const SHOWN: usize = 5;

/// Where a table is and how it is written.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The file.
    pub file: &'a Path,
    /// Sheet of a workbook.
    pub sheet: Option<&'a str>,
    /// The program whose headers, axes and signs it has; `None`: those of Bracket.
    pub program: Option<Program>,
    /// Headers that the user names.
    pub columns: &'a BTreeMap<Quantity, String>,
    /// Who asks for it.
    pub asked: Asked,
}

/// Reads a file of forces.
pub fn read(source: &Source<'_>) -> Result<Forces, Diagnostics> {
    let Source { file, sheet, program, columns, asked } = *source;
    if program == Some(Program::Iom) {
        let wrong = |message: &str| {
            let help = "leave it out: members, load cases and units are known by the elements";
            Err(Diagnostic::input("loads/iom", message).file(file).help(help).into())
        };
        return match (sheet, columns.is_empty()) {
            (Some(_), _) => {
                wrong(&format!("an IOM file has no sheets, and {} is given", asked.sheet()))
            }
            (_, false) => wrong("an IOM file has no headers, and `columns` is given"),
            _ => iom::forces(file),
        };
    }
    if is_xml(file) {
        let message = "this is an XML file, not a table";
        let iom = asked.mapping(Some(Program::Iom));
        let help = format!("the container of IDEA StatiCa (IOM) is read with {iom}");
        return Err(Diagnostic::input("loads/table", message).file(file).help(help).into());
    }
    let grid = grid::read(file, sheet, Program::sheets(program), Comments::None, |e| {
        Diagnostic::input(
            "loads/table",
            format!("the table `{}` cannot be read: {e}", file.display()),
        )
        .file(file)
        .help("the path of a table is relative to the file that names it")
    })?;
    of_grid(&grid, source)
}

fn fault(
    file: &Path,
    line: usize,
    header: Option<&str>,
    message: String,
    help: &str,
) -> Diagnostic {
    let (file, path) = (Some(file.into()), header.map(str::to_owned));
    let place = Place { file, line: Some(line), column: None, path };
    Diagnostic { place, ..Diagnostic::input("loads/table", message).help(help) }
}

pub(super) fn of_grid(grid: &Grid, source: &Source<'_>) -> Result<Forces, Diagnostics> {
    let Source { file, program, columns, asked, .. } = *source;
    let headers = Headers::find(&grid.rows, program, columns, asked)
        .map_err(|HeaderFault { line, message, help }| fault(file, line, None, message, &help))?;
    let rows = &grid.rows[headers.first..];
    if rows.is_empty() {
        let line = grid.rows.last().map_or(1, |r| r.line);
        let help = "each row below the header is a load case";
        return Err(fault(file, line, None, "the table has no rows".into(), help).into());
    }
    no_envelope(rows, &headers, file)?;
    let decimal = decimal(rows, &headers.columns, grid.separator, file)?;
    let mut out = Vec::with_capacity(rows.len());
    let mut faults = Vec::new();
    for row in rows {
        complete(row, &headers, grid.separator.is_some(), file)?;
        match of_row(row, &headers.columns, decimal) {
            Ok(row) => out.push(row),
            Err((header, message)) => {
                let help = "write a number, without a unit where the header has it, or delete a \
                            row that is no load case";
                faults.push(fault(file, row.line, Some(&header), message, help));
            }
        }
    }
    if faults.len() > SHOWN {
        let more = format!("{} more faults in the table", faults.len() - SHOWN);
        faults.truncate(SHOWN);
        faults.push(fault(file, 1, None, more, "correct these first"));
    }
    Diagnostics::refuse(faults)?;
    let given = Quantity::ACTIONS.map(|q| headers.columns.iter().any(|c| c.quantity == q));
    Ok(Forces { rows: out, given, refused: BTreeMap::new() })
}

fn cell<'a>(row: &'a Row, column: &Column) -> &'a str {
    let whole = row.cells.get(column.index).map_or("", String::as_str);
    match column.part {
        Some(part) => whole.split('/').nth(part).unwrap_or(""),
        None => whole,
    }
    .trim()
}

/// A product of a decimal number and the factor of a unit without the noise of its last digit:
/// 12.3 kN is 12300 N. A double holds 15 digits of any decimal number.
fn decimal_value(product: f64) -> f64 {
    format!("{product:.14e}").parse().unwrap_or(product)
}

fn of_row(row: &Row, columns: &[Column], decimal: char) -> Result<ForceRow, (String, String)> {
    let (mut texts, mut actions) = (BTreeMap::new(), [0.0; 6]);
    for column in columns {
        let text = cell(row, column);
        match column.quantity.action() {
            // the first of several columns that says something counts
            None if !text.is_empty() => {
                texts.entry(column.quantity).or_insert_with(|| text.to_owned());
            }
            None => {}
            // an empty cell is zero: programs leave out what does not act
            Some(_) if text.is_empty() => {}
            Some(i) => {
                let Some(value) = grid::number(text, decimal) else {
                    let message = format!("column `{}`: `{text}` is not a number", column.header);
                    return Err((column.header.clone(), message));
                };
                actions[i] = decimal_value(column.factor * value);
            }
        }
    }
    let station = texts.get(&Quantity::Station).and_then(|text| {
        // a unit may stand behind it
        grid::number(text.split_whitespace().next()?, decimal)
    });
    Ok(ForceRow { line: row.line, texts, station, length: None, actions })
}

/// The decimal sign of the actions. Between commas, and in the cells of a workbook, a point is one.
fn decimal(
    rows: &[Row],
    columns: &[Column],
    separator: Option<char>,
    file: &Path,
) -> Result<char, Diagnostics> {
    let numeric = |q: Quantity| q.action().is_some() || q == Quantity::Station;
    let numbers = || columns.iter().filter(|c| numeric(c.quantity));
    let cells: Vec<&str> = rows.iter().flat_map(|r| numbers().map(move |c| cell(r, c))).collect();
    let clear = matches!(separator, Some(',') | None);
    if clear && !cells.iter().any(|c| c.contains(',')) {
        return Ok('.');
    }
    grid::decimal_sign(cells.into_iter()).map_err(|[a, b]| {
        let line = |text: &str| {
            let holds = |r: &&Row| numbers().any(|c| cell(r, c) == text);
            rows.iter().find(holds).map_or(1, |r| r.line)
        };
        let (at, message) = match a == b {
            true => {
                let [point, comma] = [a.replace(',', "."), a.replace([',', '.'], "")];
                (line(&a), format!("`{a}` may be {point} or {comma}"))
            }
            false => {
                let [first, other] = [line(&a), line(&b)];
                let of = |l: usize| match first == other {
                    true => String::new(),
                    false => format!(" in line {l}"),
                };
                let (point, comma) = (of(first), of(other));
                let message = format!(
                    "`{a}`{point} has a point before its decimals and `{b}`{comma} a comma"
                );
                (first.max(other), message)
            }
        };
        let help =
            "write all decimals of the table with the same sign and nothing between thousands";
        fault(file, at, None, message, help).into()
    })
}

/// Refuses a row that does not have the cells of the header: a comma within a number or a name has
/// moved them. `text`: rows of a workbook all have the same width.
fn complete(row: &Row, headers: &Headers, text: bool, file: &Path) -> Result<(), Diagnostics> {
    let actions = headers.columns.iter().filter(|c| c.quantity.action().is_some());
    let last = actions.map(|c| c.index).max().unwrap_or(0);
    let beyond = row.cells.iter().skip(headers.texts.len()).any(|c| !c.is_empty());
    let short = text && row.cells.len() <= last;
    if !(beyond || short) {
        return Ok(());
    }
    let (found, wanted) = (row.cells.len(), headers.texts.len());
    let message = format!("the row has {found} cells, the header {wanted}");
    let help = "a decimal comma or a comma in a name splits a cell: write points, and put names \
                into quotes";
    Err(fault(file, row.line, None, message, help).into())
}

/// Refuses the rows of an envelope. Their actions do not act together.
fn no_envelope(rows: &[Row], headers: &Headers, file: &Path) -> Result<(), Diagnostics> {
    let steps: Vec<&Column> =
        headers.columns.iter().filter(|c| c.quantity == Quantity::Step).collect();
    let texts = headers.texts.len();
    let numbers: Vec<usize> =
        headers.columns.iter().filter(|c| c.quantity.action().is_some()).map(|c| c.index).collect();
    for row in rows {
        let stepped = steps.iter().map(|c| cell(row, c)).find(|t| is_extreme(t));
        let other = (0..texts.max(row.cells.len()))
            .filter(|i| !numbers.contains(i))
            .filter_map(|i| row.cells.get(i))
            .find(|t| is_extreme(t));
        let named = headers.columns.iter().filter(|c| c.quantity == Quantity::Case);
        let named = named.map(|c| cell(row, c)).find(|t| names_envelope(t));
        if let Some(word) = stepped.or(other.map(String::as_str)).or(named) {
            let message = format!(
                "the row `{word}` belongs to an envelope: its actions are extremes of several load \
                 cases and do not act together"
            );
            let help = "export the single combinations, or for each extreme the actions that act \
                        with it";
            return Err(fault(file, row.line, None, message, help).into());
        }
    }
    Ok(())
}

/// Whether a load case is called an envelope: `ENV_Max`, `Umhüllende min`, `MaxMy`.
fn names_envelope(name: &str) -> bool {
    let lower = name.to_lowercase();
    let words = lower.split(|c: char| !c.is_alphanumeric());
    let envelope = |w: &str| {
        let starts = ["envelop", "umhüll", "hüllkurve"].iter().any(|s| w.starts_with(s));
        w == "env" || starts
    };
    let of_action = |w: &str| {
        let rest = w.strip_prefix("max").or_else(|| w.strip_prefix("min"));
        rest.is_some_and(|r| Quantity::ACTIONS.iter().any(|q| q.word().eq_ignore_ascii_case(r)))
    };
    words.into_iter().any(|w| envelope(w) || of_action(w))
}

/// `Max`, `min`, `max My`: what programs write beside the rows of an envelope.
fn is_extreme(text: &str) -> bool {
    let mut words = text.split_whitespace();
    let first = words.next().unwrap_or_default().trim_end_matches('.').to_ascii_lowercase();
    let rest: Vec<&str> = words.collect();
    let of_action = |w: &str| {
        Quantity::ACTIONS.iter().any(|q| q.word().eq_ignore_ascii_case(&w.replace('-', "")))
            || ["P", "V2", "V3", "M2", "M3", "MT", "Mx"].iter().any(|n| n.eq_ignore_ascii_case(w))
    };
    matches!(first.as_str(), "max" | "min" | "maximum" | "minimum")
        && (rest.is_empty() || rest.len() == 1 && of_action(rest[0]))
}
