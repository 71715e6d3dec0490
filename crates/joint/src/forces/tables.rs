//! Tables of forces that many joints share: each is read once.

use super::program::Quantity;
use super::read::{ForceRow, Source, read};
use bracket_base::diag::Diagnostics;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// What makes two sources the same: file, sheet, program, headers of the user.
type Key = (PathBuf, Option<String>, Option<&'static str>, BTreeMap<Quantity, String>);

/// The tables that were read.
#[derive(Clone, Debug, Default)]
pub struct ForceTables {
    read: BTreeMap<Key, (Vec<ForceRow>, [bool; 6])>,
}

impl ForceTables {
    /// The rows of a table, and which actions its columns give.
    pub fn of(&mut self, source: &Source<'_>) -> Result<(&[ForceRow], [bool; 6]), Diagnostics> {
        let key = (
            source.file.to_path_buf(),
            source.sheet.map(str::to_owned),
            source.program.map(|p| p.word()),
            source.columns.clone(),
        );
        if !self.read.contains_key(&key) {
            self.read.insert(key.clone(), read(source)?);
        }
        let (rows, given) = &self.read[&key];
        Ok((rows, *given))
    }
}
