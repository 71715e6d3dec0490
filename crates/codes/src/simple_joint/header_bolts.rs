//! Bolts of a header plate under the vertical shear force.

use super::plies::{bolt_shear, bolts, hole, plies};
use super::resistance::Resistance;
use crate::check::{CheckId, Topic};
use crate::formula::Traced;
use crate::subject::{Part, Subject};
use crate::unit::Unit;
use crate::worked::Worked;
use bracket_joint::assembly::SimpleJoint;

/// Part of the shear resistance of the bolts beside the tension that the rotation of the joint
/// brings.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 2.2.4.
const BESIDE_ROTATION: f64 = 0.8;

/// All bolts in shear, `0.8 n F_v,Rd`, and in bearing of either ply.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 2.2.4; EN 1993-1-8:2005 3.7(1). Each is checked alone, so
/// that 0.8 counts whatever governs, on the safe side.
pub(super) fn shear_resistances(e: &SimpleJoint) -> Vec<Resistance> {
    let one = bolt_shear(e, [0.0, -1.0]);
    let all = Traced::from(BESIDE_ROTATION) * Traced::number("n", bolts(e)) * one.traced();
    let mut shear = one.clone().becomes("F_Rd", all);
    shear.id = CheckId::BoltGroupShear;
    shear.clause = "Steel Buildings in Europe 5, 2.2.4";
    let of = |worked: Worked, part: Part| {
        let (topic, subject) = (Topic::Bolts, Subject::from(part));
        Resistance { worked, topic, subject, plastic: false }
    };
    let mut out = vec![of(shear, Part::Bolts)];
    let Some(hole) = hole(e) else { return out };
    for ply in plies(e) {
        let value = ply.all_vertical(e, hole, one.value);
        let (clause, id) = ("EN 1993-1-8:2005 3.7(1)", CheckId::BearingOfGroup);
        let worked = Worked::of(clause, id, "F_Rd", value, Unit::Force);
        out.push(of(worked.after(ply.vertical(e, hole).derivation), ply.part));
    }
    out
}
