//! Dense operations on panels of eight elements at once: entry by entry, the eight side by side.

use crate::model::batch::{LANES, Lane};

/// Column `c` of the panel, from row `from` on.
fn column(panel: &[Lane], height: usize, c: usize) -> &[Lane] {
    &panel[c * height..(c + 1) * height]
}

/// Part of a diagonal entry that its pivot is raised by: what rounding may have taken from it.
const ROUNDING: f64 = 1e-14;

/// Cholesky of the leading m columns, rows below solved; returns the products `X Xᵀ`, lower triangle by columns. `None`
/// where a pivot is not positive.
pub fn eliminate(panel: &mut [Lane], m: usize, height: usize) -> Option<Vec<Lane>> {
    let k = height - m;
    let mut products = vec![[0.0; LANES]; k * (k + 1) / 2];
    let positive = pulp::Arch::new().dispatch(
        #[inline(always)]
        || {
            for c in 0..m {
                let (done, own) = panel.split_at_mut(c * height);
                let own = &mut own[..height];
                for l in 0..LANES {
                    own[c][l] *= 1.0 + ROUNDING;
                }
                // four rows at a time stay in registers while the columns before are subtracted
                let mut r = c;
                while r < height {
                    let rows = (height - r).min(4);
                    if rows == 4 {
                        let mut sums = [own[r], own[r + 1], own[r + 2], own[r + 3]];
                        for j in 0..c {
                            let before = column(done, height, j);
                            let factor = before[c];
                            for (q, sum) in sums.iter_mut().enumerate() {
                                for l in 0..LANES {
                                    sum[l] -= before[r + q][l] * factor[l];
                                }
                            }
                        }
                        own[r..r + 4].copy_from_slice(&sums);
                    } else {
                        for q in r..height {
                            let mut sum = own[q];
                            for j in 0..c {
                                let before = column(done, height, j);
                                for l in 0..LANES {
                                    sum[l] -= before[q][l] * before[c][l];
                                }
                            }
                            own[q] = sum;
                        }
                    }
                    r += rows;
                }
                let mut inverse = [0.0; LANES];
                for l in 0..LANES {
                    // not a number is not positive either
                    if own[c][l].is_nan() || own[c][l] <= 0.0 {
                        return false;
                    }
                    inverse[l] = own[c][l].sqrt().recip();
                }
                for row in &mut own[c..] {
                    for l in 0..LANES {
                        row[l] *= inverse[l];
                    }
                }
            }
            let mut at = 0;
            for b in m..height {
                let mut a = b;
                while a < height {
                    let rows = (height - a).min(4);
                    let mut sums = [[0.0; LANES]; 4];
                    for j in 0..m {
                        let x = column(panel, height, j);
                        let factor = x[b];
                        for (q, sum) in sums.iter_mut().enumerate().take(rows) {
                            for l in 0..LANES {
                                sum[l] += x[a + q][l] * factor[l];
                            }
                        }
                    }
                    products[at..at + rows].copy_from_slice(&sums[..rows]);
                    at += rows;
                    a += rows;
                }
            }
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
