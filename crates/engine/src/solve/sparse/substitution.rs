//! Forward and back substitution with a supernodal factor, for one or a few right-hand sides at
//! once.
//!
//! Reading the factor takes most of the time, so that right-hand sides are solved together,
//! interleaved: entry `i` of side `k` of `SIDES` is at `SIDES·i + k`.

use super::plan::Plan;
use super::symbolic::Symbolic;
use bracket_base::math::wide::dispatch;
use pulp::{Simd, WithSimd};
use rayon::prelude::*;

/// Solves `L Lᵀ X = X` in place, in the factor's order; `x` is interleaved, `n × SIDES`.
pub fn solve<const SIDES: usize>(symbolic: &Symbolic, plan: &Plan, values: &[f64], x: &mut [f64]) {
    forward::<SIDES>(symbolic, plan, values, x);
    backward::<SIDES>(symbolic, plan, values, x);
}

/// Results of a subtree: values in its own columns, and its contribution to the unknowns above.
struct Share<'a> {
    /// First column of the subtree.
    begin: u32,
    own: &'a mut [f64],
    top: Vec<f64>,
}

fn forward<const SIDES: usize>(symbolic: &Symbolic, plan: &Plan, values: &[f64], x: &mut [f64]) {
    let cut = plan.cut(x, |s| SIDES * symbolic.begin[s] as usize);
    let shares: Vec<Vec<f64>> = cut
        .into_par_iter()
        .with_max_len(1)
        .map(|(first, last, own)| {
            let mut share = Share {
                begin: symbolic.begin[first],
                own,
                top: vec![0.0; SIDES * plan.above.count],
            };
            let mut buffer = Vec::new();
            let above = &plan.above.number;
            (first..=last).for_each(|s| {
                forward_in_subtree::<SIDES>(symbolic, s, values, &mut share, above, &mut buffer)
            });
            share.top
        })
        .collect();
    for (k, &s) in plan.top.iter().enumerate() {
        let from = SIDES * symbolic.begin[s] as usize;
        let at = SIDES * plan.above.first[k];
        for share in &shares {
            for i in 0..SIDES * symbolic.columns(s) {
                x[from + i] += share[at + i];
            }
        }
    }
    let mut buffer = Vec::new();
    for &s in &plan.top {
        let (columns, height) = (symbolic.columns(s), symbolic.height(s));
        let from = SIDES * symbolic.begin[s] as usize;
        separate::<SIDES>(&x[from..from + SIDES * columns], height, &mut buffer);
        forward_block::<SIDES>(block_of(symbolic, values, s), height, columns, &mut buffer);
        interleave::<SIDES>(&buffer, height, &mut x[from..from + SIDES * columns]);
        for (i, &row) in symbolic.rows_of(s).iter().enumerate() {
            for k in 0..SIDES {
                x[SIDES * row as usize + k] += buffer[k * height + columns + i];
            }
        }
    }
}

fn block_of<'a>(symbolic: &Symbolic, values: &'a [f64], s: usize) -> &'a [f64] {
    &values[symbolic.value_start[s]..symbolic.value_start[s + 1]]
}

fn forward_in_subtree<const SIDES: usize>(
    symbolic: &Symbolic,
    s: usize,
    values: &[f64],
    share: &mut Share<'_>,
    above: &[u32],
    buffer: &mut Vec<f64>,
) {
    let (columns, height) = (symbolic.columns(s), symbolic.height(s));
    let from = SIDES * (symbolic.begin[s] - share.begin) as usize;
    separate::<SIDES>(&share.own[from..from + SIDES * columns], height, buffer);
    forward_block::<SIDES>(block_of(symbolic, values, s), height, columns, buffer);
    interleave::<SIDES>(buffer, height, &mut share.own[from..from + SIDES * columns]);
    let end = share.begin + (share.own.len() / SIDES) as u32;
    for (i, &row) in symbolic.rows_of(s).iter().enumerate() {
        let (to, at) = if row < end {
            (&mut *share.own, (row - share.begin) as usize)
        } else {
            (&mut share.top[..], above[row as usize] as usize)
        };
        for k in 0..SIDES {
            to[SIDES * at + k] += buffer[k * height + columns + i];
        }
    }
}

