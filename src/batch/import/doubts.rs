//! What an import doubts in its tables without refusing it.

use super::column_forces::value;
use super::end_loads::EndLoads;
use super::equilibrium::brought_by_beams;
use super::joint_row::{JointRow, MemberAt};
use bracket_joint::spec::load_table::Station;
use bracket_joint::spec::loads::{Action, ActionPoint};
use std::collections::BTreeMap;
use std::path::Path;

/// Lever of a moment, M/V, that no beam of a building has \[mm\]: its units are other ones.
const LEVER: f64 = 50e3;

/// Part of a moment that is rounding of the table.
const ROUNDING: f64 = 0.01;

/// A doubt at a line of the table of joints.
fn at(row: &JointRow, joints: &Path, text: &str) -> String {
    format!("{}:{}: joint `{}`: {text}", joints.display(), row.line, row.name)
}

/// Ends of members that two joints use.
pub fn used_twice(rows: &[JointRow], joints: &Path) -> Vec<String> {
    let mut used: BTreeMap<(&str, bool, Option<&str>), &JointRow> = BTreeMap::new();
    let mut out = Vec::new();
    for row in rows {
        let members = row.ends.iter().map(|e| &e.member).chain(row.of_column());
        for MemberAt { member, station, node, .. } in members {
            let end = *station == Station::End;
            let before = used.insert((member, end, node.as_deref()), row);
            if let Some(other) = before.filter(|o| o.name != row.name) {
                let text = format!(
                    "the {station} of member `{member}` is at joint `{}` (line {}) too",
                    other.name, other.line
                );
                out.push(at(row, joints, &text));
            }
        }
    }
    out
}

/// Moments whose lever to the shear force is beyond all buildings in every load case: a table in
/// kN mm that is read as kN m.
pub fn lever(loads: &[EndLoads]) -> Option<String> {
    let all = loads.iter().flat_map(|l| l.ends.iter().flatten());
    let levers: Vec<f64> = all
        .filter_map(|l| {
            let shear = value(l, Action::Vy).hypot(value(l, Action::Vz));
            let moment = value(l, Action::My).hypot(value(l, Action::Mz));
            (shear > 0.0 && moment > 0.0).then(|| moment / shear)
        })
        .collect();
    let least = levers.iter().copied().fold(f64::INFINITY, f64::min);
    (!levers.is_empty() && least > LEVER).then(|| {
        format!(
            "the moments of all member ends are more than {:.0} m times their shear forces: \
             compare the units of the table, kN mm are no kN m",
            (least / 1e3).floor()
        )
    })
}

/// A moment of the column that is too small for what the beams bring to the node. `m_ed`: that of
/// the spec \[N mm\]; `through`: whether the column goes on above.
pub fn column_moment(
    (row, joints): (&JointRow, &Path),
    loads: &EndLoads,
    ends: &[(ActionPoint, Option<f64>)],
    (m_ed, through): (f64, bool),
) -> Option<String> {
    let brought = brought_by_beams(loads, ends)?;
    let least = brought.value.abs() / if through { 2.0 } else { 1.0 };
    (m_ed.abs() < least * (1.0 - ROUNDING)).then(|| {
        let half = if through { "at least half of them" } else { "all of them" };
        let text = format!(
            "the beams bring {:.1} kN m to the node in `{}`, the column takes {half}, and M_Ed of \
             the column is {:.1} kN m",
            brought.value.abs() / 1e6,
            brought.case,
            m_ed.abs() / 1e6
        );
        at(row, joints, &text)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::batch::import::joint_row::EndAt;
    use bracket_joint::spec::loads::LoadSpec;

    fn loads(vz: f64, my: f64) -> EndLoads {
        let mut load = LoadSpec { name: "A".into(), ..LoadSpec::default() };
        load.set(Action::Vz, vz);
        load.set(Action::My, my);
        EndLoads { ends: vec![vec![load]], ..EndLoads::default() }
    }

    fn row(name: &str, line: usize, station: Station) -> JointRow {
        let columns = ["member", "station", "node"];
        let member = MemberAt { member: "B1".into(), station, node: None, columns };
        let (end, at) = ("beam_right".into(), ActionPoint::Node);
        let ends = vec![EndAt { end, at, member, column: "end" }];
        JointRow { name: name.into(), line, ends, below: None, above: None }
    }

    #[test]
    fn an_end_at_two_joints() {
        let joints = Path::new("joints.csv");
        let rows = [row("J", 2, Station::Start), row("K", 3, Station::End)];
        assert!(used_twice(&rows, joints).is_empty());
        let rows = [row("J", 2, Station::Start), row("K", 3, Station::Start)];
        let told = "joints.csv:3: joint `K`: the start of member `B1` is at joint `J` (line 2) too";
        assert_eq!(used_twice(&rows, joints), [told]);
    }

    #[test]
    fn moments_in_another_unit() {
        // 20 kN m beside 10 kN, and the same numbers as kN mm
        assert_eq!(lever(&[loads(10e3, 20e6)]), None);
        assert!(lever(&[loads(10e3, 20e9)]).is_some_and(|t| t.contains("more than 2000 m")));
        assert_eq!(lever(&[loads(10e3, 20e9), loads(10e3, 20e6)]), None);
        assert_eq!(lever(&[loads(0.0, 20e9)]), None);
    }

    #[test]
    fn a_column_that_takes_too_little() {
        let (row, ends) = (row("J", 2, Station::Start), [(ActionPoint::Node, Some(1.0))]);
        let told = |m_ed, through| {
            let at = (&row, Path::new("joints.csv"));
            column_moment(at, &loads(10e3, -20e6), &ends, (m_ed, through))
        };
        assert_eq!(told(10e6, true), None);
        assert_eq!(told(-20e6, false), None);
        assert!(
            told(9e6, true).is_some_and(|t| t.contains("bring 20.0 kN m") && t.contains("9.0"))
        );
        assert!(told(15e6, false).is_some_and(|t| t.contains("all of them")));
        let side = [(ActionPoint::Node, None)];
        let at = (&row, Path::new("joints.csv"));
        assert_eq!(column_moment(at, &loads(10e3, 20e6), &side, (0.0, true)), None);
    }
}
