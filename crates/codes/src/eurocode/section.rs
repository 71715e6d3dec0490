//! Rules for the cross-section of a rolled I or H beam: EN 1993-1-1:2005 6.2 and Table 5.2. The
//! axial force is positive in tension.

use super::i_section::Section;
use super::yielding::{in_shear, plastic, plastic_shear, yield_strength};
use crate::check::{Unit, number as n, within};
use crate::error::CheckError;
use crate::worked::Worked;
use bracket_joint::strength::Nominal;

/// Factor ε = √(235/f_y).
///
/// # Source
/// EN 1993-1-1:2005 Table 5.2.
pub fn epsilon(fy: f64) -> f64 {
    (235.0 / fy).sqrt()
}

/// Class of a cross-section in bending.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// Class 1 or 2: the plastic moment is reached.
    Plastic,
    /// Class 3: the outermost fibre yields.
    Elastic,
    /// Class 4: it buckles before it yields.
    Slender,
}

/// Slenderness c/t of the compressed flange and of the web.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slenderness {
    /// (0.5 (b − t_w) − r)/t_f.
    pub flange: f64,
    /// d/t_w.
    pub web: f64,
}

impl Slenderness {
    /// Slenderness of a section, the outstand of its flange counted from the radius `root` \[mm\].
    pub fn new(s: &Section, root: f64) -> Self {
        Self { flange: (0.5 * (s.b - s.tw) - root) / s.tf, web: s.clear_depth() / s.tw }
    }

    /// Class under bending about the strong axis with an axial compression `push` ≥ 0 \[N\].
    ///
    /// # Source
    /// EN 1993-1-1:2005 Table 5.2: flange 10 ε and 14 ε; web 456 ε/(13 α − 1) and 42 ε/(0.67 + 0.33
    /// ψ), in pure bending 83 ε and 124 ε.
    pub fn class(self, s: &Section, fy: f64, push: f64) -> Class {
        let eps = epsilon(fy);
        let alpha = (0.5 * (1.0 + push / (s.clear_depth() * s.tw * fy))).min(1.0);
        let psi = (2.0 * push / (s.area * fy) - 1.0).min(1.0);
        let [plastic, elastic] = match push > 0.0 {
            true => [456.0 * eps / (13.0 * alpha - 1.0), 42.0 * eps / (0.67 + 0.33 * psi)],
            false => [83.0 * eps, 124.0 * eps],
        };
        if within(self.flange, 10.0 * eps) && within(self.web, plastic) {
            Class::Plastic
        } else if within(self.flange, 14.0 * eps) && within(self.web, elastic) {
            Class::Elastic
        } else {
            Class::Slender
        }
    }
}

/// Reduction ρ of the strength of the shear area beside a shear force, `ratio` = V_Ed/V_pl,Rd:
/// `(2 V_Ed/V_pl,Rd − 1)²` above one half, otherwise 0. Beyond V_pl,Rd it is more than 1.
///
/// # Source
/// EN 1993-1-1:2005 6.2.8(2) and (3).
pub fn shear_reduction(ratio: f64) -> f64 {
    if ratio > 0.5 { (2.0 * ratio - 1.0).powi(2) } else { 0.0 }
}

/// Plastic section modulus that a shear force leaves \[mm³\], `W_pl − ρ A_w²/(4 t_w)` with
/// A_w = h_w t_w.
///
/// # Source
/// EN 1993-1-1:2005 6.2.8(5), formula 6.30.
pub fn reduced_modulus(s: &Section, rho: f64) -> f64 {
    let web = s.web_depth() * s.tw;
    s.w_pl - rho * web * web / (4.0 * s.tw)
}

/// λ̄_w and χ_w of a web in shear, `depth` h_w and `web` t_w \[mm\], stiffened at its supports
/// alone: `λ̄_w = h_w/(86.4 t_w ε)`, χ_w = 1 up to 0.83 and 0.83/λ̄_w beyond.
///
/// # Source
/// EN 1993-1-5:2006 5.3(1) and (3), Table 5.1, non-rigid end posts, η = 1.
pub fn shear_buckling(depth: f64, web: f64, fy: f64) -> (f64, f64) {
    let lambda = depth / (86.4 * web * epsilon(fy));
    (lambda, if lambda < 0.83 { 1.0 } else { 0.83 / lambda })
}

/// Cross-section of a beam with its steel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrossSection {
    /// Dimensions.
    pub section: Section,
    /// Yield strength f_y.
    pub fy: Nominal,
    /// γ_M0.
    pub gamma_m0: f64,
}

impl CrossSection {
    /// Plastic shear resistance along the web \[N\].
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.6(2) and (3)a, η = 1.
    pub fn shear(&self) -> Worked {
        self.plastic_shear("shear of the beam", self.section.shear_area())
    }

    /// Plastic shear resistance across the web, along the flanges \[N\]: A_v = A − h_w t_w.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.6(3)e.
    pub fn shear_across(&self) -> Worked {
        self.plastic_shear(
            "shear of the beam along its flanges",
            self.section.area - self.section.web_depth() * self.section.tw,
        )
    }

    fn plastic_shear(&self, title: &'static str, area: f64) -> Worked {
        let value = plastic_shear(area, self.fy, self.gamma_m0);
        let formula = format!(
            "V_pl,Rd = A_v f_y/(√3 γ_M0) = {} · {}/(√3 · {})",
            n(area),
            n(self.fy.mpa()),
            n(self.gamma_m0)
        );
        Worked::new("EN 1993-1-1:2005 6.2.6(2)", title, value, Unit::Force, formula).with(
            "A_v",
            area,
            Unit::Area,
        )
    }

