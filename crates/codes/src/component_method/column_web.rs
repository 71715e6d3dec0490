//! The column web in tension, compression and shear: EN 1993-1-8:2005 6.2.6.1 to 6.2.6.3.

use super::joint::Column;
use crate::check::{CheckId, Unit, within};
use crate::eurocode::section::{epsilon, shear_buckling};
use crate::formula::{Derivation, Formula, Line, Number, Relation, Traced};
use crate::worked::Worked;

/// Greatest slenderness d/(t_w ε) of a web panel whose shear resistance is plastic, 6.2.6.1(1).
pub(super) const SHEAR_SLENDERNESS: f64 = 69.0;
/// Greatest c/(t_s ε) of a flat stiffener that does not buckle about its weld, EN 1993-1-5:2006
/// 9.2.1(8): I_T/I_p ≥ 5.3 f_y/E.
pub const STIFFENER_SLENDERNESS: f64 = 13.0;
/// Plate slenderness λ̄_p up to which a web in compression does not buckle, 6.2.6.2(1).
const STOCKY: f64 = 0.72;

/// Reduction ω of the web for its interaction with shear in the panel.
///
/// β ≤ 0.5: 1; β = 1: ω1 = 1/√(1 + 1.3 (b_eff t_wc/A_vc)²); β = 2: ω2 with 5.2 in place of 1.3;
/// between: ω1 + 2 (1 − β)(1 − ω1) and ω1 + (β − 1)(ω2 − ω1).
///
/// # Source
/// EN 1993-1-8:2005 Table 6.3.
pub fn shear_interaction(beta: f64, effective_width: f64, web: f64, shear_area: f64) -> f64 {
    let ratio = (effective_width * web / shear_area).powi(2);
    let omega1 = 1.0 / (1.0 + 1.3 * ratio).sqrt();
    let omega2 = 1.0 / (1.0 + 5.2 * ratio).sqrt();
    match beta {
        b if b <= 0.5 => 1.0,
        b if b < 1.0 => omega1 + 2.0 * (1.0 - b) * (1.0 - omega1),
        b if b < 2.0 => omega1 + (b - 1.0) * (omega2 - omega1),
        _ => omega2,
    }
}

/// Shear area A_vc of the column \[mm²\], with a supplementary web plate b_s × t_wc; a plate on the
/// second side adds nothing.
///
/// # Source
/// EN 1993-1-1:2005 6.2.6(3); EN 1993-1-8:2005 6.2.6.1(6).
pub fn shear_area(c: &Column) -> f64 {
    let doubler = if c.doublers > 0 { c.doubler_width * c.section.tw } else { 0.0 };
    c.section.shear_area() + doubler
}

/// A column web panel between the flanges of the beam. Lengths in mm, strengths in MPa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearPanel {
    /// A_vc, see [`shear_area`] \[mm²\].
    pub area: f64,
    /// Nominal yield strength.
    pub fy: f64,
    /// d_c = h − 2 (t_f + r).
    pub clear_depth: f64,
    /// h_w = h − 2 t_f.
    pub web_depth: f64,
    /// t_wc.
    pub web: f64,
    /// Contribution of transverse stiffeners, see [`stiffened_panel`] \[N\].
    pub stiffeners: f64,
    /// γ_M0.
    pub gamma_m0: f64,
    /// γ_M1.
    pub gamma_m1: f64,
}

impl ShearPanel {
    /// d_c/t_w and its limit 69 ε, beyond which 6.2.6.1 gives no resistance.
    ///
    /// # Source
    /// EN 1993-1-8:2005 6.2.6.1(1).
    pub fn slenderness(&self) -> (f64, f64) {
        (self.clear_depth / self.web, SHEAR_SLENDERNESS * epsilon(self.fy))
    }

    /// Whether the panel buckles in shear before it yields.
    pub fn slender(&self) -> bool {
        let (slenderness, limit) = self.slenderness();
        !within(slenderness, limit)
    }

