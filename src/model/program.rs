//! A conic program as plain data, with no solver in sight.
//!
//! `min ½ xᵀPx + qᵀx + c` subject to `s = G x + h`, `s ∈ K`, with K a product of small cones. The multipliers `z ∈ K*`
//! satisfy `P x + q = Gᵀ z`.
//!
//! Some unknowns may be maximised over instead: multipliers `y` of equations `E x − F y = b` among the others, which no cone
//! touches. They stand in the same vector, and P is then the matrix of a saddle, `[P Eᵀ; E −F]` with q = (q, −b): P and F
//! positive semidefinite, every stationarity row as before.

use std::ops::Range;

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
    /// When an unknown is eliminated: 0 by the sparse factor, above it element by element, the highest stage first.
    ///
    /// Empty: all 0. Unknowns of one stage that P or a cone joins are eliminated together, so they must form small groups.
    pub stage: Vec<u8>,
    /// True for an unknown that is maximised over. Empty: none.
    pub maximised: Vec<bool>,
}

impl SymmetricCsc {
    /// `A x`.
    pub fn mul(&self, x: &[f64]) -> Vec<f64> {
        let [y] = self.mul_all([x]);
        y
    }

    /// `A X` for a few vectors, the matrix read once.
    ///
    /// Two halves side by side, whatever the number of threads: the digits do not depend on it.
    pub fn mul_all<const SIDES: usize>(&self, x: [&[f64]; SIDES]) -> [Vec<f64>; SIDES] {
        let half = self.col_ptr.partition_point(|&k| 2 * k < self.values.len()).min(self.n);
        let (mut y, rest) = rayon::join(|| self.mul_columns(0..half, x), || self.mul_columns(half..self.n, x));
        for (y, rest) in y.iter_mut().zip(rest) {
            y.resize(self.n, 0.0);
            y.iter_mut().zip(rest).for_each(|(a, b)| *a += b);
        }
        y
    }

    /// What the given columns and their mirror images add to `A X`; as long as the last of them needs.
    fn mul_columns<const SIDES: usize>(&self, columns: Range<usize>, x: [&[f64]; SIDES]) -> [Vec<f64>; SIDES] {
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
                self.row_idx[range.clone()].binary_search(&(c as u32)).map_or(0.0, |k| self.values[range.start + k])
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
    /// `½ xᵀPx + qᵀx + c`; with unknowns `y` maximised over, the objective `½ xᵀPx + ½ yᵀFy + qᵀx + c` of the minimiser.
    pub fn objective(&self, x: &[f64]) -> f64 {
        let px = self.p.mul(x);
        let term = |i: usize| if self.is_maximised(i) { -0.5 * x[i] * px[i] } else { x[i] * (0.5 * px[i] + self.q[i]) };
        crate::math::Sum::of((0..x.len()).map(term)) + self.c
    }

    /// True when unknown `i` is maximised over.
    pub fn is_maximised(&self, i: usize) -> bool {
        self.maximised.get(i).copied().unwrap_or(false)
    }

    /// Stage at which unknown `i` is eliminated.
    pub fn stage_of(&self, i: usize) -> u8 {
        self.stage.get(i).copied().unwrap_or(0)
    }

    /// `G x + h`.
    pub fn slack(&self, x: &[f64]) -> Vec<f64> {
        self.g.mul(x).iter().zip(&self.h).map(|(a, b)| a + b).collect()
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

/// Distance of a point from the boundary of its cone along the axis: `s₀ − ‖s₁…‖` (or `s` itself); ≥ 0 inside.
pub fn cone_margin(s: &[f64]) -> f64 {
    s[0] - s[1..].iter().map(|x| x * x).sum::<f64>().sqrt()
}
