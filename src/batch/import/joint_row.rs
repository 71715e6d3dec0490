//! A row of the table of joints: the members that meet at a joint.

use bracket_base::diag::Place;
use bracket_joint::spec::load_table::Station;
use bracket_joint::spec::loads::ActionPoint;
use std::path::Path;

/// The end of a member of the frame that is at a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct MemberAt {
    /// Name of the member in the table of forces.
    pub member: String,
    /// Which end of it is at the joint.
    pub station: Station,
    /// Its node, for a table without stations.
    pub node: Option<String>,
    /// The columns that name member, station and node.
    pub columns: [&'static str; 3],
}

/// A member at an end of the template.
#[derive(Clone, Debug, PartialEq)]
pub struct EndAt {
    /// Name of the end.
    pub end: String,
    /// Point at which its actions act.
    pub at: ActionPoint,
    /// The member.
    pub member: MemberAt,
    /// The column that names the end.
    pub column: &'static str,
}

/// A joint.
#[derive(Clone, Debug, PartialEq)]
pub struct JointRow {
    /// Its name.
    pub name: String,
    /// Line of the table.
    pub line: usize,
    /// Its member ends, one or two.
    pub ends: Vec<EndAt>,
    /// The member of the column below.
    pub below: Option<MemberAt>,
    /// The member of the column above.
    pub above: Option<MemberAt>,
}

impl JointRow {
    /// The place of a cell of the row.
    pub fn place(&self, file: &Path, column: &str) -> Place {
        let path = Some(column.to_owned());
        Place { file: Some(file.into()), line: Some(self.line), column: None, path }
    }

    /// The members of the column, the lower one first.
    pub fn of_column(&self) -> impl Iterator<Item = &MemberAt> {
        self.below.iter().chain(&self.above)
    }
}
