//! Shear forces of the single bolts of an end plate under Vy and Vz, and bearing across the member.
//!
//! Both forces act in the axis of the beam. A group of bolts whose centre lies above or below the
//! axis therefore turns under Vy, and the bolts carry that moment as well. Plates are rigid in
//! their plane.

use super::bolt_rows::from_top;
use super::clamped_plates::ClampedPlate;
use crate::check::{Check, CheckId, Topic, Unit, number as n};
use crate::eurocode::bearing::{Along, Hole};
use crate::eurocode::block_tearing::Blocks;
use crate::subject::{Part, Subject};
use crate::worked::Worked;
use bracket_base::say;
use bracket_joint::assembly::{EndPlate, Way};

/// A bolt of the group.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct GroupBolt {
    /// Position from the axis of the beam, across and along it, `[y, z]` \[mm\].
    pub at: [f64; 2],
    /// Its stiffness beside the others: the share that tension leaves of its shear resistance.
    pub weight: f64,
}

/// Centre of a group, each bolt with its weight, `[y, z]` \[mm\].
fn centre(bolts: &[GroupBolt]) -> [f64; 2] {
    let whole: f64 = bolts.iter().map(|b| b.weight).sum();
    [0, 1].map(|k| bolts.iter().map(|b| b.weight * b.at[k]).sum::<f64>() / whole)
}

/// Shear force `[y, z]` of each bolt \[N\] under a force `[Vy, Vz]` in the axis of the beam: in
/// proportion to the weights, and for the moment about the centre of the group to the distance from
/// it as well. The forces balance the load whatever the weights.
///
/// # Source
/// EN 1993-1-8:2005 3.12(1), Table 3.4.
pub(super) fn shear_forces(bolts: &[GroupBolt], [vy, vz]: [f64; 2]) -> Vec<[f64; 2]> {
    let whole: f64 = bolts.iter().map(|b| b.weight).sum();
    let [cy, cz] = centre(bolts);
    let arm = |b: &GroupBolt| [b.at[0] - cy, b.at[1] - cz];
    let polar: f64 =
        bolts.iter().map(|b| b.weight * arm(b).iter().map(|x| x * x).sum::<f64>()).sum();
    // the load acts at the axis, −c from the centre
    let moment = cz * vy - cy * vz;
    let turn = if moment == 0.0 { 0.0 } else { moment / polar };
    let of = |b: &GroupBolt| {
        let [y, z] = arm(b);
        [b.weight * (vy / whole - turn * z), b.weight * (vz / whole + turn * y)]
    };
    bolts.iter().map(of).collect()
}

/// What the checks take Vy to do.
pub(super) fn assumption(bolts: &[GroupBolt], end: &str, vy: f64) -> Check {
    let [_, z] = centre(bolts);
    let words = say!(
        "Vy = {} acts in the axis of the beam; the bolts carry it with its moment about their \
         centre at z = {} mm; end plate and column flange are rigid in their plane; bearing is \
         checked in both directions",
        Unit::Force.show(vy),
        n(z)
    );
    let (clause, id) = ("EN 1993-1-8:2005 3.12, Table 3.4", CheckId::ShearAcross);
    Check::assumption(Topic::Bolts, Subject::end(end), clause, id, words)
}

/// Distance of a row at `z` from the nearer end of a plate, above or below \[mm\]; infinite where
/// it goes on.
fn end_distance(e: &EndPlate, plate: &ClampedPlate, z: f64) -> f64 {
    match e.column.as_ref().filter(|_| plate.part != Part::EndPlate) {
        None => (e.top - z).min(z - e.bottom),
        Some(c) => {
            let ends = [Way::Up, Way::Down].into_iter().filter_map(|way| c.ends().from(z, way));
            ends.fold(f64::INFINITY, f64::min)
        }
    }
}

/// Distance of the outermost bolts from the edge of a plate \[mm\].
fn edge_distance(e: &EndPlate, plate: &ClampedPlate) -> f64 {
    0.5 * (plate.width - e.gauge.max(e.outer_gauge))
}

