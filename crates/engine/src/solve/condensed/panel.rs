//! Dense operations on panels of eight elements at once; the eight values of an entry are adjacent.

use bracket_base::math::lanes::{Place, kernel};
use bracket_base::math::wide::{Lane, dispatch, parts, registers, registers_mut};
use pulp::{Simd, WithSimd};

/// Fraction of a diagonal entry added to its pivot, an allowance for rounding.
const ROUNDING: f64 = 1e-14;
/// Rows and columns of a tile, whose sums stay in registers.
const TILE: usize = 4;

/// Start of column `c` in a lower triangle of order `n` packed by columns.
#[inline(always)]
pub fn packed(n: usize, c: usize) -> usize {
    c * n - c * c.saturating_sub(1) / 2
}

/// A panel of one height by columns, one register of each of its lanes.
#[derive(Clone, Copy)]
struct View<'a, S: Simd> {
    values: &'a [S::f64s],
    height: usize,
    part: usize,
}

/// `Σ_j a_j[r + q] b_j[c + p]` over the first columns j: entry (q, p) of a tile.
#[inline(always)]
fn tile<S: Simd, const R: usize, const C: usize>(
    simd: S,
    a: View<'_, S>,
    b: View<'_, S>,
    columns: usize,
    (r, c): (usize, usize),
) -> [[S::f64s; R]; C] {
    let n = parts::<S>();
    let mut sums = [[simd.splat_f64s(0.0); R]; C];
    for j in 0..columns {
        let left = &a.values[(j * a.height + r) * n + a.part..][..(R - 1) * n + 1];
        let right = &b.values[(j * b.height + c) * n + b.part..][..(C - 1) * n + 1];
        for p in 0..C {
            for q in 0..R {
                sums[p][q] = simd.mul_add_e_f64s(left[q * n], right[p * n], sums[p][q]);
            }
        }
    }
    sums
}

/// `out += Σ_j a_j b_jᵀ` over the rows from `from` on, of two panels of one height: lower triangle
/// by columns. The sum must be symmetric.
pub fn add_products(
    a: &[Lane],
    b: &[Lane],
    height: usize,
    columns: usize,
    from: usize,
    out: &mut [Lane],
) {
    dispatch(Products { a, b, height, columns, from, sign: 1.0, out });
}

/// `out −= X Xᵀ`, X the rows below the m columns of a factored panel.
pub fn subtract_products(panel: &[Lane], m: usize, height: usize, out: &mut [Lane]) {
    dispatch(Products { a: panel, b: panel, height, columns: m, from: m, sign: -1.0, out });
}

struct Products<'a> {
    a: &'a [Lane],
    b: &'a [Lane],
    height: usize,
    columns: usize,
    from: usize,
    sign: f64,
    out: &'a mut [Lane],
}

impl WithSimd for Products<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { a, b, height, columns, from, sign, out } = self;
        let (a, b, out) = (registers::<S>(a), registers::<S>(b), registers_mut::<S>(out));
        let sign = simd.splat_f64s(sign);
        for part in 0..parts::<S>() {
            let view = |values| View::<S> { values, height, part };
            let sides = Sides { a: view(a), b: view(b), columns, from, sign };
            for c in (from..height).step_by(TILE) {
                match height - c {
                    1 => product_tiles::<S, 1>(simd, &sides, c, out),
                    2 => product_tiles::<S, 2>(simd, &sides, c, out),
                    3 => product_tiles::<S, 3>(simd, &sides, c, out),
                    _ => product_tiles::<S, 4>(simd, &sides, c, out),
                }
            }
        }
    }
}

struct Sides<'a, S: Simd> {
    a: View<'a, S>,
    b: View<'a, S>,
    columns: usize,
    from: usize,
    sign: S::f64s,
}

/// The tiles of C columns from column `c` down.
#[inline(always)]
fn product_tiles<S: Simd, const C: usize>(
    simd: S,
    sides: &Sides<'_, S>,
    c: usize,
    out: &mut [S::f64s],
) {
    let height = sides.a.height;
    let mut r = c;
    while r + TILE <= height {
        product_tile::<S, TILE, C>(simd, sides, r, c, out);
        r += TILE;
    }
    match height - r {
        0 => {}
        1 => product_tile::<S, 1, C>(simd, sides, r, c, out),
        2 => product_tile::<S, 2, C>(simd, sides, r, c, out),
        _ => product_tile::<S, 3, C>(simd, sides, r, c, out),
    }
}

#[inline(always)]
fn product_tile<S: Simd, const R: usize, const C: usize>(
    simd: S,
    sides: &Sides<'_, S>,
    r: usize,
    c: usize,
    out: &mut [S::f64s],
) {
    let n = parts::<S>();
    let sums = tile::<S, R, C>(simd, sides.a, sides.b, sides.columns, (r, c));
    for p in 0..C {
        let column = c + p;
        let start = packed(sides.a.height - sides.from, column - sides.from);
        for q in 0..R {
            if r + q >= column {
                let entry = &mut out[(start + r + q - column) * n + sides.a.part];
                *entry = simd.mul_add_e_f64s(sums[p][q], sides.sign, *entry);
            }
        }
    }
}

