//! Forward and back substitution with a supernodal factor, for one or a few right-hand sides at once.
//!
//! Reading the factor takes the time, so right-hand sides go through together, interleaved: entry `i` of side `k` of
//! `SIDES` stands at `SIDES·i + k`.

use super::factor::Plan;
use super::symbolic::Symbolic;
use rayon::prelude::*;

/// Solves `L Lᵀ X = X` in place, in the factor's order; `x` is interleaved, `n × SIDES`.
pub fn solve<const SIDES: usize>(symbolic: &Symbolic, plan: &Plan, values: &[f64], x: &mut [f64]) {
    let first_of_top = TopRows::new(symbolic, plan);
    forward::<SIDES>(symbolic, plan, values, x, &first_of_top);
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
    let mut pieces = Vec::with_capacity(plan.subtrees.len());
    let (mut rest, mut at) = (&mut *x, 0);
    for &(first, last) in &plan.subtrees {
        let (from, to) = (symbolic.begin[first] as usize, symbolic.begin[last + 1] as usize);
        let (piece, after) =
            std::mem::take(&mut rest).split_at_mut(SIDES * (from - at)).1.split_at_mut(SIDES * (to - from));
        pieces.push((first, last, piece));
        (rest, at) = (after, to);
    }
    let shares: Vec<Vec<f64>> = pieces
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
        buffer.clear();
        buffer.extend_from_slice(&x[from..from + SIDES * columns]);
        buffer.resize(SIDES * height, 0.0);
        forward_block::<SIDES>(block_of(symbolic, values, s), height, columns, &mut buffer);
        x[from..from + SIDES * columns].copy_from_slice(&buffer[..SIDES * columns]);
        for (i, &row) in symbolic.rows_of(s).iter().enumerate() {
            for k in 0..SIDES {
                x[SIDES * row as usize + k] += buffer[SIDES * (columns + i) + k];
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
    buffer.clear();
    buffer.extend_from_slice(&share.own[from..from + SIDES * columns]);
    buffer.resize(SIDES * height, 0.0);
    forward_block::<SIDES>(block_of(symbolic, values, s), height, columns, buffer);
    share.own[from..from + SIDES * columns].copy_from_slice(&buffer[..SIDES * columns]);
    let end = share.begin + (share.own.len() / SIDES) as u32;
    for (i, &row) in symbolic.rows_of(s).iter().enumerate() {
        let (to, at) = if row < end {
            (&mut *share.own, (row - share.begin) as usize)
        } else {
            (&mut share.top[..], top.number(row))
        };
        for k in 0..SIDES {
            to[SIDES * at + k] += buffer[SIDES * (columns + i) + k];
        }
    }
}

fn backward<const SIDES: usize>(symbolic: &Symbolic, plan: &Plan, values: &[f64], x: &mut [f64]) {
    let mut buffer = Vec::new();
    for &s in plan.top.iter().rev() {
        let (columns, height) = (symbolic.columns(s), symbolic.height(s));
        let from = SIDES * symbolic.begin[s] as usize;
        buffer.clear();
        buffer.extend_from_slice(&x[from..from + SIDES * columns]);
        for &row in symbolic.rows_of(s) {
            buffer.extend_from_slice(&x[SIDES * row as usize..SIDES * (row as usize + 1)]);
        }
        backward_block::<SIDES>(block_of(symbolic, values, s), height, columns, &mut buffer);
        x[from..from + SIDES * columns].copy_from_slice(&buffer[..SIDES * columns]);
    }
    // subtrees read the top and write their own columns
    let mut pieces = Vec::with_capacity(plan.subtrees.len());
    let mut gaps = Vec::with_capacity(plan.top.len());
    let (mut rest, mut at) = (&mut *x, 0usize);
    for &(first, last) in &plan.subtrees {
        let (from, to) = (symbolic.begin[first] as usize, symbolic.begin[last + 1] as usize);
        let (gap, after) = std::mem::take(&mut rest).split_at_mut(SIDES * (from - at));
        let (piece, after) = after.split_at_mut(SIDES * (to - from));
        gaps.push((at as u32, &*gap));
        pieces.push((first, last, piece));
        (rest, at) = (after, to);
    }
    gaps.push((at as u32, &*rest));
    let above = |row: u32| {
        let k = gaps.partition_point(|g| g.0 <= row) - 1;
        let at = SIDES * (row - gaps[k].0) as usize;
        &gaps[k].1[at..at + SIDES]
    };
    pieces.into_par_iter().with_max_len(1).for_each(|(first, last, own)| {
        let (begin, end) = (symbolic.begin[first], symbolic.begin[last + 1]);
        let mut buffer = Vec::new();
        for s in (first..=last).rev() {
            let (columns, height) = (symbolic.columns(s), symbolic.height(s));
            let from = SIDES * (symbolic.begin[s] - begin) as usize;
            buffer.clear();
            buffer.extend_from_slice(&own[from..from + SIDES * columns]);
            for &row in symbolic.rows_of(s) {
                if row < end {
                    let at = SIDES * (row - begin) as usize;
                    buffer.extend_from_slice(&own[at..at + SIDES]);
                } else {
                    buffer.extend_from_slice(above(row));
                }
            }
            backward_block::<SIDES>(block_of(symbolic, values, s), height, columns, &mut buffer);
            own[from..from + SIDES * columns].copy_from_slice(&buffer[..SIDES * columns]);
        }
    });
}

/// Solves the triangle on top for `x[..columns]` and subtracts the rows below from the rest of `x`.
fn forward_block<const SIDES: usize>(block: &[f64], height: usize, columns: usize, x: &mut [f64]) {
    pulp::Arch::new().dispatch(
        #[inline(always)]
        || {
            let mut j = 0;
            // four columns at a time: x is read and written once for the four
            while j + 4 <= columns {
                let column = |k: usize| &block[(j + k) * height + j..(j + k + 1) * height];
                let (c0, c1, c2, c3) = (column(0), column(1), column(2), column(3));
                let x = &mut x[SIDES * j..SIDES * height];
                for k in 0..SIDES {
                    let a = x[k] / c0[0];
                    let b = (x[SIDES + k] - c0[1] * a) / c1[1];
                    let c = (x[2 * SIDES + k] - c0[2] * a - c1[2] * b) / c2[2];
                    let d = (x[3 * SIDES + k] - c0[3] * a - c1[3] * b - c2[3] * c) / c3[3];
                    (x[k], x[SIDES + k], x[2 * SIDES + k], x[3 * SIDES + k]) = (a, b, c, d);
                }
                let (head, tail) = x.split_at_mut(4 * SIDES);
                let rows = tail.len() / SIDES;
                let (c0, c1, c2, c3) = (&c0[4..4 + rows], &c1[4..4 + rows], &c2[4..4 + rows], &c3[4..4 + rows]);
                for i in 0..rows {
                    for k in 0..SIDES {
                        tail[SIDES * i + k] -= c0[i] * head[k]
                            + c1[i] * head[SIDES + k]
                            + c2[i] * head[2 * SIDES + k]
                            + c3[i] * head[3 * SIDES + k];
                    }
                }
                j += 4;
            }
            while j < columns {
                let c = &block[j * height + j..(j + 1) * height];
                let x = &mut x[SIDES * j..SIDES * height];
                for k in 0..SIDES {
                    x[k] /= c[0];
                }
                let (head, tail) = x.split_at_mut(SIDES);
                for i in 0..tail.len() / SIDES {
                    for k in 0..SIDES {
                        tail[SIDES * i + k] -= c[i + 1] * head[k];
                    }
                }
                j += 1;
            }
        },
    );
}

/// Subtracts the rows below, then solves the transposed triangle on top; the result is `x[..columns]`.
fn backward_block<const SIDES: usize>(block: &[f64], height: usize, columns: usize, x: &mut [f64]) {
    pulp::Arch::new().dispatch(
        #[inline(always)]
        || {
            for j in (0..columns).rev() {
                let c = &block[j * height + j..(j + 1) * height];
                let (head, tail) = x[SIDES * j..SIDES * height].split_at_mut(SIDES);
                // eight partial sums: one would wait for itself
                const LANES: usize = 8;
                let mut sums = [[0.0f64; SIDES]; LANES];
                let rows = tail.len() / SIDES;
                let c1 = &c[1..1 + rows];
                let whole = rows / LANES * LANES;
                for i in (0..whole).step_by(LANES) {
                    for l in 0..LANES {
                        for k in 0..SIDES {
                            sums[l][k] += c1[i + l] * tail[SIDES * (i + l) + k];
                        }
                    }
                }
                for i in whole..rows {
                    for k in 0..SIDES {
                        sums[0][k] += c1[i] * tail[SIDES * i + k];
                    }
                }
                for k in 0..SIDES {
                    let sum: f64 = sums.iter().map(|s| s[k]).sum();
                    head[k] = (head[k] - sum) / c[0];
                }
            }
        },
    );
}
