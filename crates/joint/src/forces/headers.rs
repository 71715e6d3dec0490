//! Finds the columns of a table of forces by their headers.

use super::asked::Asked;
use super::program::{Heading, Program, Quantity};
use bracket_base::diag::did_you_mean;
use bracket_base::grid::Row;
use bracket_base::units::unit;
use std::collections::BTreeMap;

/// Rows in which the header is looked for: programs write titles above a table.
const SEARCHED: usize = 100;

/// A column that holds a quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its number.
    pub index: usize,
    /// What it holds.
    pub quantity: Quantity,
    /// Factor from the number of a cell to N or N mm, sign included; 1 for texts.
    pub factor: f64,
    /// Its header.
    pub header: String,
    /// Which part of its cells, where they hold several texts: `Bar/Node/Case`.
    pub part: Option<usize>,
}

/// The header of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Headers {
    /// Index of the row after it, and after the units below it.
    pub first: usize,
    /// Columns with a quantity, in the order in which their cells count.
    pub columns: Vec<Column>,
    /// The texts of all headers.
    pub texts: Vec<String>,
}

/// A fault of a header: the line, what is wrong, and what to do.
#[derive(Clone, Debug, PartialEq)]
pub struct HeaderFault {
    /// Line of the table.
    pub line: usize,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub help: String,
}

/// A header as a user names it: its text with the sign before it.
fn signed(text: &str) -> (f64, &str) {
    match text.trim().strip_prefix(['-', '−']) {
        Some(rest) => (-1.0, rest.trim()),
        None => (1.0, text.trim()),
    }
}

/// Splits `M-y [kNm]` into the name and the unit.
fn split(header: &str) -> (String, Option<&str>) {
    let header = header.trim();
    let cut = match header.chars().last() {
        Some(']') => header.rfind('['),
        Some(')') => header.rfind('('),
        _ => None,
    };
    let (name, unit) = match cut {
        Some(i) => (&header[..i], Some(&header[i + 1..header.len() - 1])),
        // a comma stands before the unit in tables of some spreadsheets
        None => header.split_once(", ").map_or((header, None), |(n, u)| (n, Some(u))),
    };
    let words: Vec<&str> = name.split_whitespace().collect();
    (words.join(" "), unit.map(str::trim).filter(|u| !u.is_empty()))
}

fn same(a: &str, b: &str) -> bool {
    a.trim().eq_ignore_ascii_case(b.trim())
}

/// The factor of a unit of an action to N or N mm; programs write `KN-m`, `kN.m` and `kNm`.
fn factor(text: &str, quantity: Quantity) -> Option<f64> {
    let dim = quantity.kind().dim();
    let spaced = text.replace(['-', '.', '_'], " ");
    let known = |t: &str| unit(t).filter(|(_, d)| *d == dim).map(|(f, _)| f);
    let usual = || {
        let usual = spaced.to_ascii_lowercase();
        known(&usual.replace("kn", "kN").replace("mn", "MN").replace("kips", "kip"))
    };
    known(&spaced).or_else(usual)
}

