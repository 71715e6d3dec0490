//! Symmetric tensors in Mandel form `[xx, yy, zz, √2 yz, √2 xz, √2 xy]`, in which inner products
//! are dot products.

use super::vec3::{M3, V3};
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

/// A symmetric tensor in Mandel form.
pub type Mandel = [f64; 6];

/// Isotropic stiffness `σ = C ε`, defined by its two moduli.
///
/// # Units
/// MPa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isotropic {
    /// First Lamé constant.
    pub lambda: f64,
    /// Twice the shear modulus.
    pub two_mu: f64,
}

impl Isotropic {
    /// The stiffness for Young's modulus \[MPa\] and Poisson's ratio.
    #[inline]
    pub fn new(e: f64, nu: f64) -> Self {
        Self { lambda: e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), two_mu: e / (1.0 + nu) }
    }

    /// Stress for a strain.
    #[inline]
    pub fn stress(&self, eps: &Mandel) -> Mandel {
        let p = self.lambda * (eps[0] + eps[1] + eps[2]);
        let mut s = eps.map(|x| self.two_mu * x);
        s[0] += p;
        s[1] += p;
        s[2] += p;
        s
    }

    /// Strain for a stress.
    #[inline]
    pub fn strain(&self, sig: &Mandel) -> Mandel {
        let tr = sig[0] + sig[1] + sig[2];
        let k = self.lambda / (self.two_mu + 3.0 * self.lambda) * tr;
        let mut e = *sig;
        e[0] -= k;
        e[1] -= k;
        e[2] -= k;
        e.map(|x| x / self.two_mu)
    }
}

/// An orthonormal basis of the traceless tensors.
pub const DEVIATORIC: [Mandel; 5] = {
    // 1/√6
    const R: f64 = 0.408_248_290_463_863;
    [
        [FRAC_1_SQRT_2, -FRAC_1_SQRT_2, 0.0, 0.0, 0.0, 0.0],
        [-R, -R, 2.0 * R, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
    ]
};

/// Components of the deviator in the basis [`DEVIATORIC`]; their Euclidean norm is the deviator's
/// norm.
#[inline]
pub fn deviator(s: &Mandel) -> [f64; 5] {
    DEVIATORIC.map(|d| dot(&d, s))
}

/// Von Mises stress `√(3/2) ‖dev σ‖` \[MPa\].
#[inline]
pub fn von_mises(s: &Mandel) -> f64 {
    let p = (s[0] + s[1] + s[2]) / 3.0;
    1.5f64.sqrt() * norm(&[s[0] - p, s[1] - p, s[2] - p, s[3], s[4], s[5]])
}

/// Radius of the von Mises yield surface, `‖dev σ‖ ≤ √(2/3) f_y` \[MPa\].
#[inline]
pub fn yield_radius(fy: f64) -> f64 {
    (2.0f64 / 3.0).sqrt() * fy
}

/// Inner product.
#[inline]
pub fn dot(a: &Mandel, b: &Mandel) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Frobenius norm.
#[inline]
pub fn norm(a: &Mandel) -> f64 {
    dot(a, a).sqrt()
}

/// Traction `σ n`.
#[inline]
pub fn traction(s: &Mandel, n: V3) -> V3 {
    let (yz, xz, xy) = (s[3] * FRAC_1_SQRT_2, s[4] * FRAC_1_SQRT_2, s[5] * FRAC_1_SQRT_2);
    [
        s[0] * n[0] + xy * n[1] + xz * n[2],
        xy * n[0] + s[1] * n[1] + yz * n[2],
        xz * n[0] + yz * n[1] + s[2] * n[2],
    ]
}

/// The 3 × 6 matrix `N(n)` with `σ n = N(n) σ`.
#[inline]
pub fn normal_operator(n: V3) -> [Mandel; 3] {
    let r = FRAC_1_SQRT_2;
    [
        [n[0], 0.0, 0.0, 0.0, n[2] * r, n[1] * r],
        [0.0, n[1], 0.0, n[2] * r, 0.0, n[0] * r],
        [0.0, 0.0, n[2], n[1] * r, n[0] * r, 0.0],
    ]
}

/// The symmetric part of a matrix, in Mandel form.
#[inline]
pub fn symmetric_part(m: &M3) -> Mandel {
    let r = FRAC_1_SQRT_2;
    [
        m[0][0],
        m[1][1],
        m[2][2],
        r * (m[1][2] + m[2][1]),
        r * (m[0][2] + m[2][0]),
        r * (m[0][1] + m[1][0]),
    ]
}

/// The symmetric matrix for a tensor in Mandel form.
#[inline]
pub fn to_matrix(s: &Mandel) -> M3 {
    let (yz, xz, xy) = (s[3] * FRAC_1_SQRT_2, s[4] * FRAC_1_SQRT_2, s[5] * FRAC_1_SQRT_2);
    [[s[0], xy, xz], [xy, s[1], yz], [xz, yz, s[2]]]
}

/// The 6 × 6 matrix of the contravariant Piola map `σ̂ ↦ J σ̂ Jᵀ / det J` in Mandel form.
///
/// The map takes divergence-free fields to divergence-free fields and keeps tractions continuous.
/// One null space computed on a reference tetrahedron therefore serves every element.
#[inline]
pub fn piola(j: &M3, det: f64) -> [Mandel; 6] {
    let mut p = [[0.0; 6]; 6];
    for c in 0..6 {
        let mut unit = [0.0; 6];
        unit[c] = 1.0;
        let s = to_matrix(&unit);
        let mut m = [[0.0; 3]; 3];
        for a in 0..3 {
            for b in 0..3 {
                let mut x = 0.0;
                for k in 0..3 {
                    for l in 0..3 {
                        x += j[a][k] * s[k][l] * j[b][l];
                    }
                }
                m[a][b] = x / det;
            }
        }
        let col = [m[0][0], m[1][1], m[2][2], SQRT_2 * m[1][2], SQRT_2 * m[0][2], SQRT_2 * m[0][1]];
        for r in 0..6 {
            p[r][c] = col[r];
        }
    }
    p
}

/// `M s` for a 6 × 6 matrix.
#[inline]
pub fn mul(m: &[Mandel; 6], s: &Mandel) -> Mandel {
    std::array::from_fn(|i| dot(&m[i], s))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The components of the deviator preserve inner products, omit the trace, and give f_y
    /// in uniaxial stress.
    #[test]
    fn deviators() {
        for (i, a) in DEVIATORIC.iter().enumerate() {
            assert!((a[0] + a[1] + a[2]).abs() < 1e-15);
            for (j, b) in DEVIATORIC.iter().enumerate() {
                assert!((dot(a, b) - if i == j { 1.0 } else { 0.0 }).abs() < 1e-15);
            }
        }
        let length = |s: &Mandel| deviator(s).iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((length(&[235.0, 0.0, 0.0, 0.0, 0.0, 0.0]) - yield_radius(235.0)).abs() < 1e-12);
        assert!(length(&[7.0, 7.0, 7.0, 0.0, 0.0, 0.0]) < 1e-14);
        // pure shear of f_y/√3
        let shear = SQRT_2 * 235.0 / 3.0f64.sqrt();
        assert!((length(&[0.0, 0.0, 0.0, 0.0, shear, 0.0]) - yield_radius(235.0)).abs() < 1e-12);
    }
}
