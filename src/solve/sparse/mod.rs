//! One symmetric positive definite sparse system: ordered once, factored as often as its values
//! change.

pub mod blocks;
pub mod dense;
pub mod factor;
pub mod ordering;
pub mod patterns;
pub mod substitution;
pub mod symbolic;

use crate::programs::conic::SymmetricCsc;
use factor::Pool;
use patterns::Layout;
pub use patterns::Patterns;
use rayon::prelude::*;
use std::sync::Arc;
use symbolic::Symbolic;

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
    layout: Arc<Layout>,
    /// The matrix, and then its factor, in that layout.
    values: Vec<f64>,
    pool: Pool,
}

impl SparseCholesky {
    /// Factors the upper triangle `a`; `block` gives the block of each unknown for the ordering,
    /// which `patterns` may know.
    pub fn new(a: &SymmetricCsc, block: &[u32], patterns: &Patterns) -> Result<Self, LinearError> {
        let mut factor = Self::symbolic(a, block, patterns)?;
        factor.refactor(a)?;
        Ok(factor)
    }

    /// Factors a matrix with the pattern the layout was made for.
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

    /// Lays out the factor of matrices with the pattern of `a`, as `patterns` knows it or learns it
    /// now, without numbers yet.
    pub fn symbolic(
        a: &SymmetricCsc,
        block: &[u32],
        patterns: &Patterns,
    ) -> Result<Self, LinearError> {
        let layout = patterns.layout(a, block);
        if layout.symbolic.len() > u32::MAX as usize {
            let gib = layout.symbolic.len() as f64 / f64::from(1 << 27);
            return Err(LinearError::Setup(format!("its factor would take {gib:.0} GiB")));
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

    /// Length of its storage.
    pub fn len(&self) -> usize {
        self.layout.symbolic.len()
    }

    /// True for an empty matrix.
    pub fn is_empty(&self) -> bool {
        self.layout.symbolic.is_empty()
    }

    /// Floating-point operations of a factorisation.
    pub fn flops(&self) -> f64 {
        self.layout.symbolic.flops.iter().sum()
    }

    /// Memory of the factor and its layout, once it has numbers \[bytes\].
    pub fn bytes(&self) -> usize {
        let s = &self.layout.symbolic;
        8 * s.len()
            + 4 * s.rows.len()
            + std::mem::size_of::<symbolic::Update>() * s.updates.len()
            + 24 * s.n
    }

    /// The storage, all zero: the entries of the matrix are added at the places the locator tells,
    /// then it is factored.
    pub fn clear(&mut self) -> Result<&mut [f64], LinearError> {
        if self.values.is_empty() {
            let len = self.layout.symbolic.len();
            self.values.try_reserve_exact(len).map_err(|e| LinearError::Setup(e.to_string()))?;
            huge_pages(&mut self.values);
            self.values.resize(len, 0.0);
        } else {
            self.values.par_chunks_mut(1 << 18).for_each(|part| part.fill(0.0));
        }
        Ok(&mut self.values)
    }

    /// The storage.
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// Factors the matrix that has been added.
    pub fn factor(&mut self) -> Result<(), LinearError> {
        factor::factor(&self.layout.symbolic, &self.layout.plan, &mut self.values, &self.pool)
            .map_err(|_| LinearError::Singular)
    }

    /// Tells the places of entries.
    pub fn locator(&self) -> Locator<'_> {
        Locator::new(&self.layout)
    }

    /// `A⁻¹ b`, without refinement.
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        let [x] = self.solve_all([b]);
        x
    }

    /// `A⁻¹ B` for a few right-hand sides, at about the price of one.
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

/// Asks for huge pages under memory not yet touched: the factor is too large for the address cache
/// of small ones.
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

/// Finds the place of matrix entries in the factor's storage; entries of one column and block in a
/// row are cheap.
pub struct Locator<'a> {
    symbolic: &'a Symbolic,
    block: &'a [u32],
    /// Supernode of each position.
    owner: Vec<u32>,
    /// Position of the first unknown of each block.
    first: Vec<u32>,
    /// The supernode, block and row found last.
    known: (u32, u32, u32),
}

impl<'a> Locator<'a> {
    fn new(layout: &'a Layout) -> Self {
        let (symbolic, block) = (&layout.symbolic, &layout.pattern.block[..]);
        let mut owner = vec![0u32; symbolic.n];
        for s in 0..symbolic.supernodes() {
            owner[symbolic.begin[s] as usize..symbolic.begin[s + 1] as usize].fill(s as u32);
        }
        let mut first = vec![u32::MAX; block.iter().map(|&b| b as usize + 1).max().unwrap_or(0)];
        for (i, &b) in block.iter().enumerate() {
            first[b as usize] = first[b as usize].min(symbolic.position[i]);
        }
        Self { symbolic, block, owner, first, known: (u32::MAX, u32::MAX, 0) }
    }

    /// Place of the entry of unknowns `r` and `c`, which must be in the pattern.
    pub fn place(&mut self, r: u32, c: u32) -> u32 {
        let symbolic = self.symbolic;
        let (pr, pc) = (symbolic.position[r as usize], symbolic.position[c as usize]);
        let (low, high, outer) = if pr > pc { (pc, pr, r) } else { (pr, pc, c) };
        let block = self.block[outer as usize];
        let s = self.owner[low as usize];
        let first = self.first[block as usize];
        if (self.known.0, self.known.1) != (s, block) {
            self.known = (s, block, row_in(symbolic, s as usize, first));
        }
        let s = s as usize;
        let row = (self.known.2 + (high - first)) as usize;
        let column = (low - symbolic.begin[s]) as usize;
        (symbolic.value_start[s] + column * symbolic.height(s) + row) as u32
    }
}

