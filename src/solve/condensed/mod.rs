//! The condensed interior-point method: only the program's own unknowns reach the sparse factor.
//!
//! Slacks and multipliers of the cones are eliminated cone by cone; every iteration factors `P + Gᵀ W⁻² G`, whose pattern
//! is fixed, under one nested-dissection ordering.

pub mod cones;
pub mod ipm;
pub mod system;

use super::scales::Scales;
use super::status::{Solution, SolveOptions, SolveStatus};
use crate::model::program::ConicProgram;
use cones::Cones;
use std::time::Instant;
use system::CondensedSystem;

/// Solves a program with at least one cone; `block` gives the block (node or face) of each unknown.
pub fn solve(program: &ConicProgram, block: &[u32], options: &SolveOptions) -> Solution {
    let start = Instant::now();
    let scales = Scales::new(program);
    let scaled = scales.apply(program);
    let cones = Cones::new(&program.cones);
    let failed = || Solution {
        status: SolveStatus::NumericalError,
        x: vec![0.0; program.p.n],
        z: vec![0.0; program.h.len()],
        iterations: 0,
        seconds: start.elapsed().as_secs_f64(),
    };
    let Ok(mut system) = CondensedSystem::new(&scaled, &cones, block, 1.0) else { return failed() };
    let outcome = ipm::iterate(&scaled, &cones, &mut system, options, start);
    Solution {
        status: outcome.status,
        x: scales.unscale_x(&outcome.x),
        z: scales.unscale_z(&outcome.z),
        iterations: outcome.iterations,
        seconds: start.elapsed().as_secs_f64(),
    }
}
