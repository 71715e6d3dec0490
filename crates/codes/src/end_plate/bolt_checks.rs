//! Resistances of one bolt and of the plates that it clamps.

use super::bolt_rows::{bolt, from_top, pitches};
use super::clamped_plates::{ClampedPlate, clamped_plates};
use crate::check::{Check, Topic, largest, within};
use crate::eurocode::bearing::{Along, Hole};
use crate::eurocode::bolts::{shear_in_joint, tension_resistance};
use crate::eurocode::holes::Clearance;
use crate::eurocode::punching::{mean_diameter, punching_resistance};
use crate::subject::{Part, Place, Subject};
use crate::worked::Worked;
use bracket_joint::assembly::{EndPlate, Way};

/// End distance that reduces no bearing resistance, over d0: α_d = 1.
const FAR: f64 = 3.0;

/// Vertical force down, as `[y, z]`.
pub(super) const DOWN: [f64; 2] = [0.0, -1.0];

/// Bearing resistance of a plate at one bolt under a vertical force.
fn bearing(e: &EndPlate, along: Along, plate: &ClampedPlate, hole: Hole) -> Worked {
    plate.bearing(e, along, [0.5 * (plate.width - e.gauge), e.gauge], hole)
}

/// Positions of a bolt of the row at `z` \[mm\] along a vertical force on the part that it presses,
/// up positive.
///
/// The outermost row is an end row of the end plate whichever way the force points. Of the column
/// flange it is one where the force points to a real end of the column; where there is no force,
/// at either end.
fn positions(e: &EndPlate, plate: &ClampedPlate, z: f64, force: f64) -> Vec<Along> {
    let rows = from_top(e);
    let (highest, lowest) = (rows.first() == Some(&z), rows.last() == Some(&z));
    let mut out: Vec<Along> = pitches(e).map(|[p1, _]| Along::Inner { p1 }).into_iter().collect();
    let e1 = match e.column.as_ref().filter(|_| plate.part != Part::EndPlate) {
        None => (highest || lowest).then(|| (e.top - z).min(z - e.bottom)),
        Some(c) => {
            let towards = |way| Way::of(force).is_none_or(|w| w == way);
            let end =
                |outermost: bool, way| c.ends().from(z, way).filter(|_| outermost && towards(way));
            [end(highest, Way::Up), end(lowest, Way::Down)].into_iter().flatten().reduce(f64::min)
        }
    };
    out.extend(e1.map(|e1| Along::End { e1 }));
    out
}

/// Least bearing resistance of a plate at a bolt of the row at `z` \[mm\] under a force `[y, z]`.
fn bearing_in(e: &EndPlate, plate: &ClampedPlate, z: f64, hole: Hole, force: [f64; 2]) -> Worked {
    let each = positions(e, plate, z, force[1]).into_iter().map(|at| bearing(e, at, plate, hole));
    let least = largest(each, |worked| -worked.value);
    // a single row far from any end
    least.unwrap_or_else(|| bearing(e, Along::End { e1: FAR * e.hole }, plate, hole))
}

/// Bearing resistance of a plate at a bolt of the row at `z` \[mm\] under a force `[y, z]`; `None`
/// for a hole that the code does not have.
pub(super) fn bearing_at(
    e: &EndPlate,
    plate: &ClampedPlate,
    z: f64,
    force: [f64; 2],
) -> Option<Worked> {
    let known = Clearance::of(&e.bolt, e.hole) != Clearance::Beyond;
    known.then(|| bearing_in(e, plate, z, for_bearing(e, force), force))
}

/// Kind of the holes for bearing under a force `[y, z]`: with 2 mm clearance of small bolts a
/// normal hole if the group carries in bearing what it carries in shear, otherwise an oversize one.
///
/// # Source
/// EN 1993-1-8:2005 3.6.1(5); Table 3.4 note 1.
pub(super) fn for_bearing(e: &EndPlate, force: [f64; 2]) -> Hole {
    match Clearance::of(&e.bolt, e.hole) {
        Clearance::Normal => Hole::Normal,
        Clearance::Small
            if within(shear_of_all(e, force), group_bearing(e, Hole::Normal, force)) =>
        {
            Hole::Normal
        }
        _ => Hole::Oversize,
    }
}

