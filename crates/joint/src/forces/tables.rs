//! Tables of forces that many joints share: each is read once.

use super::force_row::{ForceRow, Forces};
use super::program::Quantity;
use super::read::{Source, read};
use bracket_base::diag::{Diagnostic, Diagnostics};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::PathBuf;

/// What makes two sources the same: file, sheet, program, headers of the user.
type Key = (PathBuf, Option<String>, Option<&'static str>, BTreeMap<Quantity, String>);

/// A table of forces, with what finds the rows of a member among hundreds of thousands.
#[derive(Clone, Debug, Default)]
pub struct ForceTable {
    /// The rows.
    pub rows: Vec<ForceRow>,
    /// Which actions its columns give: `N, Vy, Vz, T, My, Mz`.
    pub given: [bool; 6],
    /// Names of the load cases, each once.
    pub cases: BTreeSet<String>,
    /// Members that cannot be read, with the reason.
    refused: BTreeMap<String, Diagnostic>,
    /// Positions of the rows of each member; empty if a row has no member.
    by_member: HashMap<String, Vec<usize>>,
}

impl ForceTable {
    fn new(Forces { rows, given, refused }: Forces) -> Self {
        let cases = rows.iter().filter_map(|r| r.text(Quantity::Case)).map(str::to_owned);
        let cases = cases.collect();
        let mut by_member: HashMap<String, Vec<usize>> = HashMap::new();
        for (i, row) in rows.iter().enumerate() {
            let Some(member) = row.text(Quantity::Member) else {
                by_member.clear();
                break;
            };
            match by_member.get_mut(member) {
                Some(of) => of.push(i),
                None => drop(by_member.insert(member.into(), vec![i])),
            }
        }
        Self { rows, given, cases, refused, by_member }
    }

    /// Why the rows of a member cannot be read; without a member, why any of them cannot.
    pub fn refusal(&self, member: Option<&str>) -> Option<&Diagnostic> {
        match member {
            Some(member) => self.refused.get(member.trim()),
            None => self.refused.values().next(),
        }
    }

    /// The rows among which those of a member are: its own, or all of them.
    pub fn around(&self, member: Option<&str>) -> Vec<&ForceRow> {
        match member.and_then(|m| self.by_member.get(m.trim())) {
            Some(of) => of.iter().map(|i| &self.rows[*i]).collect(),
            None => self.rows.iter().collect(),
        }
    }
}

/// The tables that were read.
#[derive(Clone, Debug, Default)]
pub struct ForceTables {
    read: BTreeMap<Key, ForceTable>,
}

impl ForceTables {
    /// The table of a source.
    pub fn of(&mut self, source: &Source<'_>) -> Result<&ForceTable, Diagnostics> {
        let key = (
            source.file.to_path_buf(),
            source.sheet.map(str::to_owned),
            source.program.map(|p| p.word()),
            source.columns.clone(),
        );
        if !self.read.contains_key(&key) {
            self.read.insert(key.clone(), ForceTable::new(read(source)?));
        }
        Ok(&self.read[&key])
    }
}
