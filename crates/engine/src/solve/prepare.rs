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
    /// an answer and memory and time allow, Clarabel solves it in the time that is left.
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
        let (start, begun) = (self.start, Instant::now());
        let left = || options.time_limit - begun.elapsed().as_secs_f64();
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
                use SolveStatus::{AlmostOptimal, Interrupted, Optimal, TimeLimit, Unbounded};
                let bytes = prepared.forecast().bytes;
                let solution = prepared.solve_at(offsets.unwrap_or(&self.program.h), options);
                let answered = matches!(
                    solution.status,
                    Optimal | AlmostOptimal | Unbounded | TimeLimit | Interrupted
                );
                let times = if self.program.elements.batches.is_empty() {
                    CLARABEL_MEMORY
                } else {
                    CLARABEL_MEMORY_YIELDING
                };
                let taken_over =
                    !answered && left() > 0.0 && may_have(bytes.saturating_mul(times), options);
                (!taken_over).then_some(solution)
            }
            Method::Clarabel => None,
        };
        let solution = solution.unwrap_or_else(|| {
            // frees the factor of the condensed method
            self.method = Method::Clarabel;
            let options = SolveOptions { time_limit: left().max(0.0), ..options.clone() };
            match offsets {
                Some(h) => clarabel::solve(
                    &ConicProgram { h: h.to_vec(), ..self.program.clone() },
                    &options,
                ),
                None => clarabel::solve(self.program, &options),
            }
        });
        // the preparation and a failed attempt count as well
        Solution { seconds: start.elapsed().as_secs_f64(), ..solution }
    }
}

/// True if Clarabel may take over with this memory \[bytes\].
fn may_have(bytes: u64, options: &SolveOptions) -> bool {
    match &options.hand_over {
        Some(ask) => ask(bytes),
        None => available_memory().is_none_or(|there| there > bytes),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::programs::conic::{Cone, Csr, SymmetricCsc};
    use crate::solve::StopRules;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicU64, Ordering};
    use std::time::Duration;

    /// The nearest point of a cone to (0, 3, 4).
    fn program() -> ConicProgram {
        let mut g = Csr { ncols: 3, ..Csr::default() };
        (0..3).for_each(|i| g.push_row(&[(i, 1.0)]));
        let (col_ptr, row_idx) = ((0..=3).collect(), (0..3).collect());
        ConicProgram {
            p: SymmetricCsc { n: 3, col_ptr, row_idx, values: vec![1.0; 3] },
            q: vec![0.0, -3.0, -4.0],
            g,
            h: vec![0.0; 3],
            cones: vec![Cone::SecondOrder(3)],
            ..ConicProgram::default()
        }
    }

    /// Options with which no method gets to its end, and who is asked for memory.
    fn cut_short(
        time_limit: f64,
        answer: impl Fn() -> bool + Send + Sync + 'static,
    ) -> (SolveOptions, Arc<AtomicU64>) {
        let asked = Arc::<AtomicU64>::default();
        let note = asked.clone();
        let hand_over = Some(Arc::new(move |bytes| {
            note.store(bytes, Ordering::Relaxed);
            answer()
        }) as _);
        (
            SolveOptions {
                stop: StopRules { max_iterations: 2, ..StopRules::default() },
                time_limit,
                hand_over,
                ..SolveOptions::default()
            },
            asked,
        )
    }

    #[test]
    fn clarabel_takes_over_with_the_memory_that_was_granted() {
        let program = program();
        let bytes = prepare(&program, &[0, 1, 2], &SolveOptions::default()).forecast();
        let bytes = bytes.expect("a forecast").bytes;
        let (options, asked) = cut_short(f64::INFINITY, || false);
        let own = solve(&program, &[0, 1, 2], &options);
        assert_eq!((own.status, own.iterations), (SolveStatus::IterationLimit, 2));
        assert_eq!(asked.load(Ordering::Relaxed), CLARABEL_MEMORY * bytes);
        let (options, _) = cut_short(f64::INFINITY, || true);
        let theirs = solve(&program, &[0, 1, 2], &options);
        assert_eq!(theirs.status, SolveStatus::IterationLimit);
        assert!(own.x != theirs.x, "Clarabel's point differs: {:?}", theirs.x);
        // with iterations enough no one is asked
        let (options, asked) = cut_short(f64::INFINITY, || false);
        let all =
            solve(&program, &[0, 1, 2], &SolveOptions { stop: StopRules::default(), ..options });
        assert_eq!((all.status, asked.load(Ordering::Relaxed)), (SolveStatus::Optimal, 0));
    }

    #[test]
    fn what_stalls_near_the_tolerance_is_almost_optimal() {
        let solved = |gap: f64, nearly: f64| {
            let stop = StopRules { gap, residual: gap, nearly, ..StopRules::default() };
            // Clarabel does not take over
            let (options, _) = cut_short(f64::INFINITY, || false);
            solve(&program(), &[0, 1, 2], &options.with(stop))
        };
        // nothing reaches 1e-30; 1e-30 times 1e22 is the default tolerance
        let near = solved(1e-30, 1e22);
        assert_eq!(near.status, SolveStatus::AlmostOptimal);
        let exact = solved(1e-10, 1.0);
        assert_eq!(exact.status, SolveStatus::Optimal);
        assert!(near.x.iter().zip(&exact.x).all(|(a, b)| (a - b).abs() < 1e-8), "{:?}", near.x);
        assert!(!solved(1e-30, 1.0).status.is_solution());
    }

    #[test]
    fn clarabel_has_the_time_that_is_left() {
        let slow = || {
            std::thread::sleep(Duration::from_millis(300));
            true
        };
        let (options, _) = cut_short(0.3, slow);
        let solution = solve(&program(), &[0, 1, 2], &options);
        assert_eq!(solution.status, SolveStatus::TimeLimit);
    }
}
