//! Preload and slip: EN 1993-1-8:2005 3.9.

use crate::check::{Unit, number as n};
use crate::worked::Worked;
use bracket_joint::catalog::{BoltGrade, BoltSize};

/// Holes of a slip-resistant connection, Table 3.6.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SlipHole {
    /// Normal holes.
    #[default]
    Normal,
    /// Oversize holes.
    Oversize,
}

impl SlipHole {
    /// Factor k_s.
    ///
    /// # Source
    /// EN 1993-1-8:2005 Table 3.6.
    pub fn ks(self) -> f64 {
        match self {
            SlipHole::Normal => 1.0,
            SlipHole::Oversize => 0.85,
        }
    }
}

/// Preload F_p,C of a controlled tightened bolt \[N\].
///
/// `F_p,C = 0.7 f_ub A_s`.
///
/// # Source
/// EN 1993-1-8:2005 3.9.1(2), formula 3.7.
pub fn preload(bolt: &BoltSize, grade: &BoltGrade) -> Worked {
    let value = 0.7 * grade.fub * bolt.stress_area;
    let formula =
        format!("F_p,C = 0.7 f_ub A_s = 0.7 · {} · {}", n(grade.fub), n(bolt.stress_area));
    Worked::new("EN 1993-1-8:2005 3.9.1(2)", "preload of a bolt", value, Unit::Force, formula)
}

/// Design slip resistance of one preloaded bolt \[N\], under a tension `tension` ≥ 0 \[N\] of the
/// bolt (F_t,Ed with γ_M3 in category C, F_t,Ed,ser with γ_M3,ser in category B); never below 0.
///
/// `F_s,Rd = k_s n μ (F_p,C − 0.8 F_t,Ed) / γ_M3`. In a moment end plate the contact force on the
/// compression side balances the tension, which then counts as 0 (3.9.2(3)).
///
/// # Source
/// EN 1993-1-8:2005 3.9.1(1), formula 3.6; 3.9.2(1), formulas 3.8a and 3.8b.
pub fn slip_resistance(
    hole: SlipHole,
    surfaces: u32,
    mu: f64,
    preload: f64,
    tension: f64,
    gamma_m3: f64,
) -> Worked {
    let ks = hole.ks();
    let clamp = (preload - 0.8 * tension).max(0.0);
    let value = ks * f64::from(surfaces) * mu * clamp / gamma_m3;
    let kn = |x: f64| Unit::Force.show(x);
    let (words, numbers, clause) = if tension == 0.0 {
        ("F_p,C", kn(preload), "EN 1993-1-8:2005 3.9.1(1)")
    } else {
        (
            "(F_p,C − 0.8 F_t,Ed)",
            format!("({} − 0.8 · {})", kn(preload), kn(tension)),
            "EN 1993-1-8:2005 3.9.2(1)",
        )
    };
    let formula = format!(
        "F_s,Rd = k_s n μ {words} / γ_M3 = {} · {surfaces} · {} · {numbers} / {}",
        n(ks),
        n(mu),
        n(gamma_m3)
    );
    Worked::new(clause, "slip resistance of a bolt", value, Unit::Force, formula).with(
        "k_s",
        ks,
        Unit::Number,
    )
}
