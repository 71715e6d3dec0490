//! The interior-point iteration: homogeneous embedding, predictor–corrector, one condensed factor per iteration.
//!
//! `min ½ xᵀPx + qᵀx`, `s = G x + h ∈ K` is embedded with τ, κ ≥ 0:
//! `Px − Gᵀz + qτ = 0`, `s = Gx + hτ`, `κ = −xᵀPx/τ − qᵀx − hᵀz`. A solution with τ > 0 gives x/τ, z/τ; κ > 0 gives a
//! certificate that the program is unbounded or infeasible.
//!
//! # Source
//! Goulart and Chen, Clarabel: an interior-point solver for conic programs with quadratic objectives (2024).

use super::cones::{Cones, Scaling};
use super::system::CondensedSystem;
use crate::model::program::ConicProgram;
use crate::solve::status::{Iteration, SolveOptions, SolveStatus};
use std::time::Instant;

/// Part of the way to the surface of the cone that a step may go.
const TO_THE_SURFACE: f64 = 0.99;
/// Passes of refinement on the full system at most.
const REFINEMENTS: usize = 3;
/// An iterate that stalls within this many times the tolerance is taken.
const NEARLY: f64 = 100.0;
/// Steps shorter than this make no progress; three of them end the iteration.
const SHORT_STEP: f64 = 1e-3;

/// An iterate.
#[derive(Clone, Debug)]
struct Point {
    x: Vec<f64>,
    s: Vec<f64>,
    z: Vec<f64>,
    tau: f64,
    kappa: f64,
}

/// A direction.
struct Direction {
    x: Vec<f64>,
    s: Vec<f64>,
    z: Vec<f64>,
    tau: f64,
    kappa: f64,
}

/// Residuals of the embedding at a point, and what the stopping rules need.
struct Residuals {
    f1: Vec<f64>,
    f2: Vec<f64>,
    f3: f64,
    px: Vec<f64>,
    xpx: f64,
    qx: f64,
    hz: f64,
    gap: f64,
    dual: f64,
    primal: f64,
}

