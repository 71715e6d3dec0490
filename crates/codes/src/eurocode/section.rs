//! Rules for the cross-section of a rolled I or H beam: EN 1993-1-1:2005 6.2 and Table 5.2. The
//! axial force is positive in tension.

use super::i_section::Section;
use super::yielding::{in_shear, plastic, plastic_shear, yield_strength};
use crate::check::{CheckId, within};
use crate::error::CheckError;
use crate::formula::{Number, Traced};
use crate::unit::{Unit, number as n};
use crate::worked::Worked;
use bracket_base::say;
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
pub fn shear_reduction<N: Number>(ratio: N) -> N {
    let n = N::from;
    if ratio.value() > 0.5 { (n(2.0) * ratio - n(1.0)).powi(2) } else { n(0.0) }
}

/// Plastic section modulus that a shear force leaves \[mm³\], `W_pl − ρ A_w²/(4 t_w)`; `web` is
/// A_w = h_w t_w \[mm²\].
///
/// # Source
/// EN 1993-1-1:2005 6.2.8(5), formula 6.30.
pub fn modulus_beside_shear<N: Number>(w_pl: N, rho: N, web: N, tw: N) -> N {
    w_pl - rho * web.clone() * web / (N::from(4.0) * tw)
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
        self.plastic_shear(CheckId::BeamShear, self.section.shear_area())
    }

    /// Plastic shear resistance across the web, along the flanges \[N\]: A_v = A − h_w t_w.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.6(3)e.
    pub fn shear_across(&self) -> Worked {
        self.plastic_shear(
            CheckId::BeamShearAcross,
            self.section.area - self.section.web_depth() * self.section.tw,
        )
    }

    fn plastic_shear(&self, id: CheckId, area: f64) -> Worked {
        let a_v = Traced::area("A_v", area);
        let value = plastic_shear(a_v.clone(), self.f_y(), self.gamma_m0());
        Worked::of("EN 1993-1-1:2005 6.2.6(2)", id, "V_pl,Rd", value, Unit::Force)
            .with_symbols([&a_v])
    }

    fn f_y(&self) -> Traced {
        Traced::stress("f_y", self.fy.mpa())
    }

    fn gamma_m0(&self) -> Traced {
        Traced::number("γ_M0", self.gamma_m0)
    }

    /// Plastic resistance to an axial force \[N\], `N_pl,Rd = A f_y/γ_M0`.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.3(2), 6.2.4(2).
    pub fn axial(&self) -> Worked {
        let value = plastic(Traced::area("A", self.section.area), self.f_y(), self.gamma_m0());
        let (clause, id) = ("EN 1993-1-1:2005 6.2.3(2), 6.2.4(2)", CheckId::BeamAxial);
        Worked::of(clause, id, "N_pl,Rd", value, Unit::Force)
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
        let gamma = Traced::number("γ_M1", gamma_m1);
        let (h_w, t_w) = (Traced::length("h_w", depth), Traced::length("t_w", web));
        let value = in_shear(Traced::number("χ_w", chi) * h_w * t_w * self.f_y(), gamma);
        let id = CheckId::BeamShearBuckling;
        Worked::of("EN 1993-1-5:2006 5.2", id, "V_bw,Rd", value, Unit::Force).with(
            "λ̄_w",
            lambda,
            Unit::Number,
        )
    }

    /// Utilisation under N and both moments beside a shear force along the web by the linear sum of
    /// the resistances, plastic for class 1 and 2; of no use for class 4. `moduli`: W_el,y, W_el,z
    /// and W_pl,z \[mm³\]; `actions`: N, Vz \[N\], My, Mz \[N mm\].
    ///
    /// Shear above half of V_pl,Rd reduces the yield strength of the whole section.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.1(7), 6.2.8(3).
    pub fn linear_sum(&self, moduli: [f64; 3], [axial, shear, my, mz]: [f64; 4]) -> Worked {
        let s = &self.section;
        let class = Slenderness::new(s, s.r).class(s, self.fy.mpa(), (-axial).max(0.0));
        let [w_y, w_z] = match class {
            Class::Plastic => {
                [Traced::number("W_pl,y", s.w_pl), Traced::number("W_pl,z", moduli[2])]
            }
            _ => [Traced::number("W_el,y", moduli[0]), Traced::number("W_el,z", moduli[1])],
        };
        let rho = shear_reduction(shear.abs() / self.shear().value).min(1.0);
        let f_y = || match rho > 0.0 {
            true => (Traced::from(1.0) - Traced::number("ρ", rho)) * self.f_y(),
            false => self.f_y(),
        };
        let of = |name: &'static str, moment: f64, w: Traced| {
            Traced::symbol(name, moment.abs(), Unit::Moment) / plastic(w, f_y(), self.gamma_m0())
        };
        let normal = plastic(Traced::area("A", s.area), f_y(), self.gamma_m0());
        let sum = Traced::force("N_Ed", axial.abs()) / normal
            + of("M_y,Ed", my, w_y)
            + of("M_z,Ed", mz, w_z);
        let (clause, id) = ("EN 1993-1-1:2005 6.2.1(7), 6.2.8", CheckId::ColumnMoment);
        Worked::of(clause, id, "", sum, Unit::Number)
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
        let (clause, value, part) = match slenderness.class(s, self.fy.mpa(), (-axial).max(0.0)) {
            Class::Plastic => {
                let clause = "EN 1993-1-1:2005 6.2.5, 6.2.8, 6.2.9.1";
                let alone = self.plastic_moment(rho);
                match self.beside_axial_force(rho, normal) {
                    Some(part) => {
                        let number = part.value();
                        (clause, alone * part, number)
                    }
                    None => (clause, alone, 1.0),
                }
            }
            Class::Elastic => {
                let left = self.elastic_stress(rho, normal);
                let part = left.value() / fyd;
                let value = Traced::number("W_el", s.w_el) * left;
                ("EN 1993-1-1:2005 6.2.5, 6.2.8, 6.2.9.2", value, part)
            }
            Class::Slender => {
                return Err(CheckError::NotCovered {
                    what: say!(
                        "the section is of class 4: flange c/t = {}, web c/t = {}",
                        n(slenderness.flange),
                        n(slenderness.web)
                    ),
                    clause: "EN 1993-1-1:2005 5.5.2",
                    step: "a section of class 1 to 3",
                });
            }
        };
        let id = CheckId::BeamMoment;
        Ok(Worked::of(clause, id, "M_Rd", value, Unit::Moment).with("ρ", rho, Unit::Number).with(
            "reduction for N",
            part,
            Unit::Number,
        ))
    }

    /// Plastic moment beside a shear force.
    fn plastic_moment(&self, rho: f64) -> Traced {
        let s = &self.section;
        let w_pl = Traced::number("W_pl", s.w_pl);
        let modulus = if rho == 0.0 {
            w_pl
        } else {
            let web = Traced::area("A_w", s.web_depth() * s.tw);
            modulus_beside_shear(w_pl, Traced::number("ρ", rho), web, Traced::length("t_w", s.tw))
        };
        modulus * (self.f_y() / self.gamma_m0())
    }

    /// What an axial force leaves of the plastic moment, between 0 and 1; `None` where it is so
    /// small that it does not count.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.9.1(4) and (5); 6.2.10(3): the strength of the shear area is reduced in
    /// the limits of small axial forces as well.
    fn beside_axial_force(&self, rho: f64, normal: f64) -> Option<Traced> {
        let fyd = yield_strength(self.fy, self.gamma_m0).mpa();
        let (s, n) = (&self.section, Traced::from);
        let web = s.web_depth() * s.tw;
        let area = s.area - rho * s.shear_area();
        if within(normal, 0.25 * area * fyd) && within(normal, 0.5 * (1.0 - rho) * web * fyd) {
            return None;
        }
        if area <= 0.0 {
            return Some(n(0.0));
        }
        let flanges = Traced::number("a", ((s.area - 2.0 * s.b * s.tf) / s.area).min(0.5));
        let share = Traced::number("n", normal / (area * fyd));
        let left = (n(1.0) - share) / (n(1.0) - n(0.5) * flanges);
        Some(match left.value() {
            part if part < 0.0 => left.max(n(0.0)),
            part if part > 1.0 => left.min(n(1.0)),
            _ => left,
        })
    }

    /// Stress that shear and axial force leave to elastic bending \[MPa\], not below 0.
    fn elastic_stress(&self, rho: f64, normal: f64) -> Traced {
        let strength = self.f_y() / self.gamma_m0();
        let mut left = match rho == 0.0 {
            true => strength,
            false => (Traced::from(1.0) - Traced::number("ρ", rho)) * strength,
        };
        if normal != 0.0 {
            left = left - Traced::force("N", normal) / Traced::area("A", self.section.area);
        }
        if left.value() < 0.0 { left.max(Traced::from(0.0)) } else { left }
    }
}
