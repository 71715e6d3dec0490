//! Rows of a table of forces, and what a file of forces gives.

use super::headers::list;
use super::program::Quantity;
use bracket_base::diag::Diagnostic;
use std::collections::BTreeMap;

/// A row of a table of forces.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceRow {
    /// Line of the file, or row of the sheet.
    pub line: usize,
    /// Texts of the row by quantity; none is empty.
    pub texts: BTreeMap<Quantity, String>,
    /// Distance from the start of the member, in the unit of the table.
    pub station: Option<f64>,
    /// Length of the member in the same unit, where the table knows it.
    pub length: Option<f64>,
    /// `N, Vy, Vz, T, My, Mz` with Bracket's signs at the start of the member \[N, N mm\].
    pub actions: [f64; 6],
}

impl ForceRow {
    /// The text of a quantity that is no action.
    pub fn text(&self, quantity: Quantity) -> Option<&str> {
        self.texts.get(&quantity).map(String::as_str)
    }
}

/// What a file of forces gives.
#[derive(Clone, Debug, Default)]
pub struct Forces {
    /// Its rows.
    pub rows: Vec<ForceRow>,
    /// Which actions its columns give: `N, Vy, Vz, T, My, Mz`.
    pub given: [bool; 6],
    /// Members of the file that cannot be read, with the reason. They have no rows; other members
    /// are not concerned.
    pub refused: BTreeMap<String, Diagnostic>,
}

/// The rows of a member, for a message.
pub fn names<'a>(rows: impl Iterator<Item = &'a ForceRow>, quantity: Quantity) -> String {
    let mut names: Vec<&str> = rows.filter_map(|r| r.text(quantity)).collect();
    names.sort_unstable();
    names.dedup();
    list(&names)
}
