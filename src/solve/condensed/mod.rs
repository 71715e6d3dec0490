//! The condensed interior-point method: only the program's own unknowns reach the sparse factor.
//!
//! Slacks and multipliers of the cones are eliminated cone by cone; every iteration factors `P + Gᵀ W⁻² G`, whose pattern
//! is fixed, under one nested-dissection ordering.

pub mod cones;
pub mod ipm;
pub mod system;

use super::forecast::Forecast;
use super::linear::LinearError;
use super::scales::Scales;
use super::status::{Solution, SolveOptions};
use crate::model::program::ConicProgram;
use cones::Cones;
use std::time::Instant;
use system::CondensedSystem;

/// A program scaled, ordered and laid out.
pub struct Prepared<'a> {
    program: &'a ConicProgram,
    scales: Scales,
    scaled: ConicProgram,
    cones: Cones,
    system: CondensedSystem,
}

impl<'a> Prepared<'a> {
    /// Prepares a program with at least one cone; `block` gives the block (node or face) of each unknown.
    pub fn new(program: &'a ConicProgram, block: &[u32]) -> Result<Self, LinearError> {
        let scales = Scales::new(program);
        let scaled = scales.apply(program);
        let cones = Cones::new(&program.cones);
        let system = CondensedSystem::new(&scaled, &cones, block)?;
        Ok(Self { program, scales, scaled, cones, system })
    }

    /// What the solve will cost.
    pub fn forecast(&self) -> Forecast {
        self.system.forecast()
    }

    /// Solves the program.
    pub fn solve(mut self, options: &SolveOptions) -> Solution {
        let start = Instant::now();
        let outcome = ipm::iterate(&self.scaled, &self.cones, &mut self.system, options, start);
        debug_assert_eq!(outcome.x.len(), self.program.p.n);
        Solution {
            status: outcome.status,
            x: self.scales.unscale_x(&outcome.x),
            z: self.scales.unscale_z(&outcome.z),
            iterations: outcome.iterations,
            seconds: start.elapsed().as_secs_f64(),
        }
    }
}
