//! A program prepared for its solve: the method is chosen and the cost is known.

use super::condensed;
use super::forecast::{Forecast, Yardstick, available_memory};
use super::sparse::{SparseCholesky, solve_refined};
use super::status::{Solution, SolveOptions, SolveStatus, Solver};
use super::{clarabel, pages};
use crate::programs::conic::{ConicProgram, cone_margin};
use std::time::Instant;

/// Clarabel's memory, in that of the condensed method, on the same program.
const CLARABEL_MEMORY: u64 = 3;

/// A program with its ordering and symbolic factor, ready to be solved; its cost is known.
pub struct Prepared<'a> {
    program: &'a ConicProgram,
    way: Way,
    start: Instant,
}

/// How a prepared program is solved.
enum Way {
    /// No cones: a linear system, ordered and laid out.
    Linear(Box<SparseCholesky>),
    /// A linear system that cannot be laid out.
    Singular,
    /// Nothing loads it: zero.
    Rest,
    /// By the condensed method.
    Condensed(Box<condensed::Prepared>),
    /// By Clarabel.
    Clarabel,
}

/// Prepares a program; `block` gives the block (node or face) of each unknown, for orderings.
pub fn prepare<'a>(
    program: &'a ConicProgram,
    block: &[u32],
    options: &SolveOptions,
) -> Prepared<'a> {
    let start = Instant::now();
    pages::keep();
    let way = if program.cones.is_empty() {
        SparseCholesky::symbolic(&program.p, block, &options.patterns)
            .map_or(Way::Singular, |f| Way::Linear(Box::new(f)))
    } else if program.q.iter().all(|q| *q == 0.0) && at_rest(program) {
        Way::Rest
    } else if options.solver == Solver::Condensed {
        condensed::Prepared::new(program, block, &options.patterns)
            .map_or(Way::Clarabel, |p| Way::Condensed(Box::new(p)))
    } else {
        Way::Clarabel
    };
    Prepared { program, way, start }
}

impl Prepared<'_> {
    /// What the solve will cost; `None` where nobody can tell (Clarabel) or it costs little.
    pub fn forecast(&self) -> Option<Forecast> {
        match &self.way {
            Way::Condensed(p) => Some(p.forecast()),
            Way::Linear(factor) => Some(Forecast::of_factor(factor)),
            _ => None,
        }
    }

    /// Times one factor and one solve of the matrix the iterations work with; `None` where there is
    /// no such matrix.
    pub fn yardstick(&mut self) -> Option<Yardstick> {
        match &mut self.way {
            Way::Condensed(p) => p.yardstick(),
            _ => None,
        }
    }

    /// Solves it.
    ///
    /// A program without cones is a linear system and is solved as one. When the condensed method
    /// ends without an answer, Clarabel is asked.
    pub fn solve(mut self, options: &SolveOptions) -> Solution {
        self.run(None, options)
    }

    /// Solves it and keeps what was prepared, for [`Self::solve_at`].
    pub fn solve_first(&mut self, options: &SolveOptions) -> Solution {
        self.run(None, options)
    }

    /// Solves it with other offsets of its rows; all that was prepared stays as it is.
    pub fn solve_at(&mut self, offsets: &[f64], options: &SolveOptions) -> Solution {
        self.start = Instant::now();
        self.run(Some(offsets), options)
    }

    fn run(&mut self, offsets: Option<&[f64]>, options: &SolveOptions) -> Solution {
        let start = self.start;
        let solution = match &mut self.way {
            Way::Linear(factor) => match factor.refactor(&self.program.p) {
                Ok(()) => Some(linear_solution(self.program, factor)),
                Err(_) => Some(failed(self.program)),
            },
            Way::Singular => Some(failed(self.program)),
            Way::Rest => Some(Solution {
                status: SolveStatus::Optimal,
                x: vec![0.0; self.program.unknowns()],
                z: vec![0.0; self.program.h.len()],
                iterations: 0,
                seconds: 0.0,
            }),
            Way::Condensed(prepared) => {
                use SolveStatus::{Interrupted, Optimal, TimeLimit, Unbounded};
                let bytes = prepared.forecast().bytes;
                let solution = prepared.solve_at(offsets.unwrap_or(&self.program.h), options);
                let answered =
                    matches!(solution.status, Optimal | Unbounded | TimeLimit | Interrupted);
                // Clarabel takes about twice as much memory
                let fits = available_memory().is_none_or(|there| there / CLARABEL_MEMORY > bytes);
                (answered || !fits).then_some(solution)
            }
            Way::Clarabel => None,
        };
        let solution = solution.unwrap_or_else(|| {
            // frees the factor
            self.way = Way::Clarabel;
            match offsets {
                Some(h) => clarabel::solve(
                    &ConicProgram { h: h.to_vec(), ..self.program.clone() },
                    options,
                ),
                None => clarabel::solve(self.program, options),
            }
        });
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

fn linear_solution(program: &ConicProgram, factor: &SparseCholesky) -> Solution {
    let minus_q: Vec<f64> = program.q.iter().map(|x| -x).collect();
    let x = solve_refined(&program.p, factor, &minus_q).0;
    Solution { status: SolveStatus::Optimal, x, z: Vec::new(), iterations: 1, seconds: 0.0 }
}

fn failed(program: &ConicProgram) -> Solution {
    let (x, z) = (vec![0.0; program.unknowns()], vec![0.0; program.h.len()]);
    Solution { status: SolveStatus::NumericalError, x, z, iterations: 0, seconds: 0.0 }
}
