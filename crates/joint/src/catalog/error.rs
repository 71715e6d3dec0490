//! Errors of a catalogue and of looking up a name in it.

use super::source::Source;
use bracket_base::diag::{Diagnostic, Fault};
use std::path::PathBuf;

/// An error of the catalogue stage.
#[derive(Debug, thiserror::Error)]
pub enum CatalogError {
    /// No row has this name.
    #[error("{noun} `{name}` is not in the catalogue{hint}")]
    Unknown {
        /// The kind of thing looked up: `profile`, `bolt` …
        noun: &'static str,
        /// The kind as `bracket catalog list` names it.
        kind: &'static str,
        /// The name as the user wrote it.
        name: String,
        /// `, did you mean …?` or empty.
        hint: String,
    },
    /// Several product standards contain this steel grade.
    #[error("steel `{name}` stands in {} standards: {}", choices.len(), choices.join(", "))]
    Ambiguous {
        /// The grade as the user wrote it.
        name: String,
        /// The full names, each of which is unambiguous.
        choices: Vec<String>,
    },
    /// Two rows have the same name.
    #[error(
        "{noun} `{name}` is there twice: {first} and {second} (names are compared without blanks, \
         hyphens and case)"
    )]
    Duplicate {
        /// The kind of row: `profile`, `bolt` …
        noun: &'static str,
        /// The name of the second row.
        name: String,
        /// File and line of the first row.
        first: Source,
        /// File and line of the second row.
        second: Source,
    },
    /// A cell has an invalid value.
    #[error("column `{column}`: {problem}")]
    Cell {
        /// File and line.
        at: Source,
        /// Character of the line at which the cell begins, from 1.
        character: usize,
        /// Header of the column.
        column: String,
        /// What is wrong with the cell, with the value and the limit.
        problem: String,
    },
    /// A required column is missing.
    #[error("the table of {kind} has no column `{column}`{hint}")]
    MissingColumn {
        /// The file.
        file: String,
        /// The kind of table.
        kind: &'static str,
        /// Header of the missing column.
        column: &'static str,
        /// `, did you mean …?` or empty.
        hint: String,
    },
    /// No table of this kind has this column.
    #[error("the table of {kind} has no use for column `{column}`{hint}")]
    UnknownColumn {
        /// The file.
        file: String,
        /// The kind of table.
        kind: &'static str,
        /// Header of the unknown column.
        column: String,
        /// `, did you mean …?` or empty.
        hint: String,
    },
    /// The columns match no kind of table.
    #[error("the columns fit no kind of catalogue table")]
    UnknownTable {
        /// The file.
        file: String,
    },
    /// The file is not a CSV table, or its rows differ in length.
    #[error("not a readable CSV table: {message}")]
    Csv {
        /// File and line.
        at: Source,
        /// Message of the CSV reader.
        message: String,
    },
    /// The folder or file cannot be read.
    #[error("cannot read the catalogue: {cause}")]
    Io {
        /// Folder or file.
        path: PathBuf,
        /// Error of the operating system.
        cause: std::io::Error,
    },
    /// A table of the folder cannot be read, or is not text.
    #[error("{0}")]
    Unread(Box<Diagnostic>),
    /// The folder contains no table.
    #[error("the catalogue folder holds no .csv file")]
    Empty {
        /// The folder.
        path: PathBuf,
    },
    /// The thickness is outside the bands of the grade.
    #[error(
        "{quantity} of {grade} is not tabulated in {table} for t = {thickness} mm (limit 0 < t ≤ \
         {limit} mm)"
    )]
    Thickness {
        /// `fy` or `fu`.
        quantity: &'static str,
        /// Standard and grade.
        grade: String,
        /// The table that was searched.
        table: &'static str,
        /// Requested thickness \[mm\].
        thickness: f64,
        /// Largest tabulated thickness \[mm\].
        limit: f64,
    },
    /// The product-standard table does not list the grade.
    #[error("{grade} has no product-standard thickness bands in the catalogue")]
    NoProductBands {
        /// Standard and grade.
        grade: String,
    },
}

impl From<CatalogError> for Diagnostic {
    fn from(error: CatalogError) -> Self {
        let message = error.to_string();
        let new = |code| Diagnostic::input(code, message.clone());
        match error {
            CatalogError::Unread(d) => *d,
            CatalogError::Unknown { kind, .. } => new("catalog/unknown-name").help(format!(
                "`bracket catalog list {kind}` shows every name; a folder of your own tables \
                 (`--catalog DIR`, or `catalog: DIR` in the spec) adds more"
            )),
            CatalogError::Ambiguous { choices, .. } => new("catalog/ambiguous-name")
                .help(format!("write the standard too, for example `{}`", choices[0])),
            CatalogError::Duplicate { second, .. } => place(new("catalog/duplicate-name"), second)
                .help("rename or remove one of the two rows"),
            CatalogError::Cell { at, character, .. } => new("catalog/bad-cell")
                .file(at.file)
                .at(at.line, character)
                .help("correct the cell; columns carry their unit in the header"),
            CatalogError::MissingColumn { file, .. } => new("catalog/missing-column")
                .file(file)
                .help("the tables shipped in catalogs/ show the columns; headers carry the unit"),
            CatalogError::UnknownColumn { file, .. } => new("catalog/unknown-column")
                .file(file)
                .help("correct the header, or remove the column"),
            CatalogError::UnknownTable { file } => new("catalog/unknown-table").file(file).help(
                "start from the header line of a table in catalogs/: profiles_i, bolts, \
                 bolts_preloaded, bolt_grades, steel_grades, steel_grades_product, \
                 friction_classes, partial_factors, national_annexes",
            ),
            CatalogError::Csv { at, .. } => place(new("catalog/not-csv"), at).help(
                "UTF-8, comma separated, one header row, decimal point; every row has all the \
                 columns",
            ),
            CatalogError::Io { path, cause } => {
                let denied = cause.kind() == std::io::ErrorKind::PermissionDenied;
                let fault = if denied { Fault::Environment } else { Fault::Input };
                let help = if denied {
                    "check the permissions of the folder and its files"
                } else {
                    "give a folder with tables as UTF-8 .csv files"
                };
                Diagnostic { fault, ..new("catalog/unreadable").file(path).help(help) }
            }
            CatalogError::Empty { path } => new("catalog/empty")
                .file(path)
                .help("put at least one table there, for example a copy of profiles_i.csv"),
            CatalogError::Thickness { .. } => new("catalog/thickness").help(
                "choose `fy_source: product_standard` where it reaches further, a thinner part or \
                 another grade",
            ),
            CatalogError::NoProductBands { .. } => new("catalog/no-bands")
                .help("use `fy_source: table_3_1`, or add the bands in a catalogue of your own"),
        }
    }
}

fn place(diagnostic: Diagnostic, at: Source) -> Diagnostic {
    diagnostic.file(at.file).at(at.line, 1)
}
