//! Checks of every load case with actions on the base.

use super::anchorage::{self, Pull};
use super::case_end::at;
use super::compression::{IBase, cross_section, under_flange, whole};
use super::forces::{Force, Forces, forces};
use super::open_actions::{for_analysis, torsion};
use super::shear;
use super::stiffness;
use super::tension_side::of_anchor;
use super::weld_checks;
use crate::check::{Binding, Check, CheckId, Status, Topic, Unit, largest, within};
use crate::formula::Traced;
use crate::subject::Part;
use crate::worked::Worked;
use bracket_joint::assembly::PlaneActions;

/// The topic of most of them.
const TOPIC: Topic = Topic::ComponentMethod;
/// Clause of the forces of both sides.
const CLAUSE: &str = "EN 1993-1-8:2005 6.2.8.3";

/// What the checks know.
const KNOWN: &str = "axial force, shear forces and moment about the strong axis";

/// The checks of every load case at the ultimate limit state.
pub(super) fn checks(e: &IBase<'_>) -> Vec<Check> {
    let ultimate = e.actions.iter().filter(|a| a.state.is_ultimate());
    ultimate.flat_map(|a| of_case(e, a).into_iter().map(|c| c.of_case(&a.case))).collect()
}

fn of_case(e: &IBase<'_>, a: &PlaneActions) -> Vec<Check> {
    let [[n, ..], [_, m, _]] = a.at(1.0);
    let mut out = no_formula(e, a);
    let mut pull = Pull::Known(0.0);
    let welds = weld_checks::under_load(e, a);
    if n < 0.0 && m == 0.0 {
        let subject = at(a).and(Part::BasePlate);
        out.push(whole(e).against(TOPIC, subject, -n, Status::Failed).of_strength());
    } else if n != 0.0 || m != 0.0 {
        match forces(e, n, m) {
            Ok(found) => {
                let flange = welds.iter().find(|(part, _)| *part == Part::ColumnFlange);
                let welded = flange.and_then(|(_, check)| check.utilisation);
                out.extend(of_sides(e, a, &found, welded));
                out.extend(stiffness::checks(e, a, &found));
                let pulls = found.iter().filter_map(|(_, force)| match force {
                    Force::Tension(row, force) => Some(of_anchor(row, force.value)),
                    Force::Compression(_) => None,
                });
                pull = Pull::Known(pulls.fold(0.0, f64::max));
            }
            Err(why) => {
                let (subject, id) = (at(a).and(Part::Anchors), CheckId::BaseTension);
                let step = "one row of two anchors outside each flange, or a limit analysis";
                out.push(Check::undecided(TOPIC, subject, CLAUSE, id, why, step).without_method());
            }
        }
    }
    // where analysis answers for the base, it may load the anchors more than the code's forces do
    let answers = |c: &Check| (c.binding, c.status) == (Binding::Strength, Status::Failed);
    if out.iter().any(|c| c.binding == Binding::Open || answers(c)) {
        pull = Pull::unknown(e);
    }
    let sheared = shear::of_anchor(e, a);
    out.extend(shear::checks(e, a, pull.most()));
    out.extend(anchorage::check(e, a, pull, sheared));
    out.extend(welds.into_iter().map(|(_, check)| check));
    out.extend(column(e, a));
    out
}

