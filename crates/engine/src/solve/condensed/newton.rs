//! Newton's system of one iteration, and the directions it gives: affine, corrected, centred.

use super::cones::Scaling;
use super::correction::Correction;
use super::point::{Direction, Point};
use super::residuals::Residuals;
use super::scaled_program::ScaledProgram;
use super::settings::Settings;
use super::static_condensation::Side;
use super::system::{CondensedSystem, Solved};
use super::targets::Targets;
use super::vectors::{add, dot, sum, vector};

/// Newton's system of one iteration.
pub struct Newton<'a> {
    problem: &'a ScaledProgram,
    settings: &'static Settings,
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
    /// Allowed error of stationarity rows of each kind, small beside the residual to be removed.
    allowed: [f64; 2],
}

impl<'a> Newton<'a> {
    /// The system and the affine direction; both right-hand sides go through the factor together.
    pub fn new(
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
        let settings = Settings::of(problem.is_limit());
        let rounding = |k: usize| settings.rounding * size[k].max(inner[k]).max(live);
        let part = settings.direction_error;
        let allowed = std::array::from_fn(|k| (part * off[k]).max(rounding(k)).max(1e-300));
        let mut n = Self {
            problem,
            settings,
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

    /// Solves `P dx − Gᵀ dz = r1`, `−G dx − W² dz = r2` for a few right-hand sides, refined on this
    /// full residual: the condensed matrix alone loses the small multipliers in the rounding of the
    /// large `W⁻²`.
    fn kkt<const SIDES: usize>(&self, rhs: [Side<'_>; SIDES]) -> [(Vec<f64>, Vec<f64>); SIDES] {
        let Self { problem, scaling, .. } = *self;
        let mut solution = self.system.solve::<SIDES, true>(problem, scaling, rhs);
        let mut corrections: [Vec<Correction>; SIDES] = [const { Vec::new() }; SIDES];
        let mut last = f64::INFINITY;
        for _ in 0..self.settings.refinements {
            // relative to the allowed error
            let worst = |s: &Solved| {
                let off = problem.largest_of_kinds(&s.error);
                (off[0] / self.allowed[0]).max(off[1] / self.allowed[1])
            };
            let error = solution.iter().map(worst).fold(0.0, f64::max);
            if error <= 1.0 || error >= self.settings.stalled * last {
                break;
            }
            last = error;
            let slack: [Vec<f64>; SIDES] = std::array::from_fn(|k| {
                let (Solved { x, z, .. }, r2) = (&solution[k], rhs[k].1);
                let (gx, w2) = (problem.program.rows(x), scaling.apply_twice(&problem.cones, z));
                vector(r2.len(), |i| r2[i] + gx[i] + w2[i])
            });
            let sides = std::array::from_fn::<_, SIDES, _>(|k| {
                (solution[k].error.as_slice(), slack[k].as_slice())
            });
            let correction = self.system.solve::<SIDES, true>(problem, scaling, sides);
            for (k, correction) in correction.into_iter().enumerate() {
                let solution = &mut solution[k];
                let (before, left) = (&solution.error, &correction.error);
                let effect = vector(left.len(), |i| before[i] - left[i]);
                let mut next = Correction { x: correction.x, z: correction.z, effect };
                next.orthogonalise(&corrections[k], |a, b| self.weighted_dot(a, b));
                let part = self.weighted_dot(&solution.error, &next.effect);
                add(&mut solution.x, part, &next.x);
                add(&mut solution.z, part, &next.z);
                // computed anew: the error updated by the correction would hide the rounding of the
                // sum
                solution.error =
                    self.system.stationarity_error(problem, rhs[k].0, &solution.x, &solution.z);
                corrections[k].push(next);
            }
        }
        solution.map(|s| (s.x, s.z))
    }

    /// Scalar product of stationarity rows, each kind measured by its allowed error.
    fn weighted_dot(&self, a: &[f64], b: &[f64]) -> f64 {
        let others = (self.allowed[0] / self.allowed[1]).powi(2);
        let weight = |i: usize| if self.problem.maximised[i] { others } else { 1.0 };
        sum(a.len(), |i| weight(i) * a[i] * b[i])
    }

    /// Right-hand side that removes the fraction `1 − σ` of the residuals, with complementarity
    /// `ds`.
    fn right_hand_side(&self, ds: &[f64], sigma: f64) -> (Vec<f64>, Vec<f64>) {
        let cones = &self.problem.cones;
        let keep = 1.0 - sigma;
        let back = self.scaling.apply(cones, &cones.divide(&self.scaling.lambda, ds));
        let (f1, f2) = (&self.r.f1, &self.r.f2);
        let r1 = vector(f1.len(), |i| -keep * f1[i]);
        let r2 = vector(f2.len(), |i| back[i] - keep * f2[i]);
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
    /// direction. In limit analysis affine steps are short and their second-order terms unreliable:
    /// the direction takes the fraction of the term that lengthens the step most.
    pub fn corrected(&self, affine: &Direction, ll: &[f64], targets: &Targets) -> Direction {
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
            vector(ll.len(), |i| ll[i] + part * cross[i] - targets.products[i])
        };
        let scalar =
            |part: f64| p.kappa * p.tau + part * affine.kappa * affine.tau - targets.centre;
        if !self.problem.is_limit() {
            return self.centred(self.solve(&products(1.0), scalar(1.0), sigma), targets);
        }
        let ((a1, a2), (b1, b2)) =
            (self.right_hand_side(&products(0.0), sigma), self.right_hand_side(&cross, 1.0));
        let [(xa, za), (xb, zb)] = self.kkt([(&a1, &a2), (&b1, &b2)]);
        let centring = self.direction(xa, za, scalar(0.0), sigma);
        let second = self.direction(xb, zb, affine.kappa * affine.tau, 1.0);
        let mut best = (0.0, f64::NEG_INFINITY);
        for part in self.settings.second_order {
            let step = self.step(&centring.plus(part, &second)).min(1.0);
            if step > best.1 {
                best = (part, step);
            }
        }
        self.centred(centring.plus(best.0, &second), targets)
    }

    /// The direction with Gondzio's centrality correctors: complementarity products are brought
    /// back towards their targets where a longer step would leave them far below or above. Each
    /// corrector costs one solve and is kept only if the step grows.
    fn centred(&self, mut d: Direction, targets: &Targets) -> Direction {
        let (cones, p, lambda) = (&self.problem.cones, self.point, &self.scaling.lambda);
        let settings = self.settings;
        let centre = settings.centre;
        let (least, most) = (centre.0 * targets.centre, centre.1 * targets.centre);
        let mut step = self.step(&d).min(1.0);
        let pays = self.system.flops_per_entry() >= settings.dense_factor;
        let correctors = if pays { settings.correctors } else { 0 };
        for _ in 0..correctors {
            if step > settings.long_step {
                break;
            }
            let longer = (step + settings.longer).min(1.0);
            let (s, z) = (self.scaling.apply_inverse(cones, &d.s), self.scaling.apply(cones, &d.z));
            let ahead = |v: &[f64]| vector(v.len(), |i| lambda[i] + longer * v[i]);
            let excess =
                cones.outside(&cones.product(&ahead(&s), &ahead(&z)), &targets.products, centre);
            let tk = (p.tau + longer * d.tau) * (p.kappa + longer * d.kappa);
            let scalar = tk - tk.clamp(least, most);
            // a solve for the change alone: it is small, and so is the error to refine
            let next = d.plus(1.0, &self.solve(&excess, scalar.min(most), 1.0));
            let reached = self.step(&next).min(1.0);
            if reached < step + settings.worth * settings.longer {
                break;
            }
            (d, step) = (next, reached);
        }
        d
    }

    /// The direction from the solution for its right-hand side, scalar rows included.
    fn direction(&self, x1: Vec<f64>, z1: Vec<f64>, dk: f64, sigma: f64) -> Direction {
        let (p, r) = (self.point, self.r);
        let (keep, h) = (1.0 - sigma, &self.problem.program.h);
        let tau =
            (-keep * r.f3 + dk / p.tau - dot(&self.slope, &x1) - dot(h, &z1)) / self.denominator;
        let x = vector(x1.len(), |i| x1[i] + tau * self.x2[i]);
        let z = vector(z1.len(), |i| z1[i] + tau * self.z2[i]);
        // the slack row holds exactly: s = G x + h τ with the residual shrunk
        let gx = self.problem.program.rows(&x);
        let s = vector(h.len(), |i| gx[i] + h[i] * tau - keep * r.f2[i]);
        let kappa = -(dk + p.kappa * tau) / p.tau;
        Direction { x, s, z, tau, kappa }
    }

    /// For each cone, the fraction of a direction (at most 1) that stays inside that cone.
    pub fn own_steps(&self, d: &Direction) -> Vec<f64> {
        let (p, cones) = (self.point, &self.problem.cones);
        let (s, z) = (cones.own_steps(&p.s, &d.s), cones.own_steps(&p.z, &d.z));
        vector(s.len(), |k| s[k].min(z[k]).min(1.0))
    }

    /// Largest step that stays in all cones.
    pub fn step(&self, d: &Direction) -> f64 {
        let p = self.point;
        let cones = &self.problem.cones;
        let along = |v: f64, dv: f64| if dv < 0.0 { -v / dv } else { f64::INFINITY };
        let limit = along(p.tau, d.tau).min(along(p.kappa, d.kappa)).min(1e3);
        let limit = cones.largest_step(&p.s, &d.s, limit);
        cones.largest_step(&p.z, &d.z, limit)
    }
}