impl Headers {
    /// Finds the header of a table: the row that names most actions. `own`: the headers that the
    /// user names, by quantity.
    pub fn find(
        rows: &[Row],
        program: Option<Program>,
        own: &BTreeMap<Quantity, String>,
        asked: Asked,
    ) -> Result<Self, HeaderFault> {
        let score = |row: &Row| {
            let named = |q: &Quantity| !matching(row, *q, program, own).is_empty();
            let actions = Quantity::ACTIONS.iter().filter(|q| named(q)).count();
            let others = Quantity::ALL.iter().filter(|q| q.action().is_none() && named(q)).count();
            if actions == 0 { 0 } else { 100 * actions + others }
        };
        let best = (0..rows.len().min(SEARCHED)).max_by_key(|i| (score(&rows[*i]), SEARCHED - i));
        let Some(at) = best.filter(|i| score(&rows[*i]) > 0) else {
            return Err(no_header(rows, program, own, asked));
        };
        let row = &with_titles(rows, at, program);
        let by_header =
            |q: &Quantity| !own.contains_key(q) && !matching(row, *q, program, own).is_empty();
        let guessed = program.is_none() && Quantity::ACTIONS.iter().any(by_header);
        if let (true, Some((header, other))) = (guessed, of_other(row)) {
            return Err(HeaderFault {
                line: row.line,
                message: format!(
                    "`{header}` is a header of {}, and actions with the same names have other \
                     signs there",
                    asked.mapping(Some(other))
                ),
                help: match asked {
                    Asked::Spec => "name the program with `mapping`; or, for a table with the \
                                    signs of Bracket, its headers with `columns`"
                        .into(),
                    Asked::Command => format!(
                        "name the program with `--mapping`; or, for a table with the signs of \
                         Bracket, rename the column `{header}`"
                    ),
                },
            });
        }
        for (quantity, header) in own {
            if matching(row, *quantity, program, own).is_empty() {
                let told: Vec<&str> = row.cells.iter().map(String::as_str).collect();
                let near = did_you_mean(header, told.iter().copied());
                return Err(HeaderFault {
                    line: row.line,
                    message: format!(
                        "`columns: {}` names the header `{header}`, which is not there{near}",
                        quantity.word()
                    ),
                    help: format!("the headers are {}", list(&told)),
                });
            }
        }
        let units = rows.get(at + 1).filter(|below| holds_units(row, below, program, own));
        let mut columns = Vec::new();
        for quantity in Quantity::ALL {
            columns.extend(of_quantity(row, units, quantity, (program, asked), own)?);
        }
        all_read(row, units, &columns, asked)?;
        let first = at + 1 + usize::from(units.is_some());
        Ok(Self { first, columns, texts: row.cells.clone() })
    }
}

/// The header at `at`, with the names above it of columns that it does not name itself: programs
/// write `Lastfall` over an empty cell and `Stab` over `Nr.`.
fn with_titles(rows: &[Row], at: usize, program: Option<Program>) -> Row {
    let mut row = rows[at].clone();
    let Some(above) = at.checked_sub(1).map(|i| &rows[i]) else { return row };
    let none = BTreeMap::new();
    let names = |cell: &str, text_only: bool| {
        let alone = Row { line: row.line, cells: vec![cell.to_owned()] };
        let of = |q: &&Quantity| !text_only || q.action().is_none();
        Quantity::ALL.iter().filter(of).any(|q| !matching(&alone, *q, program, &none).is_empty())
    };
    let mut found: Vec<(usize, String)> = Vec::new();
    for (i, cell) in row.cells.iter().enumerate() {
        let title = above.cells.get(i).map_or("", String::as_str);
        if !names(cell, false) && names(title, true) {
            found.push((i, title.to_owned()));
        }
    }
    found.into_iter().for_each(|(i, title)| row.cells[i] = title);
    row
}

/// A header that only another program has, and the program: the one that knows most headers.
fn of_other(row: &Row) -> Option<(&str, Program)> {
    let texts = [Quantity::Case, Quantity::Member, Quantity::Station, Quantity::Node];
    let none = BTreeMap::new();
    let found = |q: Quantity, p: Option<Program>| matching(row, q, p, &none).first().map(|m| m.0);
    let known = |p: Program| texts.iter().filter(|q| found(**q, Some(p)).is_some()).count();
    let foreign = |p: Program| {
        let mine = texts.map(|q| found(q, None));
        let theirs = texts.iter().filter_map(|q| found(*q, Some(p)));
        theirs.into_iter().find(|i| !mine.contains(&Some(*i)))
    };
    let other = Program::ALL.into_iter().rev().max_by_key(|p| known(*p))?;
    foreign(other).map(|i| (row.cells[i].as_str(), other))
}

/// The columns of a quantity: number, part of the cell, sign, units of the spec and of the header.
type Match<'a> = (usize, Option<usize>, f64, [Option<&'a str>; 2]);

