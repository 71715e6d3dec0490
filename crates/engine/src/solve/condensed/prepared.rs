//! A program prepared for the condensed method.

use super::cones::Scaling;
use super::ipm;
use super::scaled_program::ScaledProgram;
use super::system::CondensedSystem;
use crate::programs::conic::ConicProgram;
use crate::solve::forecast::{Forecast, Yardstick};
use crate::solve::scales::Scales;
use crate::solve::sparse::{LinearError, Patterns};
use crate::solve::status::{Solution, SolveOptions, SolveStatus};
use std::time::Instant;

/// A program that is scaled, ordered and laid out.
pub struct Prepared {
    scales: Scales,
    problem: ScaledProgram,
    system: CondensedSystem,
}

impl Prepared {
    /// Prepares a program with at least one cone. `block` gives the block (node or face) of each
    /// shared unknown for the ordering, which is taken from `patterns` if known.
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

    /// Forecast of the cost of the solve.
    pub fn forecast(&self) -> Forecast {
        self.system.forecast(&self.problem.program)
    }

    /// Time of the second of two factorisations of the starting matrix, and of the second of two
    /// solves with it.
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

    /// Solves the program with other row offsets; scales, ordering and pattern stay.
    pub fn solve_at(&mut self, offsets: &[f64], options: &SolveOptions) -> Solution {
        self.problem.program.h = self.scales.scale_offsets(offsets);
        self.run(options)
    }

    fn run(&mut self, options: &SolveOptions) -> Solution {
        let start = Instant::now();
        let mut result = ipm::iterate(&self.problem, &mut self.system, options, start);
        // a larger term keeps the digits that very long tets lose
        if result.status == SolveStatus::NumericalError && self.system.raise_proximal() {
            result = ipm::iterate(&self.problem, &mut self.system, options, start);
        }
        Solution {
            status: result.status,
            x: self.scales.unscale_x(&result.x),
            z: self.scales.unscale_z(&result.z),
            iterations: result.iterations,
            seconds: start.elapsed().as_secs_f64(),
        }
    }
}
