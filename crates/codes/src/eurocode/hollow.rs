//! Rectangular and circular hollow sections: moduli, class and elastic resistance of the
//! cross-section, EN 1993-1-1:2005 6.2. The axial force is positive in tension.

use super::section::{Class, epsilon, shear_reduction};
use super::yielding::{plastic, plastic_shear};
use crate::check::{CheckId, within};
use crate::error::CheckError;
use crate::formula::Traced;
use crate::unit::{Unit, number as n};
use crate::worked::Worked;
use bracket_base::say;
use bracket_joint::strength::Nominal;
use std::f64::consts::{FRAC_PI_4, PI};

/// Dimensions of a hollow section \[mm\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hollow {
    /// Depth along the first axis, width, wall, outer and inner radius of the corners.
    Rectangular {
        /// Depth and width.
        size: [f64; 2],
        /// Thickness of the wall.
        t: f64,
        /// Outer and inner radius of the corners.
        radii: [f64; 2],
    },
    /// Diameter and wall.
    Circular {
        /// Diameter.
        d: f64,
        /// Thickness of the wall.
        t: f64,
    },
}

/// Area and second moment about the axis normal to the depth of a rectangle with round corners
/// \[mm², mm⁴\].
fn rounded([h, b]: [f64; 2], r: f64) -> [f64; 2] {
    // what a square corner has beyond its quarter circle: area, and centre beside that of the arc
    let area = (1.0 - FRAC_PI_4) * r * r;
    if r == 0.0 {
        return [h * b, b * h.powi(3) / 12.0];
    }
    let arm = r / (6.0 * (1.0 - FRAC_PI_4));
    let own = (1.0 / 3.0 - PI / 16.0) * r.powi(4) - area * arm * arm;
    let far = 0.5 * h - r + arm;
    [h * b - 4.0 * area, b * h.powi(3) / 12.0 - 4.0 * (own + area * far * far)]
}

impl Hollow {
    /// Thickness of the wall \[mm\].
    pub fn wall(&self) -> f64 {
        match *self {
            Hollow::Rectangular { t, .. } | Hollow::Circular { t, .. } => t,
        }
    }

    /// Area \[mm²\].
    pub fn area(&self) -> f64 {
        match *self {
            Hollow::Rectangular { size, t, radii } => {
                rounded(size, radii[0])[0] - rounded(size.map(|s| s - 2.0 * t), radii[1])[0]
            }
            Hollow::Circular { d, t } => PI * (d - t) * t,
        }
    }

    /// Elastic section moduli about y, for bending along the depth, and about z \[mm³\].
    pub fn w_el(&self) -> [f64; 2] {
        match *self {
            Hollow::Rectangular { size: [h, b], t, radii: [outer, inner] } => {
                [[h, b], [b, h]].map(|size| {
                    let inside = size.map(|s| s - 2.0 * t);
                    (rounded(size, outer)[1] - rounded(inside, inner)[1]) / (0.5 * size[0])
                })
            }
            Hollow::Circular { d, t } => {
                let inside = d - 2.0 * t;
                [PI * (d.powi(4) - inside.powi(4)) / (32.0 * d); 2]
            }
        }
    }

    /// Shear areas along the depth and across \[mm²\].
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.6(3)f and g.
    pub fn shear_areas(&self) -> [f64; 2] {
        let area = self.area();
        match *self {
            Hollow::Rectangular { size: [h, b], .. } => [h, b].map(|s| area * s / (h + b)),
            Hollow::Circular { .. } => [2.0 * area / PI; 2],
        }
    }

    /// Length of the outline \[mm\].
    pub fn outline(&self) -> f64 {
        match *self {
            Hollow::Rectangular { size: [h, b], radii: [r, _], .. } => {
                2.0 * (h + b) - (8.0 - 2.0 * PI) * r
            }
            Hollow::Circular { d, .. } => PI * d,
        }
    }

    /// c/t of the widest wall, or d/t, and the class as if every wall were compressed evenly.
    ///
    /// # Source
    /// EN 1993-1-1:2005 Table 5.2: c/t ≤ 38 ε, 42 ε with c = h − 3 t; d/t ≤ 70 ε², 90 ε².
    pub fn class(&self, fy: Nominal) -> (f64, Class) {
        let e = epsilon(fy.mpa());
        let (slenderness, limits) = match *self {
            Hollow::Rectangular { size: [h, b], t, .. } => {
                (h.max(b) / t - 3.0, [38.0 * e, 42.0 * e])
            }
            Hollow::Circular { d, t } => (d / t, [70.0 * e * e, 90.0 * e * e]),
        };
        let class = match () {
            () if within(slenderness, limits[0]) => Class::Plastic,
            () if within(slenderness, limits[1]) => Class::Elastic,
            () => Class::Slender,
        };
        (slenderness, class)
    }

