//! One symmetric positive definite sparse system: factor once, solve with refinement.

use super::ordering::nested_dissection;
use crate::model::program::SymmetricCsc;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::perm::PermRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

/// Why a factorisation failed.
#[derive(Clone, Debug, thiserror::Error)]
pub enum LinearError {
    /// The matrix is not positive definite: some part can move freely.
    #[error("the stiffness matrix is singular: some part of the model is not held")]
    Singular,
    /// Out of memory or too large an index.
    #[error("the sparse factorisation could not be set up: {0}")]
    Setup(String),
}

/// A Cholesky factor `A = L Lᵀ` under nested dissection.
pub struct SparseCholesky {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
}

impl SparseCholesky {
    /// Factors the upper triangle `a`; `block` gives the block of each unknown for the ordering.
    pub fn new(a: &SymmetricCsc, block: &[u32]) -> Result<Self, LinearError> {
        let mut factor = Self::symbolic(a, block)?;
        factor.refactor(a)?;
        Ok(factor)
    }

    /// Orders and lays out the factor of matrices with the pattern of `a`, without numbers yet.
    pub fn symbolic(a: &SymmetricCsc, block: &[u32]) -> Result<Self, LinearError> {
        let order = nested_dissection(a, block);
        let mut inverse = vec![0; order.len()];
        order.iter().enumerate().for_each(|(new, &old)| inverse[old] = new);
        let pattern = SymbolicSparseColMatRef::new_checked(a.n, a.n, &a.col_ptr, None, &a.row_idx);
        let symbolic = factorize_symbolic_cholesky(
            pattern,
            Side::Upper,
            SymmetricOrdering::Custom(PermRef::new_checked(&order, &inverse, a.n)),
            CholeskySymbolicParams::default(),
        )
        .map_err(|e| LinearError::Setup(format!("{e:?}")))?;
        let values = vec![0.0; symbolic.len_val()];
        Ok(Self { symbolic, values })
    }

    /// Nonzeros of the factor, stored zeros of its dense blocks included.
    pub fn entries(&self) -> usize {
        self.values.len()
    }

    /// Floating-point operations of a factorisation.
    pub fn flops(&self) -> f64 {
        0.0
    }

    /// Work space a factorisation needs beside the factor \[bytes\].
    pub fn work_bytes(&self) -> usize {
        0
    }

    /// Factors a matrix with the pattern the layout was made for.
    pub fn refactor(&mut self, a: &SymmetricCsc) -> Result<(), LinearError> {
        let pattern = SymbolicSparseColMatRef::new_checked(a.n, a.n, &a.col_ptr, None, &a.row_idx);
        let matrix = SparseColMatRef::new(pattern, &a.values);
        let scratch = self.symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        let mut memory = MemBuffer::try_new(scratch).map_err(|e| LinearError::Setup(format!("{e:?}")))?;
        // sequential kernels: faer's parallel ones have two public reports of wrong results
        self.symbolic
            .factorize_numeric_llt(
                &mut self.values,
                matrix,
                Side::Upper,
                LltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .map_err(|_| LinearError::Singular)?;
        Ok(())
    }

    /// `A⁻¹ b`, without refinement.
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        let mut x = b.to_vec();
        let scratch = self.symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
        let mut memory = MemBuffer::new(scratch);
        let n = x.len();
        LltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(&mut x, n, 1),
            Par::Seq,
            MemStack::new(&mut memory),
        );
        x
    }
}

/// `A⁻¹ b` refined until the residual stops falling; returns the solution and the last relative residual.
pub fn solve_refined(a: &SymmetricCsc, factor: &SparseCholesky, b: &[f64]) -> (Vec<f64>, f64) {
    let size = |v: &[f64]| v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let scale = size(b);
    let mut x = factor.solve(b);
    let mut best = f64::INFINITY;
    if scale == 0.0 {
        return (x, 0.0);
    }
    for _ in 0..5 {
        let r: Vec<f64> = a.mul(&x).iter().zip(b).map(|(ax, b)| b - ax).collect();
        let residual = size(&r) / scale;
        if residual >= 0.5 * best {
            break;
        }
        best = residual;
        let dx = factor.solve(&r);
        x.iter_mut().zip(&dx).for_each(|(x, d)| *x += d);
    }
    (x, best)
}
