//! The table of forces, and which of its load cases are taken.

use super::joint_row::{EndAt, MemberAt};
use bracket_joint::forces::{Asked, Program};
use bracket_joint::spec::load_table::{LoadTable, Station};
use bracket_joint::spec::loads::LimitState;
use std::path::PathBuf;

/// A table of forces of many members.
#[derive(Clone, Debug, Default)]
pub struct ForcesFile {
    /// The file.
    pub file: PathBuf,
    /// Sheet of a workbook.
    pub sheet: Option<String>,
    /// The program whose headers, axes and signs it has; `None`: those of Bracket.
    pub mapping: Option<Program>,
    /// Patterns of the load cases that are taken; none: all.
    pub cases: Vec<String>,
    /// Patterns of the load cases of serviceability.
    pub sls: Vec<String>,
}

impl ForcesFile {
    /// The load cases of a member, as a spec would ask for them.
    pub fn of_member(&self, at: &MemberAt) -> LoadTable {
        let by_node = at.node.is_some();
        LoadTable {
            table: self.file.clone(),
            sheet: self.sheet.clone(),
            mapping: self.mapping,
            member: Some(at.member.clone()),
            node: at.node.clone(),
            station: (!by_node).then_some(at.station),
            flip: by_node.then_some(at.station == Station::End),
            cases: self.cases.clone(),
            state: match self.sls.is_empty() {
                true => Default::default(),
                false => [(LimitState::Serviceability, self.sls.clone())].into(),
            },
            asked: Asked::Command,
            ..LoadTable::default()
        }
    }

    /// The load cases of a member end of the joint.
    pub fn of_end(&self, end: &EndAt) -> LoadTable {
        let (name, at) = (Some(end.end.clone()), Some(end.at));
        LoadTable { end: name, at, ..self.of_member(&end.member) }
    }
}
