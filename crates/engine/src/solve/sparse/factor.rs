//! Numeric supernodal Cholesky: subtrees of the dissection in parallel, then the separators in
//! blocks.
//!
//! The method is left-looking: a supernode gathers the updates of its descendants, then factors its
//! own dense block. It needs only the factor and one block of work space per thread. The cuts of
//! the work depend on sizes alone, so that the factor is the same, byte for byte, on any number of
//! threads.

use super::blocks;
use super::dense::{self, MatMut, MatRef};
use super::plan::Plan;
use super::symbolic::{Symbolic, Update};
use rayon::prelude::*;
use std::sync::Mutex;

/// Number of columns of a supernode updated together; wider supernodes are cut into such strips,
/// one task each.
const STRIP: usize = 96;
/// Columns of a panel of a wide diagonal block.
const PANEL: usize = 128;
/// Rows of a panel solved together.
const ROWS: usize = 512;
/// Number of columns of a supernode up to which packing the operands of its products does not pay.
const NARROW: usize = 128;
/// Work space of one thread.
#[derive(Default)]
struct Work {
    /// Place of a row in the current supernode.
    place: Vec<u32>,
    /// One update before it is scattered.
    product: Vec<f64>,
    /// Places of the rows of one update, and its columns.
    targets: Vec<u32>,
    columns: Vec<u32>,
    /// Runs of neighbouring places among them: first place, first row, rows.
    runs: Vec<(u32, u32, u32)>,
}

/// Work spaces, taken by tasks and returned.
#[derive(Default)]
pub struct Pool(Mutex<Vec<Work>>);

impl Pool {
    fn with<T>(&self, n: usize, run: impl FnOnce(&mut Work) -> T) -> T {
        let taken = self.0.lock().ok().and_then(|mut free| free.pop());
        let mut work = taken.unwrap_or_default();
        work.place.resize(n, 0);
        let result = run(&mut work);
        if let Ok(mut free) = self.0.lock() {
            free.push(work);
        }
        result
    }
}

/// A pivot was not positive.
pub struct NotPositive;

/// The dense block of one supernode while it is computed.
struct Target<'a> {
    symbolic: &'a Symbolic,
    s: usize,
    /// Values of supernodes before it, from value `base` on.
    done: &'a [f64],
    base: usize,
}

/// Factors in place; `values` holds the matrix in the layout of `symbolic`.
pub fn factor(
    symbolic: &Symbolic,
    plan: &Plan,
    values: &mut [f64],
    pool: &Pool,
) -> Result<(), NotPositive> {
    let mut pieces = plan.cut(values, |s| symbolic.value_start[s]);
    // the most expensive first, for less idle time at the end
    pieces.sort_by_key(|(first, last, _)| {
        std::cmp::Reverse(symbolic.value_start[*last + 1] - symbolic.value_start[*first])
    });
    pieces.into_par_iter().with_max_len(1).try_for_each(|(first, last, piece)| {
        let base = symbolic.value_start[first];
        pool.with(symbolic.n, |work| {
            (first..=last).try_for_each(|s| {
                let (done, own) = piece.split_at_mut(symbolic.value_start[s] - base);
                let own = &mut own[..symbolic.value_start[s + 1] - symbolic.value_start[s]];
                Target { symbolic, s, done, base }.factor_alone(own, work)
            })
        })
    })?;
    plan.top.iter().try_for_each(|&s| {
        let (done, own) = values.split_at_mut(symbolic.value_start[s]);
        let own = &mut own[..symbolic.value_start[s + 1] - symbolic.value_start[s]];
        Target { symbolic, s, done, base: 0 }.factor_together(own, pool)
    })
}

