//! Products and triangular solves of the blocks of small supernodes, in registers, on column-major
//! storage.
//!
//! Most supernodes are a few dozen columns wide: too small for kernels that pack their operands
//! first. Here a strip of rows, three registers high, stays in registers while the loop runs over
//! the columns. The kernels use loops and no closures: code that is not inlined into a kernel is
//! compiled for the baseline instruction set.

use bracket_base::math::wide::dispatch;
use pulp::{Simd, WithSimd};
use std::ops::Range;

/// Registers of rows in a strip.
const HIGH: usize = 3;
/// Columns in a strip.
const WIDE: usize = 4;

/// V registers of rows from the front of a column.
#[inline(always)]
fn load<S: Simd, const V: usize>(simd: S, x: &[f64]) -> [S::f64s; V] {
    let mut out = [simd.splat_f64s(0.0); V];
    out.copy_from_slice(S::as_simd_f64s(&x[..V * S::F64_LANES]).0);
    out
}

/// Cholesky of the square on top of a block, and the rows below it solved by it, in place, lower
/// triangle. The block has `columns` columns of `height` values. False when a pivot is not
/// positive.
pub fn factor(block: &mut [f64], height: usize, columns: usize) -> bool {
    dispatch(Factor { block, height, columns })
}

struct Factor<'a> {
    block: &'a mut [f64],
    height: usize,
    columns: usize,
}

impl WithSimd for Factor<'_> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        let Self { block, height, columns } = self;
        // reciprocals of the diagonal
        let mut inverse = vec![0.0; columns];
        for c in (0..columns).step_by(WIDE) {
            let positive = match columns - c {
                1 => factor_columns::<S, 1>(simd, block, height, &mut inverse, c),
                2 => factor_columns::<S, 2>(simd, block, height, &mut inverse, c),
                3 => factor_columns::<S, 3>(simd, block, height, &mut inverse, c),
                _ => factor_columns::<S, 4>(simd, block, height, &mut inverse, c),
            };
            if !positive {
                return false;
            }
        }
        let mut row = columns;
        while row + HIGH * S::F64_LANES <= height {
            solve_strip::<S, HIGH>(simd, block, height, &inverse, row);
            row += HIGH * S::F64_LANES;
        }
        while row + S::F64_LANES <= height {
            solve_strip::<S, 1>(simd, block, height, &inverse, row);
            row += S::F64_LANES;
        }
        if row < height {
            for c in 0..columns {
                solve_last_rows::<S>(simd, block, height, &inverse, row..height, c);
            }
        }
        true
    }
}

/// W columns of the square from column `c` on.
#[inline(always)]
fn factor_columns<S: Simd, const W: usize>(
    simd: S,
    block: &mut [f64],
    height: usize,
    inverse: &mut [f64],
    c: usize,
) -> bool {
    let columns = inverse.len();
    let (done, own) = block.split_at_mut(c * height);
    let mut sums = [[0.0; W]; W];
    for column in done.chunks_exact(height) {
        let row = &column[c..c + W];
        for p in 0..W {
            for q in 0..W {
                sums[p][q] += row[p] * row[q];
            }
        }
    }
    for p in 0..W {
        for q in p..W {
            let mut v = own[p * height + c + q] - sums[p][q];
            for j in 0..p {
                v -= own[j * height + c + p] * own[j * height + c + q];
            }
            if p == q {
                // NaN is not positive either
                if v.is_nan() || v <= 0.0 {
                    return false;
                }
                v = v.sqrt();
                inverse[c + p] = v.recip();
            } else {
                v *= inverse[c + p];
            }
            own[p * height + c + q] = v;
        }
    }
    let mut row = c + W;
    while row + HIGH * S::F64_LANES <= columns {
        solve_tile::<S, HIGH, W>(simd, block, height, inverse, row, c);
        row += HIGH * S::F64_LANES;
    }
    while row + S::F64_LANES <= columns {
        solve_tile::<S, 1, W>(simd, block, height, inverse, row, c);
        row += S::F64_LANES;
    }
    if row < columns {
        for c in c..c + W {
            solve_last_rows::<S>(simd, block, height, inverse, row..columns, c);
        }
    }
    true
}

/// V registers of rows from `row` on.
#[inline(always)]
fn solve_strip<S: Simd, const V: usize>(
    simd: S,
    block: &mut [f64],
    height: usize,
    inverse: &[f64],
    row: usize,
) {
    let columns = inverse.len();
    let mut c = 0;
    while c + WIDE <= columns {
        solve_tile::<S, V, WIDE>(simd, block, height, inverse, row, c);
        c += WIDE;
    }
    match columns - c {
        1 => solve_tile::<S, V, 1>(simd, block, height, inverse, row, c),
        2 => solve_tile::<S, V, 2>(simd, block, height, inverse, row, c),
        3 => solve_tile::<S, V, 3>(simd, block, height, inverse, row, c),
        _ => {}
    }
}

