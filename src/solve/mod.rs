//! Solvers of conic programs and of linear systems.

pub mod clarabel;
pub mod collapse;
pub mod condensed;
pub mod forecast;
pub mod scales;
pub mod sparse;
pub mod status;

pub use forecast::Forecast;
pub use status::{Iteration, Solution, SolveOptions, SolveStatus, Solver};

use crate::model::program::{ConicProgram, cone_margin};
use sparse::{SparseCholesky, solve_refined};
use std::time::Instant;

/// A program with its ordering and symbolic factor, ready to be solved; its cost is known.
pub struct Prepared<'a> {
    program: &'a ConicProgram,
    block: &'a [u32],
    way: Way,
    start: Instant,
}

/// Time of the pieces a solve is made of.
#[derive(Clone, Copy, Debug)]
pub struct Yardstick {
    /// One factorisation \[s\].
    pub factor: f64,
    /// One solve \[s\].
    pub solve: f64,
}

/// How a prepared program is solved.
enum Way {
    /// No cones: a linear system.
    Linear,
    /// Nothing loads it: zero.
    Rest,
    /// By the condensed method.
    Condensed(Box<condensed::Prepared>),
    /// By Clarabel.
    Clarabel,
}

/// Prepares a program; `block` gives the block (node or face) of each unknown, for orderings.
pub fn prepare<'a>(program: &'a ConicProgram, block: &'a [u32], options: &SolveOptions) -> Prepared<'a> {
    let start = Instant::now();
    let way = if program.cones.is_empty() {
        Way::Linear
    } else if program.q.iter().all(|q| *q == 0.0) && at_rest(program) {
        Way::Rest
    } else if options.solver == Solver::Condensed {
        condensed::Prepared::new(program, block).map_or(Way::Clarabel, |p| Way::Condensed(Box::new(p)))
    } else {
        Way::Clarabel
    };
    Prepared { program, block, way, start }
}

impl Prepared<'_> {
    /// What the solve will cost; `None` where nobody can tell (Clarabel) or it costs little.
    pub fn forecast(&self) -> Option<Forecast> {
        match &self.way {
            Way::Condensed(p) => Some(p.forecast()),
            _ => None,
        }
    }

    /// Times one factor and one solve of the matrix the iterations work with; `None` where there is no such matrix.
    pub fn yardstick(&mut self) -> Option<Yardstick> {
        match &mut self.way {
            Way::Condensed(p) => p.yardstick(),
            _ => None,
        }
    }

    /// Solves it.
    ///
    /// A program without cones is a linear system and is solved as one. When the condensed method ends without an answer,
    /// Clarabel is asked.
    pub fn solve(self, options: &SolveOptions) -> Solution {
        let start = self.start;
        let solution = match self.way {
            Way::Linear => linear_solution(self.program, self.block, start),
            Way::Rest => Solution {
                status: SolveStatus::Optimal,
                x: vec![0.0; self.program.p.n],
                z: vec![0.0; self.program.h.len()],
                iterations: 0,
                seconds: 0.0,
            },
            Way::Condensed(prepared) => {
                use SolveStatus::{Interrupted, Optimal, TimeLimit, Unbounded};
                let solution = prepared.solve(options);
                if matches!(solution.status, Optimal | Unbounded | TimeLimit | Interrupted) {
                    solution
                } else {
                    clarabel::solve(self.program, options)
                }
            }
            Way::Clarabel => clarabel::solve(self.program, options),
        };
        // preparing and an attempt in vain count as well
        Solution { seconds: start.elapsed().as_secs_f64(), ..solution }
    }
}

/// Prepares and solves a program.
pub fn solve(program: &ConicProgram, block: &[u32], options: &SolveOptions) -> Solution {
    prepare(program, block, options).solve(options)
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
