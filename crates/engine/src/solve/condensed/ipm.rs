//! The interior-point iteration: homogeneous embedding, predictor–corrector, one condensed factor
//! per iteration.
//!
//! `min ½ xᵀPx + qᵀx`, `s = G x + h ∈ K` is embedded with τ, κ ≥ 0:
//! `Px − Gᵀz + qτ = 0`, `s = Gx + hτ`, `κ = −xᵀPx/τ − qᵀx − hᵀz`. A solution with τ > 0 gives x/τ,
//! z/τ; κ > 0 gives a certificate that the program is unbounded or infeasible. Rows of maximised
//! unknowns y enter with their natural sign (`E x − F y − b τ = 0`); in the scalar row and in the
//! objectives they count with the opposite one.
//!
//! # Source
//! Goulart and Chen, Clarabel: an interior-point solver for conic programs with quadratic
//! objectives (2024).

use super::cones::Scaling;
use super::newton::Newton;
use super::point::Point;
use super::residuals::{certificate, residuals};
use super::scaled_program::ScaledProgram;
use super::settings::Settings;
use super::start::starting_point;
use super::system::CondensedSystem;
use super::targets::Targets;
use super::vectors::{add, dot, scale};
use crate::solve::status::{Iteration, SolveOptions, SolveStatus};
use std::time::Instant;

/// Result of the iteration.
pub struct IpmResult {
    /// How the iteration ended.
    pub status: SolveStatus,
    /// Unknowns, or the direction of a certificate.
    pub x: Vec<f64>,
    /// Multipliers.
    pub z: Vec<f64>,
    /// Number of iterations.
    pub iterations: u32,
}

/// Runs the iteration on a scaled program.
pub fn iterate(
    problem: &ScaledProgram,
    system: &mut CondensedSystem,
    options: &SolveOptions,
    start: Instant,
) -> IpmResult {
    let cones = &problem.cones;
    if system.factor_start(problem).is_err() {
        let (x, z) = (vec![0.0; problem.program.unknowns()], vec![0.0; cones.rows]);
        return IpmResult { status: SolveStatus::NumericalError, x, z, iterations: 0 };
    }
    let settings = Settings::of(problem.is_limit());
    let (mut p, reference) = starting_point(problem, settings, system);
    let mut last_step = 0.0;
    let degree = cones.degree() + 1.0;
    let (mut best, mut short, mut worse) = (p.clone(), 0, 0);
    let mut best_merit = f64::INFINITY;
    let end = |status, p: Point, iterations| {
        let t = if status == SolveStatus::Unbounded || status == SolveStatus::Infeasible {
            1.0
        } else {
            p.tau
        };
        IpmResult {
            status,
            x: p.x.iter().map(|v| v / t).collect(),
            z: p.z.iter().map(|v| v / t).collect(),
            iterations,
        }
    };
    let rules = &options.stop;
    // the best iterate is a solution when it is nearly as good as the tolerances ask; the fields
    // are certified in any case
    let nearly = rules.nearly(problem.is_limit());
    let cut_off = rules.cut_off(problem.is_limit());
    let stop = |status, best: Point, merit: f64, iteration| {
        let enough = if status == SolveStatus::TimeLimit { cut_off } else { nearly };
        let status = if merit <= enough { SolveStatus::AlmostOptimal } else { status };
        end(status, best, iteration)
    };
    let mut merits = Vec::new();
    for iteration in 0..=rules.max_iterations {
        let r = residuals(problem, settings, &p, reference);
        // 1 at the tolerances
        let dual = r.dual / rules.residual.max(rules.unbalanced);
        let merit = (r.gap / rules.gap).max(dual).max(r.primal / rules.residual);
        if let Some(report) = &options.progress {
            let residual = r.dual.max(r.primal);
            let seconds = start.elapsed().as_secs_f64();
            report(&Iteration {
                number: iteration,
                gap: r.gap,
                residual,
                step: last_step,
                seconds,
            });
        }
        if merit <= 1.0 {
            return end(SolveStatus::Optimal, p, iteration);
        }
        if let Some(status) = certificate(problem, rules, &p, &r) {
            return end(status, p, iteration);
        }
        if merit < best_merit {
            (best_merit, best, worse) = (merit, p.clone(), 0);
        } else if best_merit <= nearly {
            worse += 1;
            if worse == rules.not_better {
                return stop(SolveStatus::ReducedAccuracy, best, best_merit, iteration);
            }
        }
        merits.push(best_merit);
        if best_merit <= cut_off && rules.crawls(&merits) {
            return end(SolveStatus::AlmostOptimal, best, iteration);
        }
        if iteration == rules.max_iterations {
            return stop(SolveStatus::IterationLimit, best, best_merit, iteration);
        }
        if options.interrupted() {
            return stop(SolveStatus::Interrupted, best, best_merit, iteration);
        }
        if start.elapsed().as_secs_f64() > options.time_limit {
            return stop(SolveStatus::TimeLimit, best, best_merit, iteration);
        }
        let Some(scaling) = Scaling::new(cones, &p.s, &p.z) else {
            return stop(SolveStatus::ReducedAccuracy, best, best_merit, iteration);
        };
        if system.factor(problem, &scaling, 0.0).is_err()
            && system.factor(problem, &scaling, settings.raised_diagonal).is_err()
        {
            return stop(SolveStatus::NumericalError, best, best_merit, iteration);
        }
        let mu = (dot(&p.s, &p.z) + p.tau * p.kappa) / degree;
        let ll = cones.product(&scaling.lambda, &scaling.lambda);
        let (newton, affine) = Newton::new(problem, &scaling, system, &p, &r, &ll);
        let a = newton.step(&affine).min(1.0);
        let targets = if problem.is_limit() {
            Targets::own(cones, newton.own_steps(&affine), mu)
        } else {
            Targets::common(cones, a, mu)
        };
        let d = newton.corrected(&affine, &ll, &targets);
        let a = (settings.fraction_to_boundary * newton.step(&d)).min(1.0);
        if !a.is_finite() || d.x.iter().any(|v| !v.is_finite()) {
            return stop(SolveStatus::NumericalError, best, best_merit, iteration);
        }
        last_step = a;
        short = if a < rules.short_step { short + 1 } else { 0 };
        if short == rules.short_steps {
            return stop(SolveStatus::ReducedAccuracy, best, best_merit, iteration);
        }
        for (v, d) in [(&mut p.x, &d.x), (&mut p.s, &d.s), (&mut p.z, &d.z)] {
            add(v, a, d);
        }
        p.tau += a * d.tau;
        p.kappa += a * d.kappa;
        // the embedding is homogeneous: its scale is kept near one
        let size = 1.0 / p.tau.max(p.kappa);
        for v in [&mut p.x, &mut p.s, &mut p.z] {
            scale(v, size);
        }
        p.tau *= size;
        p.kappa *= size;
    }
    stop(SolveStatus::IterationLimit, best, best_merit, rules.max_iterations)
}