    /// Design resistance in shear \[N\]: `V_wp,Rd = 0.9 f_y,wc A_vc/(√3 γ_M0)` plus the
    /// contribution of stiffeners. Beyond d_c/t_w = 69 ε it is no more than 0.9 times the shear
    /// buckling resistance of the web, `χ_w h_w t_w f_y/(√3 γ_M1)`: exceeding this limit justifies
    /// NOT OK, but 6.2.6.1 does not allow it as a design resistance.
    ///
    /// # Source
    /// EN 1993-1-8:2005 6.2.6.1(1) to (4), formula 6.7; EN 1993-1-5:2006 5.2 and 5.3, Table 5.1
    /// (non-rigid end posts, η = 1).
    pub fn resistance(&self) -> Worked {
        let root3 = || Traced::from(3.0).sqrt();
        let f_y = || Traced::stress("f_y", self.fy);
        let area = Traced::area("A_vc", self.area);
        let gamma = Traced::number("γ_M0", self.gamma_m0);
        let mut force = Traced::from(0.9) * f_y() * area / (root3() * gamma);
        if self.stiffeners > 0.0 {
            force = force + Traced::force("V_wp,add,Rd", self.stiffeners);
        }
        let (slenderness, limit) = self.slenderness();
        let id = CheckId::ColumnPanel;
        let (mut clause, mut symbol) = ("EN 1993-1-8:2005 6.2.6.1", "V_wp,Rd");
        if self.slender() {
            let (_, chi) = shear_buckling(self.web_depth, self.web, self.fy);
            let buckling = Traced::from(0.9)
                * Traced::number("χ_w", chi)
                * Traced::length("h_w", self.web_depth)
                * Traced::length("t_w", self.web)
                * f_y()
                / (root3() * Traced::number("γ_M1", self.gamma_m1));
            if buckling.value() < force.value() {
                (clause, symbol, force) = ("EN 1993-1-5:2006 5.2", "V_wp,max", buckling);
            }
        }
        let mut worked =
            Worked::of(clause, id, symbol, force, Unit::Force).with("A_vc", self.area, Unit::Area);
        if self.stiffeners > 0.0 {
            worked = worked.with("V_wp,add,Rd", self.stiffeners, Unit::Force);
        }
        worked.with("d_c/t_w", slenderness, Unit::Number).with("69 ε", limit, Unit::Number)
    }
}

/// Contribution of transverse stiffeners in tension and compression zone to the shear resistance of
/// the panel \[N\]; moments of the column flange and the stiffener \[N mm\], `distance` d_s of the
/// stiffeners \[mm\].
///
/// `V_wp,add,Rd = 4 M_pl,fc,Rd/d_s ≤ (2 M_pl,fc,Rd + 2 M_pl,st,Rd)/d_s`.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.1(4), formula 6.8.
pub fn stiffened_panel<N: Number>(flange: N, stiffener: N, distance: N) -> N {
    let number = N::from;
    let both = number(2.0) * flange.clone() + number(2.0) * stiffener;
    (number(4.0) * flange).min(both) / distance
}

/// Design resistance of the web in tension \[N\]; `effective_width` is ℓ_eff of the T-stub of the
/// column flange.
///
/// `F_t,wc,Rd = ω b_eff t_wc f_y/γ_M0`.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.3(1) to (3), formula 6.15.
pub fn tension(effective_width: f64, web: f64, fy: f64, omega: f64, gamma_m0: f64) -> Worked {
    let value = Traced::number("ω", omega)
        * Traced::length("b_eff", effective_width)
        * Traced::length("t_wc", web)
        * Traced::stress("f_y", fy)
        / Traced::number("γ_M0", gamma_m0);
    let id = CheckId::ColumnWebTension;
    Worked::of("EN 1993-1-8:2005 6.2.6.3", id, "F_t,wc,Rd", value, Unit::Force)
        .with("ω", omega, Unit::Number)
        .with("b_eff", effective_width, Unit::Length)
        .with("t_w", web, Unit::Length)
        .with("f_y", fy, Unit::Stress)
}

/// ρ of a plate beyond λ̄_p = 0.72: `(λ̄_p − 0.2)/λ̄_p²`.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.2(1), formula 6.13b.
fn plate_buckling<N: Number>(slenderness: N) -> N {
    (slenderness.clone() - N::from(0.2)) / (slenderness.clone() * slenderness)
}

/// A web in transverse compression. Lengths in mm, strengths in MPa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompressedWeb {
    /// b_eff,c,wc.
    pub effective_width: f64,
    /// t_wc, supplementary web plates included.
    pub web: f64,
    /// d_c = h − 2 (t_f + r).
    pub clear_depth: f64,
    /// Nominal yield strength.
    pub fy: f64,
    /// Young's modulus.
    pub young: f64,
    /// ω of Table 6.3.
    pub omega: f64,
    /// Largest longitudinal compressive stress σ_com,Ed of the column at the root, from N and M.
    pub longitudinal: f64,
    /// γ_M0.
    pub gamma_m0: f64,
    /// γ_M1.
    pub gamma_m1: f64,
}

