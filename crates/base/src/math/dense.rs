//! Small dense linear algebra: Cholesky factors of fixed-size matrices, symmetric eigenvectors,
//! least squares, and systems that may be singular.
//!
//! Only this file and `solve/sparse/dense.rs` use faer.

pub use faer::Mat;
use faer::linalg::solvers::Qr;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::prelude::{Solve, SolveLstsq};
use faer::{Par, Side};

/// Makes faer's dense kernels sequential in the whole process. With parallel kernels the last
/// digits of a result would depend on the number of threads.
pub fn sequential_kernels() {
    faer::set_global_parallelism(Par::Seq);
}

/// Lower Cholesky factor of a symmetric positive definite matrix of order `N`.
#[derive(Clone, Debug)]
pub struct Cholesky<const N: usize> {
    l: Box<[[f64; N]; N]>,
}

impl<const N: usize> Cholesky<N> {
    /// Factors the matrix given by the lower triangle of `a`; `None` if a pivot is not positive.
    pub fn new(mut a: Box<[[f64; N]; N]>) -> Option<Self> {
        for j in 0..N {
            let mut d = a[j][j];
            for k in 0..j {
                d -= a[j][k] * a[j][k];
            }
            if !(d > 0.0 && d.is_finite()) {
                return None;
            }
            let d = d.sqrt();
            a[j][j] = d;
            for i in j + 1..N {
                let mut s = a[i][j];
                for k in 0..j {
                    s -= a[i][k] * a[j][k];
                }
                a[i][j] = s / d;
            }
        }
        Some(Self { l: a })
    }

    /// `L⁻¹ b` in place, for `M` right-hand sides stored as rows `b[i]`.
    #[inline]
    pub fn forward<const M: usize>(&self, b: &mut [[f64; M]; N]) {
        for i in 0..N {
            let (done, rest) = b.split_at_mut(i);
            let row = &mut rest[0];
            for (k, bk) in done.iter().enumerate() {
                let l = self.l[i][k];
                for c in 0..M {
                    row[c] -= l * bk[c];
                }
            }
            let d = 1.0 / self.l[i][i];
            row.iter_mut().for_each(|x| *x *= d);
        }
    }

    /// `A⁻¹ b` in place.
    #[inline]
    pub fn solve(&self, b: &mut [f64; N]) {
        for i in 0..N {
            let mut s = b[i];
            for k in 0..i {
                s -= self.l[i][k] * b[k];
            }
            b[i] = s / self.l[i][i];
        }
        for i in (0..N).rev() {
            let mut s = b[i];
            for k in i + 1..N {
                s -= self.l[k][i] * b[k];
            }
            b[i] = s / self.l[i][i];
        }
    }
}

/// Orthonormal basis of the null space of a symmetric positive semidefinite matrix: the
/// eigenvectors whose eigenvalue is below `tolerance` times the largest, one per column. Empty if
/// the matrix is regular.
pub fn null_space(gram: &Mat<f64>, tolerance: f64) -> Vec<Vec<f64>> {
    let n = gram.nrows();
    if n == 0 {
        return Vec::new();
    }
    let eig =
        gram.self_adjoint_eigen(Side::Lower).expect("a finite symmetric matrix has eigenvectors");
    let s = eig.S().column_vector();
    let largest = (0..n).map(|i| s[i].abs()).fold(0.0, f64::max);
    (0..n)
        .filter(|&i| largest == 0.0 || s[i] <= tolerance * largest)
        .map(|i| (0..n).map(|r| eig.U()[(r, i)]).collect())
        .collect()
}

/// Eigenvalues of a symmetric matrix in increasing order, and its orthonormal eigenvectors, one per
/// column. Only the lower triangle is read.
pub fn symmetric_eigen(a: &Mat<f64>) -> Result<(Vec<f64>, Mat<f64>), NoConvergence> {
    let eigen = a.self_adjoint_eigen(Side::Lower).map_err(|_| NoConvergence)?;
    Ok((eigen.S().column_vector().iter().copied().collect(), eigen.U().to_owned()))
}

/// Minimum-norm solution of a small symmetric positive semidefinite system.
pub fn pseudo_solve(a: &Mat<f64>, b: &Mat<f64>) -> Mat<f64> {
    // scale to unit diagonal, then drop directions below rounding error
    let n = a.nrows();
    let d: Vec<f64> =
        (0..n).map(|i| if a[(i, i)] > 0.0 { a[(i, i)].sqrt().recip() } else { 0.0 }).collect();
    let scaled = Mat::from_fn(n, n, |i, j| d[i] * a[(i, j)] * d[j]);
    let mut regular = scaled.clone();
    for v in null_space(&scaled, 1e-14) {
        for i in 0..n {
            for j in 0..n {
                regular[(i, j)] += v[i] * v[j];
            }
        }
    }
    let rhs = Mat::from_fn(n, 1, |i, _| d[i] * b[(i, 0)]);
    let y = regular.partial_piv_lu().solve(&rhs);
    Mat::from_fn(n, 1, |i, _| d[i] * y[(i, 0)])
}

/// Least-squares solution of `A X = B`, refined once.
pub fn least_squares(a: &Mat<f64>, b: &Mat<f64>) -> Mat<f64> {
    let factor = a.qr();
    let mut x = factor.solve_lstsq(b);
    x += factor.solve_lstsq(b - a * &x);
    x
}

/// Least-squares solution of `A x = b` by damped normal equations, refined twice. Directions that A
/// does not determine remain zero.
pub fn damped_least_squares(a: &Mat<f64>, b: &Mat<f64>) -> Mat<f64> {
    let normal = a.transpose() * a;
    let rhs = a.transpose() * b;
    let n = normal.nrows();
    let scale = (0..n).map(|i| normal[(i, i)]).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
    let damped =
        Mat::from_fn(n, n, |i, j| normal[(i, j)] + if i == j { 1e-14 * scale } else { 0.0 });
    let mut x = damped.partial_piv_lu().solve(&rhs);
    for _ in 0..2 {
        let r = &rhs - &normal * &x;
        x += damped.partial_piv_lu().solve(&r);
    }
    x
}

/// The square orthogonal factor Q of `A = Q R`; its last columns span the null space of `Aᵀ`.
pub fn orthogonal_factor(a: &Mat<f64>) -> Mat<f64> {
    a.qr().compute_Q()
}

/// Thin factors of `A = Q R`.
pub struct ThinQr {
    q: Mat<f64>,
    factor: Qr<f64>,
}

impl ThinQr {
    /// Factors a matrix with at least as many rows as columns.
    pub fn new(a: &Mat<f64>) -> Self {
        let factor = a.qr();
        Self { q: factor.compute_thin_Q(), factor }
    }

    /// The least-norm solution x of `Aᵀ x = y`.
    pub fn least_norm(&self, mut y: Mat<f64>) -> Mat<f64> {
        let r = self.factor.thin_R();
        solve_lower_triangular_in_place(r.transpose(), y.as_mut(), Par::Seq);
        &self.q * &y
    }
}

/// A decomposition did not converge.
#[derive(Clone, Copy, Debug)]
pub struct NoConvergence;

/// Singular values in decreasing order, and the matrix of right singular vectors, one per column.
pub fn right_singular_vectors(a: &Mat<f64>) -> Result<(Vec<f64>, Mat<f64>), NoConvergence> {
    let svd = a.svd().map_err(|_| NoConvergence)?;
    Ok((svd.S().column_vector().iter().copied().collect(), svd.V().to_owned()))
}