/// W columns from column `c` on.
#[inline(always)]
fn solve_tile<S: Simd, const V: usize, const W: usize>(
    simd: S,
    block: &mut [f64],
    height: usize,
    inverse: &[f64],
    row: usize,
    c: usize,
) {
    let (done, own) = block.split_at_mut(c * height);
    let mut x = [[simd.splat_f64s(0.0); V]; W];
    for p in 0..W {
        x[p] = load::<S, V>(simd, &own[p * height + row..]);
    }
    for column in done.chunks_exact(height) {
        let left = load::<S, V>(simd, &column[row..]);
        let right = &column[c..c + W];
        for p in 0..W {
            let factor = simd.splat_f64s(right[p]);
            for v in 0..V {
                x[p][v] = simd.negate_mul_add_e_f64s(left[v], factor, x[p][v]);
            }
        }
    }
    for p in 0..W {
        for j in 0..p {
            let factor = simd.splat_f64s(own[j * height + c + p]);
            for v in 0..V {
                x[p][v] = simd.negate_mul_add_e_f64s(x[j][v], factor, x[p][v]);
            }
        }
        let inverse = simd.splat_f64s(inverse[c + p]);
        for v in 0..V {
            x[p][v] = simd.mul_f64s(x[p][v], inverse);
        }
        let to = &mut own[p * height + row..][..V * S::F64_LANES];
        S::as_mut_simd_f64s(to).0.copy_from_slice(&x[p]);
    }
}

/// Column `c` of the last rows, fewer than a register holds.
#[inline(always)]
fn solve_last_rows<S: Simd>(
    simd: S,
    block: &mut [f64],
    height: usize,
    inverse: &[f64],
    rows: Range<usize>,
    c: usize,
) {
    let (done, own) = block.split_at_mut(c * height);
    let mut x = simd.partial_load_f64s(&own[rows.clone()]);
    for column in done.chunks_exact(height) {
        let left = simd.partial_load_f64s(&column[rows.clone()]);
        x = simd.negate_mul_add_e_f64s(left, simd.splat_f64s(column[c]), x);
    }
    simd.partial_store_f64s(&mut own[rows], simd.mul_f64s(x, simd.splat_f64s(inverse[c])));
}

/// Update of one supernode by another: the rows from `first` on of the updating block times the
/// first of these rows.
pub struct Update<'a> {
    /// The updating block.
    pub block: &'a [f64],
    /// Its height.
    pub height: usize,
    /// Its columns.
    pub depth: usize,
    /// First of the rows.
    pub first: usize,
    /// Number of them that are columns of the target.
    pub wide: usize,
}

impl Update<'_> {
    /// Subtracts from the columns of `target`: value (i, j) goes to row `rows[i]` of column
    /// `columns[j]`, columns `height` long. Some values above the diagonal are written as well.
    pub fn subtract(&self, target: &mut [f64], height: usize, rows: &[u32], columns: &[u32]) {
        dispatch(Subtract { update: self, target, height, rows, columns });
    }
}

struct Subtract<'a> {
    update: &'a Update<'a>,
    target: &'a mut [f64],
    height: usize,
    rows: &'a [u32],
    columns: &'a [u32],
}

impl WithSimd for Subtract<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) {
        let wide = self.update.wide;
        let mut c = 0;
        while c + WIDE <= wide {
            self.columns::<S, WIDE>(simd, c);
            c += WIDE;
        }
        match wide - c {
            1 => self.columns::<S, 1>(simd, c),
            2 => self.columns::<S, 2>(simd, c),
            3 => self.columns::<S, 3>(simd, c),
            _ => {}
        }
    }
}

