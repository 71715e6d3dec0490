//! Sections of a plate across its plane, with and without their holes.

use super::yielding::{in_shear, plastic, plastic_shear};
use crate::check::CheckId;
use crate::formula::{Formula, Number, Traced};
use crate::unit::Unit;
use crate::worked::Worked;
use bracket_joint::spec::code::PartialFactors;
use bracket_joint::strength::Strength;
use std::f64::consts::PI;

/// Part of the shear resistance that bending in the plane of the plate takes, as a divisor.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 2.2.5.1 and 3.2.2.1.
pub const BENDING_BESIDE_SHEAR: f64 = 1.27;

/// Factor on the moment of a plate that its shear force bends, triangular along the plate.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 3.2.4.
pub const TRIANGULAR: f64 = 0.6;

/// Young's modulus of BS 5950-1 \[MPa\].
const E_BRITISH: f64 = 205_000.0;

/// Section of one plate, or of several equal ones, through a line of holes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlateSection<'a> {
    /// Height h_p \[mm\].
    pub height: f64,
    /// Thickness t_p \[mm\].
    pub thickness: f64,
    /// Number of holes n_1 in the section.
    pub holes: usize,
    /// Diameter d_0 of the holes \[mm\].
    pub hole: f64,
    /// Sections that fail together.
    pub count: f64,
    /// Steel.
    pub steel: &'a Strength,
    /// Partial factors.
    pub factors: &'a PartialFactors,
}

