//! File and line of a table row.

use bracket_base::display_text;
use bracket_base::say;
use bracket_base::words::Text;
use serde::Serialize;

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

display_text!(Source);
