//! The place of a row in the file of its table.

use serde::Serialize;
use std::fmt;

/// Where a row stands.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Source {
    /// The file, as the user named it; for the built-in catalogue its path in the project
    /// (`catalogs/…`).
    pub file: String,
    /// 1-based line.
    pub line: usize,
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} line {}", self.file, self.line)
    }
}
