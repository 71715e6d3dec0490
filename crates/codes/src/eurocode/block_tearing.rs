//! Block tearing: EN 1993-1-8:2005 3.10.2.

use super::yielding::in_shear;
use crate::check::CheckId;
use crate::formula::Traced;
use crate::unit::Unit;
use crate::worked::Worked;

/// Blocks of a plate that a bolt group tears out together, each with one face in tension and one in
/// shear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blocks {
    /// How many there are.
    pub count: f64,
    /// Net length of the face in tension \[mm\].
    pub tension: f64,
    /// Net length of the face in shear \[mm\].
    pub shear: f64,
    /// Thickness of the plate \[mm\].
    pub thickness: f64,
    /// Nominal yield strength of the plate \[MPa\].
    pub fy: f64,
    /// Nominal ultimate strength of the plate \[MPa\].
    pub fu: f64,
}

impl Blocks {
    /// Design resistance of a symmetric bolt group under a concentric force \[N\].
    ///
    /// `V_eff,1,Rd = f_u A_nt/γ_M2 + f_y A_nv/(√3 γ_M0)`.
    ///
    /// # Source
    /// EN 1993-1-8:2005 3.10.2(2), formula 3.9.
    pub fn resistance(&self, gamma_m0: f64, gamma_m2: f64) -> Worked {
        self.with_tension(1.0, ("EN 1993-1-8:2005 3.10.2(2)", "V_eff,1,Rd"), gamma_m0, gamma_m2)
    }

    /// Design resistance of a bolt group under an eccentric force \[N\]: the tension on its face
    /// varies, and half of it counts.
    ///
    /// `V_eff,2,Rd = 0.5 f_u A_nt/γ_M2 + f_y A_nv/(√3 γ_M0)`.
    ///
    /// # Source
    /// EN 1993-1-8:2005 3.10.2(3), formula 3.10.
    pub fn eccentric(&self, gamma_m0: f64, gamma_m2: f64) -> Worked {
        self.with_tension(0.5, ("EN 1993-1-8:2005 3.10.2(3)", "V_eff,2,Rd"), gamma_m0, gamma_m2)
    }

    /// Both formulas: `part` of the tension counts.
    fn with_tension(
        &self,
        part: f64,
        (clause, symbol): (&'static str, &'static str),
        gamma_m0: f64,
        gamma_m2: f64,
    ) -> Worked {
        let area = |length: f64| self.count * length.max(0.0) * self.thickness;
        let (tension, shear) = (area(self.tension), area(self.shear));
        let [a_nt, a_nv] = [("A_nt", tension), ("A_nv", shear)].map(|(a, v)| Traced::area(a, v));
        let [f_u, f_y] = [("f_u", self.fu), ("f_y", self.fy)].map(|(f, v)| Traced::stress(f, v));
        let [m0, m2] = [("γ_M0", gamma_m0), ("γ_M2", gamma_m2)].map(|(g, v)| Traced::number(g, v));
        let f_u = if part < 1.0 { Traced::from(part) * f_u } else { f_u };
        let value = f_u * a_nt.clone() / m2 + in_shear(f_y * a_nv.clone(), m0);
        Worked::of(clause, CheckId::BlockTearing, symbol, value, Unit::Force)
            .with_symbols([&a_nt, &a_nv])
    }
}
