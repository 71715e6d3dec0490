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

use super::cones::{Scaling, dot};
use super::correction::Correction;
use super::scaled_program::{ScaledProgram, largest};
use super::system::{CondensedSystem, Solved};
use super::targets::Targets;
use crate::solve::condensed::static_condensation::Side;
use crate::solve::status::{Iteration, SolveOptions, SolveStatus};
use std::time::Instant;

/// Part of the way to the surface of the cone that a step may go.
const TO_THE_SURFACE: f64 = 0.99;
/// Passes of refinement on the full system at most.
const REFINEMENTS: usize = 6;
/// A pass that leaves this part of the error or more is the last.
const STALLED: f64 = 0.9;
/// Error of a direction's stationarity rows, as a part of the residual it is to remove, that needs
/// no refinement; in limit analysis, where a refinement costs a tenth of the iteration, the larger
/// one (as many iterations, an eighth of the solves less).
const DIRECTION_ERROR: f64 = 0.01;
const LIMIT_DIRECTION_ERROR: f64 = 0.1;
/// Centrality correctors at most in an iteration; of limit analysis, where contacts end steps
/// early.
const CORRECTORS: usize = 2;
const LIMIT_CORRECTORS: usize = 8;
/// Operations of a factorisation for each nonzero of the factor from which on correctors pay: a
/// solve, with what goes with it, then costs less than a tenth of a factor.
const DENSE_FACTOR: f64 = 1500.0;
/// Parts of the second-order term that are tried.
const SECOND_ORDER: [f64; 6] = [1.0, 0.75, 0.5, 0.25, 0.1, 0.0];
/// Steps as long as this need no corrector.
const LONG_STEP: f64 = 0.97;
/// How much longer a step a corrector aims at, and the part of that it must gain.
const LONGER: f64 = 0.3;
const WORTH: f64 = 0.1;
/// Complementarity products within these multiples of the target are well centred.
const CENTRE: (f64, f64) = (0.1, 10.0);
/// An iterate that stalls within this many times the tolerances is taken; in limit analysis they
/// are rough as they are.
const NEARLY: f64 = 100.0;
const LIMIT_NEARLY: f64 = 10.0;
/// A certificate's residuals at most, however rough a solution may be.
const CERTAIN: f64 = 1e-8;
/// A certificate is accepted with residuals this many times larger once κ is so many times τ: the
/// embedding has decided.
const DECIDED: (f64, f64) = (100.0, 1e3);
/// Part of the load factor at first yield below which a factor is as good as zero: gap and
/// residuals are measured there by what they would be at that part. Where a mesh's stresses carry
/// no load at all, forces and objective vanish together.
const NOTHING: f64 = 1e-3;
/// Velocities of contacts and what presses them at the start of limit analysis, beside the mean of
/// the yield points. Most contacts of a mechanism open, at hundreds of times that velocity; started
/// alike, each of them has to lose its pressure on the way, and a few of them at a time end the
/// steps (static program of the paper's joint with 13 000 tets: 47 iterations, now 26; the pairs
/// (30, 0.1) takes 31, and (100, 0.01) on other joints an eighth to a quarter more than this one).
const OPENING: f64 = 100.0;
const PRESSURE: f64 = 0.1;
/// Elastic stress at a load factor of one below which there is no such load factor.
const UNSTRESSED: f64 = 1e-9;
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

impl Direction {
    /// `self + part · other`.
    fn plus(&self, part: f64, other: &Self) -> Self {
        let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + part * b).collect();
        Self {
            x: sum(&self.x, &other.x),
            s: sum(&self.s, &other.s),
            z: sum(&self.z, &other.z),
            tau: self.tau + part * other.tau,
            kappa: self.kappa + part * other.kappa,
        }
    }
}

/// Residuals of the embedding at a point, and what the stopping rules need.
struct Residuals {
    f1: Vec<f64>,
    f2: Vec<f64>,
    f3: f64,
    px: Vec<f64>,
    /// The blocks of P on its diagonal times x.
    diagonal: Vec<f64>,
    xpx: f64,
    /// Linear terms of the scalar row: `qᵀx + bᵀy`.
    cx: f64,
    hz: f64,
    gap: f64,
    dual: f64,
    primal: f64,
}

/// What the iteration returns.
pub struct IpmResult {
    /// How it ended.
    pub status: SolveStatus,
    /// Unknowns, or the certificate's direction.
    pub x: Vec<f64>,
    /// Multipliers.
    pub z: Vec<f64>,
    /// Iterations.
    pub iterations: u32,
}

