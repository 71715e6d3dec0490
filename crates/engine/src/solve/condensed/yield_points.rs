//! Kernels of the yield points of a batch: their scaling, its root, its inverse and its square.

use crate::elements::yielding_element::YIELD_ROWS;
use bracket_base::math::lanes::{Place, kernel};
use bracket_base::math::wide::{Lane, parts, registers, registers_mut};
use pulp::Simd;

/// Values of one yield point's scaling: 1/η, then the six of w. The vector block of `W⁻²` is
/// `η⁻² (I + 2 w₁w₁ᵀ)`.
pub const SCALING: usize = 1 + YIELD_ROWS;
/// The scaling at each yield point of a batch.
pub type Weights = Vec<[Lane; SCALING]>;

kernel! {
    /// The root `√α (I + γ w wᵀ)` of `V = α (I + 2 w wᵀ)` of each point times its rows of B,
    /// `columns` long.
    pub fn times_roots(
        simd;
        weights: &'a [[Lane; SCALING]],
        b: &'a [Lane],
        columns: usize,
        y: &'a mut [Lane],
    ) {
        let weights = registers::<S>(weights.as_flattened());
        let (b, y) = (registers::<S>(b), registers_mut::<S>(y));
        let (one, two) = (simd.splat_f64s(1.0), simd.splat_f64s(2.0));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            for point in 0..weights.len() / (SCALING * parts::<S>()) {
                let size = weights[at.of(SCALING * point)];
                let mut w = [one; 5];
                let mut n = simd.splat_f64s(0.0);
                for a in 0..5 {
                    w[a] = weights[at.of(SCALING * point + 2 + a)];
                    n = simd.mul_add_e_f64s(w[a], w[a], n);
                }
                // (√(1 + 2n) − 1)/n without cancellation
                let root = simd.sqrt_f64s(simd.mul_add_e_f64s(two, n, one));
                let gamma = simd.div_f64s(two, simd.add_f64s(root, one));
                for c in 0..columns {
                    let mut rows = [one; 5];
                    let mut along = simd.splat_f64s(0.0);
                    for a in 0..5 {
                        rows[a] = b[at.of((5 * point + a) * columns + c)];
                        along = simd.mul_add_e_f64s(w[a], rows[a], along);
                    }
                    let along = simd.mul_f64s(along, gamma);
                    for a in 0..5 {
                        let v = simd.mul_f64s(size, simd.mul_add_e_f64s(along, w[a], rows[a]));
                        y[at.of((5 * point + a) * columns + c)] = v;
                    }
                }
            }
        }
    }
}

/// `H⁻¹ = a (I − g w wᵀ)` of a point that is rigid before it yields: a, g, w.
#[inline(always)]
pub fn point_inverse<S: Simd>(
    simd: S,
    weight: &[S::f64s],
    at: Place,
    proximal: f64,
) -> (S::f64s, S::f64s, [S::f64s; 5]) {
    let mut w = [simd.splat_f64s(0.0); 5];
    let mut n = simd.splat_f64s(0.0);
    for a in 0..5 {
        w[a] = weight[at.of(2 + a)];
        n = simd.mul_add_e_f64s(w[a], w[a], n);
    }
    let size = weight[at.of(0)];
    let alpha = simd.mul_f64s(size, size);
    let (a, beta) = (simd.add_f64s(alpha, simd.splat_f64s(proximal)), simd.add_f64s(alpha, alpha));
    let fraction = simd.div_f64s(beta, simd.mul_add_e_f64s(beta, n, a));
    (simd.div_f64s(simd.splat_f64s(1.0), a), fraction, w)
}

kernel! {
    /// `y ← H⁻¹ y` at points that are rigid before they yield.
    pub fn solve_points(simd; weights: &'a [[Lane; SCALING]], proximal: f64, y: &'a mut [Lane]) {
        let y = registers_mut::<S>(y);
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            for (point, weight) in weights.iter().enumerate() {
                let weight = registers::<S>(weight);
                let (inverse, fraction, w) = point_inverse(simd, weight, at, proximal);
                let mut along = simd.splat_f64s(0.0);
                for a in 0..5 {
                    along = simd.mul_add_e_f64s(w[a], y[at.of(5 * point + a)], along);
                }
                let along = simd.mul_f64s(along, fraction);
                for a in 0..5 {
                    let y = &mut y[at.of(5 * point + a)];
                    *y = simd.mul_f64s(inverse, simd.negate_mul_add_e_f64s(along, w[a], *y));
                }
            }
        }
    }
}

kernel! {
    /// `W⁻²` of each yield point of a batch times its six values, in place.
    pub fn inverse_square(simd; weights: &'a [[Lane; SCALING]], values: &'a mut [Lane]) {
        let values = registers_mut::<S>(values);
        let one = simd.splat_f64s(1.0);
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            for (point, weight) in weights.iter().enumerate() {
                let weight = registers::<S>(weight);
                let (e, w0) = (weight[at.of(0)], weight[at.of(1)]);
                let (mut w, mut v) = ([one; 5], [one; 5]);
                let mut v0 = values[at.of(YIELD_ROWS * point)];
                for a in 0..5 {
                    w[a] = weight[at.of(2 + a)];
                    v[a] = values[at.of(YIELD_ROWS * point + 1 + a)];
                }
                let share = simd.div_f64s(one, simd.add_f64s(one, w0));
                for _ in 0..2 {
                    let mut t = simd.splat_f64s(0.0);
                    for a in 0..5 {
                        t = simd.mul_add_e_f64s(w[a], v[a], t);
                    }
                    let f = simd.sub_f64s(simd.mul_f64s(t, share), v0);
                    v0 = simd.mul_f64s(e, simd.sub_f64s(simd.mul_f64s(w0, v0), t));
                    for a in 0..5 {
                        v[a] = simd.mul_f64s(e, simd.mul_add_e_f64s(w[a], f, v[a]));
                    }
                }
                values[at.of(YIELD_ROWS * point)] = v0;
                for a in 0..5 {
                    values[at.of(YIELD_ROWS * point + 1 + a)] = v[a];
                }
            }
        }
    }
}
