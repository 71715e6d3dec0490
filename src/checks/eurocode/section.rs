//! Cross-section of a rolled I or H beam: EN 1993-1-1:2005 6.2. The axial force is positive in
//! tension.

use crate::checks::check::{Unit, Worked, number as n};
use crate::checks::component_method::column_web::{epsilon, shear_area, shear_buckling};
use crate::checks::component_method::joint::Section;
use crate::checks::error::CheckError;

/// A cross-section, its nominal yield strength \[MPa\] and γ_M0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// The section.
    pub section: Section,
    /// f_y.
    pub fy: f64,
    /// γ_M0.
    pub gamma_m0: f64,
}

/// How the moment resistance of a class is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Distribution {
    /// Classes 1 and 2.
    Plastic,
    /// Class 3.
    Elastic,
}

impl Beam {
    /// h_w = h − 2 t_f \[mm\].
    fn web(&self) -> f64 {
        self.section.h - 2.0 * self.section.tf
    }

    /// Plastic shear resistance along the web \[N\], `V_pl,Rd = A_v f_y/(√3 γ_M0)`.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.6(2) and (3)a, η = 1.
    pub fn shear(&self) -> Worked {
        let s = &self.section;
        let area = shear_area(s.area, s.b, s.h, s.tf, s.tw, s.r, 0.0);
        self.plastic_shear("shear of the beam", area)
    }

    /// The same across the web, along the flanges: A_v = A − h_w t_w.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.6(3)e.
    pub fn shear_across(&self) -> Worked {
        self.plastic_shear(
            "shear of the beam along its flanges",
            self.section.area - self.web() * self.section.tw,
        )
    }

    fn plastic_shear(&self, title: &'static str, area: f64) -> Worked {
        let value = area * self.fy / (3f64.sqrt() * self.gamma_m0);
        let formula = format!(
            "V_pl,Rd = A_v f_y/(√3 γ_M0) = {} · {}/(√3 · {})",
            n(area),
            n(self.fy),
            n(self.gamma_m0)
        );
        Worked::new("EN 1993-1-1:2005 6.2.6(2)", title, value, Unit::Force, formula).with(
            "A_v",
            area,
            Unit::Area,
        )
    }

    /// Plastic resistance against an axial force \[N\], `N_pl,Rd = A f_y/γ_M0`.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.3(2), 6.2.4(2).
    pub fn axial(&self) -> Worked {
        let value = self.section.area * self.fy / self.gamma_m0;
        let formula = format!(
            "N_pl,Rd = A f_y/γ_M0 = {} · {}/{}",
            n(self.section.area),
            n(self.fy),
            n(self.gamma_m0)
        );
        Worked::new(
            "EN 1993-1-1:2005 6.2.3(2), 6.2.4(2)",
            "axial force of the beam",
            value,
            Unit::Force,
            formula,
        )
    }

    /// Greatest slenderness h_w/t_w of a web that needs no check of shear buckling, `72 ε/η` with η
    /// = 1.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.6(6).
    pub fn stocky_web(&self) -> (f64, f64) {
        (self.web() / self.section.tw, 72.0 * epsilon(self.fy))
    }

    /// Shear buckling resistance of the web, the flanges' part left out \[N\]:
    /// `χ_w h_w t_w f_y/(√3 γ_M1)`.
    ///
    /// # Source
    /// EN 1993-1-5:2006 5.2, 5.3 and Table 5.1, non-rigid end posts, stiffeners at the supports
    /// alone, η = 1.
    pub fn shear_buckling(&self, gamma_m1: f64) -> Worked {
        let (depth, web) = (self.web(), self.section.tw);
        let (lambda, chi) = shear_buckling(depth, web, self.fy);
        let value = chi * depth * web * self.fy / (3f64.sqrt() * gamma_m1);
        let formula = format!(
            "V_bw,Rd = χ_w h_w t_w f_y/(√3 γ_M1) = {} · {} · {} · {}/(√3 · {})",
            n(chi),
            n(depth),
            n(web),
            n(self.fy),
            n(gamma_m1)
        );
        let title = "shear buckling of the beam web, h_w/t_w > 72 ε";
        Worked::new("EN 1993-1-5:2006 5.2", title, value, Unit::Force, formula).with(
            "λ̄_w",
            lambda,
            Unit::Number,
        )
    }

