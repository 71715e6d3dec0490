//! Forward and back substitution with a supernodal factor, for one or a few right-hand sides at once.
//!
//! Reading the factor takes the time, so right-hand sides go through together, interleaved: entry `i` of side `k` of
//! `SIDES` stands at `SIDES·i + k`.

use super::factor::Plan;
use super::symbolic::Symbolic;
use rayon::prelude::*;

/// Solves `L Lᵀ X = X` in place, in the factor's order; `x` is interleaved, `n × SIDES`.
pub fn solve<const SIDES: usize>(symbolic: &Symbolic, plan: &Plan, values: &[f64], x: &mut [f64]) {
    forward::<SIDES>(symbolic, plan, values, x, &TopRows::new(symbolic, plan));
    backward::<SIDES>(symbolic, plan, values, x);
}

/// Number of each unknown of the top supernodes among them.
struct TopRows {
    /// First number of each top supernode.
    first: Vec<usize>,
    /// First column of each.
    begin: Vec<u32>,
    /// Their number.
    count: usize,
}

impl TopRows {
    fn new(symbolic: &Symbolic, plan: &Plan) -> Self {
        let mut out = Self { first: Vec::new(), begin: Vec::new(), count: 0 };
        for &s in &plan.top {
            out.first.push(out.count);
            out.begin.push(symbolic.begin[s]);
            out.count += symbolic.columns(s);
        }
        out
    }

    fn number(&self, row: u32) -> usize {
        let k = self.begin.partition_point(|&b| b <= row) - 1;
        self.first[k] + (row - self.begin[k]) as usize
    }
}

/// Where a subtree's rows go: its own columns, or the share it hands to the top.
struct Share<'a> {
    /// First column of the subtree.
    begin: u32,
    own: &'a mut [f64],
    top: Vec<f64>,
}