/// What the iteration returns.
pub struct Outcome {
    /// How it ended.
    pub status: SolveStatus,
    /// Unknowns, or the certificate's direction.
    pub x: Vec<f64>,
    /// Multipliers.
    pub z: Vec<f64>,
    /// Iterations.
    pub iterations: u32,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn largest(a: &[f64]) -> f64 {
    a.iter().fold(0.0, |m, x| m.max(x.abs()))
}

fn residuals(program: &ConicProgram, p: &Point) -> Residuals {
    let px = program.p.mul(&p.x);
    let gz = program.g.mul_transpose(&p.z);
    let gx = program.g.mul(&p.x);
    let n = p.x.len();
    let f1: Vec<f64> = (0..n).map(|i| px[i] - gz[i] + program.q[i] * p.tau).collect();
    let f2: Vec<f64> = (0..p.s.len()).map(|r| p.s[r] - gx[r] - program.h[r] * p.tau).collect();
    let (xpx, qx, hz) = (dot(&p.x, &px), dot(&program.q, &p.x), dot(&program.h, &p.z));
    let t = p.tau;
    let (po, dual_objective) = (0.5 * xpx / (t * t) + qx / t, -0.5 * xpx / (t * t) - hz / t);
    let gap = (po - dual_objective).abs() / po.abs().min(dual_objective.abs()).max(1e-300);
    let dual_scale = largest(&program.q).max(largest(&px) / t).max(largest(&gz) / t);
    let primal_scale = largest(&program.h).max(largest(&gx) / t).max(largest(&p.s) / t);
    Residuals {
        dual: largest(&f1) / (t * dual_scale.max(1e-300)),
        primal: largest(&f2) / (t * primal_scale.max(1e-300)),
        f3: xpx / t + qx + hz + p.kappa,
        f1,
        f2,
        px,
        xpx,
        qx,
        hz,
        gap,
    }
}

/// A certificate in the point, if there is one.
fn certificate(program: &ConicProgram, p: &Point, r: &Residuals, tolerance: f64) -> Option<SolveStatus> {
    if r.qx < 0.0 {
        // G x − s without the τ term
        let off: Vec<f64> = r.f2.iter().zip(&program.h).map(|(f, h)| f + h * p.tau).collect();
        let unit = -r.qx / largest(&program.q).max(1e-300);
        if largest(&r.px) <= tolerance * -r.qx && largest(&off) <= tolerance * unit.max(largest(&p.s)) {
            return Some(SolveStatus::Unbounded);
        }
    }
    if r.hz < 0.0 {
        let off: Vec<f64> = (0..p.x.len()).map(|i| r.px[i] - r.f1[i] + program.q[i] * p.tau).collect();
        if largest(&off) <= tolerance * -r.hz {
            return Some(SolveStatus::Infeasible);
        }
    }
    None
}

/// Iterates on a scaled program.
pub fn iterate(
    program: &ConicProgram,
    cones: &Cones,
    system: &mut CondensedSystem,
    options: &SolveOptions,
    start: Instant,
) -> Outcome {
    if system.factor_start(cones).is_err() {
        let (x, z) = (vec![0.0; program.p.n], vec![0.0; cones.rows]);
        return Outcome { status: SolveStatus::NumericalError, x, z, iterations: 0 };
    }
    let mut p = starting_point(program, cones, system);
    let mut last_step = 0.0;
    let degree = cones.degree() + 1.0;
    let (mut best, mut short, mut worse) = (p.clone(), 0, 0);
    let mut best_merit = f64::INFINITY;
    let end = |status, p: Point, iterations| {
        let t = if status == SolveStatus::Unbounded || status == SolveStatus::Infeasible { 1.0 } else { p.tau };
        Outcome { status, x: p.x.iter().map(|v| v / t).collect(), z: p.z.iter().map(|v| v / t).collect(), iterations }
    };
    // the best iterate is an answer when it is nearly as good as asked for; the fields are certified in any case
    let stop = |status, best: Point, merit: f64, iteration| {
        let good = merit <= NEARLY * options.tolerance && !matches!(status, SolveStatus::TimeLimit);
        end(if good { SolveStatus::Optimal } else { status }, best, iteration)
    };
    for iteration in 0..=options.max_iterations {
        let r = residuals(program, &p);
        let merit = r.gap.max(r.dual).max(r.primal);
        if let Some(tell) = &options.progress {
            let residual = r.dual.max(r.primal);
            let seconds = start.elapsed().as_secs_f64();
            tell(&Iteration { number: iteration, gap: r.gap, residual, step: last_step, seconds });
        }
        if merit <= options.tolerance {
            return end(SolveStatus::Optimal, p, iteration);
        }
        if let Some(status) = certificate(program, &p, &r, options.tolerance) {
            return end(status, p, iteration);
        }
        if merit < best_merit {
            (best_merit, best, worse) = (merit, p.clone(), 0);
        } else if best_merit <= NEARLY * options.tolerance {
            // good enough and no longer getting better: the floor of the arithmetic
            worse += 1;
            if worse == 2 {
                return stop(SolveStatus::ReducedAccuracy, best, best_merit, iteration);
            }
        }
        if iteration == options.max_iterations {
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
        if system.factor(cones, &scaling, 0.0).is_err() && system.factor(cones, &scaling, 1e-10).is_err() {
            return stop(SolveStatus::NumericalError, best, best_merit, iteration);
        }
        let mu = (dot(&p.s, &p.z) + p.tau * p.kappa) / degree;
        let newton = Newton::new(program, cones, &scaling, system, &p, &r);
        let ll = cones.product(&scaling.lambda, &scaling.lambda);
        let affine = newton.solve(&ll, p.kappa * p.tau, 0.0);
        let a = newton.step(&affine).min(1.0);
        let sigma = (1.0 - a).powi(3);
        let cross = cones.product(&scaling.apply_inverse(cones, &affine.s), &scaling.apply(cones, &affine.z));
        let identity = cones.identity();
        let ds: Vec<f64> = (0..ll.len()).map(|i| ll[i] + cross[i] - sigma * mu * identity[i]).collect();
        let dk = p.kappa * p.tau + affine.kappa * affine.tau - sigma * mu;
        let d = newton.solve(&ds, dk, sigma);
        let a = (TO_THE_SURFACE * newton.step(&d)).min(1.0);
        if !a.is_finite() || d.x.iter().any(|v| !v.is_finite()) {
            return stop(SolveStatus::NumericalError, best, best_merit, iteration);
        }
        last_step = a;
        short = if a < SHORT_STEP { short + 1 } else { 0 };
        if short == 3 {
            return stop(SolveStatus::ReducedAccuracy, best, best_merit, iteration);
        }
        for (v, d) in [(&mut p.x, &d.x), (&mut p.s, &d.s), (&mut p.z, &d.z)] {
            v.iter_mut().zip(d).for_each(|(v, d)| *v += a * d);
        }
        p.tau += a * d.tau;
        p.kappa += a * d.kappa;
        // the embedding is homogeneous: keep its scale near one
        let scale = 1.0 / p.tau.max(p.kappa);
        for v in [&mut p.x, &mut p.s, &mut p.z] {
            v.iter_mut().for_each(|v| *v *= scale);
        }
        p.tau *= scale;
        p.kappa *= scale;
    }
    stop(SolveStatus::IterationLimit, best, best_merit, options.max_iterations)
}

/// `min ½ xᵀPx + qᵀx + ½‖s‖²` over `s = Gx + h`, then slacks and multipliers pushed inside.
fn starting_point(program: &ConicProgram, cones: &Cones, system: &CondensedSystem) -> Point {
    let gh = program.g.mul_transpose(&program.h);
    let rhs: Vec<f64> = program.q.iter().zip(&gh).map(|(q, g)| -q - g).collect();
    let x = system.solve(&rhs);
    let s = program.slack(&x);
    let z: Vec<f64> = s.iter().map(|v| -v).collect();
    let inside = |mut v: Vec<f64>| {
        let margins: Vec<f64> =
            cones.blocks.iter().map(|&(at, d)| crate::model::program::cone_margin(&v[at..at + d])).collect();
        let worst = margins.iter().fold(f64::INFINITY, |m, x| m.min(*x));
        let mean = margins.iter().map(|m| m.max(0.0)).sum::<f64>() / cones.degree().max(1.0);
        let target = (0.1 * mean).max(1e-2 * largest(&v)).max(1e-8);
        if worst < target {
            cones.blocks.iter().for_each(|&(at, _)| v[at] += target - worst);
        }
        v
    };
    Point { x, s: inside(s), z: inside(z), tau: 1.0, kappa: 1.0 }
}

/// Newton's system of one iteration.
struct Newton<'a> {
    program: &'a ConicProgram,
    cones: &'a Cones,
    scaling: &'a Scaling,
    system: &'a CondensedSystem,
    point: &'a Point,
    r: &'a Residuals,
    /// Solution for the right-hand side `[−q; h]`.
    x2: Vec<f64>,
    z2: Vec<f64>,
    /// `2 P x/τ + q`.
    slope: Vec<f64>,
    denominator: f64,
}

impl<'a> Newton<'a> {
    fn new(
        program: &'a ConicProgram,
        cones: &'a Cones,
        scaling: &'a Scaling,
        system: &'a CondensedSystem,
        point: &'a Point,
        r: &'a Residuals,
    ) -> Self {
        let t = point.tau;
        let slope: Vec<f64> = r.px.iter().zip(&program.q).map(|(p, q)| 2.0 * p / t + q).collect();
        let mut n = Self { program, cones, scaling, system, point, r, x2: vec![], z2: vec![], slope, denominator: 0.0 };
        let minus_q: Vec<f64> = program.q.iter().map(|q| -q).collect();
        (n.x2, n.z2) = n.kkt(&minus_q, &program.h);
        n.denominator = dot(&n.slope, &n.x2) + dot(&program.h, &n.z2) - r.xpx / (t * t) - point.kappa / t;
        n
    }

