//! Eigenvalues and eigenvectors of symmetric 3 × 3 tensors, by Jacobi's rotations.

use super::mandel::{Mandel, to_matrix};
use super::vec3::V3;
use std::f64::consts::SQRT_2;

/// Sweeps of rotations; the off-diagonal entries vanish to rounding after four to six.
const SWEEPS: usize = 12;

/// Eigenvalues and the unit eigenvector of each; in no particular order.
pub fn eigen(s: &Mandel) -> ([f64; 3], [V3; 3]) {
    let mut a = to_matrix(s);
    // rows become the eigenvectors
    let mut v = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..SWEEPS {
        if a[0][1] == 0.0 && a[0][2] == 0.0 && a[1][2] == 0.0 {
            break;
        }
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = if theta.is_finite() {
                theta.signum() / (theta.abs() + theta.hypot(1.0))
            } else {
                0.0
            };
            let c = 1.0 / t.hypot(1.0);
            let s = t * c;
            for k in 0..3 {
                let (x, y) = (a[k][p], a[k][q]);
                (a[k][p], a[k][q]) = (c * x - s * y, s * x + c * y);
            }
            for k in 0..3 {
                let (x, y) = (a[p][k], a[q][k]);
                (a[p][k], a[q][k]) = (c * x - s * y, s * x + c * y);
            }
            (a[p][q], a[q][p]) = (0.0, 0.0);
            for k in 0..3 {
                let (x, y) = (v[p][k], v[q][k]);
                (v[p][k], v[q][k]) = (c * x - s * y, s * x + c * y);
            }
        }
    }
    ([a[0][0], a[1][1], a[2][2]], v)
}

/// The tensor `Σ λ_i v_i v_iᵀ`; the inverse of [`eigen`] for orthonormal vectors.
pub fn compose(values: [f64; 3], vectors: &[V3; 3]) -> Mandel {
    let at = |i: usize, j: usize| (0..3).map(|k| values[k] * vectors[k][i] * vectors[k][j]).sum();
    let (yz, xz, xy): (f64, f64, f64) = (at(1, 2), at(0, 2), at(0, 1));
    [at(0, 0), at(1, 1), at(2, 2), SQRT_2 * yz, SQRT_2 * xz, SQRT_2 * xy]
}

/// The tensor with the same eigenvectors and every eigenvalue replaced by `f` of it.
pub fn mapped(s: &Mandel, f: impl Fn(f64) -> f64) -> Mandel {
    let (values, vectors) = eigen(s);
    compose(values.map(f), &vectors)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::mandel::traction;
    use crate::math::vec3::{dot, norm, scale, sub};

    /// `S v = λ v` with orthonormal v, and the tensor is restored, for tensors of all kinds: full,
    /// diagonal, with equal eigenvalues, of widely different sizes.
    #[test]
    fn satisfies_its_definition() {
        let cases: [Mandel; 6] = [
            [1.0, -2.0, 3.0, 0.5, -1.5, 0.7],
            [4.0, 4.0, -1.0, 0.0, 0.0, 0.0],
            [1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
            [1e-9, 2e3, -5.0, 1e-4, 3.0, 1e2],
            [0.0; 6],
            [0.0, 0.0, 0.0, 0.0, 0.0, 2.0],
        ];
        for s in cases {
            let size = s.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            let (values, vectors) = eigen(&s);
            for (l, v) in values.iter().zip(&vectors) {
                let rest = norm(sub(traction(&s, *v), scale(*l, *v)));
                assert!(rest <= 1e-14 * size, "{s:?} {rest:e}");
                assert!((norm(*v) - 1.0).abs() < 1e-14);
            }
            assert!(dot(vectors[0], vectors[1]).abs() < 1e-14);
            let back = compose(values, &vectors);
            assert!(back.iter().zip(&s).all(|(a, b)| (a - b).abs() <= 1e-14 * size));
        }
    }

    /// The absolute value of a shear: both of its principal values become positive.
    #[test]
    fn absolute_value_of_a_shear() {
        let shear = [0.0, 0.0, 0.0, 0.0, 0.0, SQRT_2];
        let want = [1.0, 1.0, 0.0, 0.0, 0.0, 0.0];
        let got = mapped(&shear, f64::abs);
        assert!(got.iter().zip(&want).all(|(a, b): (&f64, &f64)| (a - b).abs() < 1e-15));
    }
}
