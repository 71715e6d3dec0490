//! File and line of a table row.

use bracket_base::say;
use bracket_base::words::Text;
use serde::Serialize;
use std::fmt;

/// File and line of a table row.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Source {
    /// The file as the user named it; for the built-in catalogue its path in the project
    /// (`catalogs/…`).
    pub file: String,
    /// Line, counted from 1.
    pub line: usize,
}

impl Source {
    /// File and line in words.
    pub fn text(&self) -> Text {
        say!("{} line {}", &self.file, self.line)
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.text().fmt(f)
    }
}
