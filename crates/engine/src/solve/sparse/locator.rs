//! Places of matrix entries in the storage of the factor.

use super::layout::Layout;
use super::symbolic::Symbolic;

/// Finds the places of matrix entries in the storage of the factor. Successive entries of one
/// column and block are found fast.
pub struct Locator<'a> {
    symbolic: &'a Symbolic,
    block: &'a [u32],
    /// Supernode of each position.
    owner: Vec<u32>,
    /// Position of the first unknown of each block.
    first: Vec<u32>,
    /// Supernode, block and row of the last entry.
    known: (u32, u32, u32),
}

impl<'a> Locator<'a> {
    pub(super) fn new(layout: &'a Layout) -> Self {
        let (symbolic, block) = (&layout.symbolic, &layout.pattern.block[..]);
        let mut owner = vec![0u32; symbolic.n];
        for s in 0..symbolic.supernodes() {
            owner[symbolic.begin[s] as usize..symbolic.begin[s + 1] as usize].fill(s as u32);
        }
        let mut first = vec![u32::MAX; block.iter().map(|&b| b as usize + 1).max().unwrap_or(0)];
        for (i, &b) in block.iter().enumerate() {
            first[b as usize] = first[b as usize].min(symbolic.position[i]);
        }
        Self { symbolic, block, owner, first, known: (u32::MAX, u32::MAX, 0) }
    }

    /// Place of the entry of unknowns `r` and `c`, which must be in the pattern.
    pub fn place(&mut self, r: u32, c: u32) -> u32 {
        let symbolic = self.symbolic;
        let (pr, pc) = (symbolic.position[r as usize], symbolic.position[c as usize]);
        let (low, high, outer) = if pr > pc { (pc, pr, r) } else { (pr, pc, c) };
        let block = self.block[outer as usize];
        let s = self.owner[low as usize];
        let first = self.first[block as usize];
        if (self.known.0, self.known.1) != (s, block) {
            self.known = (s, block, row_in(symbolic, s as usize, first));
        }
        let s = s as usize;
        let row = (self.known.2 + (high - first)) as usize;
        let column = (low - symbolic.begin[s]) as usize;
        (symbolic.value_start[s] + column * symbolic.height(s) + row) as u32
    }
}

/// Row of unknown `position` in the dense block of supernode `s`.
fn row_in(symbolic: &Symbolic, s: usize, position: u32) -> u32 {
    if position < symbolic.begin[s + 1] {
        return position - symbolic.begin[s];
    }
    let rows = symbolic.rows_of(s);
    symbolic.columns(s) as u32 + rows.partition_point(|&r| r < position) as u32
}
