//! A conic program as plain data, independent of any solver.
//!
//! `min ½ xᵀPx + qᵀx + c` subject to `s = G x + h`, `s ∈ K`, with K a product of small cones. The
//! multipliers `z ∈ K*` satisfy `P x + q = Gᵀ z`.
//!
//! Elements that yield and the load factor of limit analysis turn it into a saddle-point problem.
//! Their parameters y are maximised over; they follow the shared unknowns of the elements in the
//! same vector, and the matrix of the quadratic term is `[P E; Eᵀ −F]`. A cone contains minimised
//! unknowns or maximised ones, never both. Rows keep their natural sign: the gradient is
//! `P x + q − Gᵀz` for minimised unknowns and `P x + q + Gᵀz` for maximised ones; it is zero at the
//! saddle point.

use crate::elements::packed_elements::Batch;
use crate::elements::yielding_element::{NONE, YIELD_ROWS};
use bracket_base::math::wide::{LANES, Lane};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;

/// Symmetric sparse matrix, upper triangle by columns, row indices increasing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SymmetricCsc {
    /// Order.
    pub n: usize,
    /// Start of each column, `n + 1` entries.
    pub col_ptr: Vec<usize>,
    /// Row of each entry, `row ≤ column`.
    pub row_idx: Vec<u32>,
    /// Values.
    pub values: Vec<f64>,
}

/// Sparse matrix by rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Csr {
    /// Number of columns.
    pub ncols: usize,
    /// Start of each row, `nrows + 1` entries.
    pub row_ptr: Vec<usize>,
    /// Column of each entry.
    pub col_idx: Vec<usize>,
    /// Values.
    pub values: Vec<f64>,
}

/// A small self-dual cone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cone {
    /// `s ≥ 0`, one row.
    NonNegative,
    /// `s₀ ≥ ‖s₁…‖`, the given number of rows.
    SecondOrder(usize),
}

impl Cone {
    /// Number of rows.
    pub fn dim(self) -> usize {
        match self {
            Cone::NonNegative => 1,
            Cone::SecondOrder(n) => n,
        }
    }
}

/// `min ½ xᵀPx + qᵀx + c`, `G x + h ∈ K`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ConicProgram {
    /// Quadratic term, n × n.
    pub p: SymmetricCsc,
    /// Linear term, n.
    pub q: Vec<f64>,
    /// Constant term.
    pub c: f64,
    /// Rows of the cones, in the order of `cones`.
    pub g: Csr,
    /// Offsets of the rows.
    pub h: Vec<f64>,
    /// The cones.
    pub cones: Vec<Cone>,
    /// Elements that yield. Their own unknowns follow the shared ones, and the rows of their yield
    /// points follow those of `g`; `h` and `cones` contain both.
    pub elements: Elements,
    /// Loads multiplied by the load factor, on the shared unknowns \[N\]; empty: no load factor.
    /// The load factor is the last unknown and maximised over.
    pub live: Vec<f64>,
    /// Stiffness that scales each unknown; empty: the diagonal of P.
    pub stiffness: Vec<f64>,
}

/// All elements that yield.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Elements {
    /// Batches of up to eight elements of one shape.
    pub batches: Arc<Vec<Batch>>,
    /// Factors on the shared and inner displacements of the elements; empty: 1.
    pub scale: Vec<f64>,
}

impl SymmetricCsc {
    /// `A x`.
    pub fn mul(&self, x: &[f64]) -> Vec<f64> {
        let [y] = self.mul_all([x]);
        y
    }

    /// `A X` for a few vectors; the matrix is read once.
    ///
    /// The columns are always split into two halves, so that the result does not depend on the
    /// number of threads.
    pub fn mul_all<const SIDES: usize>(&self, x: [&[f64]; SIDES]) -> [Vec<f64>; SIDES] {
        let half = self.col_ptr.partition_point(|&k| 2 * k < self.values.len()).min(self.n);
        let (mut y, rest) =
            rayon::join(|| self.mul_columns(0..half, x), || self.mul_columns(half..self.n, x));
        for (y, rest) in y.iter_mut().zip(rest) {
            y.resize(self.n, 0.0);
            y.iter_mut().zip(rest).for_each(|(a, b)| *a += b);
        }
        y
    }

