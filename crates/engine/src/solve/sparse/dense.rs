//! Dense kernels of the sparse factorisation, on column-major matrices, sequential.
//!
//! The kernels are faer's. Its parallel kernels have two public reports of wrong results. So the
//! factorisation is parallel over blocks instead, each through a sequential kernel, and its digits
//! do not depend on the number of threads. This file and `math/dense.rs` alone name faer.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{
    LltParams, cholesky_in_place, cholesky_in_place_scratch,
};
use faer::linalg::{matmul, triangular_solve};
use faer::{Accum, Mat, Par, Spec};
pub use faer::{MatMut, MatRef};
use std::time::Instant;

/// `A = L Lᵀ` in place, lower triangle; false when A is not positive definite.
pub fn cholesky(a: MatMut<'_, f64>) -> bool {
    let n = a.nrows();
    let params = Spec::<LltParams, f64>::default();
    let mut memory = MemBuffer::new(cholesky_in_place_scratch::<f64>(n, Par::Seq, params));
    cholesky_in_place(a, Default::default(), Par::Seq, MemStack::new(&mut memory), params).is_ok()
}

/// `B ← B L⁻ᵀ`.
pub fn solve_right(l: MatRef<'_, f64>, b: MatMut<'_, f64>) {
    triangular_solve::solve_lower_triangular_in_place(l, b.transpose_mut(), Par::Seq);
}

/// `C ← C − A Bᵀ`.
pub fn subtract_product(c: MatMut<'_, f64>, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    matmul::matmul(c, Accum::Add, a, b.transpose(), -1.0, Par::Seq);
}

/// `C ← A Bᵀ`.
pub fn product(c: MatMut<'_, f64>, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    matmul::matmul(c, Accum::Replace, a, b.transpose(), 1.0, Par::Seq);
}

/// Floating-point operations per second of a dense Cholesky factorisation on one thread of this
/// machine.
pub fn dense_rate() -> f64 {
    static RATE: std::sync::OnceLock<f64> = std::sync::OnceLock::new();
    *RATE.get_or_init(|| {
        let n = 512;
        let mut best = f64::INFINITY;
        for _ in 0..4 {
            let mut a = Mat::<f64>::from_fn(n, n, |i, j| if i == j { n as f64 } else { 1.0 });
            let start = Instant::now();
            cholesky(a.as_mut());
            best = best.min(start.elapsed().as_secs_f64());
        }
        (n as f64).powi(3) / 3.0 / best
    })
}
