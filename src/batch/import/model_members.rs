//! Profiles and steels of a joint from the model of a frame program.

use super::joint_row::{JointRow, MemberAt};
use super::joints_table::JointsTable;
use super::template_ends::TemplateEnds;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_joint::catalog::{Catalog, CatalogError};
use bracket_joint::forces::{FrameMember, FrameModel};
use std::path::Path;

/// The model and the catalogue whose names it must have.
pub struct ModelMembers<'a> {
    /// The model.
    pub model: &'a FrameModel,
    /// Its file, for messages.
    pub file: &'a Path,
    /// The catalogue.
    pub catalog: &'a Catalog,
}

/// Profile or steel.
#[derive(Clone, Copy)]
enum What {
    Profile,
    Steel,
}

impl What {
    fn key(self) -> &'static str {
        match self {
            Self::Profile => "profile",
            Self::Steel => "steel",
        }
    }

    fn of(self, member: &FrameMember) -> &str {
        match self {
            Self::Profile => &member.profile,
            Self::Steel => &member.steel,
        }
    }
}

impl ModelMembers<'_> {
    /// Fills in profiles and steels that the row of a joint does not give. False if it gives all.
    pub fn fill(
        &self,
        table: &mut JointsTable,
        joint: usize,
        template: &TemplateEnds,
    ) -> Result<bool, Diagnostics> {
        let row = table.rows[joint].clone();
        let beams: Vec<&MemberAt> = row.ends.iter().map(|e| &e.member).collect();
        let columns: Vec<&MemberAt> = row.of_column().collect();
        let mut filled = false;
        for (role, members) in [(&template.beam, beams), (&template.column, columns)] {
            let Some(role) = role else { continue };
            for what in [What::Profile, What::Steel] {
                let path = format!("members.{role}.{}", what.key());
                if table.gives(joint, &path) {
                    continue;
                }
                let Some(name) = self.common(&row, &table.file, &members, &path, what)? else {
                    continue;
                };
                filled |= table.fill(joint, &path, &name)?;
            }
            self.straight(&row, &table.file, &members)?;
        }
        Ok(filled)
    }

    /// The name in the catalogue that all members share; `None` without members.
    fn common(
        &self,
        row: &JointRow,
        joints: &Path,
        members: &[&MemberAt],
        path: &str,
        what: What,
    ) -> Result<Option<String>, Diagnostics> {
        let mut common: Option<(String, &MemberAt)> = None;
        for at in members {
            let name = self.named(row, joints, at, path, what)?;
            match &common {
                Some((other, first)) if *other != name => {
                    let message = format!(
                        "joint `{}`: `{}` is {other} and `{}` {name}; the joint has one `{path}`",
                        row.name, first.member, at.member
                    );
                    let help = format!("give the column `{path}` in the table of joints");
                    let d = Diagnostic::input("import/model", message).help(help);
                    let place = row.place(joints, at.columns[0]);
                    return Err(Diagnostic { place, ..d }.into());
                }
                Some(_) => {}
                None => common = Some((name, at)),
            }
        }
        Ok(common.map(|(name, _)| name))
    }

    fn member(
        &self,
        row: &JointRow,
        joints: &Path,
        at: &MemberAt,
    ) -> Result<&FrameMember, Diagnostics> {
        self.model.member(&at.member).ok_or_else(|| {
            let message = format!(
                "joint `{}`: the model of `{}` has no member `{}`",
                row.name,
                self.file.display(),
                at.member
            );
            let help = "export members, sections and materials of the whole model, or give \
                        profiles and steels in the table of joints";
            let d = Diagnostic::input("import/model", message).help(help);
            Diagnostic { place: row.place(joints, at.columns[0]), ..d }.into()
        })
    }

    /// Profile or steel of a member in the words of the catalogue.
    fn named(
        &self,
        row: &JointRow,
        joints: &Path,
        at: &MemberAt,
        path: &str,
        what: What,
    ) -> Result<String, Diagnostics> {
        let member = self.member(row, joints, at)?;
        let given = what.of(member);
        let found = match what {
            // a section may be named like its profile
            What::Profile if given.is_empty() => self.profile(&member.section),
            What::Profile => self.profile(given),
            What::Steel => self.catalog.steel(given).map(|s| s.grade.clone()),
        };
        found.map_err(|e| {
            let message = format!(
                "joint `{}`, member `{}` with the section `{}`: {e}",
                row.name, at.member, member.section
            );
            let help = format!(
                "give the column `{path}` in the table of joints, or a catalogue of your own with \
                 `--catalog`"
            );
            let d = Diagnostic::input("import/model", message).help(help);
            Diagnostic { place: member.place.clone(), ..d }.into()
        })
    }

    fn profile(&self, name: &str) -> Result<String, CatalogError> {
        self.catalog.profile(name).map(|p| p.name.clone())
    }

    /// Refuses members whose forces may be those of other axes.
    fn straight(
        &self,
        row: &JointRow,
        joints: &Path,
        members: &[&MemberAt],
    ) -> Result<(), Diagnostics> {
        for at in members {
            let member = self.member(row, joints, at)?;
            if member.turned {
                let message = format!(
                    "joint `{}`: the section `{}` of member `{}` is an angle or a Z, whose \
                     principal axes are turned: nobody can tell about which axes its moments are",
                    row.name, member.section, at.member
                );
                let help = "joints have members with I and H sections";
                let d = Diagnostic::input("import/model", message).help(help);
                return Err(Diagnostic { place: member.place.clone(), ..d }.into());
            }
        }
        Ok(())
    }
}