fn backward<const SIDES: usize>(symbolic: &Symbolic, plan: &Plan, values: &[f64], x: &mut [f64]) {
    let mut buffer = Vec::new();
    for &s in plan.top.iter().rev() {
        let (columns, height) = (symbolic.columns(s), symbolic.height(s));
        let from = SIDES * symbolic.begin[s] as usize;
        separate::<SIDES>(&x[from..from + SIDES * columns], height, &mut buffer);
        for (i, &row) in symbolic.rows_of(s).iter().enumerate() {
            (0..SIDES).for_each(|k| buffer[k * height + columns + i] = x[SIDES * row as usize + k]);
        }
        backward_block::<SIDES>(block_of(symbolic, values, s), height, columns, &mut buffer);
        interleave::<SIDES>(&buffer, height, &mut x[from..from + SIDES * columns]);
    }
    // subtrees read the top and write their own columns
    let mut top = vec![0.0; SIDES * plan.above.count];
    for (k, &s) in plan.top.iter().enumerate() {
        let (from, at, count) = (
            SIDES * symbolic.begin[s] as usize,
            SIDES * plan.above.first[k],
            SIDES * symbolic.columns(s),
        );
        top[at..at + count].copy_from_slice(&x[from..from + count]);
    }
    let above = |row: u32| &top[SIDES * plan.above.number[row as usize] as usize..];
    let cut = plan.cut(x, |s| SIDES * symbolic.begin[s] as usize);
    cut.into_par_iter().with_max_len(1).for_each(|(first, last, own)| {
        let (begin, end) = (symbolic.begin[first], symbolic.begin[last + 1]);
        let mut buffer = Vec::new();
        for s in (first..=last).rev() {
            let (columns, height) = (symbolic.columns(s), symbolic.height(s));
            let from = SIDES * (symbolic.begin[s] - begin) as usize;
            separate::<SIDES>(&own[from..from + SIDES * columns], height, &mut buffer);
            for (i, &row) in symbolic.rows_of(s).iter().enumerate() {
                let entry =
                    if row < end { &own[SIDES * (row - begin) as usize..] } else { above(row) };
                (0..SIDES).for_each(|k| buffer[k * height + columns + i] = entry[k]);
            }
            backward_block::<SIDES>(block_of(symbolic, values, s), height, columns, &mut buffer);
            interleave::<SIDES>(&buffer, height, &mut own[from..from + SIDES * columns]);
        }
    });
}

/// Solves the triangle on top for the first `columns` of each side and subtracts the rows below
/// from the rest.
///
/// `x` holds the sides one after the other, `height` entries each.
fn forward_block<const SIDES: usize>(block: &[f64], height: usize, columns: usize, x: &mut [f64]) {
    dispatch(Forward::<SIDES> { block, height, columns, x });
}

/// Subtracts the rows below, then solves the transposed triangle on top; the result is the first
/// `columns` of each side.
fn backward_block<const SIDES: usize>(block: &[f64], height: usize, columns: usize, x: &mut [f64]) {
    dispatch(Backward::<SIDES> { block, height, columns, x });
}

/// The sides of a buffer.
#[inline(always)]
fn sides<const SIDES: usize>(x: &mut [f64], height: usize) -> [&mut [f64]; SIDES] {
    let mut each = x.chunks_exact_mut(height);
    std::array::from_fn(|_| each.next().unwrap_or_default())
}

/// Rows `first..` of W columns from column `j` on: whole registers, and the remainder of each
/// column.
#[inline(always)]
fn rows_of<S: Simd, const W: usize>(
    block: &[f64],
    height: usize,
    j: usize,
    first: usize,
) -> ([&[S::f64s]; W], [&[f64]; W]) {
    let cut = |k| S::as_simd_f64s(&block[(j + k) * height + first..(j + k + 1) * height]);
    let whole = cut(0).0.len();
    (std::array::from_fn(|k| &cut(k).0[..whole]), std::array::from_fn(|k| cut(k).1))
}

struct Forward<'a, const SIDES: usize> {
    block: &'a [f64],
    height: usize,
    columns: usize,
    x: &'a mut [f64],
}

impl<const SIDES: usize> WithSimd for Forward<'_, SIDES> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { block, height, columns, x } = self;
        let mut x = sides::<SIDES>(x, height);
        let mut j = 0;
        // four columns at a time: x is read and written once for the four, the columns once for all
        // sides
        while j + 4 <= columns {
            forward_columns::<S, SIDES, 4>(simd, block, height, j, &mut x);
            j += 4;
        }
        match columns - j {
            1 => forward_columns::<S, SIDES, 1>(simd, block, height, j, &mut x),
            2 => forward_columns::<S, SIDES, 2>(simd, block, height, j, &mut x),
            3 => forward_columns::<S, SIDES, 3>(simd, block, height, j, &mut x),
            _ => {}
        }
    }
}