    /// Contribution of the given columns and their mirror images to `A X`; the vectors end at the
    /// last of the columns.
    fn mul_columns<const SIDES: usize>(
        &self,
        columns: Range<usize>,
        x: [&[f64]; SIDES],
    ) -> [Vec<f64>; SIDES] {
        let mut y: [Vec<f64>; SIDES] = std::array::from_fn(|_| vec![0.0; columns.end]);
        for c in columns {
            let xc: [f64; SIDES] = std::array::from_fn(|k| x[k][c]);
            let mut yc = [0.0; SIDES];
            let range = self.col_ptr[c]..self.col_ptr[c + 1];
            for (&r, &v) in self.row_idx[range.clone()].iter().zip(&self.values[range]) {
                let r = r as usize;
                if r == c {
                    (0..SIDES).for_each(|k| yc[k] += v * xc[k]);
                    continue;
                }
                for k in 0..SIDES {
                    y[k][r] += v * xc[k];
                    yc[k] += v * x[k][r];
                }
            }
            (0..SIDES).for_each(|k| y[k][c] += yc[k]);
        }
        y
    }

    /// The diagonal.
    pub fn diagonal(&self) -> Vec<f64> {
        (0..self.n)
            .map(|c| {
                let range = self.col_ptr[c]..self.col_ptr[c + 1];
                self.row_idx[range.clone()]
                    .binary_search(&(c as u32))
                    .map_or(0.0, |k| self.values[range.start + k])
            })
            .collect()
    }

    /// Adds `d` to the stored diagonal entry of column `c`.
    pub fn add_diagonal(&mut self, c: usize, d: f64) {
        let range = self.col_ptr[c]..self.col_ptr[c + 1];
        if let Ok(k) = self.row_idx[range.clone()].binary_search(&(c as u32)) {
            self.values[range.start + k] += d;
        }
    }
}

impl Csr {
    /// Number of rows.
    pub fn nrows(&self) -> usize {
        self.row_ptr.len().saturating_sub(1)
    }

    /// Appends a row.
    pub fn push_row(&mut self, row: &[(u32, f64)]) {
        if self.row_ptr.is_empty() {
            self.row_ptr.push(0);
        }
        for &(c, v) in row {
            self.col_idx.push(c as usize);
            self.values.push(v);
        }
        self.row_ptr.push(self.col_idx.len());
    }

    /// Column indices and values of row `r`.
    pub fn row(&self, r: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let range = self.row_ptr[r]..self.row_ptr[r + 1];
        self.col_idx[range.clone()].iter().copied().zip(self.values[range].iter().copied())
    }

    /// `G x`.
    pub fn mul(&self, x: &[f64]) -> Vec<f64> {
        (0..self.nrows()).map(|r| self.row(r).map(|(c, v)| v * x[c]).sum()).collect()
    }

    /// `Gᵀ z`.
    pub fn mul_transpose(&self, z: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; self.ncols];
        for (r, &zr) in z.iter().enumerate().take(self.nrows()) {
            for (c, v) in self.row(r) {
                y[c] += v * zr;
            }
        }
        y
    }
}

impl ConicProgram {
    /// Number of unknowns that elements share, those of P.
    pub fn shared(&self) -> usize {
        self.p.n
    }

    /// Number of all unknowns.
    pub fn unknowns(&self) -> usize {
        self.q.len()
    }

    /// Appends the load factor of limit analysis, which multiplies the given loads on the shared
    /// unknowns \[N\] and is maximised.
    pub fn add_load_factor(&mut self, live: Vec<f64>) {
        self.live = live;
        self.q.push(1.0);
    }

    /// Prescribes the value of shared unknown `k`. Its couplings move to the linear terms of the
    /// other unknowns and to the offsets. The unknown keeps a quadratic term of its own, minimal at
    /// the value, so that the sparsity pattern stays. The objective is unchanged at that value.
    ///
    /// For programs in which all elements are elastic.
    pub fn freeze(&mut self, k: usize, value: f64) {
        let mut own = 0.0;
        for c in 0..self.p.n {
            for i in self.p.col_ptr[c]..self.p.col_ptr[c + 1] {
                let r = self.p.row_idx[i] as usize;
                match (r == k, c == k) {
                    (true, true) => own = self.p.values[i],
                    (true, false) => self.q[c] += value * std::mem::take(&mut self.p.values[i]),
                    (false, true) => self.q[r] += value * std::mem::take(&mut self.p.values[i]),
                    (false, false) => {}
                }
            }
        }
        // its share of the objective was ½ own v² + q v; its new term is ½ own (x − v)²
        self.c += value * (own * value + self.q[k]);
        self.q[k] = -own * value;
        for r in 0..self.g.nrows() {
            for i in self.g.row_ptr[r]..self.g.row_ptr[r + 1] {
                if self.g.col_idx[i] == k {
                    self.h[r] += value * std::mem::take(&mut self.g.values[i]);
                }
            }
        }
    }

