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

/// Reads a table. `sheet`: sheet of a workbook; `usual`: sheets to read where none is named;
/// `unread`: the message for a file that the operating system cannot read.
pub fn read(
    path: &Path,
    sheet: Option<&str>,
    usual: &[&str],
    unread: impl FnOnce(std::io::Error) -> Diagnostic,
) -> Result<Grid, Diagnostics> {
    match text_file::read_table(path, unread)? {
        Table::Text(text) => match sheet {
            Some(sheet) => {
                let message = format!("a text file has no sheets, and `{sheet}` is asked for");
                let help = "leave `sheet` out, or name the workbook (.xlsx)";
                Err(Diagnostic::input("table/sheet", message).file(path).help(help).into())
            }
            None => of_text(&text).map_err(|f| Diagnostics::from(f.file(path))),
        },
        Table::Workbook(bytes) => {
            workbook::read(&bytes, sheet, usual).map_err(|f| Diagnostics::from(f.file(path)))
        }
    }
}

/// The table in a text. Lines that begin with `#` are comments.
pub fn of_text(text: &str) -> Result<Grid, Box<Diagnostic>> {
    let (text, first) = match text.lines().next().and_then(|l| l.strip_prefix("sep=")) {
        // the line with which Excel is told the separator
        Some(_) => (text.split_once('\n').map_or("", |(_, rest)| rest), 2),
        None => (text, 1),
    };
    let separator = separator(text);
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
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
        let line = record.position().map_or(0, |p| line_of(text, p)) + first - 1;
        rows.push(Row { line, cells: record.iter().map(str::to_owned).collect() });
    }
    Ok(Grid { rows, separator: Some(char::from(separator)), sheet: None })
}

/// The line of a record. The reader reports where it began to read, which may be a comment or an
/// empty line before the record.
fn line_of(text: &str, start: &csv::Position) -> usize {
    let rest = text.get(start.byte() as usize..).unwrap_or("");
    let skipped = rest.lines().take_while(|l| l.trim().is_empty() || l.starts_with('#'));
    start.line() as usize + skipped.count()
}

/// The separator of a text: the tab, the semicolon or the comma, in this order whichever most of
/// its lines have. Titles above a table have none.
fn separator(text: &str) -> u8 {
    let lines = || {
        let told = |l: &&str| !l.trim().is_empty() && !l.starts_with('#');
        text.lines().filter(told).take(SAMPLE)
    };
    let count = |s: u8| lines().filter(|l| l.as_bytes().contains(&s)).count();
    let half = lines().count().div_ceil(2);
    [b'\t', b';', b','].into_iter().find(|s| count(*s) >= half.max(1)).unwrap_or(b',')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(text: &str) -> Vec<(usize, Vec<String>)> {
        let grid = of_text(text).unwrap_or_else(|e| panic!("{e:?}"));
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

    #[test]
    fn the_separator_is_told() {
        for (text, separator) in [("a,b\n1,2\n", ','), ("a;b\n1;2\n", ';'), ("a\tb\n", '\t')] {
            assert_eq!(of_text(text).expect("a table").separator, Some(separator));
        }
    }
}