    /// Class of the section under bending about its strong axis with an axial force; a class 4 is
    /// refused.
    ///
    /// # Source
    /// EN 1993-1-1:2005 Table 5.2: flange 10 ε and 14 ε; web 456 ε/(13 α − 1) and 42 ε/(0.67 + 0.33
    /// ψ), in pure bending 83 ε and 124 ε.
    pub fn distribution(&self, axial: f64) -> Result<Distribution, CheckError> {
        let (s, eps) = (&self.section, epsilon(self.fy));
        let flange = (0.5 * (s.b - s.tw) - s.r) / s.tf;
        let web = s.clear_depth() / s.tw;
        let push = (-axial).max(0.0);
        let alpha = (0.5 * (1.0 + push / (s.clear_depth() * s.tw * self.fy))).min(1.0);
        let psi = (2.0 * push / (s.area * self.fy) - 1.0).min(1.0);
        let [plastic, elastic] = match push > 0.0 {
            true => [456.0 * eps / (13.0 * alpha - 1.0), 42.0 * eps / (0.67 + 0.33 * psi)],
            false => [83.0 * eps, 124.0 * eps],
        };
        if flange <= 10.0 * eps && web <= plastic {
            return Ok(Distribution::Plastic);
        }
        if flange <= 14.0 * eps && web <= elastic {
            return Ok(Distribution::Elastic);
        }
        Err(CheckError::NotCovered {
            what: format!(
                "the beam is of class 4: flange c/t = {}, web c/t = {}",
                n(flange),
                n(web)
            ),
            clause: "EN 1993-1-1:2005 5.5.2",
        })
    }

    /// Moment resistance about the strong axis with a shear force along the web and an axial force
    /// \[N mm\].
    ///
    /// Plastic: `(W_pl − ρ A_w²/(4 t_w)) f_y/γ_M0`, times `(1 − n)/(1 − 0.5 a)` where N counts, n
    /// of what shear leaves of the area; ρ = (2 V/V_pl,Rd − 1)² above V_pl,Rd/2. Elastic:
    /// `W_el ((1 − ρ) f_y/γ_M0 − N/A)`. Shear beyond V_pl,Rd goes on reducing it.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.5, 6.2.8(3) and (5), 6.2.9.1(4) and (5), 6.2.9.2, 6.2.10(3).
    pub fn moment(&self, shear: f64, axial: f64) -> Result<Worked, CheckError> {
        let (s, strength) = (&self.section, self.fy / self.gamma_m0);
        let (v, normal) = (shear.abs() / self.shear().value, axial.abs());
        let rho = if v > 0.5 { (2.0 * v - 1.0).powi(2) } else { 0.0 };
        let (clause, value, formula, part) = match self.distribution(axial)? {
            Distribution::Plastic => {
                let web = self.web() * s.tw;
                let modulus = s.w_pl - rho * web * web / (4.0 * s.tw);
                let area = s.area - rho * shear_area(s.area, s.b, s.h, s.tf, s.tw, s.r, 0.0);
                let a = ((s.area - 2.0 * s.b * s.tf) / s.area).min(0.5);
                // 6.2.10(3): the strength of the shear area is reduced for the small forces as well
                let small = normal <= 0.25 * area * strength
                    && normal <= 0.5 * (1.0 - rho) * web * strength;
                let part = if small {
                    1.0
                } else if area > 0.0 {
                    ((1.0 - normal / (area * strength)) / (1.0 - 0.5 * a)).min(1.0)
                } else {
                    0.0
                };
                let formula = format!(
                    "(W_pl − ρ A_w²/(4 t_w)) f_y/γ_M0 (1 − n)/(1 − 0.5 a) = ({} − {} · {}²/(4 · \
                     {})) · {}/{} · {}",
                    n(s.w_pl),
                    n(rho),
                    n(web),
                    n(s.tw),
                    n(self.fy),
                    n(self.gamma_m0),
                    n(part)
                );
                ("EN 1993-1-1:2005 6.2.5, 6.2.8, 6.2.9.1", modulus * strength * part, formula, part)
            }
            Distribution::Elastic => {
                let formula = format!(
                    "W_el ((1 − ρ) f_y/γ_M0 − N/A) = {} · ({} · {}/{} − {}/{})",
                    n(s.w_el),
                    n(1.0 - rho),
                    n(self.fy),
                    n(self.gamma_m0),
                    Unit::Force.show(normal),
                    n(s.area)
                );
                let left = (1.0 - rho) * strength - normal / s.area;
                ("EN 1993-1-1:2005 6.2.5, 6.2.8, 6.2.9.2", s.w_el * left, formula, left / strength)
            }
        };
        let title = "moment of the beam with its shear and axial force";
        Ok(Worked::new(clause, title, value, Unit::Moment, formula)
            .with("ρ", rho, Unit::Number)
            .with("what N leaves", part, Unit::Number))
    }
}
