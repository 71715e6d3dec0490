//! A program prepared for its solve: the method is chosen and the cost is known.

use super::condensed;
use super::forecast::{Forecast, Yardstick, available_memory};
use super::sparse::{SparseCholesky, solve_refined};
use super::status::{Solution, SolveOptions, SolveStatus, Solver};
use super::{allocator, clarabel};
use crate::programs::conic::{ConicProgram, cone_margin};
use std::time::Instant;

/// Clarabel's memory over the forecast of the condensed method, with room: at most 2.1 measured on
/// elastic programs, see benches/README.md.
const CLARABEL_MEMORY: u64 = 3;
/// The same for programs with yield conditions, which Clarabel takes written out: 3.3 to 6.0
/// measured.
const CLARABEL_MEMORY_YIELDING: u64 = 7;

/// A program with its ordering and symbolic factor, ready to be solved, with a forecast of its
/// cost.
pub struct Prepared<'a> {
    program: &'a ConicProgram,
    method: Method,
    start: Instant,
}

/// Method that solves a prepared program.
enum Method {
    /// A program without cones: a linear system, ordered and laid out.
    Linear(Box<SparseCholesky>),
    /// A linear system whose factor cannot be laid out.
    Singular,
    /// A program without loads: the solution is zero.
    Rest,
    /// The condensed method.
    Condensed(Box<condensed::Prepared>),
    /// Clarabel.
    Clarabel,
}

/// Prepares a program; `block` gives the block (node or face) of each unknown, for orderings.
pub fn prepare<'a>(
    program: &'a ConicProgram,
    block: &[u32],
    options: &SolveOptions,
) -> Prepared<'a> {
    let start = Instant::now();
    allocator::keep();
    let method = if program.cones.is_empty() {
        SparseCholesky::symbolic(&program.p, block, &options.patterns)
            .map_or(Method::Singular, |f| Method::Linear(Box::new(f)))
    } else if program.q.iter().all(|q| *q == 0.0) && at_rest(program) {
        Method::Rest
    } else if options.solver == Solver::Condensed {
        condensed::Prepared::new(program, block, &options.patterns)
            .map_or(Method::Clarabel, |p| Method::Condensed(Box::new(p)))
    } else {
        Method::Clarabel
    };
    Prepared { program, method, start }
}

impl Prepared<'_> {
    /// Forecast of the cost of the solve; `None` for Clarabel, whose cost is unknown, and where the
    /// cost is negligible.
    pub fn forecast(&self) -> Option<Forecast> {
        match &self.method {
            Method::Condensed(p) => Some(p.forecast()),
            Method::Linear(factor) => Some(Forecast::of_factor(factor)),
            _ => None,
        }
    }

    /// Times one factorisation and one solve of the iterations' matrix; `None` for other methods.
    pub fn yardstick(&mut self) -> Option<Yardstick> {
        match &mut self.method {
            Method::Condensed(p) => p.yardstick(),
            _ => None,
        }
    }

    /// Solves the program.
    ///
    /// A program without cones is solved as a linear system. When the condensed method ends without
    /// an answer and memory allows, Clarabel solves it.
    pub fn solve(mut self, options: &SolveOptions) -> Solution {
        self.run(None, options)
    }

    /// Solves the program and keeps the preparation for [`Self::solve_at`].
    pub fn solve_first(&mut self, options: &SolveOptions) -> Solution {
        self.run(None, options)
    }

    /// Solves the program with other row offsets; the preparation is used again.
    pub fn solve_at(&mut self, offsets: &[f64], options: &SolveOptions) -> Solution {
        self.start = Instant::now();
        self.run(Some(offsets), options)
    }

    fn run(&mut self, offsets: Option<&[f64]>, options: &SolveOptions) -> Solution {
        let start = self.start;
        let solution = match &mut self.method {
            Method::Linear(factor) => match factor.refactor(&self.program.p) {
                Ok(()) => Some(linear_solution(self.program, factor)),
                Err(_) => Some(failed(self.program)),
            },
            Method::Singular => Some(failed(self.program)),
            Method::Rest => Some(Solution {
                status: SolveStatus::Optimal,
                x: vec![0.0; self.program.unknowns()],
                z: vec![0.0; self.program.h.len()],
                iterations: 0,
                seconds: 0.0,
            }),
            Method::Condensed(prepared) => {
                use SolveStatus::{Interrupted, Optimal, TimeLimit, Unbounded};
                let bytes = prepared.forecast().bytes;
                let solution = prepared.solve_at(offsets.unwrap_or(&self.program.h), options);
                let answered =
                    matches!(solution.status, Optimal | Unbounded | TimeLimit | Interrupted);
                let times = if self.program.elements.batches.is_empty() {
                    CLARABEL_MEMORY
                } else {
                    CLARABEL_MEMORY_YIELDING
                };
                let fits = available_memory().is_none_or(|there| there / times > bytes);
                (answered || !fits).then_some(solution)
            }
            Method::Clarabel => None,
        };
        let solution = solution.unwrap_or_else(|| {
            // frees the factor of the condensed method
            self.method = Method::Clarabel;
            match offsets {
                Some(h) => clarabel::solve(
                    &ConicProgram { h: h.to_vec(), ..self.program.clone() },
                    options,
                ),
                None => clarabel::solve(self.program, options),
            }
        });
        // the preparation and a failed attempt count as well
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
