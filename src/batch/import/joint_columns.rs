//! Columns of the table of joints that say which members meet there.

use super::joint_row::{EndAt, JointRow, MemberAt};
use bracket_joint::spec::load_table::Station;
use bracket_joint::spec::loads::ActionPoint;
use std::collections::BTreeMap;

/// Names of the columns.
pub const NAMES: [&str; 17] = [
    "joint",
    "end",
    "member",
    "station",
    "node",
    "at",
    "end2",
    "member2",
    "station2",
    "node2",
    "at2",
    "column_below",
    "station_below",
    "node_below",
    "column_above",
    "station_above",
    "node_above",
];

/// A fault of a row: the column, what is wrong, and what to do.
pub type CellFault = (&'static str, String, &'static str);

/// The cells of a row by column; none is empty.
pub struct Cells<'a>(pub BTreeMap<&'static str, &'a str>);

/// Columns of a member: itself, station, node.
type Columns = [&'static str; 3];

const FIRST: Columns = ["member", "station", "node"];
const SECOND: Columns = ["member2", "station2", "node2"];
const BELOW: Columns = ["column_below", "station_below", "node_below"];
const ABOVE: Columns = ["column_above", "station_above", "node_above"];

impl Cells<'_> {
    fn get(&self, column: &'static str) -> Option<&str> {
        self.0.get(column).copied()
    }

    fn station(&self, column: &'static str) -> Result<Option<Station>, CellFault> {
        let of = |word: &str| match word.to_ascii_lowercase().as_str() {
            "start" => Ok(Station::Start),
            "end" => Ok(Station::End),
            _ => {
                let message = format!("`{word}` is no end of a member");
                Err((column, message, "write `start` or `end`: which end is at the joint"))
            }
        };
        self.get(column).map(of).transpose()
    }

    fn point(&self, column: &'static str) -> Result<Option<ActionPoint>, CellFault> {
        let of = |word: &str| {
            ActionPoint::of(word).ok_or_else(|| {
                let message = format!("`{word}` is no point at which actions act");
                (column, message, "write node, column_face or bolt_plane")
            })
        };
        self.get(column).map(of).transpose()
    }

    /// A member whose cell is not empty; `usual`: the end that is at the joint where nothing says
    /// it.
    fn member(
        &self,
        columns: Columns,
        usual: Option<Station>,
    ) -> Result<Option<MemberAt>, CellFault> {
        let [member, station, node] = columns;
        let Some(name) = self.get(member) else {
            let lost = [station, node].into_iter().find(|c| self.get(c).is_some());
            return match lost {
                Some(column) => {
                    let message = format!("`{column}` belongs to `{member}`, which is empty");
                    Err((column, message, "name the member, or delete the cell"))
                }
                None => Ok(None),
            };
        };
        let Some(at) = self.station(station)?.or(usual) else {
            let message = format!("the row does not say which end of `{name}` is at the joint");
            return Err((station, message, "write `start` or `end` into this column"));
        };
        let node = self.get(node).map(str::to_owned);
        Ok(Some(MemberAt { member: name.into(), station: at, node, columns }))
    }

    fn end(
        &self,
        [end, at]: [&'static str; 2],
        columns: Columns,
    ) -> Result<Option<EndAt>, CellFault> {
        let member = self.member(columns, None)?;
        let point = self.point(at)?;
        match (self.get(end), member) {
            (Some(name), Some(member)) => {
                let at = point.or(self.point("at")?).unwrap_or(ActionPoint::Node);
                Ok(Some(EndAt { end: name.into(), at, member, column: end }))
            }
            (None, None) => Ok(None),
            (Some(name), None) => {
                let message = format!("the end `{name}` has no member");
                Err((columns[0], message, "write the name of the member in the table of forces"))
            }
            (None, Some(member)) => {
                let message = format!("the member `{}` has no end of the joint", member.member);
                let help = "write a member end of the template, such as `beam_right`; `bracket \
                            templates NAME` lists them";
                Err((end, message, help))
            }
        }
    }

    /// The joint of the row.
    pub fn joint(&self, line: usize) -> Result<JointRow, CellFault> {
        let Some(name) = self.get("joint") else {
            let message = "the joint has no name".to_string();
            return Err(("joint", message, "give every joint a name of its own"));
        };
        let Some(first) = self.end(["end", "at"], FIRST)? else {
            let message = "the joint has no member".to_string();
            let help = "write a member end of the template into `end` and the member of the \
                        table of forces into `member`";
            return Err(("member", message, help));
        };
        let mut ends = vec![first];
        if let Some(second) = self.end(["end2", "at2"], SECOND)? {
            if second.end == ends[0].end {
                let message = format!("both members are at the end `{}`", second.end);
                return Err(("end2", message, "write the other end of the template"));
            }
            ends.push(second);
        }
        // a column that nothing else is said of goes on upwards
        let below = self.member(BELOW, Some(Station::End))?;
        let above = self.member(ABOVE, Some(Station::Start))?;
        Ok(JointRow { name: name.into(), line, ends, below, above })
    }
}