/// Residuals; `reference`: the load factor that a load factor of zero is told by, 0 without one.
fn residuals(problem: &ScaledProgram, p: &Point, reference: f64) -> Residuals {
    let (q, h) = (&problem.program.q, &problem.program.h);
    let diagonal = problem.program.quadratic_diagonal(&p.x);
    let mut px = diagonal.clone();
    problem.program.add_coupling(&p.x, &mut px);
    let gz = problem.program.rows_transposed(&p.z);
    let gx = problem.program.rows(&p.x);
    let n = p.x.len();
    let f1: Vec<f64> = (0..n).map(|i| px[i] - gz[i] + q[i] * p.tau).collect();
    let f2: Vec<f64> = (0..p.s.len()).map(|r| p.s[r] - gx[r] - h[r] * p.tau).collect();
    let (xpx, cx, hz) = (problem.signed_dot(&p.x, &px), problem.signed_dot(q, &p.x), dot(h, &p.z));
    let t = p.tau;
    // what belongs to the maximiser: its linear terms, and the yield points
    let by = if problem.saddle { -dot(&problem.part(q, true), &p.x) } else { 0.0 };
    let yielding = dot(&h[problem.points..], &p.z[problem.points..]);
    let po = 0.5 * xpx / (t * t) + (cx - by + yielding) / t;
    let dual_objective = -0.5 * xpx / (t * t) - (hz - yielding + by) / t;
    let floor = NOTHING * reference;
    let least = floor * q.last().map_or(0.0, |q| q.abs());
    let gap =
        (po - dual_objective).abs() / po.abs().min(dual_objective.abs()).max(least).max(1e-300);
    let sizes = [q, &px, &gz].map(|v| problem.largest_of_kinds(v));
    let off = problem.largest_of_kinds(&f1);
    let live = problem.live_force(&p.x);
    let least = floor * largest(&problem.program.live);
    let scale = |k: usize| {
        sizes[0][k].max(sizes[1][k] / t).max(sizes[2][k] / t).max(live / t).max(least).max(1e-300)
    };
    // closed contacts have neither slack nor gap; rows are of unit size, so the unknowns are a
    // measure as well
    let primal_scale = largest(&problem.program.h).max(largest(&p.s) / t).max(largest(&p.x) / t);
    Residuals {
        dual: (off[0] / (t * scale(0))).max(off[1] / (t * scale(1))),
        primal: largest(&f2) / (t * primal_scale.max(1e-300)),
        f3: xpx / t + cx + hz + p.kappa,
        f1,
        f2,
        px,
        diagonal,
        xpx,
        cx,
        hz,
        gap,
    }
}

/// A certificate in the point, if there is one.
fn certificate(
    problem: &ScaledProgram,
    p: &Point,
    r: &Residuals,
    tolerance: f64,
) -> Option<SolveStatus> {
    if r.cx + r.hz + r.xpx / p.tau >= 0.0 {
        return None;
    }
    let tolerance = if p.kappa > DECIDED.1 * p.tau { DECIDED.0 * tolerance } else { tolerance };
    let (q, h) = (&problem.program.q, &problem.program.h);
    // G x − s without the τ term, of the cones of one side
    let off = |points: bool| {
        let rows = if points { problem.points..h.len() } else { 0..problem.points };
        rows.fold(0.0, |m: f64, i| m.max((r.f2[i] + h[i] * p.tau).abs()))
    };
    // stationarity rows of one side's unknowns and of the other side's multipliers, without the τ
    // term
    let stationarity = |maximised: bool| {
        if !problem.saddle && !maximised {
            return largest(&r.px);
        }
        let mut rows = problem.program.rows_transposed(&problem.rows_part(&p.z, !maximised));
        if problem.saddle {
            let [px] = problem.program.quadratic([&problem.part(&p.x, maximised)]);
            rows.iter_mut().zip(&px).for_each(|(o, v)| *o -= v);
        }
        largest(&rows)
    };
    let falls =
        dot(q, &problem.part(&p.x, false)) + dot(&h[problem.points..], &p.z[problem.points..]);
    if falls < 0.0 {
        let unit = -falls / largest(q).max(1e-300);
        if stationarity(false) <= tolerance * -falls
            && off(false) <= tolerance * unit.max(largest(&p.s))
        {
            return Some(SolveStatus::Unbounded);
        }
    }
    let works =
        dot(&h[..problem.points], &p.z[..problem.points]) - dot(q, &problem.part(&p.x, true));
    if works < 0.0 && stationarity(true) <= tolerance * -works {
        let unit = -works / largest(q).max(1e-300);
        if off(true) <= tolerance * unit.max(largest(&p.s)) {
            return Some(SolveStatus::Infeasible);
        }
    }
    None
}