    /// The same program in unknowns relative to the given point: its solutions are those of this
    /// program minus the point. Unknowns beyond the end of `from` stay absolute.
    pub fn measured_from(&self, from: &[f64]) -> Self {
        let mut out = self.clone();
        let mut x = from.to_vec();
        x.resize(self.unknowns(), 0.0);
        let [px] = self.quadratic([&x]);
        let half = (0..x.len()).map(|i| x[i] * (0.5 * px[i] + self.q[i]));
        out.c += bracket_base::math::Sum::of(half);
        out.q.iter_mut().zip(&px).for_each(|(q, p)| *q += p);
        out.h = self.slack(&x);
        out
    }

    /// The unknowns that are maximised over: parameters of elements, and the load factor.
    pub fn maximised(&self) -> Vec<bool> {
        let mut out = vec![false; self.unknowns()];
        for batch in self.elements.batches.iter() {
            for own in batch.own.iter().filter(|o| **o != NONE) {
                out[*own as usize..][..batch.shape.parameters()].fill(true);
            }
        }
        if let (false, Some(last)) = (self.live.is_empty(), out.last_mut()) {
            *last = true;
        }
        out
    }

    /// Value of the primal objective, `½ xᵀPx + ½ yᵀFy + qᵀx + hᵀz + c`, with z the multipliers of
    /// the yield points only.
    pub fn objective(&self, x: &[f64], z: &[f64]) -> f64 {
        let [px] = self.quadratic([x]);
        let maximised = self.maximised();
        let term = |i: usize| {
            if maximised[i] { -0.5 * x[i] * px[i] } else { x[i] * (0.5 * px[i] + self.q[i]) }
        };
        let points = (self.g.nrows()..self.h.len()).map(|r| self.h[r] * z[r]);
        bracket_base::math::Sum::of((0..x.len()).map(term).chain(points)) + self.c
    }

    /// The matrix of the quadratic term times a few vectors.
    pub fn quadratic<const SIDES: usize>(&self, x: [&[f64]; SIDES]) -> [Vec<f64>; SIDES] {
        let mut y = self.p.mul_all(x.map(|x| &x[..self.shared()]));
        y.iter_mut().for_each(|y| y.resize(self.unknowns(), 0.0));
        self.add_of_elements(x, &mut y, |batch, v, sigma, force, strain| {
            batch.strain(v, strain);
            batch.subtract_flexibility(sigma, strain);
            batch.add_force(sigma, force);
            batch.add_inner(v, force);
        });
        self.add_live(x, &mut y);
        y
    }

    /// The diagonal blocks of that matrix (minimised with minimised, maximised with maximised
    /// unknowns) times a vector.
    pub fn quadratic_diagonal(&self, x: &[f64]) -> Vec<f64> {
        let mut y = self.p.mul_all([&x[..self.shared()]]);
        y.iter_mut().for_each(|y| y.resize(self.unknowns(), 0.0));
        // rigid-plastic elements have no such blocks
        if self.elements.batches.iter().any(|b| b.flexible || b.shape.inner() > 0) {
            self.add_of_elements([x], &mut y, |batch, v, sigma, force, strain| {
                batch.subtract_flexibility(sigma, strain);
                batch.add_inner(v, force);
            });
        }
        let [y] = y;
        y
    }

    /// Adds the off-diagonal blocks of that matrix times a vector.
    pub fn add_coupling(&self, x: &[f64], y: &mut Vec<f64>) {
        let mut sides = [std::mem::take(y)];
        self.add_of_elements([x], &mut sides, |batch, v, sigma, force, strain| {
            batch.strain(v, strain);
            batch.add_force(sigma, force);
        });
        self.add_live([x], &mut sides);
        [*y] = sides;
    }