/// Bearing resistance of a plate at a bolt of the row at `z` \[mm\] under a force across the member
/// \[N\]. The edge of the plate is the end, the next column of bolts the next bolt along the force.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4: components of a force that is not parallel to the edge are checked
/// separately.
pub(super) fn bearing_across(e: &EndPlate, plate: &ClampedPlate, hole: Hole, z: f64) -> Worked {
    let rows = from_top(e);
    let pitch = rows.windows(2).map(|w| w[0] - w[1]).fold(f64::INFINITY, f64::min);
    let columns = e.columns();
    let next = columns.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
    let across = [end_distance(e, plate, z), pitch];
    let of = |along: Along| plate.bearing(e, along, across, hole);
    let e1 = edge_distance(e, plate);
    let (end, inner) = (of(Along::End { e1 }), of(Along::Inner { p1: next }));
    let mut least = if inner.value < end.value { inner } else { end };
    least.id = CheckId::BearingAcross;
    least
}

/// The block that all bolts tear out of an edge of a plate under a force across the member: along
/// the far column of bolts in tension, along the outer rows in shear.
pub(super) fn block_across(e: &EndPlate, plate: &ClampedPlate) -> Worked {
    let rows = from_top(e);
    let height = rows.first().zip(rows.last()).map_or(0.0, |(top, bottom)| top - bottom);
    let blocks = Blocks {
        count: 1.0,
        tension: height - (rows.len() as f64 - 1.0) * e.hole,
        shear: 2.0 * (e.gauge + edge_distance(e, plate) - 1.5 * e.hole),
        thickness: plate.thickness,
        fy: plate.fy,
        fu: plate.fu,
    };
    let mut worked = blocks.resistance(e.factors.gamma_m0, e.factors.gamma_m2);
    worked.id = CheckId::BlockTearingAcross;
    worked
}

#[cfg(test)]
mod tests {
    use super::*;

    fn group(rows: &[f64], weights: &[f64]) -> Vec<GroupBolt> {
        let of = |(z, weight): (&f64, &f64)| {
            [-50.0, 50.0].map(|y| GroupBolt { at: [y, *z], weight: *weight })
        };
        rows.iter().zip(weights).flat_map(of).collect()
    }

    /// The forces balance the load in the axis, whatever the weights; without a moment they are the
    /// resultant over the number of bolts.
    #[test]
    fn bolt_forces_balance_both_shear_forces() {
        for (rows, weights, load) in [
            ([-90.0, 90.0, 190.0], [1.0, 1.0, 1.0], [30e3, -80e3]),
            ([-90.0, 90.0, 190.0], [1.0, 0.4, 0.2], [-30e3, 10e3]),
            ([-60.0, 0.0, 60.0], [1.0, 0.5, 1.0], [25e3, -60e3]),
        ] {
            let bolts = group(&rows, &weights);
            let forces = shear_forces(&bolts, load);
            let sum = |k: usize| forces.iter().map(|f| f[k]).sum::<f64>();
            let turning: f64 =
                bolts.iter().zip(&forces).map(|(b, f)| b.at[0] * f[1] - b.at[1] * f[0]).sum();
            assert!((sum(0) - load[0]).abs() < 1e-6 && (sum(1) - load[1]).abs() < 1e-6);
            assert!(turning.abs() < 1e-3, "{turning}");
        }
        let plain = shear_forces(&group(&[-60.0, 60.0], &[1.0, 1.0]), [30e3, -40e3]);
        assert!(plain.iter().all(|f| (f[0].hypot(f[1]) - 50e3 / 4.0).abs() < 1e-6), "{plain:?}");
        // by hand: rows at −90, 90, 190, centre 63.33 mm; Σ r² = 2 Σ (z − c)² + 6 · 50² = 96 333;
        // the top bolts get Vy (1/6 − c (190 − c)/Σ r²) across and ± Vy c 50/Σ r² along
        let bolts = group(&[-90.0, 90.0, 190.0], &[1.0; 3]);
        let forces = shear_forces(&bolts, [12e3, 0.0]);
        let (c, polar) = (
            190.0 / 3.0,
            2.0 * (153.333_f64.powi(2) + 26.667f64.powi(2) + 126.667f64.powi(2)) + 15e3,
        );
        let top = forces[4];
        assert!((top[0] - 12e3 * (1.0 / 6.0 - c * 126.667 / polar)).abs() < 1.0, "{top:?} {polar}");
        assert!((top[1].abs() - 12e3 * c * 50.0 / polar).abs() < 1.0, "{top:?}");
    }
}
