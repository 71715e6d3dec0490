//! Sum of a symmetric sparse matrix and single entries.

use crate::programs::conic::SymmetricCsc;

/// `P` plus entries (column, row, value) of the upper triangle; entries at one place add up.
pub fn plus_entries(p: &SymmetricCsc, mut entries: Vec<(usize, u32, f64)>) -> SymmetricCsc {
    entries.sort_unstable_by_key(|e| (e.0, e.1));
    let mut out = SymmetricCsc { n: p.n, col_ptr: vec![0], ..SymmetricCsc::default() };
    let mut next = entries.into_iter().peekable();
    for c in 0..p.n {
        let mut k = p.col_ptr[c];
        loop {
            let row_p = (k < p.col_ptr[c + 1]).then(|| p.row_idx[k]);
            let row_e = next.peek().filter(|e| e.0 == c).map(|e| e.1);
            let Some(r) = [row_p, row_e].into_iter().flatten().min() else { break };
            let mut v = 0.0;
            if row_p == Some(r) {
                v += p.values[k];
                k += 1;
            }
            while next.peek().is_some_and(|e| e.0 == c && e.1 == r) {
                v += next.next().map_or(0.0, |e| e.2);
            }
            out.row_idx.push(r);
            out.values.push(v);
        }
        out.col_ptr.push(out.row_idx.len());
    }
    out
}