fn matching<'a>(
    row: &'a Row,
    quantity: Quantity,
    program: Option<Program>,
    own: &'a BTreeMap<Quantity, String>,
) -> Vec<Match<'a>> {
    let cells = || row.cells.iter().enumerate();
    let headings: &'static [Heading] = Program::headings(program);
    let heading = headings.iter().find(|h| h.quantity == quantity);
    if let Some(header) = own.get(&quantity) {
        let (sign, wanted) = signed(header);
        let (name, unit) = split(wanted);
        // the signs of a program hold whatever its headers are called
        let of_program = program.and(heading).map_or(1.0, |h| h.sign);
        let whole = cells().find(|(_, c)| same(c, wanted));
        let found = whole.or_else(|| cells().find(|(_, c)| same(&split(c).0, &name)));
        let units = |c: &'a str| [unit, split(c).1];
        let one = |(i, c): (usize, &'a String)| (i, None, sign * of_program, units(c));
        return found.map(one).into_iter().collect();
    }
    let Some(heading) = heading else { return Vec::new() };
    // Bracket's actions count with their case; Robot writes several names into one column
    let exact = program.is_none() && quantity.action().is_some();
    let joined = program == Some(Program::Robot) && quantity.action().is_none();
    let mut found = Vec::new();
    for name in heading.names {
        for (i, cell) in cells() {
            let (header, unit) = split(cell);
            let named = if exact { header == *name } else { same(&header, name) };
            if named {
                found.push((i, None, heading.sign, [unit, None]));
            } else if joined && header.contains('/') {
                let part = header.split('/').position(|p| same(p, name));
                found.extend(part.map(|p| (i, Some(p), heading.sign, [unit, None])));
            }
        }
    }
    found
}

/// Whether the row below a header has units: one of an action at least, and no number. One that
/// cannot be read is a fault of its own column then.
fn holds_units(
    row: &Row,
    below: &Row,
    program: Option<Program>,
    own: &BTreeMap<Quantity, String>,
) -> bool {
    let of = |q: &'static Quantity| matching(row, *q, program, own).into_iter().map(|m| m.0);
    let cells: Vec<&str> = Quantity::ACTIONS
        .iter()
        .flat_map(of)
        .filter_map(|i| below.cells.get(i).map(|c| bare(c)))
        .collect();
    let loads = |u: &&str| factor(u, Quantity::N).or(factor(u, Quantity::My)).is_some();
    let begins_as_number =
        |c: &&str| c.starts_with(|c: char| c.is_ascii_digit() || "+-−".contains(c));
    cells.iter().any(loads) && !cells.iter().any(begins_as_number)
}

/// The columns of a quantity with their factors. An action has one column; of texts the first cell
/// that is not empty counts.
fn of_quantity(
    row: &Row,
    units: Option<&Row>,
    quantity: Quantity,
    (program, asked): (Option<Program>, Asked),
    own: &BTreeMap<Quantity, String>,
) -> Result<Vec<Column>, HeaderFault> {
    let found = matching(row, quantity, program, own);
    let header = |m: &Match| row.cells[m.0].clone();
    let column = |m: &Match, factor: f64| Column {
        index: m.0,
        quantity,
        factor: m.2 * factor,
        header: header(m),
        part: m.1,
    };
    if quantity.action().is_none() {
        return Ok(found.iter().map(|m| column(m, 1.0)).collect());
    }
    let fault = |message: String, help: String| HeaderFault { line: row.line, message, help };
    let m = match found.as_slice() {
        [] => return Ok(Vec::new()),
        [m] => m,
        [a, b, ..] => {
            let message =
                format!("both `{}` and `{}` may be {}", header(a), header(b), quantity.word());
            let help = match asked {
                Asked::Spec => {
                    format!("name one: `columns: {{{}: \"{}\"}}`", quantity.word(), header(a))
                }
                Asked::Command => "delete or rename one of them".into(),
            };
            return Err(fault(message, help));
        }
    };
    let below = units.and_then(|u| u.cells.get(m.0)).map(|c| bare(c)).filter(|u| !u.is_empty());
    let told: Vec<&str> = m.3.into_iter().chain([below]).flatten().collect();
    let factors: Vec<Option<f64>> = told.iter().map(|u| factor(u, quantity)).collect();
    if let Some(i) = factors.iter().position(|f| *f != factors[0]) {
        let message =
            format!("column `{}` has two units: `{}` and `{}`", header(m), told[0], told[i]);
        return Err(fault(message, "correct the one that is wrong".into()));
    }
    let Some(unit) = told.first() else {
        let message = format!("the column `{}` has no unit", header(m));
        let usual = quantity.kind().usual();
        let name = split(&header(m)).0;
        let spec = match asked {
            Asked::Spec => {
                let word = quantity.word();
                format!(", or into the spec: `columns: {{{word}: \"{name} [{usual}]\"}}`")
            }
            Asked::Command => String::new(),
        };
        let help = format!("write it into the header, `{name} [{usual}]`{spec}");
        return Err(fault(message, help));
    };
    let Some(factor) = factor(unit, quantity) else {
        let kind = quantity.kind();
        let message = format!("column `{}`: `{unit}` is no unit of a {}", header(m), kind.word());
        return Err(fault(message, format!("units are {}", kind.accepted())));
    };
    Ok(vec![column(m, factor)])
}

