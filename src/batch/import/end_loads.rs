//! The load cases of a joint: actions of the same load cases at all of its members.

use super::forces_file::ForcesFile;
use super::joint_row::{EndAt, JointRow, MemberAt};
use bracket_base::diag::{Diagnostic, Diagnostics, Place};
use bracket_joint::forces::ForceTables;
use bracket_joint::spec::load_table::LoadTable;
use bracket_joint::spec::loads::LoadSpec;
use bracket_joint::spec::table_loads::listed;
use std::path::Path;

/// The load cases of a joint. All lists have the same load cases in the same order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EndLoads {
    /// Actions at each member end, in the order of the row.
    pub ends: Vec<Vec<LoadSpec>>,
    /// Actions at the upper end of the column below, in its own axes: x′ down.
    pub below: Option<Vec<LoadSpec>>,
    /// Actions at the lower end of the column above, in its own axes: x′ up.
    pub above: Option<Vec<LoadSpec>>,
}

/// What reads the load cases of joints.
pub struct Reader<'a> {
    /// The table of forces.
    pub forces: &'a ForcesFile,
    /// The file with the joints, for messages.
    pub joints: &'a Path,
    /// What is read once for all joints.
    pub tables: ForceTables,
}

impl EndLoads {
    /// The loads of the spec: those of all ends, load case by load case.
    pub fn listed(&self) -> Vec<LoadSpec> {
        let cases = 0..self.cases();
        cases.flat_map(|i| self.ends.iter().map(move |e| e[i].clone())).collect()
    }

    /// Number of load cases.
    pub fn cases(&self) -> usize {
        self.ends.first().map_or(0, Vec::len)
    }
}

impl Reader<'_> {
    /// The load cases of a joint.
    pub fn of(&mut self, row: &JointRow) -> Result<EndLoads, Diagnostics> {
        let mut ends: Vec<Vec<LoadSpec>> = Vec::new();
        for end in &row.ends {
            let loads = self.read(row, &end.member, &self.forces.of_end(end))?;
            self.at_end(row, end, &loads)?;
            let loads = loads.into_iter().map(|(_, load)| load).collect();
            ends.push(self.as_first(row, &ends, &end.member, loads)?);
        }
        let mut of_column = |at: &Option<MemberAt>| -> Result<_, Diagnostics> {
            let Some(at) = at else { return Ok(None) };
            let loads = self.read(row, at, &self.forces.of_member(at))?;
            let loads = loads.into_iter().map(|(_, load)| load).collect();
            self.as_first(row, &ends, at, loads).map(Some)
        };
        let (below, above) = (of_column(&row.below)?, of_column(&row.above)?);
        Ok(EndLoads { ends, below, above })
    }

    fn read(
        &mut self,
        row: &JointRow,
        at: &MemberAt,
        table: &LoadTable,
    ) -> Result<Vec<(usize, LoadSpec)>, Diagnostics> {
        let [member, station, node] = at.columns;
        let of_forces = |option: &str| Place {
            file: Some(self.forces.file.clone()),
            line: None,
            column: None,
            path: Some(option.into()),
        };
        let place = |path: &str| match path {
            "loads.member" => row.place(self.joints, member),
            "loads.station" => row.place(self.joints, station),
            "loads.node" => row.place(self.joints, node),
            "loads.cases" => of_forces("--cases"),
            "loads.state.SLS" | "loads.state" => of_forces("--sls"),
            _ => of_forces("FORCES"),
        };
        listed(&mut self.tables, table, &self.forces.file, place).map_err(|faults| {
            faults.map(|mut d| {
                let at_joint = d.place.file.as_deref() == Some(self.joints);
                if at_joint && d.place.path.as_deref() == Some(station) {
                    let help = format!(
                        "export the stations of the members, or give the joint the column `{node}`"
                    );
                    d.help = Some(help);
                }
                if at_joint {
                    d.message = format!("joint `{}`: {}", row.name, d.message);
                }
                d
            })
        })
    }

    /// Refuses a table of forces whose own column says another end.
    fn at_end(
        &self,
        row: &JointRow,
        end: &EndAt,
        loads: &[(usize, LoadSpec)],
    ) -> Result<(), Diagnostics> {
        let other = loads.iter().find(|(_, l)| l.end.as_ref() != Some(&end.end));
        let Some((line, load)) = other else { return Ok(()) };
        let message = format!(
            "joint `{}`: the table of forces has `{}` at the end `{}` in line {line}, the joint \
             has it at `{}`",
            row.name,
            end.member.member,
            load.end.as_deref().unwrap_or_default(),
            end.end
        );
        let help = "delete the column `end` of the table of forces, or make both agree";
        let d = Diagnostic::input("import/forces", message).help(help);
        Err(Diagnostic { place: row.place(self.joints, end.column), ..d }.into())
    }

    /// The loads in the order of those of the first end; refuses other load cases.
    fn as_first(
        &self,
        row: &JointRow,
        ends: &[Vec<LoadSpec>],
        at: &MemberAt,
        mut loads: Vec<LoadSpec>,
    ) -> Result<Vec<LoadSpec>, Diagnostics> {
        let Some(first) = ends.first() else { return Ok(loads) };
        let one = &row.ends[0].member.member;
        let lacking = |here: &[LoadSpec], there: &[LoadSpec]| {
            here.iter().find(|l| !there.iter().any(|o| o.name == l.name)).map(|l| l.name.clone())
        };
        let fault = |case: String, has: &str, lacks: &str| {
            let message = format!(
                "joint `{}`: load case `{case}` has forces of `{has}` and none of `{lacks}`",
                row.name
            );
            let help = "export the same load cases of all members of a joint, or choose with \
                        `--cases` those that all have";
            let d = Diagnostic::input("import/forces", message).help(help);
            Diagnostics::from(Diagnostic { place: row.place(self.joints, at.columns[0]), ..d })
        };
        if let Some(case) = lacking(first, &loads) {
            return Err(fault(case, one, &at.member));
        }
        if let Some(case) = lacking(&loads, first) {
            return Err(fault(case, &at.member, one));
        }
        let place = |l: &LoadSpec| first.iter().position(|o| o.name == l.name);
        loads.sort_by_key(place);
        Ok(loads)
    }
}
