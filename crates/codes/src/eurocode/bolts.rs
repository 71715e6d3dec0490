//! Tension and shear of single bolts: EN 1993-1-8:2005 Table 3.4.

use super::holes::shear_factor;
use crate::check::{CheckId, within};
use crate::formula::{Number, Traced};
use crate::unit::Unit;
use crate::worked::Worked;
use bracket_joint::catalog::{BoltGrade, BoltSize};
use bracket_joint::strength::{BoltShank, Design};

/// k2 of bolts that are not countersunk.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4.
const K2: f64 = 0.9;

/// Design tension resistance of one bolt, `F_t,Rd = k2 f_ub A_s/γ_M2` \[N\].
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4.
pub fn f_t_rd<N: Number>(k2: N, f_ub: N, a_s: N, gamma_m2: N) -> N {
    k2 * f_ub * a_s / gamma_m2
}

/// Design shear resistance of one bolt per shear plane, the thread in the plane, `F_v,Rd = α_v f_ub
/// A_s/γ_M2` \[N\].
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4.
pub fn f_v_rd<N: Number>(alpha_v: N, f_ub: N, a_s: N, gamma_m2: N) -> N {
    alpha_v * f_ub * a_s / gamma_m2
}

/// Reduction of the shear resistance of all bolts of a long joint, `β_Lf = 1 − (L_j − 15 d)/(200
/// d)`, between 0.75 and 1; `length` L_j between the end bolts in the direction of the force
/// \[mm\], `d` of the bolt \[mm\].
///
/// # Source
/// EN 1993-1-8:2005 3.8(1), formula 3.5.
pub fn beta_lf<N: Number>(length: N, d: N) -> N {
    let n = N::from;
    let beta = n(1.0) - (length - n(15.0) * d.clone()) / (n(200.0) * d);
    beta.max(n(0.75)).min(n(1.0))
}

/// Design yield strength of a shank that yields under F_t,Rd: `F_t,Rd` over the area of the shank.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4; the area of the shank in place of A_s is this program's.
pub fn shank_strength(bolt: &BoltShank, gamma_m2: f64) -> Design {
    let force = f_t_rd(K2, bolt.fub.mpa(), bolt.stress_area, gamma_m2);
    Design::new(force / bolt.shank_area)
}

/// [`f_t_rd`] of a bolt.
pub fn tension_resistance(bolt: &BoltSize, grade: &BoltGrade, gamma_m2: f64) -> Worked {
    let (k2, a_s) = (Traced::number("k2", K2), Traced::area("A_s", bolt.stress_area));
    let (f_ub, gamma) = (Traced::stress("f_ub", grade.fub), Traced::number("γ_M2", gamma_m2));
    let value = f_t_rd(k2.clone(), f_ub, a_s.clone(), gamma);
    let id = CheckId::BoltTensionResistance;
    Worked::of("EN 1993-1-8:2005 Table 3.4", id, "F_t,Rd", value, Unit::Force)
        .with_symbols([&k2, &a_s])
}

/// [`beta_lf`] of a joint.
pub fn long_joint(length: f64, d: f64) -> Worked {
    let value = beta_lf(Traced::length("L_j", length), Traced::length("d", d));
    Worked::of("EN 1993-1-8:2005 3.8(1)", CheckId::LongJoint, "β_Lf", value, Unit::Number)
}

/// [`f_v_rd`] of a bolt.
pub fn shear_resistance(bolt: &BoltSize, grade: &BoltGrade, gamma_m2: f64) -> Worked {
    let alpha_v = Traced::number("α_v", grade.alpha_v_thread);
    let a_s = Traced::area("A_s", bolt.stress_area);
    let (f_ub, gamma) = (Traced::stress("f_ub", grade.fub), Traced::number("γ_M2", gamma_m2));
    let value = f_v_rd(alpha_v.clone(), f_ub, a_s.clone(), gamma);
    let id = CheckId::BoltShearResistance;
    Worked::of("EN 1993-1-8:2005 Table 3.4", id, "F_v,Rd", value, Unit::Force)
        .with_symbols([&alpha_v, &a_s])
}

/// [`f_v_rd`] of a bolt of a joint, reduced for a long joint and for 2 mm clearance of small bolts;
/// `hole` diameter, `length` L_j between the end bolts in the direction of the force \[mm\].
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4, 3.8(1), 3.6.1(5).
pub fn shear_in_joint(
    (bolt, grade): (&BoltSize, &BoltGrade),
    hole: f64,
    length: f64,
    gamma_m2: f64,
) -> Worked {
    let mut worked = shear_resistance(bolt, grade, gamma_m2);
    let whole = worked.traced();
    let mut reduced = whole.clone();
    let long = long_joint(length, bolt.d);
    let small = shear_factor(bolt, grade, hole);
    if small < 1.0 {
        worked = worked.then("small bolts in holes wider than normal (3.6.1(5))");
        reduced = Traced::from(small) * reduced;
    }
    if long.value < 1.0 {
        reduced = reduced * long.traced();
        worked.derivation = worked.derivation.followed_by(long.derivation);
    }
    if reduced == whole { worked } else { worked.becomes("F_v,Rd,red", reduced) }
}

/// f_yb and f_ub of the grades 4.6 to 10.9 \[MPa\], EN 1993-1-8:2005 Table 3.1.
const LISTED: [(f64, f64); 2] = [(240.0, 900.0), (400.0, 1000.0)];

/// Whether a grade lies within those of Table 3.1.
pub fn is_listed(grade: &BoltGrade) -> bool {
    let inside = |x: f64, (least, most): (f64, f64)| within(least, x) && within(x, most);
    inside(grade.fyb, LISTED[0]) && inside(grade.fub, LISTED[1])
}