    /// Adds forces and strains of the elements, from their displacements and parameters.
    fn add_of_elements<const SIDES: usize>(
        &self,
        x: [&[f64]; SIDES],
        y: &mut [Vec<f64>; SIDES],
        of: impl Fn(&Batch, &[Lane], &[Lane], &mut [Lane], &mut [Lane]) + Sync,
    ) {
        let (batches, scale) = (&self.elements.batches, &self.elements.scale);
        let parts: Vec<[(Vec<Lane>, Vec<Lane>); SIDES]> = batches
            .par_iter()
            .map(|batch| {
                x.map(|x| {
                    let (v, sigma) =
                        (batch.gather_displacements(x, scale), batch.gather_parameters(x));
                    let (mut force, mut strain) =
                        (vec![[0.0; LANES]; v.len()], vec![[0.0; LANES]; sigma.len()]);
                    of(batch, &v, &sigma, &mut force, &mut strain);
                    (force, strain)
                })
            })
            .collect();
        for (batch, part) in batches.iter().zip(&parts) {
            for (y, (force, strain)) in y.iter_mut().zip(part) {
                batch.scatter_displacements(force, scale, y);
                Batch::scatter(&batch.own, strain, y);
            }
        }
    }

    /// Adds the coupling of the load factor with the live loads.
    fn add_live<const SIDES: usize>(&self, x: [&[f64]; SIDES], y: &mut [Vec<f64>; SIDES]) {
        let (false, Some(last)) = (self.live.is_empty(), self.unknowns().checked_sub(1)) else {
            return;
        };
        for (y, x) in y.iter_mut().zip(x) {
            let factor = x[last];
            y.iter_mut().zip(&self.live).for_each(|(y, f)| *y -= factor * f);
            y[last] -= self.live.iter().zip(x).map(|(f, x)| f * x).sum::<f64>();
        }
    }

    /// `G x`, rows of the yield points included.
    pub fn rows(&self, x: &[f64]) -> Vec<f64> {
        let mut s = self.g.mul(x);
        s.resize(self.h.len(), 0.0);
        let batches = &self.elements.batches;
        let parts: Vec<Vec<Lane>> =
            batches.par_iter().map(|b| b.deviators(&b.gather_parameters(x))).collect();
        for (batch, d) in batches.iter().zip(&parts) {
            for l in (0..LANES).filter(|&l| batch.own[l] != NONE) {
                let at = batch.rows[l] as usize;
                for (cone, d) in
                    s[at..].chunks_exact_mut(YIELD_ROWS).zip(d.chunks_exact(YIELD_ROWS - 1))
                {
                    cone[1..].iter_mut().zip(d).for_each(|(s, d)| *s = d[l]);
                }
            }
        }
        s
    }

    /// `Gᵀ z`, its entries of maximised unknowns with the opposite sign.
    pub fn rows_transposed(&self, z: &[f64]) -> Vec<f64> {
        let mut y = self.g.mul_transpose(&z[..self.g.nrows()]);
        y.resize(self.unknowns(), 0.0);
        let batches = &self.elements.batches;
        let parts: Vec<Vec<Lane>> = batches
            .par_iter()
            .map(|batch| {
                let rows = Batch::gather(&batch.rows, YIELD_ROWS * batch.shape.points(), z);
                let minus: Vec<Lane> = rows
                    .chunks_exact(YIELD_ROWS)
                    .flat_map(|c| c[1..].iter().map(|d| d.map(|x| -x)))
                    .collect();
                let mut out = vec![[0.0; LANES]; batch.shape.parameters()];
                batch.add_deviators(&minus, &mut out);
                out
            })
            .collect();
        batches.iter().zip(&parts).for_each(|(batch, d)| Batch::scatter(&batch.own, d, &mut y));
        y
    }

    /// `G x + h`.
    pub fn slack(&self, x: &[f64]) -> Vec<f64> {
        self.rows(x).iter().zip(&self.h).map(|(a, b)| a + b).collect()
    }

    /// First row of each cone.
    pub fn cone_starts(&self) -> Vec<usize> {
        self.cones
            .iter()
            .scan(0, |row, c| {
                let start = *row;
                *row += c.dim();
                Some(start)
            })
            .collect()
    }
}

/// Distance of a point from the boundary of its cone along the axis: `s₀ − ‖s₁…‖` (or `s` itself);
/// ≥ 0 inside.
pub fn cone_margin(s: &[f64]) -> f64 {
    s[0] - s[1..].iter().map(|x| x * x).sum::<f64>().sqrt()
}
