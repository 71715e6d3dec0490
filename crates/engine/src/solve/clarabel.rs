//! Clarabel (homogeneous embedding, Nesterov–Todd scaling) as the conic solver, with the kernels of
//! faer where the feature `faer-sparse` is on.
//!
//! Clarabel minimises. A saddle `½ xᵀPx + qᵀx + yᵀ(E x − b) − ½ yᵀFy`, with y maximised, becomes
//! `min ½ xᵀPx + qᵀx + ½ yᵀFy` subject to `E x − F y = b`. With w the multiplier of these
//! equations, stationarity reads `P x + q + Eᵀw = Gᵀz` and `F y = F w`. So w is the y of the
//! saddle, for regular and singular F; the y of the minimum equals it only where F is regular. The
//! rows `E x − F y` are the rows of y in the matrix of the saddle, and b is minus its q.

use super::scales::Scales;
use super::status::{Iteration, Solution, SolveOptions, SolveStatus};
use crate::programs::conic::{Cone, ConicProgram};
use crate::programs::explicit::Explicit;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultInfo, DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT,
};
use std::time::Instant;

/// Solves a program with at least one cone.
pub fn solve(program: &ConicProgram, options: &SolveOptions) -> Solution {
    let scales = Scales::new(program);
    let explicit = Explicit::new(&scales.apply(program));
    let Solution { mut x, mut z, status, iterations, seconds } = solve_explicit(&explicit, options);
    // the multipliers of the yield points follow the unknowns of the program
    let points = x.split_off(explicit.unknowns);
    z.truncate(explicit.rows);
    z.extend(points);
    Solution { status, x: scales.unscale_x(&x), z: scales.unscale_z(&z), iterations, seconds }
}

