//! Sums and held unknowns of symmetric sparse matrices.

use crate::programs::conic::SymmetricCsc;

/// `A + s B` on the union of both patterns.
pub fn sum(a: &SymmetricCsc, s: f64, b: &SymmetricCsc) -> SymmetricCsc {
    let mut out = SymmetricCsc { n: a.n, col_ptr: vec![0], ..SymmetricCsc::default() };
    for c in 0..a.n {
        let (mut i, mut j) = (a.col_ptr[c], b.col_ptr[c]);
        let row = |m: &SymmetricCsc, k: usize| {
            if k < m.col_ptr[c + 1] { m.row_idx[k] } else { u32::MAX }
        };
        loop {
            let (of_a, of_b) = (row(a, i), row(b, j));
            let next = of_a.min(of_b);
            if next == u32::MAX {
                break;
            }
            let mut value = 0.0;
            if of_a == next {
                value += a.values[i];
                i += 1;
            }
            if of_b == next {
                value += s * b.values[j];
                j += 1;
            }
            out.row_idx.push(next);
            out.values.push(value);
        }
        out.col_ptr.push(out.row_idx.len());
    }
    out
}

/// Removes the couplings of held unknowns; their diagonal entries become `diagonal`.
pub fn hold(a: &mut SymmetricCsc, held: &[usize], diagonal: f64) {
    let mut is_held = vec![false; a.n];
    held.iter().for_each(|&k| is_held[k] = true);
    for c in 0..a.n {
        for i in a.col_ptr[c]..a.col_ptr[c + 1] {
            let r = a.row_idx[i] as usize;
            if is_held[r] || is_held[c] {
                a.values[i] = if r == c { diagonal } else { 0.0 };
            }
        }
    }
}

/// Mean of the diagonal; 1 for a matrix without unknowns.
pub fn mean_diagonal(a: &SymmetricCsc) -> f64 {
    if a.n == 0 { 1.0 } else { a.diagonal().iter().sum::<f64>() / a.n as f64 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(columns: &[&[(u32, f64)]]) -> SymmetricCsc {
        let mut a = SymmetricCsc { n: columns.len(), col_ptr: vec![0], ..SymmetricCsc::default() };
        for column in columns {
            column.iter().for_each(|&(r, v)| {
                a.row_idx.push(r);
                a.values.push(v);
            });
            a.col_ptr.push(a.row_idx.len());
        }
        a
    }

    #[test]
    fn sums_and_holds() {
        let a = matrix(&[&[(0, 1.0)], &[(1, 2.0)], &[(0, 3.0), (2, 4.0)]]);
        let b = matrix(&[&[], &[(0, 1.0)], &[(0, 1.0), (1, 5.0)]]);
        let mut c = sum(&a, 2.0, &b);
        let all = [(0, 1.0)].into_iter().chain([(0, 2.0), (1, 2.0), (0, 5.0), (1, 10.0), (2, 4.0)]);
        assert!(c.row_idx.iter().copied().zip(c.values.iter().copied()).eq(all));
        assert_eq!(c.col_ptr, [0, 1, 3, 6]);
        hold(&mut c, &[1], 7.0);
        assert_eq!(c.values, [1.0, 0.0, 7.0, 5.0, 0.0, 4.0]);
        assert_eq!(mean_diagonal(&c), 4.0);
    }
}
