//! A scaled program and its cones, with the scalar products and measures of the iteration.

use super::cones::Cones;
use super::vectors::{dot, largest, sum, vector};
use crate::programs::conic::ConicProgram;

/// A scaled program, ready for the iteration.
pub struct ScaledProgram {
    /// The program.
    pub program: ConicProgram,
    /// Its cones.
    pub cones: Cones,
    /// True for maximised unknowns.
    pub maximised: Vec<bool>,
    /// True if any unknown is maximised.
    pub(super) saddle: bool,
    /// First row of the yield points, whose cones contain maximised unknowns.
    pub(super) points: usize,
}

impl ScaledProgram {
    /// The cones and measures of a scaled program.
    pub fn new(program: ConicProgram) -> Self {
        let (cones, maximised) = (Cones::new(&program.cones), program.maximised());
        let (saddle, points) = (maximised.contains(&true), program.g.nrows());
        Self { program, cones, maximised, saddle, points }
    }

    /// True for programs of limit analysis, whose last unknown is the load factor.
    pub(super) fn is_limit(&self) -> bool {
        !self.program.live.is_empty()
    }

    /// Scalar product in which maximised unknowns count negative.
    pub(super) fn signed_dot(&self, a: &[f64], b: &[f64]) -> f64 {
        if !self.saddle {
            return dot(a, b);
        }
        sum(a.len(), |i| if self.maximised[i] { -a[i] * b[i] } else { a[i] * b[i] })
    }

    /// Maximised entries with the opposite sign.
    pub(super) fn signed(&self, mut a: Vec<f64>) -> Vec<f64> {
        if self.saddle {
            a.iter_mut().zip(&self.maximised).filter(|(_, m)| **m).for_each(|(v, _)| *v = -*v);
        }
        a
    }

    /// The vector with the maximised (or the other) entries zero.
    pub(super) fn part(&self, a: &[f64], maximised: bool) -> Vec<f64> {
        if !self.saddle {
            return if maximised { vec![0.0; a.len()] } else { a.to_vec() };
        }
        vector(a.len(), |i| if self.maximised[i] == maximised { a[i] } else { 0.0 })
    }

    /// Largest entry among the minimised unknowns, and among all. Rows of minimised unknowns are
    /// forces: their errors must be small relative to forces, not to strains or to the power of the
    /// live loads.
    pub(super) fn largest_of_kinds(&self, a: &[f64]) -> [f64; 2] {
        let all = largest(a);
        if !self.saddle {
            return [all; 2];
        }
        let forces = a
            .iter()
            .zip(&self.maximised)
            .filter(|(_, m)| !**m)
            .fold(0.0, |m: f64, (v, _)| m.max(v.abs()));
        [forces, all]
    }

    /// Largest live load at the load factor. It balances the stress, so that `P x` does not show
    /// it.
    pub(super) fn live_force(&self, x: &[f64]) -> f64 {
        if self.program.live.is_empty() {
            0.0
        } else {
            largest(&self.program.live) * x[x.len() - 1].abs()
        }
    }

    /// Multipliers of yield points (or of the other cones) alone.
    pub(super) fn rows_part(&self, z: &[f64], points: bool) -> Vec<f64> {
        z.iter()
            .enumerate()
            .map(|(r, v)| if (r >= self.points) == points { *v } else { 0.0 })
            .collect()
    }
}
