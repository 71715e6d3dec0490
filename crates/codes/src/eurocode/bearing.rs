//! Bearing of plates against bolts: EN 1993-1-8:2005 Table 3.4.

use crate::check::{Unit, number as n};
use crate::worked::Worked;

/// Position of a bolt in the direction of the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Along {
    /// An end bolt with the end distance e1 \[mm\].
    End {
        /// End distance.
        e1: f64,
    },
    /// An inner bolt with the pitch p1 \[mm\].
    Inner {
        /// Pitch.
        p1: f64,
    },
}

/// Kind of a hole, for bearing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hole {
    /// A normal round hole.
    #[default]
    Normal,
    /// An oversize round hole: 0.8 of the resistance.
    Oversize,
}

/// A plate that bears on an edge bolt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bearing {
    /// Position along the force.
    pub along: Along,
    /// Edge distance across the force \[mm\].
    pub e2: f64,
    /// Pitch across the force to the next column of bolts \[mm\].
    pub p2: f64,
    /// Kind of hole.
    pub hole: Hole,
    /// Diameter of the bolt \[mm\].
    pub d: f64,
    /// Diameter of the hole \[mm\].
    pub d0: f64,
    /// Thickness of the plate \[mm\].
    pub thickness: f64,
    /// Ultimate strength of the plate \[MPa\].
    pub fu: f64,
    /// Ultimate strength of the bolt \[MPa\].
    pub fub: f64,
}

impl Bearing {
    /// Design bearing resistance of the plate at one bolt \[N\].
    ///
    /// `F_b,Rd = k1 α_b f_u d t / γ_M2`; α_b = min(α_d, f_ub/f_u, 1), α_d = e1/(3 d0) or p1/(3 d0)
    /// − 1/4; k1 = min(2.8 e2/d0 − 1.7, 1.4 p2/d0 − 1.7, 2.5).
    ///
    /// # Source
    /// EN 1993-1-8:2005 Table 3.4 with its notes 1 (holes); the p2 term of edge bolts after the
    /// corrigendum of 2009.
    pub fn resistance(&self, gamma_m2: f64) -> Worked {
        let alpha_d = match self.along {
            Along::End { e1 } => e1 / (3.0 * self.d0),
            Along::Inner { p1 } => p1 / (3.0 * self.d0) - 0.25,
        };
        let alpha_b = alpha_d.min(self.fub / self.fu).min(1.0);
        let edge = 2.8 * self.e2 / self.d0 - 1.7;
        let inner = 1.4 * self.p2 / self.d0 - 1.7;
        let k1 = edge.min(inner).min(2.5);
        let factor = match self.hole {
            Hole::Normal => 1.0,
            Hole::Oversize => 0.8,
        };
        // below the least distances of Table 3.3 the factors can turn negative
        let value = (factor * k1 * alpha_b * self.fu * self.d * self.thickness / gamma_m2).max(0.0);
        let (words, hole) =
            if factor == 1.0 { (String::new(), "") } else { (format!("{} · ", n(factor)), "β ") };
        let formula = format!(
            "F_b,Rd = {hole}k1 α_b f_u d t / γ_M2 = {words}{} · {} · {} · {} · {} / {}",
            n(k1),
            n(alpha_b),
            n(self.fu),
            n(self.d),
            n(self.thickness),
            n(gamma_m2)
        );
        Worked::new(
            "EN 1993-1-8:2005 Table 3.4",
            "bearing resistance at a bolt",
            value,
            Unit::Force,
            formula,
        )
        .with("α_d", alpha_d, Unit::Number)
        .with("α_b", alpha_b, Unit::Number)
        .with("k1", k1, Unit::Number)
    }
}
