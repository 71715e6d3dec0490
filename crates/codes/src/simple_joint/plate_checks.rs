//! A fin plate as a cantilever in its plane: bending and lateral torsional buckling.

use super::actions::{larger, middle, moment};
use super::plies::{first, plate};
use crate::check::{Check, CheckId, Status, Topic, Unit, within};
use crate::eurocode::yielding::plastic;
use crate::formula::{Derivation, Formula, Line, Number, Relation, Traced};
use crate::subject::{Part, Subject};
use crate::worked::Worked;
use bracket_joint::assembly::{PlaneActions, SimpleJoint};

/// Height of a fin plate over its lever arm from which the shear of its gross section covers the
/// bending.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 3.2.3.
const STOCKY: f64 = 2.73;

/// Lever arm of a fin plate over its thickness from which it is long, 1/0.15.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 3.1 and 3.2.4.
const SHORT: f64 = 0.15;

/// Whether the lever arm z of the bolt group makes a long fin plate, `z > t_p/0.15`.
pub(super) fn is_long(e: &SimpleJoint) -> bool {
    !within(e.centre() * SHORT, e.thickness)
}

/// The larger moment of the plate about its middle, of those at the support and at the centre of
/// the bolts: between them it changes linearly.
fn largest_moment(e: &SimpleJoint, a: &PlaneActions) -> Formula {
    let at = |x| moment(e, a, [x, middle(e)]);
    larger(at(0.0), at(e.centre()))
}

/// Bending of the plate in its plane, with its axial force.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 3.2.3, with M_Ed/V_Ed in place of z; EN 1993-1-1:2005
/// 6.2.1(7) for the axial force beside it.
pub(super) fn bending(e: &SimpleJoint, a: &PlaneActions) -> Option<Check> {
    let [axial, _, vz] = a.at(1.0)[0];
    let m = largest_moment(e, a);
    if m.value == 0.0 {
        return None;
    }
    let subject = Subject::end(&a.end).and(Part::FinPlate);
    let arm = || m.traced().abs() / Traced::force("V_Ed", vz.abs());
    if axial == 0.0 && vz != 0.0 && within(STOCKY * m.value.abs() / vz.abs(), e.height()) {
        let (clause, id) = ("Steel Buildings in Europe 5, 3.2.3", CheckId::PlateBending);
        let (of, limit) = ((Topic::Member, subject), Traced::from(STOCKY) * arm());
        let mut check = Check::at_least(of, (clause, id), "h_p", limit, e.height(), Status::Failed);
        check.derivation = Derivation::from(m).followed_by(check.derivation);
        let words = "the shear of the gross section covers the bending";
        check.derivation.lines.push(words.into());
        return Some(check);
    }
    let p = plate(e);
    let resistance = p.section(e, 1.0).bending();
    if axial == 0.0 {
        let demand = m.value.abs();
        let worked = resistance.after(m);
        return Some(worked.against(Topic::Member, subject, demand, Status::Failed).of_strength());
    }
    let area = Traced::length("h_p", e.height()) * Traced::length("t_p", e.thickness);
    let f_y = Traced::stress("f_y", e.plate_steel.fy.mpa());
    let gross = plastic(area, f_y, Traced::number("γ_M0", e.factors.gamma_m0));
    let gross = Formula::new("N_pl,Rd", gross, Unit::Force);
    let used = m.traced().abs() / resistance.traced()
        + Traced::force("N_Ed", axial.abs()) / gross.traced();
    let (clause, id) = ("EN 1993-1-1:2005 6.2.1(7)", CheckId::PlateBending);
    let worked = Worked::of(clause, id, "", used, Unit::Number)
        .after(gross)
        .after(resistance.derivation)
        .after(m);
    Some(worked.utilised(Topic::Member, subject, Status::Failed).of_strength())
}

/// Lateral torsional buckling of a long fin plate; `None` of a short one, or without a moment.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 3.2.4.
pub(super) fn buckling(e: &SimpleJoint, a: &PlaneActions) -> Option<Check> {
    let m = largest_moment(e, a);
    if !is_long(e) || m.value == 0.0 {
        return None;
    }
    let p = plate(e);
    let section = p.section(e, 1.0);
    let limit = Traced::length("t_p", e.thickness) / Traced::from(SHORT);
    let long = Line::comparison("z", e.centre(), Relation::Above, limit, Unit::Length);
    let demand = m.value.abs();
    let worked = section.lateral_buckling(first(&e.columns)).after(m);
    let worked = worked.after(Derivation::from(long));
    let subject = Subject::end(&a.end).and(Part::FinPlate);
    Some(worked.against(Topic::Stability, subject, demand, Status::Failed))
}