    /// Plastic resistance to an axial force \[N\], `N_pl,Rd = A f_y/γ_M0`.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.3(2), 6.2.4(2).
    pub fn axial(&self) -> Worked {
        let value = plastic(self.section.area, self.fy, self.gamma_m0);
        let formula = format!(
            "N_pl,Rd = A f_y/γ_M0 = {} · {}/{}",
            n(self.section.area),
            n(self.fy.mpa()),
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

    /// h_w/t_w of the web, and the greatest value that needs no check of shear buckling, `72 ε/η`
    /// with η = 1.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.6(6).
    pub fn web_slenderness(&self) -> (f64, f64) {
        (self.section.web_depth() / self.section.tw, 72.0 * epsilon(self.fy.mpa()))
    }

    /// Shear buckling resistance of the web without the contribution of the flanges \[N\]:
    /// `χ_w h_w t_w f_y/(√3 γ_M1)`.
    ///
    /// # Source
    /// EN 1993-1-5:2006 5.2, 5.3 and Table 5.1, non-rigid end posts, stiffeners at the supports
    /// alone, η = 1.
    pub fn shear_buckling(&self, gamma_m1: f64) -> Worked {
        let (depth, web) = (self.section.web_depth(), self.section.tw);
        let (lambda, chi) = shear_buckling(depth, web, self.fy.mpa());
        let value = in_shear(chi * depth * web * self.fy.mpa(), gamma_m1);
        let formula = format!(
            "V_bw,Rd = χ_w h_w t_w f_y/(√3 γ_M1) = {} · {} · {} · {}/(√3 · {})",
            n(chi),
            n(depth),
            n(web),
            n(self.fy.mpa()),
            n(gamma_m1)
        );
        let title = "shear buckling of the beam web, h_w/t_w > 72 ε";
        Worked::new("EN 1993-1-5:2006 5.2", title, value, Unit::Force, formula).with(
            "λ̄_w",
            lambda,
            Unit::Number,
        )
    }

    /// Resistance to bending about the strong axis beside a shear force along the web and an axial
    /// force \[N mm\]. Class 4 is refused.
    ///
    /// Plastic: `(W_pl − ρ A_w²/(4 t_w)) f_y/γ_M0`, times `(1 − n)/(1 − 0.5 a)` where N counts; n
    /// is N over the axial force that shear leaves. Elastic: `W_el ((1 − ρ) f_y/γ_M0 − N/A)`. ρ is
    /// not limited to 1, so that shear beyond V_pl,Rd reduces the resistance further.
    ///
    /// This is the check of the beam itself. The component method takes M_c,Rd beside shear alone
    /// from `component_method::beam::bending_6_2_8`, which covers class 4 as well.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.5, 6.2.8(3) and (5), 6.2.9.1(4) and (5), 6.2.9.2, 6.2.10(3).
    pub fn bending_6_2_10(&self, shear: f64, axial: f64) -> Result<Worked, CheckError> {
        let (s, fyd) = (&self.section, yield_strength(self.fy, self.gamma_m0).mpa());
        let (v, normal) = (shear.abs() / self.shear().value, axial.abs());
        let rho = shear_reduction(v);
        // the outstand counts from the radius of the area, not from that of k_des
        let slenderness = Slenderness::new(s, s.r);
        let class = slenderness.class(s, self.fy.mpa(), (-axial).max(0.0));
        let (clause, value, formula, part) = match class {
            Class::Plastic => {
                let web = s.web_depth() * s.tw;
                let area = s.area - rho * s.shear_area();
                let a = ((s.area - 2.0 * s.b * s.tf) / s.area).min(0.5);
                // 6.2.10(3): the strength of the shear area is reduced in the limits of small axial
                // forces as well
                let small = within(normal, 0.25 * area * fyd)
                    && within(normal, 0.5 * (1.0 - rho) * web * fyd);
                let part = if small {
                    1.0
                } else if area > 0.0 {
                    ((1.0 - normal / (area * fyd)) / (1.0 - 0.5 * a)).clamp(0.0, 1.0)
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
                    n(self.fy.mpa()),
                    n(self.gamma_m0),
                    n(part)
                );
                let value = reduced_modulus(s, rho) * fyd * part;
                ("EN 1993-1-1:2005 6.2.5, 6.2.8, 6.2.9.1", value, formula, part)
            }
            Class::Elastic => {
                let formula = format!(
                    "W_el ((1 − ρ) f_y/γ_M0 − N/A) = {} · ({} · {}/{} − {}/{})",
                    n(s.w_el),
                    n(1.0 - rho),
                    n(self.fy.mpa()),
                    n(self.gamma_m0),
                    Unit::Force.show(normal),
                    n(s.area)
                );
                let left = (1.0 - rho) * fyd - normal / s.area;
                let left = left.max(0.0);
                ("EN 1993-1-1:2005 6.2.5, 6.2.8, 6.2.9.2", s.w_el * left, formula, left / fyd)
            }
            Class::Slender => {
                return Err(CheckError::NotCovered {
                    what: format!(
                        "the section is of class 4: flange c/t = {}, web c/t = {}",
                        n(slenderness.flange),
                        n(slenderness.web)
                    ),
                    clause: "EN 1993-1-1:2005 5.5.2",
                    step: "a section of class 1 to 3",
                });
            }
        };
        let title = "moment of the beam with its shear and axial force";
        Ok(Worked::new(clause, title, value, Unit::Moment, formula)
            .with("ρ", rho, Unit::Number)
            .with("reduction for N", part, Unit::Number))
    }
}
