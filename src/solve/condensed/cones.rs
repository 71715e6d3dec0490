//! Cone arithmetic and Nesterov–Todd scaling, cone by cone, on flat vectors.

use crate::programs::conic::Cone;

/// The product cone of a program.
#[derive(Clone, Debug)]
pub struct Cones {
    /// First row and dimension of each cone.
    pub blocks: Vec<(usize, usize)>,
    /// Total number of rows.
    pub rows: usize,
}

/// `a₀² − ‖a₁‖²` as a product of sums, exact to rounding near the surface of the cone.
fn det(a: &[f64]) -> f64 {
    let n = norm(&a[1..]);
    (a[0] - n) * (a[0] + n)
}

fn norm(a: &[f64]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

impl Cones {
    /// The product of the cones of a program.
    pub fn new(cones: &[Cone]) -> Self {
        let mut rows = 0;
        let blocks = cones
            .iter()
            .map(|c| {
                let start = rows;
                rows += c.dim();
                (start, c.dim())
            })
            .collect();
        Self { blocks, rows }
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
        for &(s, d) in &self.blocks {
            let (x, y) = (&a[s..s + d], &b[s..s + d]);
            c[s] = dot(x, y);
            for i in 1..d {
                c[s + i] = x[0] * y[i] + y[0] * x[i];
            }
        }
        c
    }

    /// The x with `a ∘ x = b`.
    pub fn divide(&self, a: &[f64], b: &[f64]) -> Vec<f64> {
        let mut c = vec![0.0; self.rows];
        for &(s, d) in &self.blocks {
            let (l, y) = (&a[s..s + d], &b[s..s + d]);
            if d == 1 {
                c[s] = y[0] / l[0];
                continue;
            }
            let x0 = (l[0] * y[0] - dot(&l[1..], &y[1..])) / det(l);
            c[s] = x0;
            for i in 1..d {
                c[s + i] = (y[i] - x0 * l[i]) / l[0];
            }
        }
        c
    }

    /// Excess of the eigenvalues of `v` outside `span` times the target of their cone (at its first
    /// row); above the span the excess is limited to its upper end.
    pub fn outside(&self, v: &[f64], targets: &[f64], span: (f64, f64)) -> Vec<f64> {
        let mut out = vec![0.0; self.rows];
        for &(s, d) in &self.blocks {
            let (low, high) = (span.0 * targets[s], span.1 * targets[s]);
            let excess = |e: f64| (e - e.clamp(low, high)).min(high);
            if d == 1 {
                out[s] = excess(v[s]);
                continue;
            }
            let n = norm(&v[s + 1..s + d]);
            let (more, less) = (excess(v[s] + n), excess(v[s] - n));
            out[s] = 0.5 * (more + less);
            if n > 0.0 {
                (1..d).for_each(|i| out[s + i] = 0.5 * (more - less) * v[s + i] / n);
            }
        }
        out
    }

    /// Largest step in `[0, most]` that keeps `x + a dx` in the cone.
    pub fn largest_step(&self, x: &[f64], dx: &[f64], most: f64) -> f64 {
        self.blocks
            .iter()
            .fold(most, |step, &(s, d)| step.min(step_in(&x[s..s + d], &dx[s..s + d])))
    }

    /// Largest step of each cone alone.
    pub fn own_steps<'a>(&'a self, x: &'a [f64], dx: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        self.blocks.iter().map(|&(s, d)| step_in(&x[s..s + d], &dx[s..s + d]))
    }
}

/// Largest step of one block.
fn step_in(x: &[f64], dx: &[f64]) -> f64 {
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
        let mut eta = Vec::with_capacity(cones.blocks.len());
        let mut w = vec![0.0; cones.rows];
        for &(at, d) in &cones.blocks {
            let (sb, zb) = (&s[at..at + d], &z[at..at + d]);
            if d == 1 {
                if !(sb[0] > 0.0 && zb[0] > 0.0) {
                    return None;
                }
                eta.push((sb[0] / zb[0]).sqrt());
                w[at] = 1.0;
                continue;
            }
            let (ds, dz) = (det(sb), det(zb));
            if !(ds > 0.0 && dz > 0.0 && sb[0] > 0.0 && zb[0] > 0.0) {
                return None;
            }
            let (rs, rz) = (ds.sqrt(), dz.sqrt());
            let gamma = (0.5 * (1.0 + dot(sb, zb) / (rs * rz))).sqrt();
            for i in 1..d {
                w[at + i] = (sb[i] / rs - zb[i] / rz) / (2.0 * gamma);
            }
            // normalised: w₀² − ‖w₁‖² = 1
            w[at] = (1.0 + dot(&w[at + 1..at + d], &w[at + 1..at + d])).sqrt();
            eta.push((rs / rz).sqrt());
        }
        let mut scaling = Self { eta, w, lambda: Vec::new() };
        scaling.lambda = scaling.apply(cones, z);
        Some(scaling)
    }

    /// W or its inverse applied `times` times, cone by cone; `x` may end after any of the cones.
    fn map(&self, cones: &Cones, x: &[f64], inverse: bool, times: usize) -> Vec<f64> {
        let mut y = x.to_vec();
        let sign = if inverse { -1.0 } else { 1.0 };
        for (k, &(s, d)) in cones.blocks.iter().enumerate().take_while(|(_, b)| b.0 < x.len()) {
            let e = if inverse { 1.0 / self.eta[k] } else { self.eta[k] };
            let (w, y) = (&self.w[s..s + d], &mut y[s..s + d]);
            for _ in 0..times {
                // with a known length the loops are unrolled
                match (w.first_chunk::<6>(), y.first_chunk_mut::<6>()) {
                    (Some(w), Some(y)) if d == 6 => hyperbolic(e, sign, w, y),
                    _ if d == 1 => y[0] *= e,
                    _ => hyperbolic(e, sign, w, y),
                }
            }
        }
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