fn forward<const SIDES: usize>(symbolic: &Symbolic, plan: &Plan, values: &[f64], x: &mut [f64], top: &TopRows) {
    let cut = plan.cut(x, |s| SIDES * symbolic.begin[s] as usize);
    let shares: Vec<Vec<f64>> = cut
        .subtrees
        .into_par_iter()
        .with_max_len(1)
        .map(|(first, last, own)| {
            let mut share = Share { begin: symbolic.begin[first], own, top: vec![0.0; SIDES * top.count] };
            let mut buffer = Vec::new();
            (first..=last).for_each(|s| forward_in_subtree::<SIDES>(symbolic, s, values, &mut share, top, &mut buffer));
            share.top
        })
        .collect();
    for (k, &s) in plan.top.iter().enumerate() {
        let from = SIDES * symbolic.begin[s] as usize;
        let at = SIDES * top.first[k];
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
    top: &TopRows,
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
            (&mut share.top[..], top.number(row))
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
    let cut = plan.cut(x, |s| SIDES * symbolic.begin[s] as usize);
    let between = cut.between;
    let above = |row: u32| {
        let at = SIDES * row as usize;
        let (start, part) = &between[between.partition_point(|b| b.0 <= at) - 1];
        &part[at - start..at - start + SIDES]
    };
    cut.subtrees.into_par_iter().with_max_len(1).for_each(|(first, last, own)| {
        let (begin, end) = (symbolic.begin[first], symbolic.begin[last + 1]);
        let mut buffer = Vec::new();
        for s in (first..=last).rev() {
            let (columns, height) = (symbolic.columns(s), symbolic.height(s));
            let from = SIDES * (symbolic.begin[s] - begin) as usize;
            separate::<SIDES>(&own[from..from + SIDES * columns], height, &mut buffer);
            for (i, &row) in symbolic.rows_of(s).iter().enumerate() {
                let entry = if row < end { &own[SIDES * (row - begin) as usize..] } else { above(row) };
                (0..SIDES).for_each(|k| buffer[k * height + columns + i] = entry[k]);
            }
            backward_block::<SIDES>(block_of(symbolic, values, s), height, columns, &mut buffer);
            interleave::<SIDES>(&buffer, height, &mut own[from..from + SIDES * columns]);
        }
    });
}

/// Solves the triangle on top for the first `columns` of each side and subtracts the rows below from the rest.
///
/// `x` holds the sides one after the other, `height` entries each.
fn forward_block<const SIDES: usize>(block: &[f64], height: usize, columns: usize, x: &mut [f64]) {
    pulp::Arch::new().dispatch(
        #[inline(always)]
        || {
            let mut j = 0;
            // four columns at a time: x is read and written once for the four
            while j + 4 <= columns {
                let column = |k: usize| &block[(j + k) * height + j..(j + k + 1) * height];
                let (c0, c1, c2, c3) = (column(0), column(1), column(2), column(3));
                for k in 0..SIDES {
                    let x = &mut x[k * height + j..(k + 1) * height];
                    let a = x[0] / c0[0];
                    let b = (x[1] - c0[1] * a) / c1[1];
                    let c = (x[2] - c0[2] * a - c1[2] * b) / c2[2];
                    let d = (x[3] - c0[3] * a - c1[3] * b - c2[3] * c) / c3[3];
                    (x[0], x[1], x[2], x[3]) = (a, b, c, d);
                    let rows = c0[4..].iter().zip(&c1[4..]).zip(&c2[4..]).zip(&c3[4..]);
                    for (v, (((l0, l1), l2), l3)) in x[4..].iter_mut().zip(rows) {
                        *v -= l0 * a + l1 * b + l2 * c + l3 * d;
                    }
                }
                j += 4;
            }
            while j < columns {
                let c = &block[j * height + j..(j + 1) * height];
                for k in 0..SIDES {
                    let x = &mut x[k * height + j..(k + 1) * height];
                    x[0] /= c[0];
                    let a = x[0];
                    x[1..].iter_mut().zip(&c[1..]).for_each(|(v, l)| *v -= l * a);
                }
                j += 1;
            }
        },
    );
}

/// Partial sums of a dot product: one alone would wait for itself.
const LANES: usize = 8;

/// `Σ c x` for four columns.
#[inline(always)]
fn dots(c: [&[f64]; 4], x: &[f64]) -> [f64; 4] {
    let mut sums = [[0.0f64; LANES]; 4];
    let (xs, x_rest) = x.as_chunks::<LANES>();
    let (c0, r0) = c[0].as_chunks::<LANES>();
    let (c1, r1) = c[1].as_chunks::<LANES>();
    let (c2, r2) = c[2].as_chunks::<LANES>();
    let (c3, r3) = c[3].as_chunks::<LANES>();
    for ((((x, l0), l1), l2), l3) in xs.iter().zip(c0).zip(c1).zip(c2).zip(c3) {
        for l in 0..LANES {
            sums[0][l] += l0[l] * x[l];
            sums[1][l] += l1[l] * x[l];
            sums[2][l] += l2[l] * x[l];
            sums[3][l] += l3[l] * x[l];
        }
    }
    let mut out = sums.map(|s| s.iter().sum::<f64>());
    for (i, x) in x_rest.iter().enumerate() {
        out[0] += r0[i] * x;
        out[1] += r1[i] * x;
        out[2] += r2[i] * x;
        out[3] += r3[i] * x;
    }
    out
}

/// Subtracts the rows below, then solves the transposed triangle on top; the result is the first `columns` of each side.
fn backward_block<const SIDES: usize>(block: &[f64], height: usize, columns: usize, x: &mut [f64]) {
    pulp::Arch::new().dispatch(
        #[inline(always)]
        || {
            let mut j = columns;
            while j >= 4 {
                j -= 4;
                let column = |k: usize| &block[(j + k) * height + j..(j + k + 1) * height];
                let c = [column(0), column(1), column(2), column(3)];
                for k in 0..SIDES {
                    let x = &mut x[k * height + j..(k + 1) * height];
                    let [s0, s1, s2, s3] = dots([&c[0][4..], &c[1][4..], &c[2][4..], &c[3][4..]], &x[4..]);
                    let d = (x[3] - s3) / c[3][3];
                    let e = (x[2] - s2 - c[2][3] * d) / c[2][2];
                    let b = (x[1] - s1 - c[1][2] * e - c[1][3] * d) / c[1][1];
                    let a = (x[0] - s0 - c[0][1] * b - c[0][2] * e - c[0][3] * d) / c[0][0];
                    (x[0], x[1], x[2], x[3]) = (a, b, e, d);
                }
            }
            while j > 0 {
                j -= 1;
                let c = &block[j * height + j..(j + 1) * height];
                for k in 0..SIDES {
                    let x = &mut x[k * height + j..(k + 1) * height];
                    let sum: f64 = x[1..].iter().zip(&c[1..]).map(|(v, l)| v * l).sum();
                    x[0] = (x[0] - sum) / c[0];
                }
            }
        },
    );
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