impl PlateSection<'_> {
    fn height(&self) -> Traced {
        Traced::length("h_p", self.height)
    }

    fn thickness(&self) -> Traced {
        Traced::length("t", self.thickness)
    }

    /// The number of sections times a force of one.
    fn times(&self, of: Traced) -> Traced {
        if self.count == 1.0 { of } else { Traced::from(self.count) * of }
    }

    /// Net area of one section \[mm²\], not below 0.
    fn net(&self) -> Traced {
        let holes = Traced::number("n_1", self.holes as f64) * Traced::length("d0", self.hole);
        let height = self.height() - holes;
        let height = if height.value() < 0.0 { height.max(Traced::from(0.0)) } else { height };
        height * self.thickness()
    }

    fn f_y(&self) -> Traced {
        Traced::stress("f_y", self.steel.fy.mpa())
    }

    fn f_u(&self) -> Traced {
        Traced::stress("f_u", self.steel.fu.mpa())
    }

    fn gamma_m0(&self) -> Traced {
        Traced::number("γ_M0", self.factors.gamma_m0)
    }

    fn gamma_m2(&self) -> Traced {
        Traced::number("γ_M2", self.factors.gamma_m2)
    }

    /// Shear resistance of the gross section beside the bending of the plate in its plane \[N\],
    /// `h_p t_p f_y/(1.27 √3 γ_M0)`.
    ///
    /// # Source
    /// Steel Buildings in Europe, Part 5, 2.2.5.1 and 3.2.2.1.
    pub fn gross_shear(&self) -> Worked {
        let area = self.height() * self.thickness() / Traced::from(BENDING_BESIDE_SHEAR);
        let value = self.times(plastic_shear(area, self.f_y(), self.gamma_m0()));
        let clause = "Steel Buildings in Europe 5, 2.2.5.1, 3.2.2.1";
        Worked::of(clause, CheckId::GrossShear, "V_Rd,g", value, Unit::Force)
    }

    /// Shear resistance of the net section \[N\], `(h_p − n_1 d_0) t_p f_u/(√3 γ_M2)`.
    ///
    /// # Source
    /// Steel Buildings in Europe, Part 5, 2.2.5.2 and 3.2.2.2.
    pub fn net_shear(&self) -> Worked {
        let value = self.times(in_shear(self.net() * self.f_u(), self.gamma_m2()));
        let clause = "Steel Buildings in Europe 5, 2.2.5.2, 3.2.2.2";
        Worked::of(clause, CheckId::NetShear, "V_Rd,n", value, Unit::Force)
    }

    /// Tension resistance beside the holes \[N\], the lesser of `A f_y/γ_M0` and
    /// `0.9 A_net f_u/γ_M2`.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.3(2).
    pub fn tension(&self) -> Worked {
        let gross = plastic(self.height() * self.thickness(), self.f_y(), self.gamma_m0());
        let net = plastic(Traced::from(0.9) * self.net(), self.f_u(), self.gamma_m2());
        let clause = "EN 1993-1-1:2005 6.2.3(2)";
        Worked::of(clause, CheckId::NetTension, "N_t,Rd", self.times(gross.min(net)), Unit::Force)
    }

    /// Elastic section modulus `t_p h_p²/6` of one section \[mm³\].
    fn modulus(&self) -> Traced {
        self.thickness() * self.height().powi(2) / Traced::from(6.0)
    }

    /// Elastic moment resistance in the plane of the plate \[N mm\], `W_el f_y/γ_M0`.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.5(2); Steel Buildings in Europe, Part 5, 3.2.3.
    pub fn bending(&self) -> Worked {
        let value = self.times(plastic(self.modulus(), self.f_y(), self.gamma_m0()));
        let clause = "EN 1993-1-1:2005 6.2.5(2)";
        Worked::of(clause, CheckId::PlateBending, "M_el,Rd", value, Unit::Moment)
    }

    /// Moment resistance of a long fin plate against lateral torsional buckling \[N mm\],
    /// `W_el p_LT/(0.6 γ_M1)`; `free` z_p is the distance of the first bolts from the support
    /// \[mm\].
    ///
    /// # Source
    /// Steel Buildings in Europe, Part 5, 3.2.4: `λ_LT = 2.8 √(z_p h_p/(1.5 t_p²))` and p_LT of BS
    /// 5950-1 Table 17, whose formula is [`british_bending_strength`].
    pub fn lateral_buckling(&self, free: f64) -> Worked {
        let area = Traced::length("z_p", free) * self.height();
        let slenderness =
            Traced::from(2.8) * (area / (Traced::from(1.5) * self.thickness().powi(2))).sqrt();
        let slenderness = slenderness.named("λ_LT", Unit::Number);
        let strength = british_bending_strength(slenderness.value(), self.steel.fy.mpa());
        let strength = Traced::stress("p_LT", strength);
        let gamma = Traced::from(TRIANGULAR) * Traced::number("γ_M1", self.factors.gamma_m1);
        let value = self.modulus() * strength.clone() / gamma;
        let clause = "Steel Buildings in Europe 5, 3.2.4";
        let lambda = Formula::new("λ_LT", slenderness, Unit::Number);
        let words = "p_LT by BS 5950-1 B.2.1 for welded sections, which its Table 17 lists";
        Worked::of(clause, CheckId::PlateBuckling, "M_b,Rd", value, Unit::Moment)
            .after(lambda)
            .then(words)
            .with_symbols([&strength])
    }
}

/// Bending strength p_b of a welded section of slenderness `lambda` λ_LT \[MPa\].
///
/// `p_b = p_E p_y/(φ + √(φ² − p_E p_y))` with `p_E = π² E/λ_LT²`, `φ = (p_y + (η + 1) p_E)/2` and
/// the Perry factor η of welded sections, of which that of rolled sections is the lower limit.
///
/// # Source
/// BS 5950-1:2000 B.2.1 and B.2.2: α_LT = 7.0, λ_L0 = 0.4 √(π² E/p_y).
pub fn british_bending_strength(lambda: f64, py: f64) -> f64 {
    let euler = PI * PI * E_BRITISH;
    let plateau = 0.4 * (euler / py).sqrt();
    let beyond = lambda - plateau;
    if beyond <= 0.0 {
        return py;
    }
    let eta = 7.0e-3 * (2.0 * beyond.min(plateau)).max(beyond);
    let elastic = euler / (lambda * lambda);
    let phi = 0.5 * (py + (eta + 1.0) * elastic);
    elastic * py / (phi + (phi * phi - elastic * py).sqrt())
}
