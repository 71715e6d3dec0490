//! Cut of the tree of supernodes into independent subtrees, one task each, and the supernodes
//! above.

use super::symbolic::Symbolic;

/// Subtrees with less than this part of all operations are factored by one thread.
const SUBTREE: f64 = 1.0 / 24.0;

/// Cut of the tree for threads.
pub struct Plan {
    /// Subtrees (first and last supernode) that are independent of each other, in order.
    pub subtrees: Vec<(usize, usize)>,
    /// Supernodes above them, in order.
    pub top: Vec<usize>,
    /// Numbers of their unknowns among themselves.
    pub above: Above,
}

/// The unknowns above the subtrees, numbered among themselves.
#[derive(Default)]
pub struct Above {
    /// First number in each supernode above.
    pub first: Vec<usize>,
    /// Number of each unknown; `u32::MAX` in subtrees.
    pub number: Vec<u32>,
    /// Their number.
    pub count: usize,
}

impl Above {
    fn new(symbolic: &Symbolic, top: &[usize]) -> Self {
        let mut out = Self { number: vec![u32::MAX; symbolic.n], ..Self::default() };
        for &s in top {
            out.first.push(out.count);
            for row in symbolic.begin[s]..symbolic.begin[s + 1] {
                out.number[row as usize] = out.count as u32;
                out.count += 1;
            }
        }
        out
    }
}

impl Plan {
    /// Cuts the tree into subtrees as large as allowed and the supernodes above them.
    pub fn new(symbolic: &Symbolic) -> Self {
        let count = symbolic.supernodes();
        let mut below = symbolic.flops.clone();
        for s in 0..count {
            if symbolic.parent[s] != u32::MAX {
                below[symbolic.parent[s] as usize] += below[s];
            }
        }
        let limit = SUBTREE * symbolic.flops.iter().sum::<f64>();
        let mut plan = Self { subtrees: Vec::new(), top: Vec::new(), above: Above::default() };
        let mut s = count;
        // from the root down; a subtree is skipped as a whole
        while s > 0 {
            s -= 1;
            if below[s] <= limit {
                let first = symbolic.first_descendant[s] as usize;
                plan.subtrees.push((first, s));
                s = first;
            } else {
                plan.top.push(s);
            }
        }
        plan.subtrees.reverse();
        plan.top.reverse();
        plan.above = Above::new(symbolic, &plan.top);
        plan
    }

    /// Data of the subtrees, laid out supernode by supernode (s begins at `start(s)`): first and
    /// last supernode, data.
    pub fn cut<'a>(
        &self,
        data: &'a mut [f64],
        start: impl Fn(usize) -> usize,
    ) -> Vec<(usize, usize, &'a mut [f64])> {
        let mut pieces = Vec::with_capacity(self.subtrees.len());
        let (mut rest, mut at) = (data, 0);
        for &(first, last) in &self.subtrees {
            let (from, to) = (start(first), start(last + 1));
            let (_, after) = rest.split_at_mut(from - at);
            let (piece, after) = after.split_at_mut(to - from);
            pieces.push((first, last, piece));
            (rest, at) = (after, to);
        }
        pieces
    }
}