/// Solves a program written out.
fn solve_explicit(program: &Explicit, options: &SolveOptions) -> Solution {
    let start = Instant::now();
    let Minimum { p, q, a, b, equations } = Minimum::new(program);
    let equality = (equations > 0).then_some(SupportedConeT::ZeroConeT(equations));
    let cones: Vec<SupportedConeT<f64>> = equality
        .into_iter()
        .chain(program.cones.iter().map(|c| match c {
            Cone::NonNegative => SupportedConeT::NonnegativeConeT(1),
            Cone::SecondOrder(n) => SupportedConeT::SecondOrderConeT(*n),
        }))
        .collect();
    let stop = &options.stop;
    let [gap, residual] = [stop.gap, stop.residual].map(|t| t.max(stop.clarabel));
    let settings = DefaultSettings {
        verbose: false,
        max_iter: stop.max_iterations,
        time_limit: options.time_limit,
        tol_gap_abs: gap,
        tol_gap_rel: gap,
        tol_feas: residual,
        reduced_tol_gap_abs: stop.nearly * gap,
        reduced_tol_gap_rel: stop.nearly * gap,
        reduced_tol_feas: stop.nearly * residual,
        // sequential: deterministic, and the two programs run side by side
        max_threads: 1,
        direct_solve_method: if cfg!(feature = "faer-sparse") { "faer" } else { "qdldl" }.into(),
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
    let callback = options.clone();
    solver.set_termination_callback(move |info: &DefaultInfo<f64>| {
        if let Some(report) = &callback.progress {
            report(&Iteration {
                number: info.iterations,
                gap: info.gap_rel,
                residual: info.res_primal.max(info.res_dual),
                step: info.step_length,
                seconds: start.elapsed().as_secs_f64(),
            });
        }
        callback.interrupted()
    });
    solver.solve();
    let sol = &solver.solution;
    let status = match sol.status {
        SolverStatus::Solved => SolveStatus::Optimal,
        SolverStatus::DualInfeasible => SolveStatus::Unbounded,
        SolverStatus::PrimalInfeasible => SolveStatus::Infeasible,
        SolverStatus::AlmostSolved => SolveStatus::AlmostOptimal,
        SolverStatus::AlmostDualInfeasible
        | SolverStatus::AlmostPrimalInfeasible
        | SolverStatus::InsufficientProgress => SolveStatus::ReducedAccuracy,
        SolverStatus::MaxIterations => SolveStatus::IterationLimit,
        SolverStatus::MaxTime => SolveStatus::TimeLimit,
        SolverStatus::CallbackTerminated => SolveStatus::Interrupted,
        SolverStatus::NumericalError | SolverStatus::Unsolved => SolveStatus::NumericalError,
    };
    let mut x = sol.x.clone();
    // an unbounded direction has no multipliers
    if status != SolveStatus::Unbounded {
        let maximised = (0..x.len()).filter(|&i| program.is_maximised(i));
        maximised.zip(&sol.z[..equations]).for_each(|(i, w)| x[i] = *w);
    }
    let seconds = start.elapsed().as_secs_f64();
    Solution { status, x, z: sol.z[equations..].to_vec(), iterations: sol.iterations, seconds }
}

/// The form that Clarabel solves: `min ½ uᵀPu + qᵀu`, `b − A u ∈ {0}ᵐ × K`.
struct Minimum {
    p: CscMatrix<f64>,
    q: Vec<f64>,
    a: CscMatrix<f64>,
    b: Vec<f64>,
    /// Number m of equations.
    equations: usize,
}

impl Minimum {
    /// The minimum whose solution is the saddle point of a program.
    fn new(program: &Explicit) -> Self {
        let n = program.p.n;
        let mut row_of = vec![usize::MAX; n];
        let mut equations = 0;
        for i in (0..n).filter(|&i| program.is_maximised(i)) {
            row_of[i] = equations;
            equations += 1;
        }
        let mut rows: Vec<Vec<(usize, f64)>> = vec![Vec::new(); equations];
        let (mut col_ptr, mut row_idx, mut values) = (vec![0], Vec::new(), Vec::new());
        for c in 0..n {
            for k in program.p.col_ptr[c]..program.p.col_ptr[c + 1] {
                let (r, v) = (program.p.row_idx[k] as usize, program.p.values[k]);
                let (of_r, of_c) = (rows.get(row_of[r]).is_some(), rows.get(row_of[c]).is_some());
                if of_r == of_c {
                    row_idx.push(r);
                    values.push(if of_c { -v } else { v });
                }
                if of_c && v != 0.0 {
                    rows[row_of[c]].push((r, v));
                }
                if of_r && r != c && v != 0.0 {
                    rows[row_of[r]].push((c, v));
                }
            }
            col_ptr.push(row_idx.len());
        }
        let minus_g =
            (0..program.h.len()).map(|r| program.g.row(r).map(|(c, v)| (c, -v)).collect());
        rows.extend(minus_g);
        let maximised = |i: &usize| program.is_maximised(*i);
        let q = (0..n).map(|i| if maximised(&i) { 0.0 } else { program.q[i] }).collect();
        let b = (0..n)
            .filter(maximised)
            .map(|i| -program.q[i])
            .chain(program.h.iter().copied())
            .collect();
        Self {
            p: CscMatrix::new(n, n, col_ptr, row_idx, values),
            q,
            a: by_columns(&rows, n),
            b,
            equations,
        }
    }
}

/// The matrix of the given rows, by columns.
fn by_columns(rows: &[Vec<(usize, f64)>], n: usize) -> CscMatrix<f64> {
    let mut start = vec![0usize; n + 1];
    rows.iter().flatten().for_each(|&(c, _)| start[c + 1] += 1);
    for c in 0..n {
        start[c + 1] += start[c];
    }
    let mut next = start.clone();
    let mut row_idx = vec![0; start[n]];
    let mut values = vec![0.0; start[n]];
    for (r, row) in rows.iter().enumerate() {
        for &(c, v) in row {
            row_idx[next[c]] = r;
            values[next[c]] = v;
            next[c] += 1;
        }
    }
    CscMatrix::new(rows.len(), n, start, row_idx, values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::programs::conic::{Csr, SymmetricCsc};

    /// The upper triangle of a dense symmetric matrix.
    fn upper(a: &[&[f64]]) -> SymmetricCsc {
        let mut out = SymmetricCsc { n: a.len(), col_ptr: vec![0], ..SymmetricCsc::default() };
        for c in 0..a.len() {
            for r in 0..=c {
                out.row_idx.push(r as u32);
                out.values.push(a[r][c]);
            }
            out.col_ptr.push(out.row_idx.len());
        }
        out
    }

    /// `½ x₀² + ½ x₁² − x₀ + y₀(x₀ + x₁ − 1) + y₁(x₀ − x₁ − 4) − ½ f y₀²`, x₁ ≥ −1, with the
    /// unknowns in the order y₀, x₀, x₁, y₁. The second equation has no F: x₀ = x₁ + 4. By hand:
    /// the cone keeps x₁ at −1, so x₀ = 3 and f y₀ = 1. Stationarity: x₀ − 1 + y₀ + y₁ = 0 and
    /// x₁ + y₀ − y₁ = z. With f = 0 the first equation is exact as well, x = (2.5, −1.5), so the
    /// cone is moved to x₁ ≥ −2 there.
    #[test]
    fn multipliers_of_a_saddle() {
        for (f, floor, x0) in [(0.5, -1.0, 3.0), (0.0, -2.0, 2.5)] {
            let p = upper(&[
                &[-f, 1.0, 1.0, 0.0],
                &[1.0, 1.0, 0.0, 1.0],
                &[1.0, 0.0, 1.0, -1.0],
                &[0.0, 1.0, -1.0, 0.0],
            ]);
            let mut g = Csr { ncols: 4, ..Csr::default() };
            g.push_row(&[(2, 1.0)]);
            let program = Explicit {
                p,
                q: vec![-1.0, -1.0, 0.0, -4.0],
                g,
                h: vec![-floor],
                cones: vec![Cone::NonNegative],
                maximised: vec![true, false, false, true],
                unknowns: 4,
                rows: 1,
            };
            let s = solve_explicit(&program, &SolveOptions::default());
            assert_eq!(s.status, SolveStatus::Optimal);
            let [y0, x, x1, y1] = s.x[..] else { panic!("four unknowns") };
            assert!((x - x0).abs() < 1e-6 && (x1 - (x0 - 4.0)).abs() < 1e-6, "{:?}", s.x);
            // every row of the saddle, multipliers of the cone included
            let row = program.p.mul(&s.x);
            let z = program.g.mul_transpose(&s.z);
            for i in 0..4 {
                assert!(
                    (row[i] + program.q[i] - z[i]).abs() < 1e-6,
                    "row {i} at f = {f}: {:?} {:?}",
                    s.x,
                    s.z
                );
            }
            assert!((f * y0 - if f > 0.0 { 1.0 } else { 0.0 }).abs() < 1e-6, "{y0} {y1}");
            assert!(s.z[0] >= -1e-9 && (s.z[0] * (x1 - floor)).abs() < 1e-6);
        }
    }
}
