//! Tension and shear of single bolts: EN 1993-1-8:2005 Table 3.4, 3.6.1 and 3.8.

use crate::assembly::inputs::K2;
use crate::catalog::{BoltGrade, BoltSize};
use crate::checks::check::{Unit, Worked, number as n};

/// k2 of Table 3.4 for countersunk bolts.
const K2_COUNTERSUNK: f64 = 0.63;

/// Which part of the bolt a shear plane passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShearPlane {
    /// The thread: A = A_s.
    Thread,
    /// The unthreaded shank: A gross.
    Shank,
}

/// Design tension resistance of one bolt \[N\].
///
/// `F_t,Rd = k2 f_ub A_s / γ_M2`, k2 = 0.9, countersunk 0.63.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4.
pub fn tension_resistance(
    bolt: &BoltSize,
    grade: &BoltGrade,
    countersunk: bool,
    gamma_m2: f64,
) -> Worked {
    let k2 = if countersunk { K2_COUNTERSUNK } else { K2 };
    let value = k2 * grade.fub * bolt.stress_area / gamma_m2;
    let formula = format!(
        "F_t,Rd = k2 f_ub A_s / γ_M2 = {} · {} · {} / {}",
        n(k2),
        n(grade.fub),
        n(bolt.stress_area),
        n(gamma_m2)
    );
    Worked::new(
        "EN 1993-1-8:2005 Table 3.4",
        "tension resistance of a bolt",
        value,
        Unit::Force,
        formula,
    )
    .with("k2", k2, Unit::Number)
    .with("A_s", bolt.stress_area, Unit::Area)
}

/// Design shear resistance of one bolt in one shear plane \[N\]; `reduction` is the product of β_Lf
/// and β_p, 1 for none.
///
/// `F_v,Rd = α_v f_ub A / γ_M2`; thread in the plane: A = A_s, α_v = 0.6 (4.6, 5.6, 8.8) or 0.5
/// (4.8, 5.8, 6.8, 10.9); shank in the plane: A gross, α_v = 0.6.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4.
pub fn shear_resistance(
    bolt: &BoltSize,
    grade: &BoltGrade,
    plane: ShearPlane,
    reduction: f64,
    gamma_m2: f64,
) -> Worked {
    let (alpha_v, area, symbol) = match plane {
        ShearPlane::Thread => (grade.alpha_v_thread, bolt.stress_area, "A_s"),
        ShearPlane::Shank => (grade.alpha_v_shank, bolt.area, "A"),
    };
    let value = reduction * alpha_v * grade.fub * area / gamma_m2;
    let mut formula = format!("F_v,Rd = α_v f_ub {symbol} / γ_M2");
    if reduction != 1.0 {
        formula = format!("F_v,Rd = β α_v f_ub {symbol} / γ_M2 = {} ·", n(reduction));
    } else {
        formula += " =";
    }
    formula += &format!(" {} · {} · {} / {}", n(alpha_v), n(grade.fub), n(area), n(gamma_m2));
    Worked::new(
        "EN 1993-1-8:2005 Table 3.4",
        "shear resistance of a bolt, per plane",
        value,
        Unit::Force,
        formula,
    )
    .with("α_v", alpha_v, Unit::Number)
    .with(symbol, area, Unit::Area)
}

/// Reduction β_Lf of the shear resistance in long joints; `length` L_j between the centres of the
/// end bolts \[mm\].
///
/// `β_Lf = 1 − (L_j − 15 d)/(200 d)`, between 0.75 and 1.
///
/// # Source
/// EN 1993-1-8:2005 3.8(1), formula 3.5.
pub fn long_joint_factor(length: f64, d: f64) -> Worked {
    let value = (1.0 - (length - 15.0 * d) / (200.0 * d)).clamp(0.75, 1.0);
    let formula = format!(
        "β_Lf = 1 − (L_j − 15 d)/(200 d) = 1 − ({} − 15 · {})/(200 · {}), 0.75 to 1",
        n(length),
        n(d),
        n(d)
    );
    Worked::new(
        "EN 1993-1-8:2005 3.8(1)",
        "reduction of shear in long joints",
        value,
        Unit::Number,
        formula,
    )
}

/// Reduction β_p of the shear resistance by packing of total thickness `t_p` \[mm\]; 1 up to d/3.
///
/// `β_p = 9 d/(8 d + 3 t_p) ≤ 1`.
///
/// # Source
/// EN 1993-1-8:2005 3.6.1(12), formula 3.3.
pub fn packing_factor(packing: f64, d: f64) -> Worked {
    let value =
        if packing > d / 3.0 { (9.0 * d / (8.0 * d + 3.0 * packing)).min(1.0) } else { 1.0 };
    let formula = format!(
        "β_p = 9 d/(8 d + 3 t_p) = 9 · {}/(8 · {} + 3 · {}), 1 up to t_p = d/3",
        n(d),
        n(d),
        n(packing)
    );
    Worked::new(
        "EN 1993-1-8:2005 3.6.1(12)",
        "reduction of shear by packing",
        value,
        Unit::Number,
        formula,
    )
}