/// Cholesky of the leading m columns, rows below solved. False where a pivot is not positive.
pub fn factor(panel: &mut [Lane], m: usize, height: usize) -> bool {
    dispatch(Factor { panel, m, height });
    // a pivot that is not positive leaves NaN or zero on the diagonal
    (0..m).all(|c| panel[c * height + c].iter().all(|d| *d > 0.0 && d.is_finite()))
}

struct Factor<'a> {
    panel: &'a mut [Lane],
    m: usize,
    height: usize,
}

impl WithSimd for Factor<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { panel, m, height } = self;
        let panel = registers_mut::<S>(panel);
        for part in 0..parts::<S>() {
            for c in (0..m).step_by(TILE) {
                match m - c {
                    1 => factor_columns::<S, 1>(simd, panel, height, part, c),
                    2 => factor_columns::<S, 2>(simd, panel, height, part, c),
                    3 => factor_columns::<S, 3>(simd, panel, height, part, c),
                    _ => factor_columns::<S, 4>(simd, panel, height, part, c),
                }
            }
        }
    }
}

/// Some columns being factored.
struct Columns<'a, S: Simd, const W: usize> {
    /// The columns before.
    done: View<'a, S>,
    first: usize,
    /// Their triangle on top, by columns, and the reciprocals of its diagonal.
    top: [[S::f64s; W]; W],
    inverse: [S::f64s; W],
}

/// Factors W columns from column `c` on.
#[inline(always)]
fn factor_columns<S: Simd, const W: usize>(
    simd: S,
    panel: &mut [S::f64s],
    height: usize,
    part: usize,
    c: usize,
) {
    let n = parts::<S>();
    let (done, own) = panel.split_at_mut(c * height * n);
    let zero = simd.splat_f64s(0.0);
    let done = View::<S> { values: done, height, part };
    let mut columns = Columns::<S, W> { done, first: c, top: [[zero; W]; W], inverse: [zero; W] };
    let sums = tile::<S, W, W>(simd, done, done, c, (c, c));
    for p in 0..W {
        for q in p..W {
            let entry = &mut own[(p * height + c + q) * n + part];
            let raised = if p == q {
                simd.mul_f64s(*entry, simd.splat_f64s(1.0 + ROUNDING))
            } else {
                *entry
            };
            let mut v = simd.sub_f64s(raised, sums[p][q]);
            for j in 0..p {
                v = simd.negate_mul_add_e_f64s(columns.top[j][q], columns.top[j][p], v);
            }
            if p == q {
                v = simd.sqrt_f64s(v);
                columns.inverse[p] = simd.div_f64s(simd.splat_f64s(1.0), v);
            } else {
                v = simd.mul_f64s(v, columns.inverse[p]);
            }
            columns.top[p][q] = v;
            *entry = v;
        }
    }
    let mut r = c + W;
    while r + TILE <= height {
        solve_rows::<S, TILE, W>(simd, &columns, r, own);
        r += TILE;
    }
    match height - r {
        0 => {}
        1 => solve_rows::<S, 1, W>(simd, &columns, r, own),
        2 => solve_rows::<S, 2, W>(simd, &columns, r, own),
        _ => solve_rows::<S, 3, W>(simd, &columns, r, own),
    }
}

/// The rows from `r` on of the current columns, solved by their triangle.
#[inline(always)]
fn solve_rows<S: Simd, const R: usize, const W: usize>(
    simd: S,
    columns: &Columns<'_, S, W>,
    r: usize,
    own: &mut [S::f64s],
) {
    let n = parts::<S>();
    let View { height, part, .. } = columns.done;
    let sums = tile::<S, R, W>(simd, columns.done, columns.done, columns.first, (r, columns.first));
    let mut x = sums;
    for p in 0..W {
        let entries = &mut own[(p * height + r) * n + part..][..(R - 1) * n + 1];
        for q in 0..R {
            let mut v = simd.sub_f64s(entries[q * n], sums[p][q]);
            for j in 0..p {
                v = simd.negate_mul_add_e_f64s(x[j][q], columns.top[j][p], v);
            }
            x[p][q] = simd.mul_f64s(v, columns.inverse[p]);
            entries[q * n] = x[p][q];
        }
    }
}

kernel! {
    /// `x ← L⁻¹ x` on top, `x ← −X (L⁻¹ x)` below.
    pub fn forward(simd; panel: &'a [Lane], m: usize, height: usize, x: &'a mut [Lane]) {
        let (panel, x) = (registers::<S>(panel), registers_mut::<S>(x));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            for c in 0..m {
                let y = simd.div_f64s(x[at.of(c)], panel[at.of(c * height + c)]);
                x[at.of(c)] = y;
                for r in c + 1..height {
                    let entry = panel[at.of(c * height + r)];
                    x[at.of(r)] = simd.negate_mul_add_e_f64s(entry, y, x[at.of(r)]);
                }
            }
        }
    }
}

kernel! {
    /// `x ← L⁻ᵀ (x − Xᵀ x_below)` on top.
    pub fn backward(simd; panel: &'a [Lane], m: usize, height: usize, x: &'a mut [Lane]) {
        let (panel, x) = (registers::<S>(panel), registers_mut::<S>(x));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            for c in (0..m).rev() {
                let mut y = x[at.of(c)];
                for r in c + 1..height {
                    y = simd.negate_mul_add_e_f64s(panel[at.of(c * height + r)], x[at.of(r)], y);
                }
                x[at.of(c)] = simd.div_f64s(y, panel[at.of(c * height + c)]);
            }
        }
    }
}
