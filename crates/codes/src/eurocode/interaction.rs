//! Shear and tension together: EN 1993-1-8:2005 Table 3.4.

use crate::check::{Unit, number as n};
use crate::worked::Worked;

/// Forces and resistances of one bolt \[N\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forces {
    /// F_v,Ed ≥ 0.
    pub shear: f64,
    /// F_t,Ed ≥ 0, prying included.
    pub tension: f64,
    /// F_v,Rd.
    pub shear_resistance: f64,
    /// F_t,Rd.
    pub tension_resistance: f64,
}

/// Utilisation of a bolt in shear and tension, to be at most 1: the larger of the interaction and
/// of tension alone.
///
/// `F_v,Ed/F_v,Rd + F_t,Ed/(1.4 F_t,Rd) ≤ 1`, and `F_t,Ed ≤ F_t,Rd`.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4, Table 3.2.
pub fn utilisation(f: &Forces) -> Worked {
    let (v, t) = (f.shear / f.shear_resistance, f.tension / f.tension_resistance);
    let both = v + t / 1.4;
    let kn = |x: f64| n(x * 1e-3);
    let formula = format!(
        "max(F_v,Ed/F_v,Rd + F_t,Ed/(1.4 F_t,Rd), F_t,Ed/F_t,Rd) = max({}/{} + {}/(1.4 · {}), \
         {}/{})",
        kn(f.shear),
        kn(f.shear_resistance),
        kn(f.tension),
        kn(f.tension_resistance),
        kn(f.tension),
        kn(f.tension_resistance)
    );
    Worked::new(
        "EN 1993-1-8:2005 Table 3.4",
        "shear and tension of a bolt",
        both.max(t),
        Unit::Number,
        formula,
    )
    .with("F_v,Ed/F_v,Rd", v, Unit::Number)
    .with("F_t,Ed/F_t,Rd", t, Unit::Number)
}
