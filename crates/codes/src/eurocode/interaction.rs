//! Shear and tension together: EN 1993-1-8:2005 Table 3.4.

use crate::check::CheckId;
use crate::formula::{Number, Traced};
use crate::unit::Unit;
use crate::worked::Worked;

/// Factor on F_t,Rd beside shear.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4.
pub const TENSION_BESIDE_SHEAR: f64 = 1.4;

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
    let v = Traced::force("F_v,Ed", f.shear) / Traced::force("F_v,Rd", f.shear_resistance);
    let t = Traced::force("F_t,Ed", f.tension) / Traced::force("F_t,Rd", f.tension_resistance);
    let used = [("F_v,Ed/F_v,Rd", v.value()), ("F_t,Ed/F_t,Rd", t.value())];
    let value = (v + t.clone() / Traced::from(TENSION_BESIDE_SHEAR)).max(t);
    let id = CheckId::BoltShearAndTension;
    let worked = Worked::of("EN 1993-1-8:2005 Table 3.4", id, "", value, Unit::Number);
    used.into_iter().fold(worked, |w, (symbol, value)| w.with(symbol, value, Unit::Number))
}
