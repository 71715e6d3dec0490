//! Solvers of conic programs and of linear systems.

pub mod clarabel;
pub mod collapse;
pub mod condensed;
pub mod linear;
pub mod ordering;
pub mod scales;
pub mod status;

pub use status::{Solution, SolveOptions, SolveStatus, Solver};

use crate::model::program::{ConicProgram, cone_margin};
use linear::{SparseCholesky, solve_refined};
use std::time::Instant;

/// Solves a program; `block` gives the block (node or face) of each unknown, for orderings.
///
/// A program without cones is a linear system and is solved as one. When the condensed method ends without an answer,
/// Clarabel is asked.
pub fn solve(program: &ConicProgram, block: &[u32], options: &SolveOptions) -> Solution {
    let start = Instant::now();
    if program.cones.is_empty() {
        return linear_solution(program, block, start);
    }
    if program.q.iter().all(|q| *q == 0.0) && at_rest(program) {
        // nothing loads the model and no contact is violated at rest: rest is the solution
        return Solution {
            status: SolveStatus::Optimal,
            x: vec![0.0; program.p.n],
            z: vec![0.0; program.h.len()],
            iterations: 0,
            seconds: start.elapsed().as_secs_f64(),
        };
    }
    if options.solver == Solver::Condensed {
        let solution = condensed::solve(program, block, options);
        use SolveStatus::{Optimal, TimeLimit, Unbounded};
        if matches!(solution.status, Optimal | Unbounded | TimeLimit) {
            return solution;
        }
    }
    let solution = clarabel::solve(program, options);
    // a condensed attempt before it counts as well
    Solution { seconds: start.elapsed().as_secs_f64(), ..solution }
}

/// True when `x = 0` satisfies every cone.
fn at_rest(program: &ConicProgram) -> bool {
    let starts = program.cone_starts().into_iter();
    starts.zip(&program.cones).all(|(s, c)| cone_margin(&program.h[s..s + c.dim()]) >= 0.0)
}

fn linear_solution(program: &ConicProgram, block: &[u32], start: Instant) -> Solution {
    let minus_q: Vec<f64> = program.q.iter().map(|x| -x).collect();
    let (status, x) = match SparseCholesky::new(&program.p, block) {
        Ok(factor) => (SolveStatus::Optimal, solve_refined(&program.p, &factor, &minus_q).0),
        Err(_) => (SolveStatus::NumericalError, vec![0.0; program.p.n]),
    };
    Solution { status, x, z: Vec::new(), iterations: 1, seconds: start.elapsed().as_secs_f64() }
}