/// Resistance of all bolts in bearing under a force `[y, z]` in holes of a kind \[N\].
pub(super) fn group_bearing(e: &EndPlate, hole: Hole, force: [f64; 2]) -> f64 {
    let of = |plate: &ClampedPlate| -> f64 {
        e.rows.iter().map(|z| 2.0 * bearing_in(e, plate, *z, hole, force).value).sum()
    };
    clamped_plates(e).iter().map(of).fold(f64::INFINITY, f64::min)
}

/// Resistance of all bolts in shear under a force `[y, z]` \[N\].
pub(super) fn shear_of_all(e: &EndPlate, force: [f64; 2]) -> f64 {
    2.0 * e.rows.len() as f64 * bolt_shear(e, force).value
}

/// F_v,Rd of one bolt, thread in the shear plane, under a force `[y, z]` on the group: reduced for
/// a long joint and for 2 mm clearance of small bolts.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4, 3.8(1), 3.6.1(5).
pub(super) fn bolt_shear(e: &EndPlate, [across, along]: [f64; 2]) -> Worked {
    let size = across.hypot(along);
    let [y, z] = if size > 0.0 { [across / size, along / size] } else { DOWN };
    let height = from_top(e);
    let height = height.first().zip(height.last()).map_or(0.0, |(a, b)| a - b);
    let length = z.abs() * height + y.abs() * e.gauge;
    shear_in_joint((&e.bolt, &e.grade), e.hole, length, e.factors.gamma_m2)
}

/// Resistances of one bolt in tension, shear, punching and bearing, as information.
pub(super) fn resistances(e: &EndPlate) -> Vec<Check> {
    let (b, g, gamma) = (&e.bolt, &e.grade, e.factors.gamma_m2);
    let subject = Subject::from(bolt(e));
    let tension = tension_resistance(b, g, gamma);
    let mut out = Vec::new();
    out.push(tension.information(Topic::Bolts, subject.clone()));
    let thread = subject.and(Place::Thread);
    out.push(bolt_shear(e, DOWN).information(Topic::Bolts, thread));
    let known = Clearance::of(&e.bolt, e.hole) != Clearance::Beyond;
    let hole = for_bearing(e, DOWN);
    for plate in clamped_plates(e) {
        out.push(
            punching_resistance(mean_diameter(b), plate.thickness, plate.fu, gamma)
                .information(Topic::Bolts, plate.part),
        );
        if !known {
            continue;
        }
        let at = |along, which: Place| {
            let subject = Subject::from(plate.part).and(which).and(Place::VerticalForce);
            bearing(e, along, &plate, hole).information(Topic::Bolts, subject)
        };
        let positions = e.rows.iter().flat_map(|z| positions(e, &plate, *z, 0.0));
        let ends = positions.filter_map(|along| match along {
            Along::End { e1 } => Some(e1),
            Along::Inner { .. } => None,
        });
        out.extend(ends.reduce(f64::min).map(|e1| at(Along::End { e1 }, Place::EndBolt)));
        out.extend(pitches(e).map(|[p1, _]| at(Along::Inner { p1 }, Place::InnerBolt)));
    }
    out
}

/// F_t,Rd of a bolt with the punching of the plates that it clamps \[N\].
pub(super) fn bolt_tension(e: &EndPlate, gamma: f64) -> f64 {
    let dm = mean_diameter(&e.bolt);
    let punching = |p: ClampedPlate| punching_resistance(dm, p.thickness, p.fu, gamma).value;
    let tension = tension_resistance(&e.bolt, &e.grade, gamma).value;
    clamped_plates(e).into_iter().map(punching).fold(tension, f64::min)
}