    /// `P dx − Gᵀ dz = r1`, `−G dx − W² dz = r2`, refined on this full residual: the condensed matrix alone loses the
    /// small multipliers in the rounding of the large `W⁻²`.
    fn kkt(&self, r1: &[f64], r2: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let (mut dx, mut dz) = self.condensed(r1, r2);
        let mut last = f64::INFINITY;
        for _ in 0..REFINEMENTS {
            let (px, gz, gx) = (self.program.p.mul(&dx), self.program.g.mul_transpose(&dz), self.program.g.mul(&dx));
            let e1: Vec<f64> = (0..r1.len()).map(|i| r1[i] - px[i] + gz[i]).collect();
            let w2 = self.scaling.apply(self.cones, &self.scaling.apply(self.cones, &dz));
            let e2: Vec<f64> = (0..r2.len()).map(|i| r2[i] + gx[i] + w2[i]).collect();
            let error = largest(&e1);
            if error >= 0.5 * last || error <= 1e-13 * largest(r1) {
                break;
            }
            last = error;
            let (cx, cz) = self.condensed(&e1, &e2);
            dx.iter_mut().zip(&cx).for_each(|(a, b)| *a += b);
            dz.iter_mut().zip(&cz).for_each(|(a, b)| *a += b);
        }
        (dx, dz)
    }

