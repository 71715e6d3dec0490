//! Dense kernels of the sparse factorisation, on column-major matrices, sequential.
//!
//! faer's kernels do the work; its parallel ones have two public reports of wrong results, so
//! parallelism is ours, over blocks that each go through a sequential kernel: the digits do not
//! depend on the number of threads.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{
    LltParams, cholesky_in_place, cholesky_in_place_scratch,
};
use faer::linalg::{matmul, triangular_solve};
use faer::{Accum, MatMut, MatRef, Par, Spec};

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