/// Iterates on a scaled problem.
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
    let (mut p, reference) = starting_point(problem, system);
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
    // the best iterate is an answer when it is nearly as good as asked for; the fields are
    // certified in any case
    let nearly = if problem.program.live.is_empty() { NEARLY } else { LIMIT_NEARLY };
    let stop = |status, best: Point, merit: f64, iteration| {
        let good = merit <= nearly && !matches!(status, SolveStatus::TimeLimit);
        end(if good { SolveStatus::Optimal } else { status }, best, iteration)
    };
    for iteration in 0..=options.max_iterations {
        let r = residuals(problem, &p, reference);
        // 1 is what was asked for
        let dual = r.dual / options.residual.max(options.unbalanced);
        let merit = (r.gap / options.gap).max(dual).max(r.primal / options.residual);
        if let Some(tell) = &options.progress {
            let residual = r.dual.max(r.primal);
            let seconds = start.elapsed().as_secs_f64();
            tell(&Iteration { number: iteration, gap: r.gap, residual, step: last_step, seconds });
        }
        if merit <= 1.0 {
            return end(SolveStatus::Optimal, p, iteration);
        }
        if let Some(status) = certificate(problem, &p, &r, options.residual.min(CERTAIN)) {
            return end(status, p, iteration);
        }
        if merit < best_merit {
            (best_merit, best, worse) = (merit, p.clone(), 0);
        } else if best_merit <= nearly {
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
        if system.factor(problem, &scaling, 0.0).is_err()
            && system.factor(problem, &scaling, 1e-10).is_err()
        {
            return stop(SolveStatus::NumericalError, best, best_merit, iteration);
        }
        let mu = (dot(&p.s, &p.z) + p.tau * p.kappa) / degree;
        let ll = cones.product(&scaling.lambda, &scaling.lambda);
        let (newton, affine) = Newton::new(problem, &scaling, system, &p, &r, &ll);
        let a = newton.step(&affine).min(1.0);
        let targets = if problem.program.live.is_empty() {
            Targets::common(cones, a, mu)
        } else {
            Targets::own(cones, newton.own_steps(&affine), mu)
        };
        let d = newton.corrected(&affine, &ll, &targets);
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

/// `min ½ xᵀPx + qᵀx + ½‖s‖²` over `s = Gx + h`, then slacks and multipliers pushed inside; and the
/// load factor at which that elastic stress would reach the yield surface, 0 where it never does.
fn starting_point(problem: &ScaledProgram, system: &CondensedSystem) -> (Point, f64) {
    let cones = &problem.cones;
    let minus_q: Vec<f64> = problem.program.q.iter().map(|q| -q).collect();
    let [Solved { x, .. }] = system.solve::<1, false>(
        problem,
        &Scaling::identity(cones),
        [(&minus_q, &problem.program.h)],
    );
    let s = problem.program.slack(&x);
    let reference = match (problem.program.live.is_empty(), x.last()) {
        (false, Some(factor)) => {
            let yields = cones.blocks.iter().filter(|b| b.0 >= problem.points);
            let stress = yields
                .fold(0.0, |m: f64, &(at, d)| m.max(dot(&s[at + 1..at + d], &s[at + 1..at + d])));
            // loads that slide one part over another need not stress any
            if stress.sqrt() > UNSTRESSED * factor.abs() {
                factor.abs() / stress.sqrt()
            } else {
                0.0
            }
        }
        _ => 0.0,
    };
    let z: Vec<f64> = s.iter().map(|v| -v).collect();
    let inside = |mut v: Vec<f64>| {
        let margins: Vec<f64> = cones
            .blocks
            .iter()
            .map(|&(at, d)| crate::programs::conic::cone_margin(&v[at..at + d]))
            .collect();
        let worst = margins.iter().fold(f64::INFINITY, |m, x| m.min(*x));
        let mean = margins.iter().map(|m| m.max(0.0)).sum::<f64>() / cones.degree().max(1.0);
        let target = (0.1 * mean).max(1e-2 * largest(&v)).max(1e-8);
        if worst < target {
            cones.blocks.iter().for_each(|&(at, _)| v[at] += target - worst);
        }
        v
    };
    let (mut x, mut s, mut z) = (x, inside(s), inside(z));
    if !problem.program.live.is_empty() {
        // without elasticity motions and forces have no size of their own; too large a start lets τ
        // fall by many orders, and ten iterations go into its return
        let size = (cones.degree() / dot(&s, &z)).sqrt();
        [&mut x, &mut s, &mut z].into_iter().for_each(|v| v.iter_mut().for_each(|v| *v *= size));
        for &(at, d) in cones.blocks.iter().filter(|b| b.0 < problem.points) {
            s[at..at + d].iter_mut().for_each(|v| *v *= OPENING);
            z[at..at + d].iter_mut().for_each(|v| *v *= PRESSURE);
        }
    }
    (Point { x, s, z, tau: 1.0, kappa: 1.0 }, reference)
}

/// Newton's system of one iteration.
struct Newton<'a> {
    problem: &'a ScaledProgram,
    scaling: &'a Scaling,
    system: &'a CondensedSystem,
    point: &'a Point,
    r: &'a Residuals,
    /// Solution for the right-hand side `[−q; h]`.
    x2: Vec<f64>,
    z2: Vec<f64>,
    /// Slope of the scalar row: `2 P x/τ + q`, maximised entries of opposite sign.
    slope: Vec<f64>,
    denominator: f64,
    /// Error of stationarity rows of each kind that is small beside what is to be removed.
    allowed: [f64; 2],
}

impl<'a> Newton<'a> {
    /// The system, and the affine direction: both right-hand sides go through the factor together.
    fn new(
        problem: &'a ScaledProgram,
        scaling: &'a Scaling,
        system: &'a CondensedSystem,
        point: &'a Point,
        r: &'a Residuals,
        ll: &[f64],
    ) -> (Self, Direction) {
        let t = point.tau;
        let (q, h) = (&problem.program.q, &problem.program.h);
        // (M + Mᵀ) w = S P w + P S w for M = S P: the coupling cancels
        let slope =
            problem.signed(r.diagonal.iter().zip(q).map(|(p, q)| 2.0 * p / t + q).collect());
        let [off, size, inner] = [&r.f1, q, &r.px].map(|v| problem.largest_of_kinds(v));
        let live = problem.live_force(&point.x);
        let rounding = |k: usize| 1e-13 * size[k].max(inner[k]).max(live);
        let part =
            if problem.program.live.is_empty() { DIRECTION_ERROR } else { LIMIT_DIRECTION_ERROR };
        let allowed = std::array::from_fn(|k| (part * off[k]).max(rounding(k)).max(1e-300));
        let mut n = Self {
            problem,
            scaling,
            system,
            point,
            r,
            x2: vec![],
            z2: vec![],
            slope,
            denominator: 0.0,
            allowed,
        };
        let minus_q: Vec<f64> = q.iter().map(|q| -q).collect();
        let (r1, r2) = n.right_hand_side(ll, 0.0);
        let [(x2, z2), (x1, z1)] = n.kkt([(&minus_q, h), (&r1, &r2)]);
        (n.x2, n.z2) = (x2, z2);
        n.denominator = dot(&n.slope, &n.x2) + dot(h, &n.z2) - r.xpx / (t * t) - point.kappa / t;
        let affine = n.direction(x1, z1, point.kappa * point.tau, 0.0);
        (n, affine)
    }

    /// `P dx − Gᵀ dz = r1`, `−G dx − W² dz = r2` for a few right-hand sides, refined on this full
    /// residual: the condensed matrix alone loses the small multipliers in the rounding of the
    /// large `W⁻²`.
    fn kkt<const SIDES: usize>(&self, rhs: [Side<'_>; SIDES]) -> [(Vec<f64>, Vec<f64>); SIDES] {
        let Self { problem, scaling, .. } = *self;
        let mut solution = self.system.solve::<SIDES, true>(problem, scaling, rhs);
        let mut corrections: [Vec<Correction>; SIDES] = [const { Vec::new() }; SIDES];
        let mut last = f64::INFINITY;
        for _ in 0..REFINEMENTS {
            // 1 is what is allowed
            let worst = |s: &Solved| {
                let off = problem.largest_of_kinds(&s.error);
                (off[0] / self.allowed[0]).max(off[1] / self.allowed[1])
            };
            let error = solution.iter().map(worst).fold(0.0, f64::max);
            if error <= 1.0 || error >= STALLED * last {
                break;
            }
            last = error;
            let slack: [Vec<f64>; SIDES] = std::array::from_fn(|k| {
                let (Solved { x, z, .. }, r2) = (&solution[k], rhs[k].1);
                let (gx, w2) = (problem.program.rows(x), scaling.apply_twice(&problem.cones, z));
                (0..r2.len()).map(|i| r2[i] + gx[i] + w2[i]).collect()
            });
            let sides = std::array::from_fn::<_, SIDES, _>(|k| {
                (solution[k].error.as_slice(), slack[k].as_slice())
            });
            let correction = self.system.solve::<SIDES, true>(problem, scaling, sides);
            for (k, correction) in correction.into_iter().enumerate() {
                let solution = &mut solution[k];
                let effect = solution
                    .error
                    .iter()
                    .zip(&correction.error)
                    .map(|(r, left)| r - left)
                    .collect();
                let mut next = Correction { x: correction.x, z: correction.z, effect };
                next.orthogonalise(&corrections[k], |a, b| self.weighted_dot(a, b));
                let part = self.weighted_dot(&solution.error, &next.effect);
                solution.x.iter_mut().zip(&next.x).for_each(|(a, b)| *a += part * b);
                solution.z.iter_mut().zip(&next.z).for_each(|(a, b)| *a += part * b);
                // anew: what the correction leaves of the error would hide the rounding of the sum
                solution.error =
                    self.system.stationarity_error(problem, rhs[k].0, &solution.x, &solution.z);
                corrections[k].push(next);
            }
        }
        solution.map(|s| (s.x, s.z))
    }

    /// Scalar product of stationarity rows, each kind measured by what is allowed of it.
    fn weighted_dot(&self, a: &[f64], b: &[f64]) -> f64 {
        let others = (self.allowed[0] / self.allowed[1]).powi(2);
        let weight = |i: usize| if self.problem.maximised[i] { others } else { 1.0 };
        (0..a.len()).map(|i| weight(i) * a[i] * b[i]).sum()
    }

    /// Right-hand side for removing the fraction `1 − σ` of the residuals with complementarity
    /// `ds`.
    fn right_hand_side(&self, ds: &[f64], sigma: f64) -> (Vec<f64>, Vec<f64>) {
        let cones = &self.problem.cones;
        let keep = 1.0 - sigma;
        let back = self.scaling.apply(cones, &cones.divide(&self.scaling.lambda, ds));
        let r1 = self.r.f1.iter().map(|f| -keep * f).collect();
        let r2 = self.r.f2.iter().zip(&back).map(|(f, b)| b - keep * f).collect();
        (r1, r2)
    }

    /// The direction that removes the fraction `1 − σ` of the residuals, with complementarity
    /// right-hand sides `ds`, `dk`.
    fn solve(&self, ds: &[f64], dk: f64, sigma: f64) -> Direction {
        let (r1, r2) = self.right_hand_side(ds, sigma);
        let [(x1, z1)] = self.kkt([(&r1, &r2)]);
        self.direction(x1, z1, dk, sigma)
    }

    /// Mehrotra's direction: centred, and corrected for the second-order term of the affine
    /// direction. In limit analysis, where affine steps are short and their second-order terms not
    /// to be trusted, only for as much of it as lengthens the step.
    fn corrected(&self, affine: &Direction, ll: &[f64], targets: &Targets) -> Direction {
        let (cones, p) = (&self.problem.cones, self.point);
        let mut cross = cones.product(
            &self.scaling.apply_inverse(cones, &affine.s),
            &self.scaling.apply(cones, &affine.z),
        );
        for (&(at, d), part) in cones.blocks.iter().zip(&targets.trusted) {
            cross[at..at + d].iter_mut().for_each(|v| *v *= part);
        }
        let sigma = targets.sigma;
        let products = |part: f64| -> Vec<f64> {
            (0..ll.len()).map(|i| ll[i] + part * cross[i] - targets.products[i]).collect()
        };
        let scalar =
            |part: f64| p.kappa * p.tau + part * affine.kappa * affine.tau - targets.centre;
        if self.problem.program.live.is_empty() {
            return self.centred(self.solve(&products(1.0), scalar(1.0), sigma), targets);
        }
        let ((a1, a2), (b1, b2)) =
            (self.right_hand_side(&products(0.0), sigma), self.right_hand_side(&cross, 1.0));
        let [(xa, za), (xb, zb)] = self.kkt([(&a1, &a2), (&b1, &b2)]);
        let centring = self.direction(xa, za, scalar(0.0), sigma);
        let second = self.direction(xb, zb, affine.kappa * affine.tau, 1.0);
        let mut best = (0.0, f64::NEG_INFINITY);
        for part in SECOND_ORDER {
            let step = self.step(&centring.plus(part, &second)).min(1.0);
            if step > best.1 {
                best = (part, step);
            }
        }
        self.centred(centring.plus(best.0, &second), targets)
    }

    /// The direction with complementarity products brought back towards their targets where a
    /// longer step would leave them far behind or ahead (Gondzio's centrality correctors); each
    /// costs one solve and is kept only if the step grows.
    fn centred(&self, mut d: Direction, targets: &Targets) -> Direction {
        let (cones, p, lambda) = (&self.problem.cones, self.point, &self.scaling.lambda);
        let (least, most) = (CENTRE.0 * targets.centre, CENTRE.1 * targets.centre);
        let mut step = self.step(&d).min(1.0);
        let correctors = match (
            self.problem.program.live.is_empty(),
            self.system.flops_per_entry() < DENSE_FACTOR,
        ) {
            (false, _) => LIMIT_CORRECTORS,
            (true, true) => 0,
            (true, false) => CORRECTORS,
        };
        for _ in 0..correctors {
            if step > LONG_STEP {
                break;
            }
            let longer = (step + LONGER).min(1.0);
            let (s, z) = (self.scaling.apply_inverse(cones, &d.s), self.scaling.apply(cones, &d.z));
            let ahead =
                |v: &[f64]| lambda.iter().zip(v).map(|(l, v)| l + longer * v).collect::<Vec<f64>>();
            let excess =
                cones.outside(&cones.product(&ahead(&s), &ahead(&z)), &targets.products, CENTRE);
            let tk = (p.tau + longer * d.tau) * (p.kappa + longer * d.kappa);
            let scalar = tk - tk.clamp(least, most);
            // of the change alone: it is small, and so is what there is to refine
            let next = d.plus(1.0, &self.solve(&excess, scalar.min(most), 1.0));
            let reached = self.step(&next).min(1.0);
            if reached < step + WORTH * LONGER {
                break;
            }
            (d, step) = (next, reached);
        }
        d
    }

    /// The direction from the solution for its right-hand side, the scalar rows taken in.
    fn direction(&self, x1: Vec<f64>, z1: Vec<f64>, dk: f64, sigma: f64) -> Direction {
        let (p, r) = (self.point, self.r);
        let (keep, h) = (1.0 - sigma, &self.problem.program.h);
        let tau =
            (-keep * r.f3 + dk / p.tau - dot(&self.slope, &x1) - dot(h, &z1)) / self.denominator;
        let x: Vec<f64> = x1.iter().zip(&self.x2).map(|(a, b)| a + tau * b).collect();
        let z: Vec<f64> = z1.iter().zip(&self.z2).map(|(a, b)| a + tau * b).collect();
        // the slack row holds exactly: s = G x + h τ with the residual shrunk
        let gx = self.problem.program.rows(&x);
        let s = (0..h.len()).map(|i| gx[i] + h[i] * tau - keep * r.f2[i]).collect();
        let kappa = -(dk + p.kappa * tau) / p.tau;
        Direction { x, s, z, tau, kappa }
    }

    /// Part of a direction, at most all of it, that stays in each cone for itself.
    fn own_steps(&self, d: &Direction) -> Vec<f64> {
        let (p, cones) = (self.point, &self.problem.cones);
        let steps = cones.own_steps(&p.s, &d.s).zip(cones.own_steps(&p.z, &d.z));
        steps.map(|(s, z)| s.min(z).min(1.0)).collect()
    }

    /// Largest step that stays in the cones.
    fn step(&self, d: &Direction) -> f64 {
        let p = self.point;
        let cones = &self.problem.cones;
        let along = |v: f64, dv: f64| if dv < 0.0 { -v / dv } else { f64::INFINITY };
        let limit = along(p.tau, d.tau).min(along(p.kappa, d.kappa)).min(1e3);
        let limit = cones.largest_step(&p.s, &d.s, limit);
        cones.largest_step(&p.z, &d.z, limit)
    }
}