impl CompressedWeb {
    /// Plate slenderness λ̄_p = 0.932 √(b_eff d_wc f_y/(E t_w²)).
    ///
    /// # Source
    /// EN 1993-1-8:2005 6.2.6.2(1), formula 6.13c.
    pub fn slenderness(&self) -> f64 {
        0.932
            * (self.effective_width * self.clear_depth * self.fy
                / (self.young * self.web * self.web))
                .sqrt()
    }

    /// Reduction ρ for plate buckling: 1 up to λ̄_p = 0.72, then (λ̄_p − 0.2)/λ̄_p².
    ///
    /// # Source
    /// EN 1993-1-8:2005 6.2.6.2(1), formulas 6.13a and 6.13b.
    pub fn buckling(&self) -> f64 {
        let lambda = self.slenderness();
        if lambda <= STOCKY { 1.0 } else { plate_buckling(lambda) }
    }

    /// The reason `words` why a web buckles, with its slenderness and its reduction ρ < 1.
    pub(super) fn buckles(&self, words: &'static str) -> Derivation {
        let slenderness = self.slenderness();
        let rho = plate_buckling(Traced::number("λ̄_p", slenderness));
        let rho = Formula::new("ρ", rho, Unit::Number);
        let (limit, relation) = (STOCKY.into(), Relation::Above);
        let beyond = Line::comparison("λ̄_p", slenderness, relation, limit, Unit::Number);
        Derivation::from(words).then(beyond).then(rho)
    }

    /// Reduction k_wc for the longitudinal stress: 1 up to 0.7 f_y, then 1.7 − σ_com/f_y.
    ///
    /// # Source
    /// EN 1993-1-8:2005 6.2.6.2(2), formula 6.14.
    pub fn longitudinal_factor(&self) -> f64 {
        if self.longitudinal <= 0.7 * self.fy { 1.0 } else { 1.7 - self.longitudinal / self.fy }
    }

    /// Design resistance in transverse compression \[N\].
    ///
    /// `F_c,wc,Rd = ω k_wc b_eff t_wc f_y/γ_M0 ≤ ω k_wc ρ b_eff t_wc f_y/γ_M1`.
    ///
    /// # Source
    /// EN 1993-1-8:2005 6.2.6.2(1), formula 6.9.
    pub fn resistance(&self) -> Worked {
        let (rho, kwc) = (self.buckling(), self.longitudinal_factor());
        let [crush, buckle]: [f64; 2] = [self.force(None), self.force(Some(rho))];
        let force: Traced = self.force((buckle < crush).then_some(rho));
        let id = CheckId::ColumnWebCompression;
        Worked::of("EN 1993-1-8:2005 6.2.6.2", id, "F_c,wc,Rd", force, Unit::Force)
            .with("b_eff", self.effective_width, Unit::Length)
            .with("λ̄_p", self.slenderness(), Unit::Number)
            .with("ρ", rho, Unit::Number)
            .with("k_wc", kwc, Unit::Number)
            .with("ω", self.omega, Unit::Number)
    }

    /// Resistance of the web that yields, with a reduction ρ of the web that buckles \[N\].
    fn force<N: Number>(&self, rho: Option<f64>) -> N {
        let number = |name, value| N::symbol(name, value, Unit::Number);
        let factors = number("ω", self.omega) * number("k_wc", self.longitudinal_factor());
        let (factors, gamma) = match rho {
            Some(rho) => (factors * number("ρ", rho), number("γ_M1", self.gamma_m1)),
            None => (factors, number("γ_M0", self.gamma_m0)),
        };
        let width = N::symbol("b_eff", self.effective_width, Unit::Length);
        let web = N::symbol("t_wc", self.web, Unit::Length);
        factors * width * web * N::symbol("f_y", self.fy, Unit::Stress) / gamma
    }
}

/// Thickness of the web with supplementary plates in compression: 1.5 t_w with one plate, 2 t_w
/// with plates on both sides.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.2(6).
pub fn compressed_thickness(web: f64, plates: u32) -> f64 {
    web * [1.0, 1.5, 2.0][plates.min(2) as usize]
}

/// Thickness of the web with supplementary plates in tension, their longitudinal welds fillets: 1.4
/// t_w (steels up to S355) or 1.3 t_w, with one plate or two.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.3(8).
pub fn tension_thickness(web: f64, plates: u32, fy: f64) -> f64 {
    match (plates, within(fy, 355.0)) {
        (0, _) => web,
        (_, true) => 1.4 * web,
        (_, false) => 1.3 * web,
    }
}
