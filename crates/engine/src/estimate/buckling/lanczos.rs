//! Block Lanczos iteration with thick restart for the lowest positive factors α of
//! `K v + α K_σ v = 0`, K positive definite.
//!
//! With θ = 1/α the pencil is `K⁻¹ (−K_σ) v = θ v`, self-adjoint in the inner product of K. The
//! largest θ are at one end of the spectrum, where the iteration converges first; negative θ, which
//! belong to reversed loads, are at the other end. The basis is kept orthonormal in full. A block
//! finds eigenvalues of multiplicity up to its width. The start vectors are fixed, so that the same
//! input gives the same output.
//!
//! # Source
//! R. G. Grimes, J. G. Lewis, H. D. Simon, A shifted block Lanczos algorithm for solving sparse
//! symmetric generalized eigenproblems, SIAM J. Matrix Anal. Appl. 15 (1994); K. Wu, H. Simon,
//! Thick-restart Lanczos method for large symmetric eigenvalue problems, ibid. 22 (2000).

use crate::programs::conic::SymmetricCsc;
use crate::solve::sparse::SparseCholesky;
use bracket_base::math::dense::{Mat, symmetric_eigen};
use rayon::prelude::*;

/// Vectors in a block; a solve for this many sides costs little more than one.
const BLOCK: usize = 4;
/// Vectors of the basis before a restart.
const BASIS: usize = 80;
/// Vectors kept at a restart beyond those asked for.
const SPARE: usize = 2 * BLOCK;
/// Steps before an answer is trusted, so that no low mode is missed for want of a trace of it.
const LEAST_STEPS: usize = 4;
/// Steps after which the iteration gives up.
const MOST_STEPS: usize = 150;
/// A vector is in the span of others when less than this is left of it.
const DEPENDENT: f64 = 1e-9;
/// Length of the parts in which sums of vectors are computed.
const PART: usize = 1 << 14;

/// The matrices of the problem.
pub struct Pencil<'a> {
    /// K.
    pub stiffness: &'a SymmetricCsc,
    /// K_σ.
    pub geometric: &'a SymmetricCsc,
    /// Factor of K.
    pub factor: &'a SparseCholesky,
}

/// What is asked for.
#[derive(Clone, Copy)]
pub struct Wanted {
    /// Number of factors.
    pub count: usize,
    /// Factors above this do not matter.
    pub largest: f64,
    /// Relative residual at which a factor has converged.
    pub tolerance: f64,
}

/// A factor with its mode.
#[derive(Clone, Debug)]
pub struct Pair {
    /// α > 0.
    pub factor: f64,
    /// `‖θ v − K⁻¹ (−K_σ) v‖ / θ‖v‖` in the norm of K: some exact factor α' of the pencil has
    /// `|α/α' − 1|` at most this.
    pub residual: f64,
    /// v, of unit length in the norm of K.
    pub vector: Vec<f64>,
}

/// End of the iteration.
#[derive(Debug)]
pub struct Ended {
    /// Converged pairs by increasing factor, without a gap.
    pub pairs: Vec<Pair>,
    /// True when all pairs that were asked for are there, or as many as exist up to the largest
    /// factor that matters.
    pub complete: bool,
    /// Steps.
    pub steps: usize,
    /// Relative residual of the first pair that has not converged.
    pub residual: f64,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// `y ← y + Σ c_i q_i`, part by part, so that the sums do not depend on the number of threads.
fn add(y: &mut [f64], basis: &[Vec<f64>], c: &[f64]) {
    y.par_chunks_mut(PART).enumerate().for_each(|(k, part)| {
        for (q, c) in basis.iter().zip(c) {
            part.iter_mut().zip(&q[k * PART..]).for_each(|(y, q)| *y += c * q);
        }
    });
}

impl Pencil<'_> {
    /// `−K_σ X`.
    fn images(&self, x: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let negative = |mut y: Vec<f64>| {
            y.iter_mut().for_each(|y| *y = -*y);
            y
        };
        in_blocks(x, |x| self.geometric.mul_all(x)).into_iter().map(negative).collect()
    }

