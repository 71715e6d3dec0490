//! Fill-reducing ordering: METIS nested dissection of the graph of blocks (nodes or faces).

use crate::programs::conic::SymmetricCsc;
use std::sync::{Mutex, PoisonError};

/// A block with more neighbours than this many times the mean is kept out of the dissection and
/// eliminated last.
///
/// The unknowns of a rigid face are coupled to every node of the face; as a border they cost a few
/// dense rows.
const DENSE: usize = 30;

/// Neighbours of every block, without itself, increasing.
#[derive(PartialEq, Eq)]
pub struct BlockGraph {
    /// Start of each block's neighbours, blocks + 1.
    pub starts: Vec<usize>,
    /// Neighbours.
    pub neighbours: Vec<u32>,
}

impl BlockGraph {
    /// The graph of a matrix whose unknown `i` lies in block `block[i]` of `blocks`; unknowns of
    /// one block are consecutive.
    pub fn new(a: &SymmetricCsc, block: &[u32], blocks: usize) -> Self {
        let mut lists: Vec<Vec<u32>> = vec![Vec::new(); blocks];
        let mut last: Vec<u32> = vec![u32::MAX; blocks];
        for c in 0..a.n {
            let bc = block[c];
            for &r in &a.row_idx[a.col_ptr[c]..a.col_ptr[c + 1]] {
                let br = block[r as usize];
                // rows of one block are consecutive: this removes most repetitions
                if br != bc && last[bc as usize] != br {
                    last[bc as usize] = br;
                    lists[bc as usize].push(br);
                }
            }
            if c + 1 == a.n || block[c + 1] != bc {
                let list = &mut lists[bc as usize];
                list.sort_unstable();
                list.dedup();
            }
        }
        // both directions
        let mut count = vec![0usize; blocks + 1];
        for (b, list) in lists.iter().enumerate() {
            count[b + 1] += list.len();
            list.iter().for_each(|&o| count[o as usize + 1] += 1);
        }
        for b in 0..blocks {
            count[b + 1] += count[b];
        }
        let mut next = count.clone();
        let mut neighbours = vec![0u32; count[blocks]];
        for (b, list) in lists.iter().enumerate() {
            for &o in list {
                for (from, to) in [(b, o), (o as usize, b as u32)] {
                    neighbours[next[from]] = to;
                    next[from] += 1;
                }
            }
        }
        let mut starts = vec![0];
        let mut kept = 0;
        for b in 0..blocks {
            let range = count[b]..count[b + 1];
            neighbours[range.clone()].sort_unstable();
            let first = kept;
            for k in range {
                if kept == first || neighbours[kept - 1] != neighbours[k] {
                    neighbours[kept] = neighbours[k];
                    kept += 1;
                }
            }
            starts.push(kept);
        }
        neighbours.truncate(kept);
        Self { starts, neighbours }
    }

    /// Number of blocks.
    pub fn blocks(&self) -> usize {
        self.starts.len() - 1
    }

    /// Neighbours of a block.
    pub fn of(&self, b: usize) -> &[u32] {
        &self.neighbours[self.starts[b]..self.starts[b + 1]]
    }

    /// New position → block. Falls back to the given order when METIS refuses (tiny graphs).
    pub fn nested_dissection(&self) -> Vec<usize> {
        let n = self.blocks();
        let mean = self.neighbours.len() / n.max(1);
        let is_dense = |b: usize| self.of(b).len() > DENSE * mean.max(10);
        let inner: Vec<usize> = (0..n).filter(|&b| !is_dense(b)).collect();
        let mut place = vec![-1i32; n];
        inner.iter().enumerate().for_each(|(k, &b)| place[b] = k as i32);
        let mut xadj = vec![0i32];
        let mut adjncy: Vec<i32> = Vec::with_capacity(self.neighbours.len());
        for &b in &inner {
            adjncy.extend(self.of(b).iter().map(|&o| place[o as usize]).filter(|&o| o >= 0));
            xadj.push(adjncy.len() as i32);
        }
        let order = metis(inner.len(), &mut xadj, &mut adjncy)
            .unwrap_or_else(|| (0..inner.len()).collect());
        let border = (0..n).filter(|&b| is_dense(b));
        order.into_iter().map(|k| inner[k]).chain(border).collect()
    }
}

/// METIS NodeND with a fixed seed; new position → old vertex.
fn metis(n: usize, xadj: &mut [i32], adjncy: &mut [i32]) -> Option<Vec<usize>> {
    if n < 8 || adjncy.is_empty() {
        return None;
    }
    // METIS uses the single random sequence of the C library and replaces signal handlers: two
    // orderings at once would change each other's result from run to run
    static ONE: Mutex<()> = Mutex::new(());
    let _one = ONE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut nvtxs = n as i32;
    let mut options = [0i32; 40];
    let mut perm = vec![0i32; n];
    let mut iperm = vec![0i32; n];
    // SAFETY: the arrays have the lengths METIS asks for (xadj n + 1, adjncy xadj[n], perm and
    // iperm n, options METIS_NOPTIONS = 40); METIS writes only to perm, iperm and options and keeps
    // no pointer.
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
    (status == metis_sys::rstatus_et_METIS_OK)
        .then(|| perm.into_iter().map(|p| p as usize).collect())
}