/// Row of unknown `position` in the dense block of supernode `s`.
fn row_in(symbolic: &Symbolic, s: usize, position: u32) -> u32 {
    if position < symbolic.begin[s + 1] {
        return position - symbolic.begin[s];
    }
    let rows = symbolic.rows_of(s);
    symbolic.columns(s) as u32 + rows.partition_point(|&r| r < position) as u32
}

/// `A⁻¹ b` refined until the residual stops falling; returns the solution and the last relative
/// residual.
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Laplacian of a grid of nodes with three unknowns each, shifted to be definite; blocks are
    /// the nodes.
    fn grid(m: usize) -> (SymmetricCsc, Vec<u32>) {
        let node = |i: usize, j: usize, k: usize| (i * m + j) * m + k;
        let mut columns: Vec<Vec<(u32, f64)>> = vec![Vec::new(); 3 * m * m * m];
        for i in 0..m {
            for j in 0..m {
                for k in 0..m {
                    let here = node(i, j, k);
                    for d in 0..3 {
                        let column = 3 * here + d;
                        let before = [
                            (i > 0, i.wrapping_sub(1), j, k),
                            (j > 0, i, j.wrapping_sub(1), k),
                            (k > 0, i, j, k.wrapping_sub(1)),
                        ];
                        for (inside, a, b, c) in before {
                            if inside {
                                let other = node(a, b, c);
                                (0..3).for_each(|e| {
                                    columns[column].push((
                                        (3 * other + e) as u32,
                                        if d == e { -1.0 } else { -0.2 },
                                    ))
                                });
                            }
                        }
                        (0..d).for_each(|e| columns[column].push(((3 * here + e) as u32, 0.3)));
                        columns[column].push((column as u32, 8.0 + 0.01 * column as f64));
                        columns[column].sort_unstable_by_key(|e| e.0);
                    }
                }
            }
        }
        let mut a = SymmetricCsc { n: columns.len(), col_ptr: vec![0], ..SymmetricCsc::default() };
        for column in columns {
            column.iter().for_each(|&(r, v)| {
                a.row_idx.push(r);
                a.values.push(v);
            });
            a.col_ptr.push(a.row_idx.len());
        }
        let block = (0..a.n as u32).map(|i| i / 3).collect();
        (a, block)
    }

    #[test]
    fn solves_several_sides_to_rounding() {
        let (a, block) = grid(13);
        let factor =
            SparseCholesky::new(&a, &block, &Patterns::default()).expect("the matrix is definite");
        let sides: [Vec<f64>; 2] =
            std::array::from_fn(|k| (0..a.n).map(|i| ((7 * i + k) % 11) as f64 - 5.0).collect());
        let x = factor.solve_all([&sides[0], &sides[1]]);
        for (x, b) in x.iter().zip(&sides) {
            let ax = a.mul(x);
            let error = ax.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(error < 1e-12, "{error:e}");
            // one side alone goes through other kernels, to the same answer
            let alone = factor.solve(b);
            let off = alone.iter().zip(x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-13, "{off:e}");
        }
    }

    #[test]
    fn any_number_of_threads_gives_the_same_bits() {
        let (a, block) = grid(14);
        let factors: Vec<Vec<f64>> = [1, 2, 3]
            .map(|threads| {
                let pool =
                    rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
                pool.install(|| {
                    SparseCholesky::new(&a, &block, &Patterns::default())
                        .expect("the matrix is definite")
                        .solve(&vec![1.0; a.n])
                })
            })
            .into();
        assert!(
            factors
                .windows(2)
                .all(|w| w[0].iter().zip(&w[1]).all(|(a, b)| a.to_bits() == b.to_bits()))
        );
    }

    #[test]
    fn an_indefinite_matrix_is_refused() {
        let (mut a, block) = grid(4);
        a.add_diagonal(50, -20.0);
        assert!(matches!(
            SparseCholesky::new(&a, &block, &Patterns::default()),
            Err(LinearError::Singular)
        ));
    }

    #[test]
    fn a_node_joined_to_all_others_is_eliminated_last() {
        let (a, block) = grid(10);
        // one more block, joined to every node
        let mut b = SymmetricCsc { n: a.n + 1, ..a.clone() };
        b.row_idx.extend(0..=a.n as u32);
        b.values.extend(std::iter::repeat_n(0.001, a.n).chain([10.0]));
        b.col_ptr.push(b.row_idx.len());
        let blocks: Vec<u32> = block.iter().copied().chain([block[a.n - 1] + 1]).collect();
        let plain = SparseCholesky::symbolic(&a, &block, &Patterns::default()).expect("laid out");
        let bordered =
            SparseCholesky::symbolic(&b, &blocks, &Patterns::default()).expect("laid out");
        // a border costs one row
        assert!(bordered.nonzeros() < plain.nonzeros() + plain.nonzeros() / 20 + 2 * b.n);
        assert_eq!(bordered.layout.symbolic.order.last(), Some(&(a.n as u32)));
    }
}