    /// Utilisation under N, My, Mz beside Vy, Vz by the linear sum of the elastic resistances;
    /// class 4 is refused.
    ///
    /// Shear above half of V_pl,Rd reduces the yield strength of the whole section.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.1(7), 6.2.8(3).
    pub fn linear_sum(
        &self,
        (fy, gamma_m0): (Nominal, f64),
        [force, moment]: [[f64; 3]; 2],
    ) -> Result<Worked, CheckError> {
        let (slenderness, class) = self.class(fy);
        if class == Class::Slender {
            return Err(CheckError::NotCovered {
                what: say!("the section is of class 4: slenderness {}", n(slenderness)),
                clause: "EN 1993-1-1:2005 5.5.2",
                step: "a section of class 1 to 3",
            });
        }
        let used = [force[2], force[1]].into_iter().zip(self.shear_areas());
        let shears = used.map(|(v, area)| v.abs() / self.shear(fy, gamma_m0, area).value);
        let rho = shear_reduction(shears.fold(0.0, f64::max)).min(1.0);
        let strength = || {
            let reduced = Traced::from(1.0) - Traced::number("ρ", rho);
            let f_y = Traced::stress("f_y", fy.mpa());
            if rho > 0.0 { reduced * f_y } else { f_y }
        };
        let gamma = || Traced::number("γ_M0", gamma_m0);
        let mut sum = Traced::force("N_Ed", force[0].abs())
            / plastic(Traced::area("A", self.area()), strength(), gamma());
        let axes = [("M_y,Ed", "W_el,y"), ("M_z,Ed", "W_el,z")];
        for (((m, w), value), modulus) in axes.into_iter().zip(&moment[1..]).zip(self.w_el()) {
            if *value != 0.0 {
                let resistance = plastic(Traced::number(w, modulus), strength(), gamma());
                sum = sum + Traced::symbol(m, value.abs(), Unit::Moment) / resistance;
            }
        }
        let (clause, id) = ("EN 1993-1-1:2005 6.2.1(7), 6.2.8", CheckId::ColumnMoment);
        Ok(Worked::of(clause, id, "", sum, Unit::Number))
    }

    /// Plastic shear resistance of a shear area \[N\].
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.6(2).
    pub fn shear(&self, fy: Nominal, gamma_m0: f64, area: f64) -> Worked {
        let (f_y, gamma) = (Traced::stress("f_y", fy.mpa()), Traced::number("γ_M0", gamma_m0));
        let value = plastic_shear(Traced::area("A_v", area), f_y, gamma);
        let (clause, id) = ("EN 1993-1-1:2005 6.2.6(2)", CheckId::ColumnShear);
        Worked::of(clause, id, "V_pl,Rd", value, Unit::Force)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tables of EN 10219-2 and EN 10210-2: RHS 200×100×8 (A 44.75 cm², W_el,y 223.4, W_el,z
    /// 147.8 cm³), CHS 168.3×8 (A 40.3 cm², W_el 154 cm³).
    #[test]
    fn areas_and_moduli_are_those_of_the_tables() {
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 4e-3, "{a} {b}");
        let rhs = Hollow::Rectangular { size: [200.0, 100.0], t: 8.0, radii: [12.0, 8.0] };
        near(rhs.area(), 4475.0);
        near(rhs.w_el()[0], 223.4e3);
        near(rhs.w_el()[1], 147.8e3);
        let chs = Hollow::Circular { d: 168.3, t: 8.0 };
        near(chs.area(), 4030.0);
        near(chs.w_el()[0], 154e3);
        near(chs.shear_areas()[1], 2565.0);
    }

    /// The sum by hand: CHS 168.3×8 of S235 under N, both moments and a shear force beyond half of
    /// V_pl,Rd = 348 kN; class 4 is refused.
    #[test]
    fn the_sum_is_linear_and_counts_high_shear() {
        let chs = Hollow::Circular { d: 168.3, t: 8.0 };
        let steel = (Nominal::new(235.0), 1.0);
        let sum = |v: f64| {
            let actions = [[-200e3, 0.0, v], [0.0, 10e6, -5e6]];
            chs.linear_sum(steel, actions).expect("class 1").value
        };
        let w = chs.w_el()[0];
        let low = (200e3 / chs.area() + 15e6 / w) / 235.0;
        assert!((sum(100e3) / low - 1.0).abs() < 1e-12);
        let v_pl = 2.0 * chs.area() / PI * 235.0 / 3f64.sqrt();
        let rho = (2.0 * 300e3 / v_pl - 1.0).powi(2);
        assert!((sum(300e3) / (low / (1.0 - rho)) - 1.0).abs() < 1e-12);
        let thin = Hollow::Rectangular { size: [300.0, 100.0], t: 6.0, radii: [12.0, 6.0] };
        assert!(thin.linear_sum(steel, [[0.0; 3], [0.0, 1.0, 0.0]]).is_err());
    }
}