/// A unit without its brackets.
fn bare(text: &str) -> &str {
    text.trim_matches(['[', ']', '(', ')'])
}

/// Refuses a column with a unit of force or moment that is not read: its action would be lost.
fn all_read(
    row: &Row,
    units: Option<&Row>,
    columns: &[Column],
    asked: Asked,
) -> Result<(), HeaderFault> {
    for (i, header) in row.cells.iter().enumerate() {
        let below = units.and_then(|u| u.cells.get(i)).map(|c| bare(c));
        let unit = split(header).1.or(below);
        let loads = |u: &str| factor(u, Quantity::N).or(factor(u, Quantity::My)).is_some();
        if unit.is_some_and(loads) && !columns.iter().any(|c| c.index == i) {
            let message = format!("the column `{header}` has a unit of actions and is not read");
            let what = match asked {
                Asked::Spec => "say what it is, `columns: {My: …}`",
                Asked::Command => "rename it to the action that it is (`My`)",
            };
            let mapping = asked.mapping(None);
            let help = format!("{what}, choose the {mapping} that knows it, or delete it");
            return Err(HeaderFault { line: row.line, message, help });
        }
    }
    Ok(())
}

fn no_header(
    rows: &[Row],
    program: Option<Program>,
    own: &BTreeMap<Quantity, String>,
    asked: Asked,
) -> HeaderFault {
    let Some(first) = rows.first() else {
        let help = "the first row holds the headers, each further row a load case".into();
        return HeaderFault { line: 1, message: "the table is empty".into(), help };
    };
    let headings = Program::headings(program);
    let wanted: Vec<&str> = match own.is_empty() {
        true => Quantity::ACTIONS
            .iter()
            .filter_map(|q| headings.iter().find(|h| h.quantity == *q)?.names.first().copied())
            .collect(),
        false => own.values().map(String::as_str).collect(),
    };
    // what another program's headers would find
    let other = Program::ALL.into_iter().filter(|p| Some(*p) != program).find(|p| {
        let named = |r: &Row, q: &Quantity| !matching(r, *q, Some(*p), &BTreeMap::new()).is_empty();
        rows.iter().take(SEARCHED).any(|r| Quantity::ACTIONS.iter().all(|q| named(r, q)))
    });
    let told: Vec<&str> = first.cells.iter().map(String::as_str).collect();
    let help = match other {
        Some(p) => format!("the headers are those of {}", asked.mapping(Some(p))),
        None => {
            let (columns, mapping, told) = (asked.columns(), asked.mapping(None), list(&told));
            format!("{columns}, or name the program with {mapping}; the first row has {told}")
        }
    };
    let message = format!("no row has the header of an action ({})", list(&wanted));
    HeaderFault { line: first.line, message, help }
}

/// Names in backticks, at most some of them.
pub(super) fn list(names: &[&str]) -> String {
    const SHOWN: usize = 16;
    let shown: Vec<String> =
        names.iter().filter(|n| !n.is_empty()).take(SHOWN).map(|n| format!("`{n}`")).collect();
    let more = if names.len() > SHOWN { ", …" } else { "" };
    format!("{}{more}", shown.join(", "))
}
