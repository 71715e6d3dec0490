//! Preload and slip: EN 1993-1-8:2005 3.9.

use crate::check::{CheckId, Status};
use crate::formula::{Number, Traced};
use crate::unit::Unit;
use crate::worked::Worked;
use bracket_joint::catalog::{BoltGrade, BoltSize};
use bracket_joint::spec::connection::BoltCategory;
use bracket_joint::spec::loads::LimitState;

/// Whether slip is checked in a limit state, as the id of the check, and the status of the check
/// where it fails. Without a category slip need not be prevented.
///
/// # Source
/// EN 1993-1-8:2005 3.4.1, Table 3.2.
pub fn demanded(category: Option<BoltCategory>, state: LimitState) -> Option<(CheckId, Status)> {
    const ULTIMATE: CheckId = CheckId::SlipUltimate;
    const SERVICEABILITY: CheckId = CheckId::SlipServiceability;
    match (category, state) {
        (Some(BoltCategory::B), LimitState::Serviceability) => {
            Some((SERVICEABILITY, Status::Failed))
        }
        (Some(BoltCategory::C), LimitState::Ultimate) => Some((ULTIMATE, Status::Failed)),
        (Some(_), _) => None,
        (None, LimitState::Serviceability) => Some((SERVICEABILITY, Status::Warning)),
        (None, LimitState::Ultimate) => Some((ULTIMATE, Status::Warning)),
    }
}

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
    let (f_ub, a_s) = (Traced::stress("f_ub", grade.fub), Traced::area("A_s", bolt.stress_area));
    let value = Traced::from(0.7) * f_ub * a_s;
    let (clause, id) = ("EN 1993-1-8:2005 3.9.1(2)", CheckId::Preload);
    Worked::of(clause, id, "F_p,C", value, Unit::Force)
}

/// Design slip resistance of one preloaded bolt \[N\], under a tension `tension` ≥ 0 \[N\] of the
/// bolt (F_t,Ed with γ_M3 in category C, F_t,Ed,ser with γ_M3,ser in category B); never below 0.
/// `gamma` is the partial factor with its symbol.
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
    gamma: (&'static str, f64),
) -> Worked {
    let k_s = Traced::number("k_s", hole.ks());
    let (n, mu) = (Traced::number("n", f64::from(surfaces)), Traced::number("μ", mu));
    let preload = Traced::force("F_p,C", preload);
    let (clamp, clause) = if tension == 0.0 {
        (preload, "EN 1993-1-8:2005 3.9.1(1)")
    } else {
        let left = preload - Traced::from(0.8) * Traced::force("F_t,Ed", tension);
        let left = if left.value() >= 0.0 { left } else { left.max(Traced::from(0.0)) };
        (left, "EN 1993-1-8:2005 3.9.2(1)")
    };
    let value = k_s.clone() * n * mu * clamp / Traced::number(gamma.0, gamma.1);
    Worked::of(clause, CheckId::SlipResistance, "F_s,Rd", value, Unit::Force).with_symbols([&k_s])
}
