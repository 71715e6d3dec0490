//! Clarabel (homogeneous embedding, Nesterov–Todd) as the conic solver, with faer's sparse kernels.
//!
//! Programs are scaled first: unit stiffness of every unknown, unit largest load, unit rows per cone. A program without cones is a
//! linear system and is solved as one.

use super::linear::{SparseCholesky, solve_refined};
use super::status::{Solution, SolveOptions, SolveStatus};
use crate::model::program::{Cone, ConicProgram, cone_margin};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultInfo, DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use std::time::Instant;

/// Scales of a program: `x_i = size·columns_i·x̂_i`, `z = size·rows·ẑ`.
struct Scaling {
    columns: Vec<f64>,
    size: f64,
    rows: Vec<f64>,
}

impl Scaling {
    fn new(program: &ConicProgram) -> Self {
        // every unknown is measured in the give of its own stiffness: soft parts on hard ones are no trouble
        let diagonal = program.p.diagonal();
        let mean = (diagonal.iter().sum::<f64>() / diagonal.len().max(1) as f64).max(f64::MIN_POSITIVE);
        let columns: Vec<f64> = diagonal.iter().map(|d| d.max(1e-14 * mean).sqrt().recip()).collect();
        let load = program.q.iter().zip(&columns).fold(0.0f64, |m, (q, c)| m.max((q * c).abs()));
        let mut rows = vec![1.0; program.h.len()];
        for (start, cone) in program.cone_starts().into_iter().zip(&program.cones) {
            let range = start..start + cone.dim();
            let largest = range
                .clone()
                .flat_map(|r| program.g.row(r))
                .map(|(c, v)| (v * columns[c]).abs())
                .fold(0.0f64, f64::max);
            rows[range].fill(if largest > 0.0 { 1.0 / largest } else { 1.0 });
        }
        let offset = program.h.iter().zip(&rows).map(|(h, s)| (h * s).abs()).fold(0.0f64, f64::max);
        // the scaled loads are 1, or the largest gap is when nothing is loaded
        let size = if load > 0.0 {
            load
        } else if offset > 0.0 {
            offset
        } else {
            1.0
        };
        Self { columns, size, rows }
    }
}

/// Solves the program; `block` gives the block (node or face) of each unknown.
pub fn solve(program: &ConicProgram, block: &[u32], options: &SolveOptions) -> Solution {
    let start = Instant::now();
    if program.cones.is_empty() {
        return linear(program, block, start);
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
    let s = Scaling::new(program);
    let p = CscMatrix::new(
        program.p.n,
        program.p.n,
        program.p.col_ptr.clone(),
        program.p.row_idx.clone(),
        (0..program.p.n)
            .flat_map(|c| (program.p.col_ptr[c]..program.p.col_ptr[c + 1]).map(move |k| (c, k)))
            .map(|(c, k)| program.p.values[k] * s.columns[c] * s.columns[program.p.row_idx[k]])
            .collect(),
    );
    let q: Vec<f64> = program.q.iter().zip(&s.columns).map(|(v, c)| v * c / s.size).collect();
    let a = minus_columns(program, &s);
    let b: Vec<f64> = program.h.iter().zip(&s.rows).map(|(h, r)| h * r / s.size).collect();
    let cones: Vec<SupportedConeT<f64>> = program
        .cones
        .iter()
        .map(|c| match c {
            Cone::NonNegative => SupportedConeT::NonnegativeConeT(1),
            Cone::SecondOrder(n) => SupportedConeT::SecondOrderConeT(*n),
        })
        .collect();
    let settings = DefaultSettings {
        verbose: false,
        max_iter: options.max_iterations,
        time_limit: options.time_limit,
        tol_gap_abs: options.tolerance,
        tol_gap_rel: options.tolerance,
        tol_feas: options.tolerance,
        // sequential: deterministic, and the two programs run side by side
        max_threads: 1,
        direct_solve_method: "faer".into(),
        presolve_enable: false,
        ..DefaultSettings::default()
    };
    let failed = |status| Solution {
        status,
        x: vec![0.0; program.p.n],
        z: vec![0.0; program.h.len()],
        iterations: 0,
        seconds: start.elapsed().as_secs_f64(),
    };
    let Ok(mut solver) = DefaultSolver::new(&p, &q, &a, &b, &cones, settings) else {
        return failed(SolveStatus::NumericalError);
    };
    if let Some(tell) = options.progress.clone() {
        solver.set_termination_callback(move |info: &DefaultInfo<f64>| {
            tell(info.iterations, info.gap_rel, info.res_primal.max(info.res_dual));
            false
        });
    }
    solver.solve();
    let sol = &solver.solution;
    let status = match sol.status {
        SolverStatus::Solved => SolveStatus::Optimal,
        SolverStatus::DualInfeasible => SolveStatus::Unbounded,
        SolverStatus::PrimalInfeasible => SolveStatus::Infeasible,
        SolverStatus::AlmostSolved
        | SolverStatus::AlmostDualInfeasible
        | SolverStatus::AlmostPrimalInfeasible
        | SolverStatus::InsufficientProgress => SolveStatus::ReducedAccuracy,
        SolverStatus::MaxIterations => SolveStatus::IterationLimit,
        SolverStatus::MaxTime => SolveStatus::TimeLimit,
        SolverStatus::CallbackTerminated => SolveStatus::Interrupted,
        SolverStatus::NumericalError | SolverStatus::Unsolved => SolveStatus::NumericalError,
    };
    Solution {
        status,
        x: sol.x.iter().zip(&s.columns).map(|(x, c)| x * c * s.size).collect(),
        z: sol.z.iter().zip(&s.rows).map(|(z, r)| z * r * s.size).collect(),
        iterations: sol.iterations,
        seconds: start.elapsed().as_secs_f64(),
    }
}

/// True when `x = 0` satisfies every cone.
fn at_rest(program: &ConicProgram) -> bool {
    let starts = program.cone_starts().into_iter();
    starts.zip(&program.cones).all(|(s, c)| cone_margin(&program.h[s..s + c.dim()]) >= 0.0)
}

/// `−G` by columns, rows scaled: Clarabel's `A` in `A x + s = b`.
fn minus_columns(program: &ConicProgram, s: &Scaling) -> CscMatrix<f64> {
    let (rows, n) = (program.h.len(), program.p.n);
    let mut count = vec![0usize; n + 1];
    program.g.col_idx.iter().for_each(|&c| count[c + 1] += 1);
    for c in 0..n {
        count[c + 1] += count[c];
    }
    let mut next = count.clone();
    let mut row_idx = vec![0; program.g.col_idx.len()];
    let mut values = vec![0.0; program.g.col_idx.len()];
    for r in 0..rows {
        for (c, v) in program.g.row(r) {
            row_idx[next[c]] = r;
            values[next[c]] = -v * s.rows[r] * s.columns[c];
            next[c] += 1;
        }
    }
    CscMatrix::new(rows, n, count, row_idx, values)
}

fn linear(program: &ConicProgram, block: &[u32], start: Instant) -> Solution {
    let minus_q: Vec<f64> = program.q.iter().map(|x| -x).collect();
    let (status, x) = match SparseCholesky::new(&program.p, block) {
        Ok(factor) => (SolveStatus::Optimal, solve_refined(&program.p, &factor, &minus_q).0),
        Err(_) => (SolveStatus::NumericalError, vec![0.0; program.p.n]),
    };
    Solution { status, x, z: Vec::new(), iterations: 1, seconds: start.elapsed().as_secs_f64() }
}
