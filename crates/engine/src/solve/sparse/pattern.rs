//! Pattern of a sparse matrix: the block of each unknown and the graph of blocks.

use super::ordering::BlockGraph;
use crate::programs::conic::SymmetricCsc;

/// The data that determine the ordering and the symbolic factor of a matrix.
#[derive(PartialEq, Eq)]
pub struct Pattern {
    /// Block of each unknown, numbered without gaps; unknowns of one block are consecutive.
    pub block: Vec<u32>,
    /// Couplings of the blocks.
    pub graph: BlockGraph,
}

impl Pattern {
    /// The pattern of a matrix whose unknown `i` lies in block `block[i]`.
    pub fn new(a: &SymmetricCsc, block: &[u32]) -> Self {
        let (block, blocks) = without_gaps(block);
        let graph = BlockGraph::new(a, &block, blocks);
        Self { block, graph }
    }
}

/// The blocks with unknowns, renumbered without gaps, and their number.
fn without_gaps(block: &[u32]) -> (Vec<u32>, usize) {
    let mut number = vec![u32::MAX; block.iter().map(|&b| b as usize + 1).max().unwrap_or(0)];
    let mut count = 0;
    let renumber = |&b: &u32| {
        let n = &mut number[b as usize];
        if *n == u32::MAX {
            *n = count;
            count += 1;
        }
        *n
    };
    let out = block.iter().map(renumber).collect();
    (out, count as usize)
}
