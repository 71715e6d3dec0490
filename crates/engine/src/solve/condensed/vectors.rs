//! Work on long vectors, entry by entry, on all threads.
//!
//! Vectors are cut into pieces of a fixed length, so that no result depends on the number of
//! threads.

use rayon::prelude::*;

/// Entries of a piece. Shorter vectors are not worth a second thread.
pub const PIECE: usize = 1 << 13;

/// The vector with the entries `of(0)`, `of(1)`, …
pub fn vector(entries: usize, of: impl Fn(usize) -> f64 + Sync + Send) -> Vec<f64> {
    (0..entries).into_par_iter().with_min_len(PIECE).map(of).collect()
}

/// `a += part · b`.
pub fn add(a: &mut [f64], part: f64, b: &[f64]) {
    let pieces = a.par_chunks_mut(PIECE).zip(b.par_chunks(PIECE));
    pieces.for_each(|(a, b)| a.iter_mut().zip(b).for_each(|(a, b)| *a += part * b));
}

/// `a *= factor`.
pub fn scale(a: &mut [f64], factor: f64) {
    a.par_chunks_mut(PIECE).for_each(|a| a.iter_mut().for_each(|a| *a *= factor));
}

/// Scalar product.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    sum(a.len(), |i| a[i] * b[i])
}

/// `of(0) + of(1) + …`
pub fn sum(terms: usize, of: impl Fn(usize) -> f64 + Sync) -> f64 {
    let of_piece = |i: usize| (i * PIECE..((i + 1) * PIECE).min(terms)).map(&of).sum::<f64>();
    let pieces = terms.div_ceil(PIECE);
    if pieces < 2 {
        return of_piece(0);
    }
    (0..pieces).into_par_iter().map(of_piece).collect::<Vec<f64>>().into_iter().sum()
}

/// Largest magnitude of the entries.
pub fn largest(a: &[f64]) -> f64 {
    let of_piece = |a: &[f64]| a.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    a.par_chunks(PIECE).map(of_piece).reduce(|| 0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whole numbers, whose sums are exact in any order.
    #[test]
    fn pieces_add_up() {
        for n in [0, 1, PIECE, PIECE + 1, 5 * PIECE + 17] {
            let mut a = vector(n, |i| (i % 7) as f64);
            let b = vector(n, |i| 1.0 + (i % 3) as f64);
            let exact: usize = (0..n).map(|i| (i % 7) * (1 + i % 3)).sum();
            assert_eq!(dot(&a, &b), exact as f64, "{n}");
            add(&mut a, -2.0, &b);
            scale(&mut a, 3.0);
            let entry = |i: usize| 3.0 * ((i % 7) as f64 - 2.0 * (1 + i % 3) as f64);
            assert!((0..n).all(|i| a[i] == entry(i)), "{n}");
            assert_eq!(largest(&a), (0..n).fold(0.0, |m: f64, i| m.max(entry(i).abs())), "{n}");
        }
    }
}
