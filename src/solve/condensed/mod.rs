//! The condensed interior-point method: only the program's own unknowns reach the sparse factor.
//!
//! Slacks and multipliers of the cones are eliminated cone by cone; every iteration factors `P + Gᵀ W⁻² G`, whose pattern
//! is fixed, under one nested-dissection ordering.

pub mod cones;
pub mod ipm;
pub mod local;
pub mod system;

use super::Yardstick;
use super::forecast::Forecast;
use super::scales::Scales;
use super::sparse::LinearError;
use super::status::{Solution, SolveOptions};
use crate::model::program::ConicProgram;
use cones::Cones;
use ipm::Problem;
use std::time::Instant;
use system::CondensedSystem;

/// A program scaled, ordered and laid out.
pub struct Prepared {
    scales: Scales,
    problem: Problem,
    system: CondensedSystem,
}

impl Prepared {
    /// Prepares a program with at least one cone; `block` gives the block (node or face) of each unknown.
    pub fn new(program: &ConicProgram, block: &[u32]) -> Result<Self, LinearError> {
        let scales = Scales::new(program);
        let ConicProgram { p, q, g, h, cones, stage, maximised, .. } = scales.apply(program);
        let cones = Cones::new(&cones);
        let system = CondensedSystem::new(p, &g, &cones, &stage, &maximised, block)?;
        Ok(Self { scales, problem: Problem { q, g, h, cones, maximised }, system })
    }

    /// What the solve will cost.
    pub fn forecast(&self) -> Forecast {
        self.system.forecast()
    }

    /// Times the second of two factorisations of the starting matrix, and the second of two solves with it.
    pub fn yardstick(&mut self) -> Option<Yardstick> {
        let timed = |run: &mut dyn FnMut()| {
            run();
            let start = Instant::now();
            run();
            start.elapsed().as_secs_f64()
        };
        let factor = timed(&mut || drop(self.system.factor_start(&self.problem.cones)));
        let solve = timed(&mut || drop(self.system.solve([&self.problem.q])));
        Some(Yardstick { factor, solve })
    }

    /// Solves the program.
    pub fn solve(mut self, options: &SolveOptions) -> Solution {
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
