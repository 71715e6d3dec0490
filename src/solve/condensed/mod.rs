//! The condensed interior-point method: only unknowns that elements share reach the sparse factor.
//!
//! Slacks and multipliers of the cones are eliminated cone by cone, yielding elements one by one;
//! every iteration factors what is left of `P + Gᵀ W⁻² G`, whose pattern is fixed, under one
//! nested-dissection ordering.

pub mod cones;
pub mod correction;
pub mod elements;
pub mod elimination;
pub mod ipm;
pub mod panel;
pub mod scaled_program;
pub mod static_condensation;
pub mod system;
pub mod targets;

use super::Yardstick;
use super::forecast::Forecast;
use super::scales::Scales;
use super::sparse::{LinearError, Patterns};
use super::status::{Solution, SolveOptions};
use crate::programs::conic::ConicProgram;
use cones::Scaling;
use scaled_program::ScaledProgram;
use std::time::Instant;
use system::CondensedSystem;

/// A program scaled, ordered and laid out.
pub struct Prepared {
    scales: Scales,
    problem: ScaledProgram,
    system: CondensedSystem,
}

impl Prepared {
    /// Prepares a program with at least one cone; `block` gives the block (node or face) of each
    /// shared unknown, for the ordering, which `patterns` may know.
    pub fn new(
        program: &ConicProgram,
        block: &[u32],
        patterns: &Patterns,
    ) -> Result<Self, LinearError> {
        let scales = Scales::new(program);
        let problem = ScaledProgram::new(scales.apply(program));
        let system = CondensedSystem::new(&problem.program, &problem.cones, block, patterns)?;
        Ok(Self { scales, problem, system })
    }

    /// What the solve will cost.
    pub fn forecast(&self) -> Forecast {
        self.system.forecast(&self.problem.program)
    }

    /// Times the second of two factorisations of the starting matrix, and the second of two solves
    /// with it.
    pub fn yardstick(&mut self) -> Option<Yardstick> {
        let timed = |run: &mut dyn FnMut()| {
            run();
            let start = Instant::now();
            run();
            start.elapsed().as_secs_f64()
        };
        let factor = timed(&mut || drop(self.system.factor_start(&self.problem)));
        let (unit, none) =
            (Scaling::identity(&self.problem.cones), vec![0.0; self.problem.program.h.len()]);
        let side = (self.problem.program.q.as_slice(), none.as_slice());
        let solve =
            timed(&mut || drop(self.system.solve::<1, false>(&self.problem, &unit, [side])));
        Some(Yardstick { factor, solve })
    }

    /// Solves the program.
    pub fn solve(mut self, options: &SolveOptions) -> Solution {
        self.run(options)
    }

    /// Solves it with other offsets of its rows; scales, ordering and pattern stay.
    pub fn solve_at(&mut self, offsets: &[f64], options: &SolveOptions) -> Solution {
        self.problem.program.h = self.scales.scale_offsets(offsets);
        self.run(options)
    }

    fn run(&mut self, options: &SolveOptions) -> Solution {
        let start = Instant::now();
        let outcome = ipm::iterate(&self.problem, &mut self.system, options, start);
        Solution {
            status: outcome.status,
            x: self.scales.unscale_x(&outcome.x),
            z: self.scales.unscale_z(&outcome.z),
            iterations: outcome.iterations,
            seconds: start.elapsed().as_secs_f64(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::programs::conic::{Cone, Csr, SymmetricCsc};
    use crate::solve::SolveStatus;

    /// `min ½ p x² + q x` in each unknown, with the given rows.
    fn program(
        p: &[f64],
        q: &[f64],
        rows: &[(&[(u32, f64)], f64)],
        cones: &[Cone],
    ) -> ConicProgram {
        let n = p.len();
        let mut g = Csr { ncols: n, ..Csr::default() };
        rows.iter().for_each(|(row, _)| g.push_row(row));
        ConicProgram {
            p: SymmetricCsc {
                n,
                col_ptr: (0..=n).collect(),
                row_idx: (0..n as u32).collect(),
                values: p.to_vec(),
            },
            q: q.to_vec(),
            g,
            h: rows.iter().map(|r| r.1).collect(),
            cones: cones.to_vec(),
            ..ConicProgram::default()
        }
    }

    fn solved(program: &ConicProgram) -> Solution {
        let block: Vec<u32> = (0..program.p.n as u32).collect();
        Prepared::new(program, &block, &Patterns::default())
            .expect("laid out")
            .solve(&SolveOptions::default())
    }

    #[test]
    fn the_nearest_point_of_a_cone() {
        // the point (0, 3, 4) goes to (2.5, 1.5, 2) of the cone x₀ ≥ ‖(x₁, x₂)‖
        let rows: [(&[(u32, f64)], f64); 3] =
            [(&[(0, 1.0)], 0.0), (&[(1, 1.0)], 0.0), (&[(2, 1.0)], 0.0)];
        let s = solved(&program(&[1.0; 3], &[0.0, -3.0, -4.0], &rows, &[Cone::SecondOrder(3)]));
        assert_eq!(s.status, SolveStatus::Optimal);
        s.x.iter()
            .zip([2.5, 1.5, 2.0])
            .for_each(|(x, e)| assert!((x - e).abs() < 1e-6, "{:?}", s.x));
    }

    #[test]
    fn contradicting_rows_end_with_a_certificate() {
        // x ≥ 1 and −x ≥ 1
        let rows: [(&[(u32, f64)], f64); 2] = [(&[(0, 1.0)], -1.0), (&[(0, -1.0)], -1.0)];
        let program = program(&[1.0], &[0.5], &rows, &[Cone::NonNegative; 2]);
        let s = solved(&program);
        assert_eq!(s.status, SolveStatus::Infeasible);
        assert!(s.iterations <= 15, "{} iterations", s.iterations);
        // Gᵀz = 0 and hᵀz < 0
        let hz: f64 = program.h.iter().zip(&s.z).map(|(h, z)| h * z).sum();
        assert!(hz < 0.0 && program.g.mul_transpose(&s.z)[0].abs() < 1e-6 * -hz, "{:?}", s.z);
    }

    #[test]
    fn falling_without_limit_ends_with_a_direction() {
        // −x + y with x ≥ |y|: falls along x
        let rows: [(&[(u32, f64)], f64); 2] = [(&[(0, 1.0)], 0.0), (&[(1, 1.0)], 0.0)];
        let program = program(&[0.0, 1.0], &[-1.0, 1.0], &rows, &[Cone::SecondOrder(2)]);
        let s = solved(&program);
        assert_eq!(s.status, SolveStatus::Unbounded);
        assert!(s.iterations <= 15, "{} iterations", s.iterations);
        assert!(s.x[0] > 0.0 && s.x[1].abs() < 1e-3 * s.x[0], "{:?}", s.x);
    }
}
