//! Tables as rows of cells: from text (CSV and its relatives) and from workbooks of spreadsheets.
//!
//! What a table means is the matter of its reader. This room knows how programs write one: comma,
//! semicolon or tab between cells, points or commas before decimals, UTF-8, UTF-16 or the code page
//! of Windows, a line `sep=;` of Excel, sheets of a workbook.

mod number;
mod rows;
mod workbook;

pub use number::{decimal_sign, number};
pub use rows::{Grid, Row};

use crate::diag::{Diagnostic, Diagnostics};
use crate::text_file::{self, Table};
use std::path::Path;

/// Lines from which the separator is found.
const SAMPLE: usize = 50;

/// Whether lines that begin with `#` are comments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comments {
    /// They are: a table that a user writes.
    Hash,
    /// They are not: a table of another program, whose names may begin so.
    None,
}

/// Reads a table. `sheet`: sheet of a workbook; `usual`: sheets to read where none is named;
/// `unread`: the message for a file that the operating system cannot read.
pub fn read(
    path: &Path,
    sheet: Option<&str>,
    usual: &[&str],
    comments: Comments,
    unread: impl FnOnce(std::io::Error) -> Diagnostic,
) -> Result<Grid, Diagnostics> {
    match text_file::read_table(path, unread)? {
        Table::Text(text) => match sheet {
            Some(sheet) => {
                let message = format!("a text file has no sheets, and `{sheet}` is asked for");
                let help = "leave `sheet` out, or name the workbook (.xlsx)";
                Err(Diagnostic::input("table/sheet", message).file(path).help(help).into())
            }
            None => of_text(&text, comments).map_err(|f| Diagnostics::from(f.file(path))),
        },
        Table::Workbook(bytes) => {
            workbook::read(&bytes, sheet, usual).map_err(|f| Diagnostics::from(f.file(path)))
        }
    }
}

/// Names of the sheets of a workbook; none for a text. `unread`: see [`read`].
pub fn sheet_names(
    path: &Path,
    unread: impl FnOnce(std::io::Error) -> Diagnostic,
) -> Result<Vec<String>, Diagnostics> {
    match text_file::read_table(path, unread)? {
        Table::Text(_) => Ok(Vec::new()),
        Table::Workbook(bytes) => {
            workbook::sheet_names(&bytes).map_err(|f| Diagnostics::from(f.file(path)))
        }
    }
}

/// The table in a text.
pub fn of_text(text: &str, comments: Comments) -> Result<Grid, Box<Diagnostic>> {
    // the line with which Excel is told the separator
    let told = text.lines().next().and_then(|l| l.strip_prefix("sep="));
    let (text, first) = match told {
        Some(_) => (text.split_once('\n').map_or("", |(_, rest)| rest), 2),
        None => (text, 1),
    };
    let told = told.and_then(|t| t.bytes().next()).filter(|b| SEPARATORS.contains(b));
    let separator = told.unwrap_or_else(|| separator(text, comments));
    let mut reader = csv::ReaderBuilder::new()
        .comment((comments == Comments::Hash).then_some(b'#'))
        .delimiter(separator)
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| {
            let line = e.position().map_or(1, |p| p.line() as usize);
            let d = Diagnostic::input("table/row", e.to_string())
                .at(line + first - 1, 1)
                .help("save the table as CSV again");
            Box::new(d)
        })?;
        if record.iter().all(str::is_empty) {
            continue;
        }
        let line = record.position().map_or(0, |p| line_of(text, p, comments)) + first - 1;
        rows.push(Row { line, cells: record.iter().map(str::to_owned).collect() });
    }
    Ok(Grid { rows, separator: Some(char::from(separator)), sheet: None })
}

/// The line of a record. The reader reports where it began to read, which may be a comment or an
/// empty line before the record.
fn line_of(text: &str, start: &csv::Position, comments: Comments) -> usize {
    let rest = text.get(start.byte() as usize..).unwrap_or("");
    let skipped = rest.lines().take_while(|l| !has_cells(l, comments));
    start.line() as usize + skipped.count()
}

/// Whether a line holds a row.
fn has_cells(line: &str, comments: Comments) -> bool {
    !(line.trim().is_empty() || comments == Comments::Hash && line.starts_with('#'))
}

/// What may stand between cells; a header with several of them has the first one.
const SEPARATORS: [u8; 3] = [b'\t', b';', b','];

/// The separator of a text: that of its first two lines, or, below a title, that of most lines.
fn separator(text: &str, comments: Comments) -> u8 {
    let lines: Vec<&[u8]> =
        text.lines().filter(|l| has_cells(l, comments)).take(SAMPLE).map(str::as_bytes).collect();
    let count = |s: u8| lines.iter().filter(|l| l.contains(&s)).count();
    let first_two = |s: &u8| !lines.is_empty() && lines.iter().take(2).all(|l| l.contains(s));
    let half = lines.len().div_ceil(2).max(1);
    let found = SEPARATORS.iter().find(|s| first_two(s));
    *found.or_else(|| SEPARATORS.iter().find(|s| count(**s) >= half)).unwrap_or(&b',')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(text: &str) -> Vec<(usize, Vec<String>)> {
        let grid = of_text(text, Comments::Hash).unwrap_or_else(|e| panic!("{e:?}"));
        grid.rows.into_iter().map(|r| (r.line, r.cells)).collect()
    }

    fn row(line: usize, cells: &str) -> (usize, Vec<String>) {
        (line, cells.split('|').map(str::to_owned).collect())
    }

    #[test]
    fn the_separator_is_that_of_most_lines() {
        let titled = "TABLE:  Element Forces - Frames\nFrame\tP\n\tkN\n1\t-3,5\n";
        assert_eq!(
            cells(titled),
            [
                row(1, "TABLE:  Element Forces - Frames"),
                row(2, "Frame|P"),
                row(3, "|kN"),
                row(4, "1|-3,5")
            ]
        );
        assert_eq!(
            cells("a;b\n1,5;2\n"),
            [row(1, "a;b".replace(';', "|").as_str()), row(2, "1,5|2")]
        );
        assert_eq!(cells("a,b\n# no\n\n1, 2\n"), [row(1, "a|b"), row(4, "1|2")]);
        assert_eq!(cells("sep=;\na;b\n1;2\n"), [row(2, "a|b"), row(3, "1|2")]);
        assert!(cells("").is_empty() && cells(",,\n,,\n").is_empty());
    }

    /// Lists between commas hold semicolons; `sep=` tells the separator whatever the cells hold.
    #[test]
    fn other_separators_within_cells() {
        let rows = "name,bolts.rows\nA,[-105; 105]\n\"B;C\",[1; 2]\n";
        assert_eq!(
            cells(rows),
            [row(1, "name|bolts.rows"), row(2, "A|[-105; 105]"), row(3, "B;C|[1; 2]")]
        );
        assert_eq!(cells("sep=,\na;b,c\n1;2,3\n"), [row(2, "a;b|c"), row(3, "1;2|3")]);
        let grid = of_text("case,N\n#1,100\n", Comments::None).expect("a table");
        assert_eq!(grid.rows[1].cells, ["#1", "100"]);
    }

    #[test]
    fn the_separator_is_told() {
        for (text, separator) in [("a,b\n1,2\n", ','), ("a;b\n1;2\n", ';'), ("a\tb\n", '\t')] {
            let grid = of_text(text, Comments::Hash).expect("a table");
            assert_eq!(grid.separator, Some(separator));
        }
    }
}
