//! Sparse Cholesky factor of a symmetric positive definite matrix: ordered once, factored as often
//! as its values change.

use super::error::LinearError;
use super::factor::{self, Pool};
use super::layout::Layout;
use super::locator::Locator;
use super::patterns::Patterns;
use super::substitution;
use super::symbolic::Update;
use crate::programs::conic::SymmetricCsc;
use bracket_base::say;
use bracket_base::words::Text;
use rayon::prelude::*;
use std::collections::TryReserveError;
use std::sync::Arc;

/// A Cholesky factor `A = L Lᵀ` under nested dissection.
pub struct SparseCholesky {
    pub(super) layout: Arc<Layout>,
    /// The matrix, later its factor, in that layout.
    values: Vec<f64>,
    pool: Pool,
}

impl SparseCholesky {
    /// Factors the upper triangle `a`. `block` gives the block of each unknown for the ordering,
    /// which is taken from `patterns` if known.
    pub fn new(a: &SymmetricCsc, block: &[u32], patterns: &Patterns) -> Result<Self, LinearError> {
        let mut factor = Self::symbolic(a, block, patterns)?;
        factor.refactor(a)?;
        Ok(factor)
    }

    /// Factors a matrix with the pattern of the layout.
    pub fn refactor(&mut self, a: &SymmetricCsc) -> Result<(), LinearError> {
        self.clear()?;
        let mut values = std::mem::take(&mut self.values);
        let mut locator = self.locator();
        for c in 0..a.n {
            let range = a.col_ptr[c]..a.col_ptr[c + 1];
            for (&r, &v) in a.row_idx[range.clone()].iter().zip(&a.values[range]) {
                values[locator.place(r, c as u32) as usize] += v;
            }
        }
        self.values = values;
        self.factor()
    }

    /// Lays out the factor of matrices with the pattern of `a`, without values. The layout is taken
    /// from `patterns`, or made and stored there.
    pub fn symbolic(
        a: &SymmetricCsc,
        block: &[u32],
        patterns: &Patterns,
    ) -> Result<Self, LinearError> {
        let layout = patterns.layout(a, block);
        if layout.symbolic.storage() > u32::MAX as usize {
            let gib = layout.symbolic.storage() as f64 / f64::from(1 << 27);
            let size = format!("{gib:.0} GiB");
            return Err(LinearError::Setup(say!("its factor would take {}", size)));
        }
        Ok(Self { layout, values: Vec::new(), pool: Pool::default() })
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.layout.symbolic.n
    }

    /// Nonzeros of the factor.
    pub fn nonzeros(&self) -> usize {
        self.layout.symbolic.nonzeros()
    }

    /// Floating-point operations of a factorisation.
    pub fn flops(&self) -> f64 {
        self.layout.symbolic.flops.iter().sum()
    }

    /// Memory of the factor with values and of its layout \[bytes\].
    pub fn bytes(&self) -> usize {
        let s = &self.layout.symbolic;
        8 * s.storage()
            + 4 * s.rows.len()
            + std::mem::size_of::<Update>() * s.updates.len()
            + 24 * s.n
    }

    /// The storage, set to zero. The caller adds the entries of the matrix at the places that the
    /// locator gives, then factors.
    pub fn clear(&mut self) -> Result<&mut [f64], LinearError> {
        if self.values.is_empty() {
            let len = self.layout.symbolic.storage();
            let failed = |e: TryReserveError| LinearError::Setup(Text::given(e.to_string()));
            self.values.try_reserve_exact(len).map_err(failed)?;
            huge_pages(&mut self.values);
            self.values.resize(len, 0.0);
        } else {
            self.values.par_chunks_mut(1 << 18).for_each(|part| part.fill(0.0));
        }
        Ok(&mut self.values)
    }

    /// Factors the matrix that has been added.
    pub fn factor(&mut self) -> Result<(), LinearError> {
        factor::factor(&self.layout.symbolic, &self.layout.plan, &mut self.values, &self.pool)
            .map_err(|_| LinearError::Singular)
    }

    /// The places of entries.
    pub fn locator(&self) -> Locator<'_> {
        Locator::new(&self.layout)
    }

    /// `A⁻¹ b`, without refinement.
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        let [x] = self.solve_all([b]);
        x
    }

    /// `A⁻¹ B` for a few right-hand sides, at about the cost of one.
    pub fn solve_all<const SIDES: usize>(&self, b: [&[f64]; SIDES]) -> [Vec<f64>; SIDES] {
        let n = self.layout.symbolic.n;
        let mut x = vec![0.0; SIDES * n];
        for (new, &old) in self.layout.symbolic.order.iter().enumerate() {
            for (k, side) in b.iter().enumerate() {
                x[SIDES * new + k] = side[old as usize];
            }
        }
        substitution::solve::<SIDES>(
            &self.layout.symbolic,
            &self.layout.plan,
            &self.values,
            &mut x,
        );
        std::array::from_fn(|k| {
            self.layout.symbolic.position.iter().map(|&p| x[SIDES * p as usize + k]).collect()
        })
    }
}

/// Requests huge pages for memory not yet touched: the address cache does not cover the factor in
/// small pages.
fn huge_pages(values: &mut Vec<f64>) {
    #[cfg(target_os = "linux")]
    {
        const PAGE: usize = 1 << 21;
        let start = (values.as_mut_ptr() as usize).next_multiple_of(PAGE);
        let end = values.as_mut_ptr() as usize + 8 * values.capacity();
        if end > start + PAGE {
            // SAFETY: the range lies within one allocation of ours; the call only advises and
            // changes no content
            unsafe {
                libc::madvise(
                    start as *mut libc::c_void,
                    (end - start) / PAGE * PAGE,
                    libc::MADV_HUGEPAGE,
                )
            };
        }
    }
}

/// `A⁻¹ b`, refined until the residual stops falling: the solution and its last relative residual.
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
