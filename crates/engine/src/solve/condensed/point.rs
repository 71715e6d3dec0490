//! Iterates and directions of the homogeneous embedding.

use super::vectors::vector;

/// An iterate: the unknowns of the program are x/τ, its multipliers z/τ.
#[derive(Clone, Debug)]
pub struct Point {
    /// Unknowns.
    pub x: Vec<f64>,
    /// Slacks of the cones.
    pub s: Vec<f64>,
    /// Multipliers of the cones.
    pub z: Vec<f64>,
    /// Scale of the embedding.
    pub tau: f64,
    /// Slack of the scalar row.
    pub kappa: f64,
}

/// A direction of a step, entry by entry as in [`Point`].
pub struct Direction {
    /// Unknowns.
    pub x: Vec<f64>,
    /// Slacks of the cones.
    pub s: Vec<f64>,
    /// Multipliers of the cones.
    pub z: Vec<f64>,
    /// Scale of the embedding.
    pub tau: f64,
    /// Slack of the scalar row.
    pub kappa: f64,
}

impl Direction {
    /// `self + part · other`.
    pub fn plus(&self, part: f64, other: &Self) -> Self {
        let sum = |a: &[f64], b: &[f64]| vector(a.len(), |i| a[i] + part * b[i]);
        Self {
            x: sum(&self.x, &other.x),
            s: sum(&self.s, &other.s),
            z: sum(&self.z, &other.z),
            tau: self.tau + part * other.tau,
            kappa: self.kappa + part * other.kappa,
        }
    }
}
