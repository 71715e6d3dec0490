//! Dense operations on panels of eight elements at once: entry by entry, the eight side by side.

use crate::model::batch::{LANES, Lane};

/// Column `c` of the panel, from row `from` on.
fn column(panel: &[Lane], height: usize, c: usize) -> &[Lane] {
    &panel[c * height..(c + 1) * height]
}

/// Part of a diagonal entry that its pivot is raised by: what rounding may have taken from it.
const ROUNDING: f64 = 1e-14;
/// Rows and columns of a tile, whose sums stay in registers.
const TILE: usize = 4;

/// `Σ_j a_j[r + q] b_j[c + p]` over the columns j of two panels of one height: entry (q, p) of a tile; rows and columns
/// beyond the height are left zero.
#[inline(always)]
fn tile(a: &[Lane], b: &[Lane], height: usize, columns: usize, r: usize, c: usize) -> [[Lane; TILE]; TILE] {
    let mut sums = [[[0.0; LANES]; TILE]; TILE];
    if r + TILE <= height && c + TILE <= height {
        for j in 0..columns {
            let left: &[Lane; TILE] = a[j * height + r..].first_chunk().expect("the tile lies inside");
            let right: &[Lane; TILE] = b[j * height + c..].first_chunk().expect("the tile lies inside");
            for q in 0..TILE {
                for p in 0..TILE {
                    for l in 0..LANES {
                        sums[q][p][l] += left[q][l] * right[p][l];
                    }
                }
            }
        }
        return sums;
    }
    let (rows, cols) = ((height - r).min(TILE), (height - c).min(TILE));
    for j in 0..columns {
        for p in 0..cols {
            let right = b[j * height + c + p];
            for q in 0..rows {
                let left = a[j * height + r + q];
                for l in 0..LANES {
                    sums[q][p][l] += left[l] * right[l];
                }
            }
        }
    }
    sums
}

/// Start of column `c` in a lower triangle of order `n` packed by columns.
#[inline(always)]
pub fn packed(n: usize, c: usize) -> usize {
    c * n - c * c.saturating_sub(1) / 2
}

/// `out += Σ_j a_j b_jᵀ` over the rows from `from` on, of two panels of one height: lower triangle by columns. The sum must be
/// symmetric.
#[inline(always)]
pub fn add_products(a: &[Lane], b: &[Lane], height: usize, columns: usize, from: usize, out: &mut [Lane]) {
    let k = height - from;
    for c in (from..height).step_by(TILE) {
        for r in (c..height).step_by(TILE) {
            let sums = tile(a, b, height, columns, r, c);
            for (p, column) in (c..height.min(c + TILE)).enumerate() {
                let start = packed(k, column - from);
                for (q, row) in (r..height.min(r + TILE)).enumerate() {
                    if row >= column {
                        let entry = &mut out[start + row - column];
                        for l in 0..LANES {
                            entry[l] += sums[q][p][l];
                        }
                    }
                }
            }
        }
    }
}

/// Cholesky of the leading m columns, rows below solved; returns the products `X Xᵀ`, lower triangle by columns. `None`
/// where a pivot is not positive.
pub fn eliminate(panel: &mut [Lane], m: usize, height: usize) -> Option<Vec<Lane>> {
    let k = height - m;
    let mut products = vec![[0.0; LANES]; k * (k + 1) / 2];
    let positive = pulp::Arch::new().dispatch(
        #[inline(always)]
        || {
            for c in (0..m).step_by(TILE) {
                let width = (m - c).min(TILE);
                let (done, own) = panel.split_at_mut(c * height);
                for p in 0..width {
                    let pivot = &mut own[p * height + c + p];
                    for l in 0..LANES {
                        pivot[l] *= 1.0 + ROUNDING;
                    }
                }
                // what the columns before take from this block of columns
                for r in (c..height).step_by(TILE) {
                    let sums = tile(done, done, height, c, r, c);
                    for p in 0..width {
                        for (q, row) in (r..height.min(r + TILE)).enumerate() {
                            for l in 0..LANES {
                                own[p * height + row][l] -= sums[q][p][l];
                            }
                        }
                    }
                }
                for p in 0..width {
                    let (before, column) = own.split_at_mut(p * height);
                    let column = &mut column[..height];
                    for j in 0..p {
                        let earlier = &before[j * height..(j + 1) * height];
                        let factor = earlier[c + p];
                        for (x, y) in column[c + p..].iter_mut().zip(&earlier[c + p..]) {
                            for l in 0..LANES {
                                x[l] -= y[l] * factor[l];
                            }
                        }
                    }
                    let mut inverse = [0.0; LANES];
                    for l in 0..LANES {
                        // not a number is not positive either
                        if column[c + p][l].is_nan() || column[c + p][l] <= 0.0 {
                            return false;
                        }
                        inverse[l] = column[c + p][l].sqrt().recip();
                    }
                    for row in &mut column[c + p..] {
                        for l in 0..LANES {
                            row[l] *= inverse[l];
                        }
                    }
                }
            }
            add_products(panel, panel, height, m, m, &mut products);
            true
        },
    );
    positive.then_some(products)
}

/// `x ← L⁻¹ x` on top, `x ← −X (L⁻¹ x)` below.
pub fn forward(panel: &[Lane], m: usize, height: usize, x: &mut [Lane]) {
    pulp::Arch::new().dispatch(
        #[inline(always)]
        || {
            for c in 0..m {
                let own = column(panel, height, c);
                let mut y = x[c];
                for l in 0..LANES {
                    y[l] /= own[c][l];
                }
                x[c] = y;
                for r in c + 1..height {
                    for l in 0..LANES {
                        x[r][l] -= own[r][l] * y[l];
                    }
                }
            }
        },
    );
}

/// `x ← L⁻ᵀ (x − Xᵀ x_below)` on top.
pub fn backward(panel: &[Lane], m: usize, height: usize, x: &mut [Lane]) {
    pulp::Arch::new().dispatch(
        #[inline(always)]
        || {
            for c in (0..m).rev() {
                let own = column(panel, height, c);
                let mut y = x[c];
                for r in c + 1..height {
                    for l in 0..LANES {
                        y[l] -= own[r][l] * x[r][l];
                    }
                }
                for l in 0..LANES {
                    y[l] /= own[c][l];
                }
                x[c] = y;
            }
        },
    );
}
