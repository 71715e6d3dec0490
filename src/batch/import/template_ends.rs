//! What an import asks of a template: its member ends, on which side they are, and its members.

use super::joint_row::JointRow;
use bracket_base::diag::{Diagnostic, Diagnostics, did_you_mean};
use bracket_joint::assembly::template::Template;
use bracket_joint::assembly::template_file;
use bracket_joint::spec::expr::Value;
use std::path::Path;

/// A template.
#[derive(Clone, Debug)]
pub struct TemplateEnds {
    /// Its name.
    name: String,
    /// Names of the ends with the side of the column they are on, +1 or −1; `None` if a parameter
    /// decides.
    ends: Vec<(String, Option<f64>)>,
    /// Role of the column.
    pub column: Option<String>,
    /// Role of the column whose forces the checks take.
    pub checked_column: Option<String>,
    /// Role of the member that has the ends.
    pub beam: Option<String>,
}

impl TemplateEnds {
    /// Reads a template; `folder`: that of the spec.
    pub fn read(name: &str, folder: &Path) -> Result<Self, Diagnostics> {
        let (template, _) = template_file::load(name, folder)?;
        let plain = |t: &Template| {
            let of = |e: &bracket_joint::assembly::template::EndEntry| {
                let side = e.outward.eval(&mut |n| Err(n.to_owned())).ok();
                let side = side.and_then(|v| match v {
                    Value::Quantity(q) if q.value.abs() == 1.0 => Some(q.value),
                    _ => None,
                });
                e.names().into_iter().map(move |n| (n, side)).collect::<Vec<_>>()
            };
            t.ends.iter().flat_map(of).collect()
        };
        let roles: Vec<&str> = template.members.iter().map(|m| m.role.as_str()).collect();
        let column = template.column().map(String::as_str);
        let column = column.or_else(|| roles.iter().copied().find(|r| *r == "column"));
        let others: Vec<&str> = roles.into_iter().filter(|r| Some(*r) != column).collect();
        let beam = match others[..] {
            [one] => Some(one.to_owned()),
            _ => None,
        };
        let (column, checked_column) = (column.map(str::to_owned), template.column().cloned());
        Ok(Self {
            name: template.name.clone(),
            ends: plain(&template),
            column,
            checked_column,
            beam,
        })
    }

    /// The side of an end, +1 or −1, where it is known.
    pub fn side(&self, end: &str) -> Option<f64> {
        self.ends.iter().find(|(name, _)| name == end).and_then(|(_, side)| *side)
    }

    /// Refuses ends and columns that the template does not have.
    pub fn check(&self, row: &JointRow, joints: &Path) -> Result<(), Diagnostics> {
        let known = || self.ends.iter().map(|(name, _)| name.as_str());
        for end in &row.ends {
            if !known().any(|name| name == end.end) {
                let hint = did_you_mean(&end.end, known());
                let message = format!(
                    "joint `{}`: the template `{}` has no member end `{}`{hint}",
                    row.name, self.name, end.end
                );
                let list = known().map(|n| format!("`{n}`")).collect::<Vec<_>>().join(", ");
                let d = Diagnostic::input("import/joints", message).help(format!("it has {list}"));
                return Err(Diagnostic { place: row.place(joints, end.column), ..d }.into());
            }
        }
        if let (Some(member), None) = (row.of_column().next(), &self.column) {
            let message = format!(
                "joint `{}`: the template `{}` has no column, and the row names `{}`",
                row.name, self.name, member.member
            );
            let help = "delete the cells `column_below` and `column_above`, or choose a template \
                        of a joint at a column";
            let d = Diagnostic::input("import/joints", message).help(help);
            return Err(Diagnostic { place: row.place(joints, member.columns[0]), ..d }.into());
        }
        Ok(())
    }
}
