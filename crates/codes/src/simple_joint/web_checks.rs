//! The web of the beam around the bolts of a long fin plate.

use super::actions::moment;
use super::plate_checks::is_long;
use super::plies::{first, last, web};
use super::shear_resistances::{net_web, notched, web_shear};
use crate::check::{Check, CheckId, Status, Topic, Unit};
use crate::eurocode::section::shear_reduction;
use crate::eurocode::yielding::{in_shear, plastic};
use crate::formula::{Formula, Number, Traced};
use crate::subject::{Part, Subject};
use crate::worked::Worked;
use bracket_joint::assembly::{PlaneActions, SimpleJoint};

/// Resistance of a face of the web in shear \[N\], the lesser of the gross and the net section;
/// lengths in mm.
fn face(e: &SimpleJoint, symbol: &'static str, [gross, net]: [f64; 2]) -> Formula {
    let t_w = || Traced::length("t_w", e.beam.tw);
    let [f_y, f_u] = [("f_y", e.beam_steel.fy.mpa()), ("f_u", e.beam_steel.fu.mpa())]
        .map(|(s, v)| Traced::stress(s, v));
    let [m0, m2] = [("γ_M0", e.factors.gamma_m0), ("γ_M2", e.factors.gamma_m2)]
        .map(|(s, v)| Traced::number(s, v));
    let gross = in_shear(Traced::length("l", gross) * t_w() * f_y, m0);
    let net = in_shear(Traced::length("l_net", net.max(0.0)) * t_w() * f_u, m2);
    Formula::new(symbol, gross.min(net), Unit::Force)
}

/// Whether the web carries the moment of a long fin plate around the bolts: two faces AB and CD
/// along the beam in shear, and one face BC through the last line of bolts in bending. `None` for
/// a short plate, a notched beam, or without a moment.
///
/// `M_Ed ≤ M_c,BC,Rd + F_pl,AB,Rd (n_1 − 1) p_1`, M_Ed at the last line of bolts.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 3.2.5.3. Beside a high shear force the plastic moment that it
/// reduces counts there; here it counts no more than the elastic one, on the safe side.
pub(super) fn around_bolts(e: &SimpleJoint, a: &PlaneActions) -> Option<Check> {
    let vz = a.at(1.0)[0][2].abs();
    let centre = 0.5 * (first(&e.rows) + last(&e.rows));
    let m = moment(e, a, [last(&e.columns), centre]);
    if !is_long(e) || notched(e).is_some() || m.value == 0.0 {
        return None;
    }
    let (clause, id) = ("Steel Buildings in Europe 5, 3.2.5.3", CheckId::WebBending);
    let subject = Subject::end(&a.end).and(Part::BeamWeb);
    let height = first(&e.rows) - last(&e.rows);
    if e.rows.len() < 2 {
        let why = "a long fin plate with one row of bolts: the web has no face between rows";
        let step = "two rows of bolts or more, or a shorter fin plate";
        let check = Check::undecided(Topic::Member, subject, clause, id, why, step);
        return Some(check.without_method());
    }
    let w = web(e);
    let spaces = e.rows.len() as f64 - 1.0;
    // the half hole of the last line is in the face, those of the lines before it whole
    let depth = last(&e.columns) - e.beam_start;
    let ab = face(e, "F_pl,AB,Rd", [depth, w.edge_face(e)]);
    let bc = face(e, "F_pl,BC,Rd", [height, height - spaces * e.hole]);
    let least = web_shear(e).value.min(net_web(e).value);
    let on_bc = (vz - (least - bc.value)).max(0.0);
    let t_w = || Traced::length("t_w", e.beam.tw);
    let square = || Traced::length("(n_1 − 1) p_1", height).powi(2);
    let strength = || {
        let f_y = Traced::stress("f_y", e.beam_steel.fy.mpa());
        (f_y, Traced::number("γ_M0", e.factors.gamma_m0))
    };
    let modulus = |part: f64| {
        let (f_y, gamma) = strength();
        plastic(t_w() * square() / Traced::from(part), f_y, gamma)
    };
    let bending = if on_bc > 0.5 * bc.value {
        let ratio = Traced::force("V_Ed", vz) / Traced::force("V_Rd,min", least);
        let left = Traced::from(1.0) - shear_reduction(ratio);
        let left = if left.value() < 0.0 { left.max(Traced::from(0.0)) } else { left };
        modulus(6.0).min(modulus(4.0) * left)
    } else {
        modulus(6.0)
    };
    let bending = Formula::new("M_c,BC,Rd", bending, Unit::Moment);
    let value = bending.traced() + ab.traced() * Traced::length("(n_1 − 1) p_1", height);
    let demand = m.value.abs();
    let worked = Worked::of(clause, id, "M_Rd", value, Unit::Moment)
        .with("V_BC,Ed", on_bc, Unit::Force)
        .with("F_pl,BC,Rd", bc.value, Unit::Force)
        .after(bending)
        .after(ab)
        .after(m);
    Some(worked.against(Topic::Member, subject, demand, Status::Failed).of_strength())
}
