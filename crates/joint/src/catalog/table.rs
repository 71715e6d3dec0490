//! Strict reading of CSV tables: every cell is checked, and every row keeps its file and line.

use super::error::CatalogError;
use super::name::{nearest_sizes, normalise};
use super::source::Source;
use bracket_base::diag::did_you_mean;
use bracket_base::units::limits;
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// Most rows of a table; the largest catalogue of profiles has some thousand.
const MOST_ROWS: usize = 100_000;

/// Most columns of a table; the widest kind has some twenty.
const MOST_COLUMNS: usize = 1000;

/// The columns of one kind of table.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    /// Name of the kind, used in messages.
    pub kind: &'static str,
    /// Required columns.
    pub needed: &'static [&'static str],
    /// Optional columns; `note` and `source` are always allowed.
    pub optional: &'static [&'static str],
}

/// A table whose cells are still text.
#[derive(Debug)]
pub(super) struct RawTable {
    file: String,
    headers: Vec<String>,
    rows: Vec<(usize, Vec<String>)>,
    /// The lines of the file.
    lines: Vec<String>,
    /// Text of a `# source: …` comment line.
    pub provenance: Option<String>,
}

/// One row of a table.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row<'a> {
    table: &'a RawTable,
    line: usize,
    cells: &'a [String],
}

impl RawTable {
    /// Splits the text of `file` into cells. Lines that start with `#` are comments.
    pub fn parse(file: &str, text: &str) -> Result<Self, CatalogError> {
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let fault = |error: csv::Error| {
            let line = error.position().map_or(1, |p| p.line() as usize);
            let message = match error.kind() {
                csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
                    format!("the row has {len} cells, the header {expected_len}")
                }
                _ => error.to_string(),
            };
            CatalogError::Csv { at: Source { file: file.to_owned(), line }, message }
        };
        let too_large = |line: usize, what: &str, most: usize| CatalogError::Csv {
            at: Source { file: file.to_owned(), line },
            message: format!("more than {most} {what} are not read: leave out what no joint uses"),
        };
        let headers: Vec<String> =
            reader.headers().map_err(fault)?.iter().map(str::to_owned).collect();
        if headers.len() > MOST_COLUMNS {
            return Err(too_large(1, "columns", MOST_COLUMNS));
        }
        let lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let skipped = |line: usize| {
            lines.get(line - 1).is_some_and(|l| l.starts_with('#') || l.trim().is_empty())
        };
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = record.map_err(fault)?;
            // the reader counts the comments before a record to it
            let mut line = record.position().map_or(1, |p| p.line() as usize).max(1);
            while skipped(line) {
                line += 1;
            }
            if rows.len() == MOST_ROWS {
                return Err(too_large(line, "rows", MOST_ROWS));
            }
            rows.push((line, record.iter().map(str::to_owned).collect()));
        }
        let provenance = text
            .lines()
            .find_map(|l| l.strip_prefix('#')?.trim().strip_prefix("source:"))
            .map(|s| s.trim().to_owned());
        Ok(Self { file: file.to_owned(), headers, rows, lines, provenance })
    }

    /// The file that the table was read from.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// True if the table has the column.
    pub fn has(&self, column: &str) -> bool {
        self.headers.iter().any(|h| h == column)
    }

    /// Checks the header for missing, unknown and repeated columns.
    pub fn check(&self, columns: Columns) -> Result<(), CatalogError> {
        let known = || columns.needed.iter().chain(columns.optional).copied();
        let kind = columns.kind;
        let file = || self.file.clone();
        for (i, h) in self.headers.iter().enumerate() {
            if self.headers[..i].contains(h) {
                let at = Source { file: file(), line: 1 };
                return Err(CatalogError::Cell {
                    at,
                    character: self.start(1, i),
                    column: h.clone(),
                    problem: "the header is there twice".into(),
                });
            }
        }
        for &column in columns.needed {
            if !self.has(column) {
                let strangers =
                    self.headers.iter().map(String::as_str).filter(|h| !known().any(|k| k == *h));
                let hint = did_you_mean(column, strangers)
                    .replace("did you mean", "is it")
                    .replace('?', "");
                return Err(CatalogError::MissingColumn { file: file(), kind, column, hint });
            }
        }
        for h in &self.headers {
            if !known().any(|k| k == h) && h != "note" && h != "source" {
                let hint = did_you_mean(h, known());
                return Err(CatalogError::UnknownColumn {
                    file: file(),
                    kind,
                    column: h.clone(),
                    hint,
                });
            }
        }
        Ok(())
    }

    /// Character of a line, counted from 1, at which its cell of a number begins.
    fn start(&self, line: usize, cell: usize) -> usize {
        let text = line.checked_sub(1).and_then(|l| self.lines.get(l)).map_or("", String::as_str);
        let (mut quoted, mut passed) = (false, 0);
        for (i, c) in text.chars().enumerate() {
            if passed == cell && c != ' ' {
                return i + 1;
            }
            quoted ^= c == '"';
            passed += usize::from(c == ',' && !quoted);
        }
        1
    }

    /// The rows in the order of the file.
    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|(line, cells)| Row { table: self, line: *line, cells })
    }
}