#[inline(always)]
fn forward_columns<S: Simd, const SIDES: usize, const W: usize>(
    simd: S,
    block: &[f64],
    height: usize,
    j: usize,
    x: &mut [&mut [f64]; SIDES],
) {
    let mut done = [[simd.splat_f64s(0.0); W]; SIDES];
    for (x, done) in x.iter_mut().zip(&mut done) {
        let x = &mut x[j..j + W];
        for c in 0..W {
            let column = &block[(j + c) * height + j..][..W];
            x[c] /= column[c];
            for r in c + 1..W {
                x[r] -= column[r] * x[c];
            }
            done[c] = simd.splat_f64s(x[c]);
        }
    }
    let (whole, left) = rows_of::<S, W>(block, height, j, j + W);
    let less = |l: [S::f64s; W], done: &[S::f64s; W], mut v: S::f64s| {
        for c in 0..W {
            v = simd.negate_mul_add_e_f64s(l[c], done[c], v);
        }
        v
    };
    let mut rows = x.each_mut().map(|x| S::as_mut_simd_f64s(&mut x[j + W..]));
    for i in 0..whole[0].len() {
        let l = whole.map(|c| c[i]);
        for ((x, _), done) in rows.iter_mut().zip(&done) {
            x[i] = less(l, done, x[i]);
        }
    }
    if !left[0].is_empty() {
        let l = left.map(|r| simd.partial_load_f64s(r));
        for ((_, x), done) in rows.iter_mut().zip(&done) {
            let v = less(l, done, simd.partial_load_f64s(x));
            simd.partial_store_f64s(x, v);
        }
    }
}

struct Backward<'a, const SIDES: usize> {
    block: &'a [f64],
    height: usize,
    columns: usize,
    x: &'a mut [f64],
}

impl<const SIDES: usize> WithSimd for Backward<'_, SIDES> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { block, height, columns, x } = self;
        let mut x = sides::<SIDES>(x, height);
        let mut j = columns;
        while j >= 4 {
            j -= 4;
            backward_columns::<S, SIDES, 4>(simd, block, height, j, &mut x);
        }
        match j {
            1 => backward_columns::<S, SIDES, 1>(simd, block, height, 0, &mut x),
            2 => backward_columns::<S, SIDES, 2>(simd, block, height, 0, &mut x),
            3 => backward_columns::<S, SIDES, 3>(simd, block, height, 0, &mut x),
            _ => {}
        }
    }
}

#[inline(always)]
fn backward_columns<S: Simd, const SIDES: usize, const W: usize>(
    simd: S,
    block: &[f64],
    height: usize,
    j: usize,
    x: &mut [&mut [f64]; SIDES],
) {
    let (whole, left) = rows_of::<S, W>(block, height, j, j + W);
    let mut sums = [[simd.splat_f64s(0.0); W]; SIDES];
    let more = |l: [S::f64s; W], x: S::f64s, sums: &mut [S::f64s; W]| {
        for c in 0..W {
            sums[c] = simd.mul_add_e_f64s(l[c], x, sums[c]);
        }
    };
    let rows = x.each_ref().map(|x| S::as_simd_f64s(&x[j + W..]));
    for i in 0..whole[0].len() {
        let l = whole.map(|c| c[i]);
        for ((x, _), sums) in rows.iter().zip(&mut sums) {
            more(l, x[i], sums);
        }
    }
    if !left[0].is_empty() {
        let l = left.map(|r| simd.partial_load_f64s(r));
        for ((_, x), sums) in rows.iter().zip(&mut sums) {
            more(l, simd.partial_load_f64s(x), sums);
        }
    }
    for (x, sums) in x.iter_mut().zip(&sums) {
        let x = &mut x[j..j + W];
        for c in (0..W).rev() {
            let column = &block[(j + c) * height + j..][..W];
            let above: f64 = (c + 1..W).map(|r| column[r] * x[r]).sum();
            x[c] = (x[c] - simd.reduce_sum_f64s(sums[c]) - above) / column[c];
        }
    }
}

/// Takes the interleaved entries into `buffer`, side by side, each `height` long, zero after them.
fn separate<const SIDES: usize>(from: &[f64], height: usize, buffer: &mut Vec<f64>) {
    buffer.clear();
    buffer.resize(SIDES * height, 0.0);
    for (i, entry) in from.chunks_exact(SIDES).enumerate() {
        (0..SIDES).for_each(|k| buffer[k * height + i] = entry[k]);
    }
}

/// Puts the first entries of each side back, interleaved.
fn interleave<const SIDES: usize>(buffer: &[f64], height: usize, to: &mut [f64]) {
    for (i, entry) in to.chunks_exact_mut(SIDES).enumerate() {
        (0..SIDES).for_each(|k| entry[k] = buffer[k * height + i]);
    }
}
