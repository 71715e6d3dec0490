//! Bearing of plates against bolts: EN 1993-1-8:2005 Table 3.4.

use crate::check::CheckId;
use crate::formula::{Number, Traced};
use crate::unit::Unit;
use crate::worked::Worked;

/// Position of a bolt in the direction of the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Along {
    /// An end bolt with the end distance e1 \[mm\]; infinite for a bolt far from any end.
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
    /// Edge distance across the force \[mm\]; infinite where no edge is near.
    pub e2: f64,
    /// Pitch across the force to the next column of bolts \[mm\]; infinite without one.
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
        let n = Traced::from;
        let d0 = || Traced::length("d0", self.d0);
        let alpha_d = match self.along {
            Along::End { e1: f64::INFINITY } => n(1.0),
            Along::End { e1 } => Traced::length("e1", e1) / (n(3.0) * d0()),
            Along::Inner { p1 } => Traced::length("p1", p1) / (n(3.0) * d0()) - n(0.25),
        };
        let alpha_d = alpha_d.named("α_d", Unit::Number);
        let f_u = Traced::stress("f_u", self.fu);
        let strengths = Traced::stress("f_ub", self.fub) / f_u.clone();
        let alpha_b = alpha_d.clone().min(strengths).min(n(1.0)).named("α_b", Unit::Number);
        let across = |factor, symbol: &'static str, distance: f64| {
            let limit = || n(factor) * Traced::length(symbol, distance) / d0() - n(1.7);
            distance.is_finite().then(limit)
        };
        let near = [across(2.8, "e2", self.e2), across(1.4, "p2", self.p2)];
        let least = near.into_iter().flatten().reduce(Number::min);
        let k1 = least.map_or_else(|| n(2.5), |k| k.min(n(2.5))).named("k1", Unit::Number);
        let factors = match self.hole {
            Hole::Normal => k1.clone(),
            Hole::Oversize => Traced::number("β", 0.8) * k1.clone(),
        };
        let (d, t) = (Traced::length("d", self.d), Traced::length("t", self.thickness));
        let gamma = Traced::number("γ_M2", gamma_m2);
        let value = factors * alpha_b.clone() * f_u * d * t / gamma;
        // below the least distances of Table 3.3 the factors can turn negative
        let value = if value.value() >= 0.0 { value } else { value.max(n(0.0)) };
        let id = CheckId::BearingResistance;
        Worked::of("EN 1993-1-8:2005 Table 3.4", id, "F_b,Rd", value, Unit::Force)
            .with_symbols([&alpha_d, &alpha_b, &k1])
    }

    /// Greatest bearing resistance of a single lap joint with one bolt row \[N\],
    /// `1.5 f_u d t/γ_M2`.
    ///
    /// # Source
    /// EN 1993-1-8:2005 3.6.1(10), formula 3.2: with washers under head and nut.
    pub fn of_one_row(&self, gamma_m2: f64) -> Worked {
        let (id, value) = (CheckId::BearingResistance, self.most_of_one_row(gamma_m2));
        Worked::of("EN 1993-1-8:2005 3.6.1(10)", id, "F_b,Rd", value, Unit::Force)
    }

    /// The same as a formula that has no symbol yet.
    pub fn most_of_one_row(&self, gamma_m2: f64) -> Traced {
        let [d, t] = [("d", self.d), ("t", self.thickness)].map(|(s, v)| Traced::length(s, v));
        let gamma = Traced::number("γ_M2", gamma_m2);
        Traced::from(1.5) * Traced::stress("f_u", self.fu) * d * t / gamma
    }
}