/// The forces of both sides against their resistances, and M_j,Rd at constant eccentricity.
/// `welded`: the utilisation of fillet welds of the flanges, which must not limit M_j,Rd
/// (6.2.3(4)): where they do, it is what they carry.
fn of_sides(e: &IBase<'_>, a: &PlaneActions, forces: &Forces, welded: Option<f64>) -> Vec<Check> {
    let [[_, _, v], [_, m, _]] = a.at(1.0);
    let mut out = Vec::new();
    for (side, force) in forces {
        let flange = if *side > 0.0 { Part::FlangeAtPlus } else { Part::FlangeAtMinus };
        let subject = at(a).and(flange);
        match force {
            Force::Tension(row, force) => {
                let worked = row.resistance.clone().after(force.clone());
                let check = worked.against(TOPIC, subject, force.value, Status::Failed);
                out.push(check.of_strength());
            }
            Force::Compression(force) => match under_flange(e, *side, v.abs()) {
                Ok(worked) => {
                    let worked = worked.after(force.clone());
                    let check = worked.against(TOPIC, subject, force.value, Status::Failed);
                    out.push(check.of_strength());
                }
                Err(fault) => {
                    let (id, step) = (CheckId::BaseFlangeCompression, "a column of class 1 to 3");
                    let why = fault.text();
                    let open = Check::undecided(TOPIC, subject, CLAUSE, id, why, step);
                    out.push(open.without_method());
                }
            },
        }
    }
    let used = largest(out.iter().filter_map(|c| c.utilisation), |u| *u).filter(|u| *u > 0.0);
    if let Some(used) = used.filter(|_| m != 0.0) {
        let by_weld = welded.filter(|w| *w > used);
        let share = Traced::number("η", by_weld.unwrap_or(used));
        let value = Traced::symbol("M_Ed", m.abs(), Unit::Moment) / share;
        let (clause, id) = ("EN 1993-1-8:2005 Table 6.7", CheckId::BaseMoment);
        let worked = Worked::of(clause, id, "M_j,Rd", value, Unit::Moment).after(match by_weld {
            Some(_) => "η: the utilisation of the welds of the flanges; e = M/N is kept",
            None => "η: the largest utilisation of the forces under both flanges; e = M/N is kept",
        });
        out.push(worked.information(TOPIC, at(a).and(Part::Joint)));
    }
    out
}

/// The column's own section under the actions.
fn column(e: &IBase<'_>, a: &PlaneActions) -> Vec<Check> {
    let [[n, across, v], [_, m, mz]] = a.at(1.0);
    let (section, subject) = (cross_section(e), at(a).and(Part::Column));
    let against = |mut worked: Worked, id: CheckId, demand: f64| {
        worked.id = id;
        worked.against(Topic::Member, subject.clone(), demand.abs(), Status::Failed)
    };
    let mut out = Vec::new();
    if v != 0.0 {
        out.push(against(section.shear(), CheckId::ColumnShear, v));
    }
    if across != 0.0 {
        out.push(against(section.shear_across(), CheckId::ColumnShear, across));
    }
    if n != 0.0 {
        out.push(against(section.axial(), CheckId::ColumnAxial, n));
    }
    if m != 0.0 || mz != 0.0 || n < 0.0 {
        out.push(match section.bending_6_2_10(v, n) {
            Ok(_) if mz != 0.0 => {
                let moduli = [e.profile.w_el_y, e.profile.w_el_z, e.profile.w_pl_z];
                section.linear_sum(moduli.map(|w| 1e3 * w), [n, v, m, mz]).utilised(
                    Topic::Member,
                    subject.clone(),
                    Status::Failed,
                )
            }
            Ok(worked) => against(worked, CheckId::ColumnMoment, m),
            Err(fault) => {
                let (clause, id) = ("EN 1993-1-1:2005 5.5.2", CheckId::ColumnMoment);
                let step = "a column of class 1 to 3";
                Check::undecided(Topic::Member, subject.clone(), clause, id, fault.text(), step)
            }
        });
    }
    out
}

/// Actions that these checks do not share out. A shear force across the column is carried like one
/// along it, as long as it does not reduce the moment resistance of the column, 6.2.8(2) of EN
/// 1993-1-1.
fn no_formula(e: &IBase<'_>, a: &PlaneActions) -> Vec<Check> {
    let [[_, across, _], [_, _, mz]] = a.at(1.0);
    let high = !within(across.abs(), 0.5 * cross_section(e).shear_across().value);
    let vy = if high { across } else { 0.0 };
    [
        ("Vy", vy, Unit::Force, CheckId::ShearAcross),
        ("Mz", mz, Unit::Moment, CheckId::WeakAxisOfJoint),
    ]
    .into_iter()
    .filter_map(|action| for_analysis(a, action, KNOWN))
    .chain(torsion(a, KNOWN))
    .collect()
}