    /// `K⁻¹ X`.
    fn solved(&self, x: &[Vec<f64>]) -> Vec<Vec<f64>> {
        in_blocks(x, |x| self.factor.solve_all(x))
    }

    /// K-orthonormalises `vectors` against `basis` and among themselves. The new vectors, and the
    /// coefficients of the old ones in them, one row for each new vector; vectors that depend on
    /// others are dropped.
    fn orthonormal(
        &self,
        basis: &[Vec<f64>],
        vectors: Vec<Vec<f64>>,
    ) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
        let (mut new, mut rows): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (Vec::new(), Vec::new());
        let width = vectors.len();
        for (j, mut w) in vectors.into_iter().enumerate() {
            let mut kw = self.stiffness.mul(&w);
            let before = dot(&w, &kw).max(0.0).sqrt();
            // twice is enough
            for _ in 0..2 {
                let minus = |q: &Vec<f64>| -dot(q, &kw);
                let of_basis: Vec<f64> = basis.par_iter().map(minus).collect();
                let of_new: Vec<f64> = new.par_iter().map(minus).collect();
                add(&mut w, basis, &of_basis);
                add(&mut w, &new, &of_new);
                rows.iter_mut().zip(&of_new).for_each(|(row, c)| row[j] -= c);
                kw = self.stiffness.mul(&w);
            }
            let after = dot(&w, &kw).max(0.0).sqrt();
            if after > DEPENDENT * before && after.is_finite() {
                w.iter_mut().for_each(|x| *x /= after);
                new.push(w);
                let mut row = vec![0.0; width];
                row[j] = after;
                rows.push(row);
            }
        }
        (new, rows)
    }

    /// The pair of an approximate mode, its factor by Rayleigh's quotient.
    fn pair(&self, vector: Vec<f64>) -> Pair {
        let x = [vector];
        let kx = self.stiffness.mul(&x[0]);
        let image = &self.images(&x)[0];
        let norm = dot(&x[0], &kx);
        let theta = dot(&x[0], image) / norm;
        let mut off = self.factor.solve(image);
        off.iter_mut().zip(&x[0]).for_each(|(o, x)| *o -= theta * x);
        let residual = (dot(&off, &self.stiffness.mul(&off)).max(0.0) / norm).sqrt() / theta;
        let [vector] = x;
        Pair { factor: 1.0 / theta, residual, vector }
    }
}

/// Applies an operation on blocks of vectors to any number of them.
fn in_blocks(x: &[Vec<f64>], of: impl Fn([&[f64]; BLOCK]) -> [Vec<f64>; BLOCK]) -> Vec<Vec<f64>> {
    let mut out = Vec::with_capacity(x.len());
    for block in x.chunks(BLOCK) {
        // a short block repeats its last vector
        let sides = std::array::from_fn(|k| &block[k.min(block.len() - 1)][..]);
        out.extend(of(sides).into_iter().take(block.len()));
    }
    out
}

/// Values in (−½, ½) without a pattern.
fn noise(n: usize, seed: u64) -> Vec<f64> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    (0..n)
        .map(|_| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        })
        .collect()
}

/// A K-orthonormal basis with the operator projected on it.
struct Basis {
    q: Vec<Vec<f64>>,
    /// The projected operator, a row for each vector.
    t: Vec<Vec<f64>>,
    /// The next block, orthogonal to the basis.
    next: Vec<Vec<f64>>,
    /// What the operator adds in the direction of the next block to the last vectors of the basis:
    /// a row for each vector of the block, a column for each of the last vectors.
    coupling: Vec<Vec<f64>>,
}

/// An eigenvalue of the projected operator.
struct Ritz {
    theta: f64,
    coefficients: Vec<f64>,
    /// Distance from an eigenvalue of the operator at most.
    residual: f64,
}

impl Basis {
    fn new(pencil: &Pencil<'_>) -> Self {
        let n = pencil.stiffness.n;
        let forces: Vec<Vec<f64>> = (1..=BLOCK as u64).map(|seed| noise(n, seed)).collect();
        let (next, _) = pencil.orthonormal(&[], pencil.solved(&forces));
        Self { q: Vec::new(), t: Vec::new(), next, coupling: Vec::new() }
    }

