//! Cone arithmetic and Nesterov–Todd scaling, cone by cone, on flat vectors.

use super::vectors::PIECE;
use crate::programs::conic::Cone;
use rayon::prelude::*;
use std::ops::Range;

/// The product cone of a program.
#[derive(Clone, Debug)]
pub struct Cones {
    /// First row and dimension of each cone.
    pub blocks: Vec<(usize, usize)>,
    /// Total number of rows.
    pub rows: usize,
    /// The cones in pieces, one thread's work each.
    pieces: Vec<Range<usize>>,
}

/// `a₀² − ‖a₁‖²` as a product of sums, exact to rounding near the surface of the cone.
#[inline(always)]
fn det(a: &[f64]) -> f64 {
    let n = norm(&a[1..]);
    (a[0] - n) * (a[0] + n)
}

#[inline(always)]
fn norm(a: &[f64]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[inline(always)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

impl Cones {
    /// The product of the cones of a program.
    pub fn new(cones: &[Cone]) -> Self {
        let mut rows = 0;
        let blocks: Vec<(usize, usize)> = cones
            .iter()
            .map(|c| {
                let start = rows;
                rows += c.dim();
                (start, c.dim())
            })
            .collect();
        let pieces = pieces(&blocks);
        Self { blocks, rows, pieces }
    }

    /// Calls `of` with each cone, its first row, its dimension and its part of `out`. `out` may end
    /// after any of the cones.
    fn each(&self, out: &mut [f64], of: impl Fn(usize, usize, usize, &mut [f64]) + Sync) {
        let mut rest = out;
        let mut parts = Vec::with_capacity(self.pieces.len());
        for piece in &self.pieces {
            let (at, _) = self.blocks[piece.start];
            let end = self.blocks[piece.end - 1];
            let (part, after) = rest.split_at_mut((end.0 + end.1 - at).min(rest.len()));
            rest = after;
            parts.push((piece.clone(), at, part));
        }
        parts.into_par_iter().for_each(|(piece, first, part)| {
            for k in piece {
                let (s, d) = self.blocks[k];
                let Some(own) = part.get_mut(s - first..s - first + d) else { break };
                of(k, s, d, own);
            }
        });
    }

    /// The value of each cone.
    fn values<T: Send>(&self, of: impl Fn(usize, usize) -> T + Sync) -> Vec<T> {
        self.walk().map(|&(s, d)| of(s, d)).collect()
    }

    /// First row and dimension of each cone, in parallel; most cones have six rows.
    fn walk(&self) -> impl IndexedParallelIterator<Item = &(usize, usize)> {
        self.blocks.par_iter().with_min_len(PIECE / 8)
    }

    /// Degree of the barrier: one per cone (the second-order cone's barrier is counted by its
    /// identity `(1, 0)`).
    pub fn degree(&self) -> f64 {
        self.blocks.len() as f64
    }

    /// The identity element.
    pub fn identity(&self) -> Vec<f64> {
        let mut e = vec![0.0; self.rows];
        self.blocks.iter().for_each(|&(s, _)| e[s] = 1.0);
        e
    }

    /// Jordan product `a ∘ b`.
    pub fn product(&self, a: &[f64], b: &[f64]) -> Vec<f64> {
        let mut c = vec![0.0; self.rows];
        self.each(&mut c, |_, s, d, c| {
            let (x, y) = (&a[s..s + d], &b[s..s + d]);
            c[0] = dot(x, y);
            for i in 1..d {
                c[i] = x[0] * y[i] + y[0] * x[i];
            }
        });
        c
    }

    /// The x with `a ∘ x = b`.
    pub fn divide(&self, a: &[f64], b: &[f64]) -> Vec<f64> {
        let mut c = vec![0.0; self.rows];
        self.each(&mut c, |_, s, d, c| {
            let (l, y) = (&a[s..s + d], &b[s..s + d]);
            if d == 1 {
                c[0] = y[0] / l[0];
                return;
            }
            let x0 = (l[0] * y[0] - dot(&l[1..], &y[1..])) / det(l);
            c[0] = x0;
            for i in 1..d {
                c[i] = (y[i] - x0 * l[i]) / l[0];
            }
        });
        c
    }

    /// Excess of the eigenvalues of `v` outside `span` times the target of their cone (at its first
    /// row); above the span the excess is limited to its upper end.
    pub fn outside(&self, v: &[f64], targets: &[f64], span: (f64, f64)) -> Vec<f64> {
        let mut out = vec![0.0; self.rows];
        self.each(&mut out, |_, s, d, out| {
            let v = &v[s..s + d];
            let (low, high) = (span.0 * targets[s], span.1 * targets[s]);
            let excess = |e: f64| (e - e.clamp(low, high)).min(high);
            if d == 1 {
                out[0] = excess(v[0]);
                return;
            }
            let n = norm(&v[1..]);
            let (more, less) = (excess(v[0] + n), excess(v[0] - n));
            out[0] = 0.5 * (more + less);
            if n > 0.0 {
                (1..d).for_each(|i| out[i] = 0.5 * (more - less) * v[i] / n);
            }
        });
        out
    }

    /// Largest step in `[0, most]` that keeps `x + a dx` in the cone.
    pub fn largest_step(&self, x: &[f64], dx: &[f64], most: f64) -> f64 {
        let step = |&(s, d): &(usize, usize)| step_in(&x[s..s + d], &dx[s..s + d]);
        self.walk().map(step).reduce(|| most, f64::min)
    }

    /// Largest step of each cone alone.
    pub fn own_steps(&self, x: &[f64], dx: &[f64]) -> Vec<f64> {
        self.values(|s, d| step_in(&x[s..s + d], &dx[s..s + d]))
    }
}

/// Ranges of cones of about equal numbers of rows.
fn pieces(blocks: &[(usize, usize)]) -> Vec<Range<usize>> {
    let mut pieces = Vec::new();
    let mut start = 0;
    while start < blocks.len() {
        let last = blocks[start].0 + PIECE;
        let end = start + blocks[start..].partition_point(|b| b.0 < last);
        pieces.push(start..end);
        start = end;
    }
    pieces
}

/// Largest step of one block.
fn step_in(x: &[f64], dx: &[f64]) -> f64 {
    match (x.len(), x.first_chunk::<6>(), dx.first_chunk::<6>()) {
        // with a known length the loops are unrolled
        (6, Some(x), Some(dx)) => step_of(x, dx),
        _ => step_of(x, dx),
    }
}

#[inline(always)]
fn step_of(x: &[f64], dx: &[f64]) -> f64 {
    if x.len() == 1 {
        return if dx[0] < 0.0 { -x[0] / dx[0] } else { f64::INFINITY };
    }
    // det(x + a dx) = c + 2 b a + a₂ a²; its smallest positive root, if any
    let a2 = dx[0] * dx[0] - dot(&dx[1..], &dx[1..]);
    let b = x[0] * dx[0] - dot(&x[1..], &dx[1..]);
    let c = det(x);
    let discriminant = b * b - a2 * c;
    let mut step = if dx[0] < 0.0 { -x[0] / dx[0] } else { f64::INFINITY };
    if discriminant >= 0.0 {
        let q = -(b + if b >= 0.0 { discriminant.sqrt() } else { -discriminant.sqrt() });
        for root in [q / a2, c / q] {
            if root > 0.0 && root.is_finite() {
                step = step.min(root);
            }
        }
    }
    step
}

/// The Nesterov–Todd scaling: the symmetric W with `W z = W⁻¹ s = λ`.
#[derive(Clone, Debug)]
pub struct Scaling {
    /// η of each cone.
    eta: Vec<f64>,
    /// Unit hyperbolic vector w of each cone, flat.
    w: Vec<f64>,
    /// The scaled point λ.
    pub lambda: Vec<f64>,
}

impl Scaling {
    /// The scaling of a pair strictly inside the cones; `None` when one of them is on the surface.
    pub fn new(cones: &Cones, s: &[f64], z: &[f64]) -> Option<Self> {
        // the size of a vector inside its cone
        let size = |a: &[f64]| match a {
            [a] => (*a > 0.0).then_some(*a),
            _ => {
                let det = det(a);
                (det > 0.0 && a[0] > 0.0).then(|| det.sqrt())
            }
        };
        let sizes = cones.values(|at, d| Some([size(&s[at..at + d])?, size(&z[at..at + d])?]));
        let sizes: Vec<[f64; 2]> = sizes.into_iter().collect::<Option<_>>()?;
        let eta = sizes.iter().map(|[rs, rz]| (rs / rz).sqrt()).collect();
        let mut w = vec![0.0; cones.rows];
        cones.each(&mut w, |k, at, d, w| {
            if d == 1 {
                w[0] = 1.0;
                return;
            }
            let (s, z) = (&s[at..at + d], &z[at..at + d]);
            let [rs, rz] = sizes[k];
            let gamma = (0.5 * (1.0 + dot(s, z) / (rs * rz))).sqrt();
            for i in 1..d {
                w[i] = (s[i] / rs - z[i] / rz) / (2.0 * gamma);
            }
            // normalised: w₀² − ‖w₁‖² = 1
            w[0] = (1.0 + dot(&w[1..], &w[1..])).sqrt();
        });
        let mut scaling = Self { eta, w, lambda: Vec::new() };
        scaling.lambda = scaling.apply(cones, z);
        Some(scaling)
    }

    /// W or its inverse applied `times` times, cone by cone; `x` may end after any of the cones.
    fn map(&self, cones: &Cones, x: &[f64], inverse: bool, times: usize) -> Vec<f64> {
        let mut y = x.to_vec();
        let sign = if inverse { -1.0 } else { 1.0 };
        cones.each(&mut y, |k, s, d, y| {
            let e = if inverse { 1.0 / self.eta[k] } else { self.eta[k] };
            let w = &self.w[s..s + d];
            for _ in 0..times {
                // with a known length the loops are unrolled
                match (w.first_chunk::<6>(), y.first_chunk_mut::<6>()) {
                    (Some(w), Some(y)) if d == 6 => hyperbolic(e, sign, w, y),
                    _ if d == 1 => y[0] *= e,
                    _ => hyperbolic(e, sign, w, y),
                }
            }
        });
        y
    }

    /// `W x`.
    pub fn apply(&self, cones: &Cones, x: &[f64]) -> Vec<f64> {
        self.map(cones, x, false, 1)
    }

    /// `W⁻¹ x`.
    pub fn apply_inverse(&self, cones: &Cones, x: &[f64]) -> Vec<f64> {
        self.map(cones, x, true, 1)
    }

    /// `W² x`.
    pub fn apply_twice(&self, cones: &Cones, x: &[f64]) -> Vec<f64> {
        self.map(cones, x, false, 2)
    }

    /// `W⁻² x`.
    pub fn apply_inverse_twice(&self, cones: &Cones, x: &[f64]) -> Vec<f64> {
        self.map(cones, x, true, 2)
    }

    /// The identity: W = I.
    pub fn identity(cones: &Cones) -> Self {
        let w = cones.identity();
        Self { eta: vec![1.0; cones.blocks.len()], lambda: w.clone(), w }
    }

    /// Scaling of cone `k`, dimension 6: 1/η, then w. The vector block of `W⁻²` is
    /// `η⁻² (I + 2 w₁w₁ᵀ)`.
    pub fn of_point(&self, cones: &Cones, k: usize) -> [f64; 7] {
        let s = cones.blocks[k].0;
        let w = &self.w[s..s + 6];
        [1.0 / self.eta[k], w[0], w[1], w[2], w[3], w[4], w[5]]
    }

    /// `W⁻²` of cone `k`, row by row.
    pub fn inverse_square(&self, cones: &Cones, k: usize, out: &mut [[f64; 6]; 6]) {
        let (s, d) = cones.blocks[k];
        let e = 1.0 / (self.eta[k] * self.eta[k]);
        if d == 1 {
            out[0][0] = e;
            return;
        }
        // W⁻² = η⁻² (2 (Jw)(Jw)ᵀ − J)
        let w = &self.w[s..s + d];
        for i in 0..d {
            for j in 0..d {
                let flip = if (i == 0) == (j == 0) { 1.0 } else { -1.0 };
                let jordan = match (i == j, i == 0) {
                    (true, true) => 1.0,
                    (true, false) => -1.0,
                    _ => 0.0,
                };
                out[i][j] = e * (2.0 * flip * w[i] * w[j] - jordan);
            }
        }
    }
}

/// `η (w₀ ±w₁ᵀ; ±w₁ I + w₁w₁ᵀ/(1 + w₀))` times a vector in place: W, with the minus its inverse.
#[inline(always)]
fn hyperbolic(e: f64, sign: f64, w: &[f64], v: &mut [f64]) {
    let t = dot(&w[1..], &v[1..]);
    let f = sign * v[0] + t / (1.0 + w[0]);
    v[0] = e * (w[0] * v[0] + sign * t);
    for (v, w) in v[1..].iter_mut().zip(&w[1..]) {
        *v = e * (*v + w * f);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaling_maps_both_points_to_one() {
        let cones = Cones::new(&[
            Cone::SecondOrder(3),
            Cone::NonNegative,
            Cone::SecondOrder(4),
            Cone::SecondOrder(6),
        ]);
        let s = [2.0, 0.5, -1.0, 0.3, 1.0, 0.2, 0.3, -0.4, 3.0, 1.0, 0.5, -0.7, 0.2, 1.1];
        let z = [1.0, -0.3, 0.2, 4.0, 2.0, -0.2, 0.7, 0.4, 0.9, 0.1, 0.2, 0.3, -0.4, 0.1];
        let w = Scaling::new(&cones, &s, &z).expect("both points are inside");
        let (a, b) = (w.apply(&cones, &z), w.apply_inverse(&cones, &s));
        a.iter().zip(&b).for_each(|(x, y)| assert!((x - y).abs() < 1e-13, "{x} {y}"));
        // W⁻² is the square of W⁻¹
        let twice = w.apply_inverse(&cones, &w.apply_inverse(&cones, &s));
        for (k, &(at, d)) in cones.blocks.iter().enumerate() {
            let mut m = [[0.0; 6]; 6];
            w.inverse_square(&cones, k, &mut m);
            for i in 0..d {
                let y: f64 = (0..d).map(|j| m[i][j] * s[at + j]).sum();
                assert!((y - twice[at + i]).abs() < 1e-12);
            }
        }
        // λ ∘ (λ \ b) = b
        let back = cones.product(&w.lambda, &cones.divide(&w.lambda, &s));
        back.iter().zip(&s).for_each(|(x, y)| assert!((x - y).abs() < 1e-12));
    }

    #[test]
    fn subtracting_the_excess_moves_eigenvalues_into_the_span() {
        let cones = Cones::new(&[Cone::NonNegative, Cone::SecondOrder(3), Cone::SecondOrder(3)]);
        // eigenvalues 0.05; −4 and 6; 0.5 and 1.5
        let v = [0.05, 1.0, 3.0, -4.0, 1.0, 0.3, 0.4];
        let out = cones.outside(&v, &cones.identity(), (0.1, 10.0));
        let kept: Vec<f64> = v.iter().zip(&out).map(|(a, b)| a - b).collect();
        assert!((kept[0] - 0.1).abs() < 1e-15);
        let n = norm(&kept[2..4]);
        assert!((kept[1] - n - 0.1).abs() < 1e-14 && (kept[1] + n - 6.0).abs() < 1e-14, "{kept:?}");
        assert_eq!(out[4..], [0.0; 3]);
        // far above the span the excess is limited to the upper end
        assert_eq!(
            cones.outside(&[35.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0], &cones.identity(), (0.1, 10.0))[0],
            10.0
        );
    }

    #[test]
    fn steps_end_on_the_surface() {
        let cones = Cones::new(&[Cone::SecondOrder(3)]);
        let x = [1.0, 0.2, 0.1];
        let dx = [-0.3, 1.0, 0.4];
        let a = cones.largest_step(&x, &dx, 10.0);
        let y: Vec<f64> = x.iter().zip(&dx).map(|(x, d)| x + a * d).collect();
        assert!(det(&y).abs() < 1e-14 && a > 0.0 && a < 10.0);
    }
}
