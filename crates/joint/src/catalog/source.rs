//! File and line of a table row.

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

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} line {}", self.file, self.line)
    }
}