impl Row<'_> {
    /// File and line of the row.
    pub fn source(&self) -> Source {
        Source { file: self.table.file.clone(), line: self.line }
    }

    /// An error about one cell.
    pub fn fault(&self, column: &str, problem: impl Into<String>) -> CatalogError {
        let cell = self.table.headers.iter().position(|h| h == column).unwrap_or(0);
        CatalogError::Cell {
            at: self.source(),
            character: self.table.start(self.line, cell),
            column: column.to_owned(),
            problem: problem.into(),
        }
    }

    fn cell(&self, column: &str) -> &str {
        self.table.headers.iter().position(|h| h == column).map_or("", |i| &self.cells[i])
    }

    /// A text; an empty cell is an error.
    pub fn text(&self, column: &str) -> Result<String, CatalogError> {
        match self.cell(column) {
            "" => Err(self.fault(column, "the cell is empty")),
            text => Ok(text.to_owned()),
        }
    }

    /// A text, or `None` if the column is missing or the cell is empty.
    pub fn text_or_empty(&self, column: &str) -> Option<String> {
        Some(self.cell(column)).filter(|text| !text.is_empty()).map(str::to_owned)
    }

    /// `yes` or `no`.
    pub fn flag(&self, column: &str) -> Result<bool, CatalogError> {
        match self.cell(column) {
            "yes" => Ok(true),
            "no" => Ok(false),
            other => Err(self.fault(column, format!("`{other}` is neither `yes` nor `no`"))),
        }
    }

    fn finite(&self, column: &str) -> Result<f64, CatalogError> {
        let text = self.text(column)?;
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            Ok(_) => Err(self.fault(column, format!("`{text}` is not a finite number"))),
            Err(_) => {
                Err(self
                    .fault(column, format!("`{text}` is not a number (decimal point, no unit)")))
            }
        }
    }

    /// A finite number > 0.
    pub fn positive(&self, column: &str) -> Result<f64, CatalogError> {
        match self.finite(column)? {
            value if value > 0.0 => Ok(value),
            value => Err(self.fault(column, format!("{value} must be greater than 0"))),
        }
    }

    /// A finite number ≥ 0.
    pub fn not_negative(&self, column: &str) -> Result<f64, CatalogError> {
        match self.finite(column)? {
            value if value >= 0.0 => Ok(value),
            value => Err(self.fault(column, format!("{value} must not be negative"))),
        }
    }

    /// A finite number within the range that such a value can have; `what` names it with its unit.
    pub fn within(
        &self,
        column: &str,
        range: RangeInclusive<f64>,
        what: &str,
    ) -> Result<f64, CatalogError> {
        let value = self.positive(column)?;
        if limits::within(value, &range) {
            return Ok(value);
        }
        let (least, most) = (range.start(), range.end());
        Err(self.fault(column, format!("{value}; {what} lies between {least} and {most}")))
    }

    /// The same, or `None` if the cell is empty.
    pub fn within_or_empty(
        &self,
        column: &str,
        range: RangeInclusive<f64>,
        what: &str,
    ) -> Result<Option<f64>, CatalogError> {
        if self.cell(column).is_empty() {
            Ok(None)
        } else {
            self.within(column, range, what).map(Some)
        }
    }

    /// A finite number > 0, or `None` if the cell is empty.
    pub fn positive_or_empty(&self, column: &str) -> Result<Option<f64>, CatalogError> {
        if self.cell(column).is_empty() { Ok(None) } else { self.positive(column).map(Some) }
    }
}

/// A row type with a name and a source.
pub(super) trait Entry {
    /// The word for it in messages: `profile`, `bolt` …
    const NOUN: &'static str;
    /// The kind as `bracket catalog list` names it.
    const KIND: &'static str;
    /// True if names consist of a series and sizes. The nearest size is then a better suggestion
    /// than the nearest spelling.
    const SIZED: bool = false;
    /// The name for output.
    fn name(&self) -> String;
    /// The key used to compare names.
    fn key(name: &str) -> String {
        normalise(name)
    }
    /// File and line of the row.
    fn source(&self) -> &Source;
}

/// Rows in file order, with an index by normalised name.
#[derive(Clone, Debug)]
pub(super) struct Named<T> {
    rows: Vec<T>,
    index: BTreeMap<String, usize>,
}

impl<T> Default for Named<T> {
    fn default() -> Self {
        Self { rows: Vec::new(), index: BTreeMap::new() }
    }
}

impl<T: Entry> Named<T> {
    /// Adds a row. A second row with the same name is an error that gives both places.
    pub fn insert(&mut self, row: T) -> Result<(), CatalogError> {
        let name = row.name();
        if let Some(&first) = self.index.get(&T::key(&name)) {
            let (first, second) = (self.rows[first].source().clone(), row.source().clone());
            return Err(CatalogError::Duplicate { noun: T::NOUN, name, first, second });
        }
        self.index.insert(T::key(&name), self.rows.len());
        self.rows.push(row);
        Ok(())
    }

    /// The row with this name, in any accepted spelling.
    pub fn find(&self, name: &str) -> Option<&T> {
        self.index.get(&T::key(name)).map(|&i| &self.rows[i])
    }

    /// The row with this name, mutable.
    pub fn find_mut(&mut self, name: &str) -> Option<&mut T> {
        self.index.get(&T::key(name)).map(|&i| &mut self.rows[i])
    }

    /// The row with this name, or an error that suggests the closest name.
    pub fn get(&self, name: &str) -> Result<&T, CatalogError> {
        self.find(name).ok_or_else(|| self.unknown(name))
    }

    /// The error for an unknown name.
    pub fn unknown(&self, name: &str) -> CatalogError {
        let key = T::key(name);
        let names: Vec<String> = self.rows.iter().map(Entry::name).collect();
        let near = || nearest_sizes(&key, names.iter().map(|n| (T::key(n), n.clone())));
        let near = if T::SIZED { near() } else { None };
        let hint = near.unwrap_or_else(|| did_you_mean(&key, names.iter().map(String::as_str)));
        CatalogError::Unknown { noun: T::NOUN, kind: T::KIND, name: name.to_owned(), hint }
    }

    /// The rows in the order of the files.
    pub fn rows(&self) -> &[T] {
        &self.rows
    }
}