impl Target<'_> {
    fn columns(&self) -> usize {
        self.symbolic.columns(self.s)
    }

    /// Updates and factors with one thread.
    fn factor_alone(&self, own: &mut [f64], work: &mut Work) -> Result<(), NotPositive> {
        let height = self.symbolic.height(self.s);
        self.note_places(work);
        for (k, strip) in own.chunks_mut(STRIP * height).enumerate() {
            self.update(k * STRIP, strip, work);
        }
        factor_block(own, height, self.columns())
    }

    /// Updates and factors with all threads.
    fn factor_together(&self, own: &mut [f64], pool: &Pool) -> Result<(), NotPositive> {
        let height = self.symbolic.height(self.s);
        own.par_chunks_mut(STRIP * height).enumerate().with_max_len(1).for_each(|(k, strip)| {
            pool.with(self.symbolic.n, |work| {
                self.note_places(work);
                self.update(k * STRIP, strip, work);
            });
        });
        factor_block(own, height, self.columns())
    }

    fn note_places(&self, work: &mut Work) {
        let columns = self.columns();
        for (k, &row) in self.symbolic.rows_of(self.s).iter().enumerate() {
            work.place[row as usize] = (columns + k) as u32;
        }
    }

    /// Subtracts the descendants' products from the columns `first..` that `strip` holds.
    fn update(&self, first: usize, strip: &mut [f64], work: &mut Work) {
        let symbolic = self.symbolic;
        let height = symbolic.height(self.s);
        let begin = symbolic.begin[self.s];
        let end = symbolic.begin[self.s + 1];
        let from = begin + first as u32;
        let to = from + (strip.len() / height) as u32;
        for &Update { from: d, first: at, count } in symbolic.updates_of(self.s) {
            let d = d as usize;
            let rows = &symbolic.rows_of(d)[at as usize..];
            let within = &rows[..count as usize];
            let skip = within.partition_point(|&r| r < from);
            let wide = within[skip..].partition_point(|&r| r < to);
            if wide == 0 {
                continue;
            }
            let rows = &rows[skip..];
            let (tall, depth) = (rows.len(), symbolic.columns(d));
            let block = &self.done
                [symbolic.value_start[d] - self.base..symbolic.value_start[d + 1] - self.base];
            let first_row = depth + at as usize + skip;
            let Work { place, product, targets, columns, runs } = work;
            targets.clear();
            targets
                .extend(rows.iter().map(|&r| if r < end { r - begin } else { place[r as usize] }));
            if depth <= NARROW {
                columns.clear();
                columns.extend(rows[..wide].iter().map(|r| r - from));
                let update = blocks::Update {
                    block,
                    height: symbolic.height(d),
                    depth,
                    first: first_row,
                    wide,
                };
                update.subtract(strip, height, targets, columns);
                continue;
            }
            let block = MatRef::from_column_major_slice(block, symbolic.height(d), depth);
            let left = block.subrows(first_row, tall);
            let right = left.subrows(0, wide);
            let column = (rows[0] - from) as usize;
            let contiguous = targets[tall - 1] - targets[0] + 1 == tall as u32
                && rows[wide - 1] - rows[0] + 1 == wide as u32;
            if contiguous {
                // rows above the diagonal are written too, but never read
                let whole =
                    MatMut::from_column_major_slice_mut(strip, height, (to - from) as usize);
                let part = whole.submatrix_mut(targets[0] as usize, column, tall, wide);
                dense::subtract_product(part, left, right);
                continue;
            }
            product.resize(product.len().max(tall * wide), 0.0);
            let product = &mut product[..tall * wide];
            dense::product(MatMut::from_column_major_slice_mut(product, tall, wide), left, right);
            runs.clear();
            for (i, &t) in targets.iter().enumerate() {
                match runs.last_mut() {
                    Some((to, _, count)) if *to + *count == t => *count += 1,
                    _ => runs.push((t, i as u32, 1)),
                }
            }
            // rows above the diagonal are written too, but never read
            for (j, values) in product.chunks_exact(tall).enumerate() {
                let column = (rows[j] - from) as usize * height;
                let column = &mut strip[column..column + height];
                for &(to, i, count) in runs.iter() {
                    let (to, i, count) = (to as usize, i as usize, count as usize);
                    column[to..to + count]
                        .iter_mut()
                        .zip(&values[i..i + count])
                        .for_each(|(c, v)| *c -= v);
                }
            }
        }
    }
}

/// Cholesky of the leading `columns` of a block, and the rows below solved by it.
fn factor_block(own: &mut [f64], height: usize, columns: usize) -> Result<(), NotPositive> {
    if columns <= 2 * PANEL {
        return if blocks::factor(own, height, columns) { Ok(()) } else { Err(NotPositive) };
    }
    let mut first = 0;
    while first < columns {
        let wide = PANEL.min(columns - first);
        let (panel, right) = own[first * height..].split_at_mut(wide * height);
        let block = MatMut::from_column_major_slice_mut(panel, height, wide)
            .subrows_mut(first, height - first);
        factor_panel(block)?;
        let panel = MatRef::from_column_major_slice(panel, height, wide);
        right.par_chunks_mut(STRIP * height).enumerate().with_max_len(1).for_each(|(k, strip)| {
            let at = first + wide + k * STRIP;
            let count = strip.len() / height;
            let left = panel.subrows(at, height - at);
            let target = MatMut::from_column_major_slice_mut(strip, height, count)
                .subrows_mut(at, height - at);
            dense::subtract_product(target, left, left.subrows(0, count));
        });
        first += wide;
    }
    Ok(())
}

/// Cholesky of the square on top and the rows below it.
fn factor_panel(block: MatMut<'_, f64>) -> Result<(), NotPositive> {
    let columns = block.ncols();
    let (mut top, bottom) = block.split_at_row_mut(columns);
    if !dense::cholesky(top.as_mut()) {
        return Err(NotPositive);
    }
    let top = top.as_ref();
    let mut strips = Vec::new();
    let mut rest = bottom;
    while rest.nrows() > ROWS {
        let (strip, below) = rest.split_at_row_mut(ROWS);
        strips.push(strip);
        rest = below;
    }
    strips.push(rest);
    strips.into_par_iter().with_max_len(1).for_each(|strip| dense::solve_right(top, strip));
    Ok(())
}
