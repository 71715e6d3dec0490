//! Clarabel (homogeneous embedding, Nesterov–Todd) as the conic solver, with faer's sparse kernels.

use super::scales::Scales;
use super::status::{Iteration, Solution, SolveOptions, SolveStatus};
use crate::model::program::{Cone, ConicProgram};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultInfo, DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use std::time::Instant;

/// Solves a program with at least one cone.
pub fn solve(program: &ConicProgram, options: &SolveOptions) -> Solution {
    let start = Instant::now();
    let scales = Scales::new(program);
    let scaled = scales.apply(program);
    let a = minus_columns(&scaled);
    let rows = scaled.p.row_idx.iter().map(|&r| r as usize).collect();
    let p = CscMatrix::new(scaled.p.n, scaled.p.n, scaled.p.col_ptr, rows, scaled.p.values);
    let cones: Vec<SupportedConeT<f64>> = program
        .cones
        .iter()
        .map(|c| match c {
            Cone::NonNegative => SupportedConeT::NonnegativeConeT(1),
            Cone::SecondOrder(n) => SupportedConeT::SecondOrderConeT(*n),
        })
        .collect();
    // below 1e-8 Clarabel mostly runs into its own noise
    let (gap, residual) = (options.gap.max(1e-8), options.residual.max(1e-8));
    let settings = DefaultSettings {
        verbose: false,
        max_iter: options.max_iterations,
        time_limit: options.time_limit,
        tol_gap_abs: gap,
        tol_gap_rel: gap,
        tol_feas: residual,
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
    let Ok(mut solver) = DefaultSolver::new(&p, &scaled.q, &a, &scaled.h, &cones, settings) else {
        return failed(SolveStatus::NumericalError);
    };
    let told = options.clone();
    solver.set_termination_callback(move |info: &DefaultInfo<f64>| {
        if let Some(tell) = &told.progress {
            tell(&Iteration {
                number: info.iterations,
                gap: info.gap_rel,
                residual: info.res_primal.max(info.res_dual),
                step: info.step_length,
                seconds: start.elapsed().as_secs_f64(),
            });
        }
        told.interrupted()
    });
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
        x: scales.unscale_x(&sol.x),
        z: scales.unscale_z(&sol.z),
        iterations: sol.iterations,
        seconds: start.elapsed().as_secs_f64(),
    }
}

/// `−G` by columns: Clarabel's `A` in `A x + s = b`.
fn minus_columns(program: &ConicProgram) -> CscMatrix<f64> {
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
            values[next[c]] = -v;
            next[c] += 1;
        }
    }
    CscMatrix::new(rows, n, count, row_idx, values)
}
