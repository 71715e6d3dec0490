//! Corrections of a refined solution. Corrections with orthogonal effects, each scaled to lower the
//! residual most, make the generalised conjugate residual method. It converges where plain
//! refinement stalls because a few directions of a stiff matrix are lost in rounding.
//!
//! # Source
//! Eisenstat, Elman and Schultz, Variational iterative methods for nonsymmetric systems of linear
//! equations (1983).

use super::vectors::{add, scale};

/// A correction of a solution, and its effect on the stationarity rows.
pub struct Correction {
    /// Unknowns.
    pub x: Vec<f64>,
    /// Multipliers.
    pub z: Vec<f64>,
    /// Reduction of the residual.
    pub effect: Vec<f64>,
}

impl Correction {
    /// Makes the effect a unit vector, or zero, orthogonal to those of earlier corrections.
    pub fn orthogonalise(&mut self, earlier: &[Self], dot: impl Fn(&[f64], &[f64]) -> f64) {
        for other in earlier {
            let part = -dot(&self.effect, &other.effect);
            add(&mut self.effect, part, &other.effect);
            add(&mut self.x, part, &other.x);
            add(&mut self.z, part, &other.z);
        }
        let size = dot(&self.effect, &self.effect).sqrt();
        let unit = if size > 0.0 { size.recip() } else { 0.0 };
        for v in [&mut self.effect, &mut self.x, &mut self.z] {
            scale(v, unit);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::condensed::vectors::dot;

    /// Plain refinement never converges with a solver that is wrong by a factor in one direction of
    /// two; two corrections do.
    #[test]
    fn a_lost_direction_takes_one_correction_more() {
        let (matrix, solver) = ([4.0, 1e-3], [0.25, 3e3]);
        let (mut x, rhs, mut earlier) = (vec![0.0, 0.0], [1.0, 2.0], Vec::new());
        for _ in 0..2 {
            let residual: Vec<f64> = (0..2).map(|i| rhs[i] - matrix[i] * x[i]).collect();
            let step: Vec<f64> = (0..2).map(|i| solver[i] * residual[i]).collect();
            let effect = (0..2).map(|i| matrix[i] * step[i]).collect();
            let mut next = Correction { x: step, z: vec![], effect };
            next.orthogonalise(&earlier, dot);
            let part = dot(&residual, &next.effect);
            x.iter_mut().zip(&next.x).for_each(|(x, d)| *x += part * d);
            earlier.push(next);
        }
        assert!((x[0] - 0.25).abs() < 1e-12 && (x[1] - 2e3).abs() < 1e-9, "{x:?}");
    }
}
