//! Limits on the forces through cross-sections of bodies: how the resistances of a design code
//! (bolt, bearing, punching) enter limit analysis.
//!
//! A [`Cut`](crate::model::analysis::Cut) severs a body. Its resultant is `R = ∫ σ n dA`, n out of
//! side A: the force of side B on side A. A [`ResultantLimit`] permits
//!
//! `along · R + ‖across R‖ ≤ at_most`, with R the sum of the resultants of some cuts less that of
//! others.
//!
//! The limits of a model hold together, so that a convex set of resultants is the intersection of
//! as many limits as it needs. Moments in a cut are not limited.
//!
//! # Dual
//! The two sides of a cut may move against each other as rigid bodies without rotation,
//! `u_B − u_A = δ`. A limit has a motion `[s, y…]`, one y for each row of `across`, `s ≥ ‖y‖`. It
//! gives each of its cuts the share `± (s along + Σ y_k across_k)` of δ and costs `at_most s`. The
//! least cost of given δ is the support function of the set of resultants: both bounds belong to
//! the same structure.

use bracket_base::math::vec3::{self, V3};

/// A limit on the sum of resultants.
#[derive(Clone, Debug, PartialEq)]
pub struct ResultantLimit {
    /// Name in messages and results.
    pub name: String,
    /// The cuts by their place in the model, each with the sign of its resultant in the sum.
    pub cuts: Vec<(usize, f64)>,
    /// Factors of the linear part.
    pub along: V3,
    /// Rows of the norm, at most three.
    pub across: Vec<V3>,
    /// Largest value \[N\], > 0.
    pub at_most: f64,
}

impl ResultantLimit {
    /// The jumps of its motion at unit values of s and of each y.
    pub fn rows(&self) -> impl Iterator<Item = &V3> {
        std::iter::once(&self.along).chain(&self.across)
    }

    /// Number of unknowns of its motion.
    pub fn motions(&self) -> usize {
        1 + self.across.len()
    }

    /// `along · R + ‖across R‖` for the resultants of all cuts \[N\].
    pub fn value(&self, resultants: &[V3]) -> f64 {
        self.value_of(self.resultant(resultants))
    }

    /// `along · R + ‖across R‖` for the sum R \[N\].
    pub fn value_of(&self, sum: V3) -> f64 {
        let across: f64 = self.across.iter().map(|row| vec3::dot(*row, sum).powi(2)).sum();
        vec3::dot(self.along, sum) + across.sqrt()
    }

    /// The sum R that it limits \[N\].
    pub fn resultant(&self, resultants: &[V3]) -> V3 {
        let add = |sum, &(cut, sign): &(usize, f64)| vec3::along(sum, sign, resultants[cut]);
        self.cuts.iter().fold([0.0; 3], add)
    }

    /// The jump `s along + Σ y_k across_k` of a motion, with the sign of the sum \[mm\].
    pub fn jump(&self, motion: &[f64]) -> V3 {
        self.rows().zip(motion).fold([0.0; 3], |sum, (row, m)| vec3::along(sum, *m, *row))
    }

    /// Cost of a motion, `at_most max(s, ‖y‖)` \[N mm\]; NaN for a motion that is not a number.
    pub fn cost(&self, motion: &[f64]) -> f64 {
        let y = norm(&motion[1..]);
        if motion[0].is_nan() || y.is_nan() {
            return f64::NAN;
        }
        self.at_most * motion[0].max(y)
    }

    /// `‖y‖ − s`, where it is positive: how far a motion is outside its cone \[mm\].
    pub fn outside(&self, motion: &[f64]) -> f64 {
        (norm(&motion[1..]) - motion[0]).max(0.0)
    }
}

fn norm(y: &[f64]) -> f64 {
    y.iter().map(|y| y * y).sum::<f64>().sqrt()
}
