//! Resistances of a bolt in its grip, as limits of the forces in the sections of its shank.

use super::bearing::{Along, Bearing, Hole};
use super::bolts::{beta_lf, shear_resistance, tension_resistance};
use super::concrete::f_vb_rd;
use super::holes::{Clearance, shear_factor};
use super::interaction::TENSION_BESIDE_SHEAR;
use super::punching::{mean_diameter, punching_resistance};
use super::yielding::plastic;
use bracket_joint::assembly::assembly::{Grip, Ply, Room};
use bracket_joint::spec::code::PartialFactors;
use bracket_joint::strength::{BoltLimits, Design};

/// Least resistance in bearing \[N\]: below the distances of Table 3.3 the formula of Table 3.4 has
/// none, and a limit is above zero.
const NO_BEARING: f64 = 1.0;

/// Resistances of a bolt for forces in any direction.
///
/// Each is the least over what the code distinguishes by the direction of the force on the whole
/// group: a long joint is as long as its bolts are apart, and the pitch along the force is the
/// lesser of the two sides.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4, 3.6.1(5), 3.8(1); of an anchor 6.2.2(7).
pub fn limits(grip: &Grip, factors: &PartialFactors) -> BoltLimits {
    let (size, grade, gamma) = (&grip.size, &grip.grade, factors.gamma_m2);
    let tension = tension_resistance(size, grade, gamma).value;
    let shear = shear_resistance(size, grade, gamma).value
        * shear_factor(size, grade, grip.hole)
        * beta_lf(grip.extent, size.d);
    let punching = |ply: Option<&Ply>| {
        ply.map_or(tension, |p| {
            punching_resistance(mean_diameter(size), p.thickness, p.fu.mpa(), gamma).value
        })
    };
    // a shank weaker than this would not carry F_v,Rd; it yields in bending at f_yb
    let area = std::f64::consts::PI * size.d * size.d / 4.0;
    let yielding = plastic(area, grade.fyb, factors.gamma_m0);
    let shank = (3f64.sqrt() * shear).min(yielding).max(tension) / area;
    // outside the range of f_yb the formula goes on: it falls, and never exceeds that of a bolt
    let shear = match grip.anchored {
        true => f_vb_rd(grade.fyb, grade.fub, size.stress_area, gamma).min(shear).max(NO_BEARING),
        false => shear,
    };
    BoltLimits {
        shank: Design::new(shank),
        tension,
        shear,
        interaction: TENSION_BESIDE_SHEAR,
        punching: [punching(grip.plies.first()), punching(grip.plies.last())],
        bearing: grip.plies.iter().map(|p| bearing(grip, p, gamma)).collect(),
    }
}

/// Bearing resistances of a ply \[N\], as in [`BoltLimits::bearing`].
fn bearing(grip: &Grip, ply: &Ply, gamma_m2: f64) -> Option<[[f64; 2]; 2]> {
    let hole = match Clearance::of(&grip.size, grip.hole) {
        Clearance::Normal => Hole::Normal,
        Clearance::Small | Clearance::Oversize => Hole::Oversize,
        Clearance::Beyond => return None,
    };
    let Room { edge, pitch, .. } = ply.room?;
    let least = |x: [f64; 2]| x[0].min(x[1]);
    let towards = |i: usize, way: usize| {
        let at = |along| {
            let place = Bearing {
                along,
                e2: least(edge[1 - i]),
                p2: least(pitch[1 - i]),
                hole,
                d: grip.size.d,
                d0: grip.hole,
                thickness: ply.thickness,
                fu: ply.fu.mpa(),
                fub: grip.grade.fub,
            };
            place.resistance(gamma_m2).value
        };
        let inner = Along::Inner { p1: least(pitch[i]) };
        at(Along::End { e1: edge[i][way] }).min(at(inner)).max(NO_BEARING)
    };
    Some([0, 1].map(|i| [0, 1].map(|way| towards(i, way))))
}