    /// The same through the condensed factor, without refinement.
    fn condensed(&self, r1: &[f64], r2: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let inverse_square =
            |v: &[f64]| self.scaling.apply_inverse(self.cones, &self.scaling.apply_inverse(self.cones, v));
        let g = self.program.g.mul_transpose(&inverse_square(r2));
        let rhs: Vec<f64> = r1.iter().zip(&g).map(|(a, b)| a - b).collect();
        let dx = self.system.solve(&rhs);
        let v: Vec<f64> = self.program.g.mul(&dx).iter().zip(r2).map(|(g, r)| -g - r).collect();
        (dx, inverse_square(&v))
    }

    /// The direction that removes the fraction `1 − σ` of the residuals, with complementarity right-hand sides `ds`, `dk`.
    fn solve(&self, ds: &[f64], dk: f64, sigma: f64) -> Direction {
        let (p, r) = (self.point, self.r);
        let keep = 1.0 - sigma;
        let back = self.scaling.apply(self.cones, &self.cones.divide(&self.scaling.lambda, ds));
        let r1: Vec<f64> = r.f1.iter().map(|f| -keep * f).collect();
        let r2: Vec<f64> = r.f2.iter().zip(&back).map(|(f, b)| b - keep * f).collect();
        let (x1, z1) = self.kkt(&r1, &r2);
        let tau = (-keep * r.f3 + dk / p.tau - dot(&self.slope, &x1) - dot(&self.program.h, &z1)) / self.denominator;
        let x: Vec<f64> = x1.iter().zip(&self.x2).map(|(a, b)| a + tau * b).collect();
        let z: Vec<f64> = z1.iter().zip(&self.z2).map(|(a, b)| a + tau * b).collect();
        // the slack row holds exactly: s = G x + h τ with the residual shrunk
        let gx = self.program.g.mul(&x);
        let s = (0..ds.len()).map(|i| gx[i] + self.program.h[i] * tau - keep * r.f2[i]).collect();
        let kappa = -(dk + p.kappa * tau) / p.tau;
        Direction { x, s, z, tau, kappa }
    }

    /// Largest step that stays in the cones.
    fn step(&self, d: &Direction) -> f64 {
        let p = self.point;
        let along = |v: f64, dv: f64| if dv < 0.0 { -v / dv } else { f64::INFINITY };
        let limit = along(p.tau, d.tau).min(along(p.kappa, d.kappa)).min(1e3);
        let limit = self.cones.largest_step(&p.s, &d.s, limit);
        self.cones.largest_step(&p.z, &d.z, limit)
    }
}
