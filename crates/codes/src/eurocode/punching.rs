//! Punching of a bolt head or nut through a plate: EN 1993-1-8:2005 Table 3.4.

use crate::check::CheckId;
use crate::formula::Traced;
use crate::unit::Unit;
use crate::worked::Worked;
use bracket_joint::catalog::BoltSize;
use std::f64::consts::PI;

/// Mean diameter d_m of the head or the nut, whichever is smaller \[mm\]: mean of the distances
/// across flats and corners.
///
/// The catalogue has the corners of the head alone; those of the nut are taken in the same
/// proportion.
pub fn mean_diameter(bolt: &BoltSize) -> f64 {
    let mean = |flats: f64| 0.5 * (flats + flats * bolt.head_corners / bolt.head_width);
    mean(bolt.head_width).min(mean(bolt.nut_width))
}

/// Design punching shear resistance of head and nut \[N\]; `dm` mean diameter, `thickness` of the
/// plate \[mm\].
///
/// `B_p,Rd = 0.6 π d_m t_p f_u / γ_M2`.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4.
pub fn punching_resistance(dm: f64, thickness: f64, fu: f64, gamma_m2: f64) -> Worked {
    let (d_m, t_p) = (Traced::length("d_m", dm), Traced::length("t_p", thickness));
    let (f_u, gamma) = (Traced::stress("f_u", fu), Traced::number("γ_M2", gamma_m2));
    let value = Traced::from(0.6) * Traced::number("π", PI) * d_m.clone() * t_p * f_u / gamma;
    let id = CheckId::PunchingResistance;
    Worked::of("EN 1993-1-8:2005 Table 3.4", id, "B_p,Rd", value, Unit::Force).with_symbols([&d_m])
}