impl Subtract<'_> {
    /// W columns from column `c` on, the rows from there on.
    #[inline(always)]
    fn columns<S: Simd, const W: usize>(&mut self, simd: S, c: usize) {
        let tall = self.rows.len();
        let mut row = c;
        while row + HIGH * S::F64_LANES <= tall {
            self.tile::<S, HIGH, W>(simd, row, c);
            row += HIGH * S::F64_LANES;
        }
        while row + S::F64_LANES <= tall {
            self.tile::<S, 1, W>(simd, row, c);
            row += S::F64_LANES;
        }
        if row < tall {
            self.last_rows::<S, W>(simd, row, c);
        }
    }

    #[inline(always)]
    fn tile<S: Simd, const V: usize, const W: usize>(&mut self, simd: S, row: usize, c: usize) {
        let Update { block, height, depth, first, .. } = *self.update;
        let mut sums = [[simd.splat_f64s(0.0); V]; W];
        for column in block[..depth * height].chunks_exact(height) {
            let left = load::<S, V>(simd, &column[first + row..]);
            let right = &column[first + c..][..W];
            for p in 0..W {
                let factor = simd.splat_f64s(right[p]);
                for v in 0..V {
                    sums[p][v] = simd.mul_add_e_f64s(left[v], factor, sums[p][v]);
                }
            }
        }
        let count = V * S::F64_LANES;
        let rows = &self.rows[row..row + count];
        let together = rows[count - 1] - rows[0] + 1 == count as u32;
        for p in 0..W {
            let column =
                &mut self.target[self.columns[c + p] as usize * self.height..][..self.height];
            if together {
                let to = S::as_mut_simd_f64s(&mut column[rows[0] as usize..][..count]).0;
                for (to, sum) in to.iter_mut().zip(&sums[p]) {
                    *to = simd.sub_f64s(*to, *sum);
                }
                continue;
            }
            let mut values = [0.0; 8 * HIGH];
            S::as_mut_simd_f64s(&mut values[..count]).0.copy_from_slice(&sums[p]);
            for (&to, value) in rows.iter().zip(&values) {
                column[to as usize] -= value;
            }
        }
    }

    #[inline(always)]
    fn last_rows<S: Simd, const W: usize>(&mut self, simd: S, row: usize, c: usize) {
        let Update { block, height, depth, first, .. } = *self.update;
        let (from, count) = (first + row, self.rows.len() - row);
        let mut sums = [simd.splat_f64s(0.0); W];
        for column in block[..depth * height].chunks_exact(height) {
            let left = simd.partial_load_f64s(&column[from..from + count]);
            for p in 0..W {
                sums[p] =
                    simd.mul_add_e_f64s(left, simd.splat_f64s(column[first + c + p]), sums[p]);
            }
        }
        for p in 0..W {
            let column =
                &mut self.target[self.columns[c + p] as usize * self.height..][..self.height];
            let mut values = [0.0; 8];
            simd.partial_store_f64s(&mut values[..count], sums[p]);
            for (&to, value) in self.rows[row..].iter().zip(&values) {
                column[to as usize] -= value;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reproducible pseudo-random numbers.
    fn noise(count: usize) -> Vec<f64> {
        (0..count).map(|i| ((i * 7919 + 13) % 1009) as f64 / 1009.0 - 0.5).collect()
    }

    #[test]
    fn the_factor_times_its_transpose_is_the_matrix() {
        // every remainder of columns and rows, narrow and wide
        for (columns, height) in [(1, 1), (2, 9), (3, 3), (5, 30), (12, 61), (27, 64), (50, 131)] {
            let mut block = noise(columns * height);
            (0..columns).for_each(|c| block[c * height + c] = columns as f64);
            let matrix = block.clone();
            assert!(factor(&mut block, height, columns));
            for j in 0..columns {
                for i in j..height {
                    let product: f64 =
                        (0..=j).map(|k| block[k * height + i] * block[k * height + j]).sum();
                    let off = (product - matrix[j * height + i]).abs();
                    assert!(
                        off < 1e-13 * columns as f64,
                        "{columns} × {height}: ({i}, {j}) is off by {off:e}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_pivot_that_is_not_positive_is_refused() {
        for bad in [0.0, -1.0, f64::NAN] {
            let mut block = vec![0.0; 36];
            (0..6).for_each(|c| block[7 * c] = 1.0);
            block[7 * 4] = bad;
            assert!(!factor(&mut block, 6, 6), "{bad}");
        }
    }

    #[test]
    fn updates_go_to_their_rows_and_columns() {
        for (depth, wide, tall) in [(1, 1, 1), (3, 2, 5), (7, 6, 33), (12, 12, 70)] {
            let (above, height) = (4, depth + 4 + tall);
            let block = noise(depth * height);
            let first = depth + above;
            // the first half of the rows is one run, the others stand apart
            let rows: Vec<u32> = (0..tall as u32)
                .map(|i| if i < tall as u32 / 2 { i + 1 } else { 2 * i + 1 })
                .collect();
            let columns: Vec<u32> = (0..wide as u32).map(|j| 2 * j).collect();
            let (target_height, target_columns) = (2 * tall + 2, 2 * wide);
            let before = noise(target_height * target_columns);
            let mut target = before.clone();
            let update = Update { block: &block, height, depth, first, wide };
            update.subtract(&mut target, target_height, &rows, &columns);
            for j in 0..wide {
                for i in j..tall {
                    let product: f64 = (0..depth)
                        .map(|k| block[k * height + first + i] * block[k * height + first + j])
                        .sum();
                    let at = columns[j] as usize * target_height + rows[i] as usize;
                    assert!(
                        (target[at] - before[at] + product).abs() < 1e-14,
                        "{depth} {wide} {tall}: ({i}, {j})"
                    );
                }
            }
            // nothing else below the diagonal is touched
            let touched = |at: usize| {
                let (column, row) = ((at / target_height) as u32, (at % target_height) as u32);
                columns.contains(&column) && rows.contains(&row)
            };
            assert!((0..target.len()).all(|at| touched(at) || target[at] == before[at]));
        }
    }
}
