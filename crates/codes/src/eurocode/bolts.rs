//! Tension and shear of single bolts: EN 1993-1-8:2005 Table 3.4.

use crate::check::{Unit, number as n};
use crate::worked::Worked;
use bracket_joint::catalog::{BoltGrade, BoltSize};
use bracket_joint::strength::{BoltShank, Design, Nominal};

/// k2 of bolts that are not countersunk.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4.
const K2: f64 = 0.9;

/// F_t,Rd of a bolt \[N\], `k2 f_ub A_s/γ_M2`; `stress_area` A_s \[mm²\].
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4.
fn tension(fub: Nominal, stress_area: f64, gamma_m2: f64) -> f64 {
    K2 * fub.mpa() * stress_area / gamma_m2
}

/// Design yield strength of a shank that yields under F_t,Rd: `F_t,Rd` over the area of the shank.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4; the area of the shank in place of A_s is this program's.
pub fn shank_strength(bolt: &BoltShank, gamma_m2: f64) -> Design {
    Design::new(tension(bolt.fub, bolt.stress_area, gamma_m2) / bolt.shank_area)
}

/// Design tension resistance of one bolt \[N\].
///
/// `F_t,Rd = k2 f_ub A_s / γ_M2`, k2 = 0.9.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4.
pub fn tension_resistance(bolt: &BoltSize, grade: &BoltGrade, gamma_m2: f64) -> Worked {
    let value = tension(Nominal::new(grade.fub), bolt.stress_area, gamma_m2);
    let formula = format!(
        "F_t,Rd = k2 f_ub A_s / γ_M2 = {} · {} · {} / {}",
        n(K2),
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
    .with("k2", K2, Unit::Number)
    .with("A_s", bolt.stress_area, Unit::Area)
}

/// Reduction β_Lf of the shear resistance of all bolts of a long joint; `length` L_j between the
/// end bolts in the direction of the force \[mm\], `d` of the bolt \[mm\].
///
/// `β_Lf = 1 − (L_j − 15 d)/(200 d)`, between 0.75 and 1.
///
/// # Source
/// EN 1993-1-8:2005 3.8(1), formula 3.5.
pub fn long_joint(length: f64, d: f64) -> Worked {
    let value = (1.0 - (length - 15.0 * d) / (200.0 * d)).clamp(0.75, 1.0);
    let formula = format!(
        "β_Lf = 1 − (L_j − 15 d)/(200 d) = 1 − ({} − 15 · {})/(200 · {})",
        n(length),
        n(d),
        n(d)
    );
    Worked::new("EN 1993-1-8:2005 3.8(1)", "long joint", value, Unit::Number, formula)
}

/// Design shear resistance of one bolt per shear plane, the thread in the plane \[N\].
///
/// `F_v,Rd = α_v f_ub A_s / γ_M2`.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4.
pub fn shear_resistance(bolt: &BoltSize, grade: &BoltGrade, gamma_m2: f64) -> Worked {
    let (alpha_v, area) = (grade.alpha_v_thread, bolt.stress_area);
    let value = alpha_v * grade.fub * area / gamma_m2;
    let formula = format!(
        "F_v,Rd = α_v f_ub A_s / γ_M2 = {} · {} · {} / {}",
        n(alpha_v),
        n(grade.fub),
        n(area),
        n(gamma_m2)
    );
    Worked::new(
        "EN 1993-1-8:2005 Table 3.4",
        "shear resistance of a bolt, per plane",
        value,
        Unit::Force,
        formula,
    )
    .with("α_v", alpha_v, Unit::Number)
    .with("A_s", area, Unit::Area)
}
