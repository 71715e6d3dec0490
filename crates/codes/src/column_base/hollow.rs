//! Checks of a base whose column is a hollow section: compression on the effective area, shear,
//! welds and the section itself. For moments and tension 6.2.8 has no rules of hollow sections.

use super::anchorage::{self, Pull};
use super::case_end::at;
use super::compression::whole;
use super::open_actions::{for_analysis, torsion};
use super::shear;
use crate::check::{Check, CheckId, Status, Topic, Unit};
use crate::end_plate::without_strength;
use crate::eurocode::hollow::Hollow;
use crate::eurocode::welds::{LineForce, WeldedSteel, either_method, least_size};
use crate::formula::{Formula, Traced};
use crate::subject::{Part, Place};
use bracket_joint::assembly::{BaseSection, ColumnBase, PlaneActions};

/// What the checks know.
const KNOWN: &str = "compression, shear and, of the column and its weld, moments";

/// The hollow section of the column; `None` for an I section.
pub(super) fn section(e: &ColumnBase) -> Option<Hollow> {
    match e.section {
        BaseSection::I(_) => None,
        BaseSection::Rectangular { size, t, radii } => Some(Hollow::Rectangular { size, t, radii }),
        BaseSection::Circular { d, t } => Some(Hollow::Circular { d, t }),
    }
}

/// The checks of every load case at the ultimate limit state.
pub(super) fn checks(e: &ColumnBase, h: &Hollow) -> Vec<Check> {
    let ultimate = e.actions.iter().filter(|a| a.state.is_ultimate());
    ultimate.flat_map(|a| of_case(e, h, a).into_iter().map(|c| c.of_case(&a.case))).collect()
}

fn of_case(e: &ColumnBase, h: &Hollow, a: &PlaneActions) -> Vec<Check> {
    let [[n, ..], [_, my, mz]] = a.at(1.0);
    let mut out = Vec::new();
    let pull = n.max(0.0);
    for action in [
        ("N", pull, Unit::Force, CheckId::BaseTension),
        ("My", my, Unit::Moment, CheckId::BaseMoment),
        ("Mz", mz, Unit::Moment, CheckId::WeakAxisOfJoint),
    ] {
        out.extend(for_analysis(a, action, KNOWN));
    }
    out.extend(torsion(a, KNOWN));
    let pressed = out.is_empty();
    if n < 0.0 && pressed {
        let subject = at(a).and(Part::BasePlate);
        let check = whole(e).against(Topic::ComponentMethod, subject, -n, Status::Failed);
        out.push(check.of_strength());
    }
    let pull = if pressed { Pull::Known(0.0) } else { Pull::unknown(e) };
    out.extend(shear::checks(e, a, pull.most()));
    out.extend(anchorage::check(e, a, pull, shear::of_anchor(e, a)));
    out.extend(weld(e, h, a));
    out.extend(column(e, h, a));
    out
}

/// Least size of the weld round the column, and a steel that gives it no strength.
pub(super) fn weld_size(e: &ColumnBase, h: &Hollow) -> Vec<Check> {
    if e.flange_throat == 0.0 {
        return Vec::new();
    }
    let mut out: Vec<Check> = least_size(Part::ColumnWall, e.flange_throat, h.outline()).into();
    let steel = e.flange_steel.weaker(&e.plate_steel);
    if WeldedSteel::of(steel, e.factors.gamma_m2).is_none() {
        out.push(without_strength(Part::ColumnWall, steel));
    }
    out
}

/// The fillet weld round the column, at its most stressed point: the elastic stresses of the wall
/// under N and both moments, and the shear of both directions on the two walls, or on the ring,
/// that lie along it.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.1(1), 2.5(1). Compression counts like tension.
fn weld(e: &ColumnBase, h: &Hollow, a: &PlaneActions) -> Option<Check> {
    let [[n, vy, vz], [_, my, mz]] = a.at(1.0);
    let acts = [n, vy, vz, my, mz].iter().any(|x| *x != 0.0);
    if e.flange_throat == 0.0 || !acts {
        return None;
    }
    let steel = WeldedSteel::of(e.flange_steel.weaker(&e.plate_steel), e.factors.gamma_m2)?;
    let [w_y, w_z] = h.w_el();
    let moment = |name: &'static str, value: f64| Traced::symbol(name, value.abs(), Unit::Moment);
    let stress = Traced::force("N_Ed", n.abs()) / Traced::area("A", h.area())
        + moment("M_y,Ed", my) / Traced::number("W_el,y", w_y)
        + moment("M_z,Ed", mz) / Traced::number("W_el,z", w_z);
    let across = stress * Traced::length("t", h.wall());
    let across = Formula::new("F_⊥", across, Unit::ForcePerLength);
    let along = match *h {
        // both directions meet in a corner
        Hollow::Rectangular { size: [depth, width], .. } => {
            let of = |name: &'static str, v: f64, length: f64| {
                Traced::force(name, v.abs()) / (Traced::from(2.0) * Traced::length("l", length))
            };
            of("V_z,Ed", vz, depth) + of("V_y,Ed", vy, width)
        }
        // the greatest shear flow of a thin ring
        Hollow::Circular { d, .. } => {
            Traced::from(2.0) * Traced::force("V_Ed", vy.hypot(vz))
                / (Traced::number("π", std::f64::consts::PI) * Traced::length("d", d))
        }
    };
    let along = Formula::new("F_∥", along, Unit::ForcePerLength);
    let force = LineForce { across: across.value, along: along.value };
    let worked = either_method(force, e.flange_throat, &steel).after(along).after(across);
    let seam = at(a).and(Place::Seam { of: Part::ColumnWall, to: Part::BasePlate });
    Some(worked.against(Topic::Welds, seam, force.resultant(), Status::Failed))
}

/// The column's own section.
fn column(e: &ColumnBase, h: &Hollow, a: &PlaneActions) -> Vec<Check> {
    let [[n, vy, vz], [_, my, mz]] = a.at(1.0);
    let subject = at(a).and(Part::Column);
    let (fy, gamma) = (e.flange_steel.fy, e.factors.gamma_m0);
    let mut out = Vec::new();
    for (v, area) in [vz, vy].into_iter().zip(h.shear_areas()) {
        if v != 0.0 {
            let worked = h.shear(fy, gamma, area);
            out.push(worked.against(Topic::Member, subject.clone(), v.abs(), Status::Failed));
        }
    }
    if [n, my, mz].iter().all(|x| *x == 0.0) {
        return out;
    }
    out.push(match h.linear_sum((fy, gamma), [[n, vy, vz], [0.0, my, mz]]) {
        Ok(worked) => worked.utilised(Topic::Member, subject, Status::Failed),
        Err(fault) => {
            let (clause, id) = ("EN 1993-1-1:2005 5.5.2", CheckId::ColumnMoment);
            let step = "a column of class 1 to 3";
            Check::undecided(Topic::Member, subject, clause, id, fault.text(), step)
        }
    });
    out
}
