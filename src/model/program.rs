//! A conic program as plain data, with no solver in sight.
//!
//! `min ½ xᵀPx + qᵀx + c` subject to `s = G x + h`, `s ∈ K`, with K a product of small cones. The multipliers `z ∈ K*`
//! satisfy `P x + q = Gᵀ z`.

/// Symmetric sparse matrix, upper triangle by columns, row indices increasing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SymmetricCsc {
    /// Order.
    pub n: usize,
    /// Start of each column, `n + 1` entries.
    pub col_ptr: Vec<usize>,
    /// Row of each entry, `row ≤ column`.
    pub row_idx: Vec<usize>,
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
}
