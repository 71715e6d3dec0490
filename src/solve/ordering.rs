//! Fill-reducing ordering: METIS nested dissection of the graph of blocks (nodes or faces), expanded to unknowns.

use crate::model::program::SymmetricCsc;
use std::sync::{Mutex, PoisonError};

/// New position → old unknown.
///
/// `block[i]` is the block of unknown `i`. Falls back to the given order when METIS refuses (tiny graphs).
pub fn nested_dissection(a: &SymmetricCsc, block: &[u32]) -> Vec<usize> {
    let blocks = block.iter().map(|&b| b as usize + 1).max().unwrap_or(0);
    let mut neighbours: Vec<Vec<i32>> = vec![Vec::new(); blocks];
    for c in 0..a.n {
        let bc = block[c];
        for &r in &a.row_idx[a.col_ptr[c]..a.col_ptr[c + 1]] {
            let br = block[r];
            if br != bc {
                neighbours[bc as usize].push(br as i32);
                neighbours[br as usize].push(bc as i32);
            }
        }
        // keep the lists short while they grow: unknowns of one block are consecutive
        if c + 1 == a.n || block[c + 1] != bc {
            let list = &mut neighbours[bc as usize];
            list.sort_unstable();
            list.dedup();
        }
    }
    let mut xadj: Vec<i32> = Vec::with_capacity(blocks + 1);
    let mut adjncy: Vec<i32> = Vec::new();
    xadj.push(0);
    for list in &mut neighbours {
        list.sort_unstable();
        list.dedup();
        adjncy.append(list);
        xadj.push(adjncy.len() as i32);
    }
    let order = metis(blocks, &mut xadj, &mut adjncy).unwrap_or_else(|| (0..blocks).collect());
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); blocks];
    for (i, &b) in block.iter().enumerate() {
        members[b as usize].push(i);
    }
    order.into_iter().flat_map(|b| std::mem::take(&mut members[b])).collect()
}

/// METIS NodeND with a fixed seed; new position → old vertex.
fn metis(n: usize, xadj: &mut [i32], adjncy: &mut [i32]) -> Option<Vec<usize>> {
    if n < 8 || adjncy.is_empty() {
        return None;
    }
    let mut nvtxs = n as i32;
    let mut options = [0i32; 40];
    let mut perm = vec![0i32; n];
    let mut iperm = vec![0i32; n];
    // METIS draws from the C library's one random sequence and swaps signal handlers: one ordering at a time, or two disturb
    // each other's order from run to run
    static ONE: Mutex<()> = Mutex::new(());
    let _one = ONE.lock().unwrap_or_else(PoisonError::into_inner);
    // SAFETY: the arrays have the lengths METIS asks for (xadj n + 1, adjncy xadj[n], perm and iperm n, options
    // METIS_NOPTIONS = 40); METIS writes only to perm, iperm and options and keeps no pointer.
    let status = unsafe {
        metis_sys::METIS_SetDefaultOptions(options.as_mut_ptr());
        options[metis_sys::moptions_et_METIS_OPTION_SEED as usize] = 1;
        metis_sys::METIS_NodeND(
            &mut nvtxs,
            xadj.as_mut_ptr(),
            adjncy.as_mut_ptr(),
            std::ptr::null_mut(),
            options.as_mut_ptr(),
            perm.as_mut_ptr(),
            iperm.as_mut_ptr(),
        )
    };
    (status == metis_sys::rstatus_et_METIS_OK).then(|| perm.into_iter().map(|p| p as usize).collect())
}