    /// Adds the next block to the basis and makes the one after it.
    fn step(&mut self, pencil: &Pencil<'_>) {
        let first = self.q.len();
        let images = pencil.images(&self.next);
        self.q.append(&mut self.next);
        let size = self.q.len();
        self.t.iter_mut().for_each(|row| row.resize(size, 0.0));
        self.t.resize(size, vec![0.0; size]);
        for (j, image) in images.iter().enumerate() {
            let column: Vec<f64> = self.q.par_iter().map(|q| dot(q, image)).collect();
            for (i, c) in column.into_iter().enumerate() {
                self.t[i][first + j] = c;
                self.t[first + j][i] = c;
            }
        }
        let w = pencil.solved(&images);
        (self.next, self.coupling) = pencil.orthonormal(&self.q, w);
    }

    /// The eigenvalues of the projected operator, largest first; empty where there are none to
    /// working precision.
    fn ritz(&self) -> Vec<Ritz> {
        let m = self.q.len();
        let t = Mat::from_fn(m, m, |i, j| 0.5 * (self.t[i][j] + self.t[j][i]));
        let Ok((values, vectors)) = symmetric_eigen(&t) else { return Vec::new() };
        let ritz = |k: usize| {
            let coefficients: Vec<f64> = (0..m).map(|i| vectors[(i, k)]).collect();
            let width = self.coupling.first().map_or(0, Vec::len);
            let last = &coefficients[m - width..];
            let residual = self.coupling.iter().map(|row| dot(row, last).powi(2)).sum::<f64>();
            Ritz { theta: values[k], coefficients, residual: residual.sqrt() }
        };
        (0..m).rev().map(ritz).collect()
    }

    /// The vector with the given coefficients.
    fn vector(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut x = vec![0.0; self.q[0].len()];
        add(&mut x, &self.q, coefficients);
        x
    }

    /// Replaces the basis by its best vectors. The next block stays: in the new basis it is coupled
    /// with all of them, and the next step finds these couplings.
    fn restart(&mut self, ritz: &[Ritz], keep: usize) {
        let kept = &ritz[..keep.min(ritz.len())];
        self.q = kept.iter().map(|r| self.vector(&r.coefficients)).collect();
        self.t = vec![vec![0.0; kept.len()]; kept.len()];
        kept.iter().enumerate().for_each(|(i, r)| self.t[i][i] = r.theta);
    }
}

/// The lowest positive factors with their modes.
pub fn lowest_positive(pencil: &Pencil<'_>, wanted: &Wanted) -> Ended {
    let least = 1.0 / wanted.largest;
    let mut basis = Basis::new(pencil);
    let (mut steps, mut residual) = (0, f64::INFINITY);
    while !basis.next.is_empty() && steps < MOST_STEPS {
        basis.step(pencil);
        steps += 1;
        let ritz = basis.ritz();
        let converged = |r: &&Ritz| r.theta >= least && r.residual <= wanted.tolerance * r.theta;
        let ready = ritz.iter().take(wanted.count).take_while(converged).count();
        // those after them are settled if they cannot matter
        let rest = &ritz[ready..wanted.count.min(ritz.len()).max(ready)];
        residual = rest.first().map_or(0.0, |r| r.residual / r.theta.abs().max(least));
        let settled = rest.iter().all(|r| r.theta + r.residual < least);
        let exhausted = basis.next.is_empty();
        let enough = steps >= LEAST_STEPS && ritz.len() >= wanted.count;
        if exhausted || (enough && settled) || steps == MOST_STEPS {
            let modes = ritz[..ready].iter().map(|r| basis.vector(&r.coefficients));
            let pairs = modes.map(|v| pencil.pair(v)).collect();
            return Ended { pairs, complete: settled, steps, residual };
        }
        if basis.q.len() + basis.next.len() > BASIS.max(2 * (wanted.count + SPARE)) {
            basis.restart(&ritz, wanted.count + SPARE);
        }
    }
    Ended { pairs: Vec::new(), complete: basis.q.is_empty(), steps, residual }
}

#[cfg(test)]
mod tests;
