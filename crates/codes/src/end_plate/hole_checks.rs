//! Kind of the holes with its factors, as information.

use super::bolt_checks::{DOWN, for_bearing, group_bearing, shear_of_all};
use crate::check::{Check, CheckId, Topic, Unit, number as n};
use crate::eurocode::bearing::Hole;
use crate::eurocode::holes::{CLEARANCES, Clearance};
use crate::formula::Traced;
use crate::subject::Part;
use crate::worked::Worked;
use bracket_base::say;
use bracket_joint::assembly::EndPlate;
use bracket_joint::catalog::BoltSize;

/// Kind of the holes with its factors.
pub(super) fn holes(e: &EndPlate) -> Vec<Check> {
    let group = [shear_of_all(e, DOWN), group_bearing(e, Hole::Normal, DOWN)];
    kind_of_holes(&e.bolt, e.hole, for_bearing(e, DOWN), Some(group)).into_iter().collect()
}

/// Kind of the holes of a diameter \[mm\] with its factors; `bearing`: the kind that bearing takes,
/// `group` its resistances in shear and, in normal holes, in bearing \[N\], which decide about
/// small bolts. `None` for holes that the code does not have.
pub(crate) fn kind_of_holes(
    b: &BoltSize,
    hole: f64,
    bearing: Hole,
    group: Option<[f64; 2]>,
) -> Option<Check> {
    let kind = Clearance::of(b, hole);
    let slip = kind.slip()?;
    let (id, part) = match (kind, bearing) {
        (Clearance::Normal, _) => (CheckId::NormalHoles, 1.0),
        (_, Hole::Normal) => (CheckId::SmallBoltHoles, 1.0),
        _ => (CheckId::OversizeHoles, 0.8),
    };
    let words = say!(
        "d0 = {} mm, normal {} mm, oversize {} mm: bearing times {} (Table 3.4), k_s = {} (Table \
         3.6)",
        n(hole),
        n(b.hole_normal),
        n(b.hole_oversize),
        n(part),
        n(slip.ks())
    );
    let clearance = Traced::length("d0", hole) - Traced::length("d", b.d);
    let mut worked = Worked::of(CLEARANCES, id, "", clearance, Unit::Length).after(words);
    if let (Clearance::Small, Some([shear, normal])) = (kind, group) {
        worked = worked.after(say!(
            "group in bearing {}, in shear {}: {} (3.6.1(5))",
            Unit::Force.show(normal),
            Unit::Force.show(shear),
            match part < 1.0 {
                true => "bearing would govern, so that the holes count as oversize",
                false => "bearing does not govern",
            }
        ));
    }
    Some(worked.information(Topic::Detailing, Part::Holes))
}
