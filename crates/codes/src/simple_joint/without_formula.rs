//! Actions for which the code has no formula in a simple joint. Small ones are neglected before.

use crate::check::{Check, CheckId, Topic, Unit};
use crate::subject::Subject;
use bracket_base::say;
use bracket_joint::assembly::{PlaneActions, SimpleJoint, SimpleKind};

/// One undecided check for each of them.
pub(super) fn checks(e: &SimpleJoint, a: &PlaneActions) -> Vec<Check> {
    let [[axial, vy, _], [torsion, my, mz]] = a.at(1.0);
    let header = e.kind == SimpleKind::HeaderPlate;
    let of_plate = |fin: &'static str, other: &'static str| if header { other } else { fin };
    let force = Unit::Force;
    let moment = Unit::Moment;
    let beside = "a detail that carries it beside the joint";
    let all = [
        (
            ("Vy", vy, force),
            CheckId::ShearAcross,
            of_plate(
                "it bends the fin plate out of its plane, for which there is no formula",
                "it bends the web beside the plate, for which there is no formula",
            ),
            beside,
        ),
        (
            ("T", torsion, moment),
            CheckId::TorsionOfJoint,
            "a simple joint has no resistance to it by the code",
            beside,
        ),
        (
            ("Mz", mz, moment),
            CheckId::WeakAxisOfJoint,
            "a simple joint has no resistance to it by the code",
            beside,
        ),
        (
            ("My", if header { my } else { 0.0 }, moment),
            CheckId::MomentOfPinned,
            "the joint is nominally pinned: these checks take no moment at the face of the support",
            "an end plate with its component method, or a load without the moment",
        ),
        (
            ("N", axial.min(0.0), force),
            CheckId::PushedPlate,
            of_plate(
                "the fin plate is pushed beside its lap with the web: its buckling has no formula",
                "the plate is pushed against the support: its local bending has no formula",
            ),
            beside,
        ),
    ];
    let acts = all.into_iter().filter(|((_, value, _), ..)| *value != 0.0);
    let check = |((name, value, unit), id, why, step): (_, _, &'static str, &'static str)| {
        let (name, value, unit): (&'static str, f64, Unit) = (name, value, unit);
        let why = say!("{} = {}: {}", name, unit.show(value), why);
        let clause = "EN 1993-1-8:2005 5.1.2";
        Check::undecided(Topic::Bolts, Subject::end(&a.end), clause, id, why, step).without_method()
    };
    acts.map(check).collect()
}
