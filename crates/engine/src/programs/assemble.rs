//! Assembly of element matrices into one symmetric sparse matrix with a fixed pattern.

use crate::programs::conic::SymmetricCsc;
use crate::programs::dofs::DofMap;
use rayon::prelude::*;

/// Number of element matrices in memory at a time.
const BATCH: usize = 2048;

/// Assembles `Σ_e S_eᵀ K_e S_e`.
///
/// `dofs(e)` lists the M full unknowns of element `e`, `matrix(e)` its symmetric matrix; unknowns
/// are mapped by `map`. Every diagonal entry is stored.
pub fn assemble<const M: usize, E: Send>(
    elements: usize,
    map: &DofMap,
    dofs: impl Fn(usize) -> [usize; M] + Sync,
    matrix: impl Fn(usize) -> Result<Box<[[f64; M]; M]>, E> + Sync,
) -> Result<SymmetricCsc, E> {
    let mut a = pattern(elements, map, &dofs);
    let mut first = 0;
    while first < elements {
        let last = (first + BATCH).min(elements);
        let batch: Vec<Box<[[f64; M]; M]>> =
            (first..last).into_par_iter().map(&matrix).collect::<Result<_, E>>()?;
        for (k, ke) in batch.iter().enumerate() {
            scatter(&mut a, map, &dofs(first + k), ke);
        }
        first = last;
    }
    Ok(a)
}

fn pattern<const M: usize>(
    elements: usize,
    map: &DofMap,
    dofs: &(impl Fn(usize) -> [usize; M] + Sync),
) -> SymmetricCsc {
    let unknowns: Vec<Vec<u32>> = (0..elements)
        .into_par_iter()
        .map(|e| {
            let mut u: Vec<u32> =
                dofs(e).iter().flat_map(|&d| map.terms(d).iter().map(|t| t.0)).collect();
            u.sort_unstable();
            u.dedup();
            u
        })
        .collect();
    let mut of_unknown: Vec<Vec<u32>> = vec![Vec::new(); map.n];
    for (e, u) in unknowns.iter().enumerate() {
        for &k in u {
            of_unknown[k as usize].push(e as u32);
        }
    }
    let columns: Vec<Vec<u32>> = (0..map.n)
        .into_par_iter()
        .map(|c| {
            let mut rows: Vec<u32> = of_unknown[c]
                .iter()
                .flat_map(|&e| {
                    unknowns[e as usize].iter().copied().take_while(move |&r| r as usize <= c)
                })
                .chain([c as u32])
                .collect();
            rows.sort_unstable();
            rows.dedup();
            rows
        })
        .collect();
    let mut col_ptr = Vec::with_capacity(map.n + 1);
    col_ptr.push(0);
    for c in &columns {
        col_ptr.push(col_ptr[col_ptr.len() - 1] + c.len());
    }
    let row_idx: Vec<u32> = columns.into_iter().flatten().collect();
    let values = vec![0.0; row_idx.len()];
    SymmetricCsc { n: map.n, col_ptr, row_idx, values }
}

fn scatter<const M: usize>(
    a: &mut SymmetricCsc,
    map: &DofMap,
    dofs: &[usize; M],
    ke: &[[f64; M]; M],
) {
    for j in 0..M {
        for &(c, wc) in map.terms(dofs[j]) {
            let range = a.col_ptr[c as usize]..a.col_ptr[c as usize + 1];
            for i in 0..M {
                for &(r, wr) in map.terms(dofs[i]) {
                    if r > c {
                        continue;
                    }
                    let at = a.row_idx[range.clone()]
                        .binary_search(&r)
                        .expect("the pattern contains every pair");
                    a.values[range.start + at] += wr * wc * ke[i][j];
                }
            }
        }
    }
}
