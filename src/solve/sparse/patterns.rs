//! Patterns that were ordered before: load cases and kinds of analysis of one mesh share orderings
//! and symbolic factors.
//!
//! A layout follows from the block of each unknown and the graph of blocks alone, so what is found
//! is, to the last bit, what would be made anew: sharing changes no result. Patterns are compared
//! in full.

use super::factor::Plan;
use super::ordering::BlockGraph;
use super::symbolic::Symbolic;
use crate::programs::conic::SymmetricCsc;
use std::sync::{Arc, Mutex, PoisonError};

/// Patterns kept at most. One mesh has two of each of its programs, with contact and without, and
/// those again where a motion that friction held is pinned.
const MOST: usize = 8;

/// What ordering and symbolic factor of a matrix follow from.
#[derive(PartialEq, Eq)]
pub struct Pattern {
    /// Block of each unknown, numbered without gaps; unknowns of one block are consecutive.
    pub block: Vec<u32>,
    /// Which blocks are coupled.
    pub graph: BlockGraph,
}

impl Pattern {
    /// Of a matrix whose unknown `i` lies in block `block[i]`.
    pub fn new(a: &SymmetricCsc, block: &[u32]) -> Self {
        let (block, blocks) = without_gaps(block);
        let graph = BlockGraph::new(a, &block, blocks);
        Self { block, graph }
    }
}

/// A pattern, ordered and laid out for its factor.
pub struct Layout {
    /// The pattern.
    pub pattern: Pattern,
    /// The factor's layout.
    pub symbolic: Symbolic,
    /// How its tree is cut for threads.
    pub plan: Plan,
}

impl Layout {
    /// Orders a pattern and lays out its factor.
    pub fn new(pattern: Pattern) -> Self {
        let symbolic = Symbolic::new(&pattern);
        let plan = Plan::new(&symbolic);
        Self { pattern, symbolic, plan }
    }
}

/// The layouts of one mesh. Clones are one store; a new one for each mesh lets those of the last
/// mesh go.
#[derive(Clone, Default)]
pub struct Patterns {
    kept: Arc<Mutex<Kept>>,
}

/// The layouts, the one used last at the end, and how often one was found.
#[derive(Default)]
struct Kept {
    layouts: Vec<Arc<Layout>>,
    found: usize,
}

impl Kept {
    /// The layout of a pattern, which becomes the one used last.
    fn find(&mut self, pattern: &Pattern) -> Option<Arc<Layout>> {
        let at = self.layouts.iter().position(|l| l.pattern == *pattern)?;
        let layout = self.layouts.remove(at);
        self.layouts.push(layout.clone());
        Some(layout)
    }
}

impl Patterns {
    /// The layout for matrices with the pattern of `a`, made only if it is not there yet.
    pub fn layout(&self, a: &SymmetricCsc, block: &[u32]) -> Arc<Layout> {
        let pattern = Pattern::new(a, block);
        let kept = || self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        {
            let mut kept = kept();
            if let Some(layout) = kept.find(&pattern) {
                kept.found += 1;
                return layout;
            }
        }
        // made while others may look: two that need the same at once both make it, and one stays
        let layout = Arc::new(Layout::new(pattern));
        let mut kept = kept();
        if let Some(other) = kept.find(&layout.pattern) {
            return other;
        }
        if kept.layouts.len() == MOST {
            kept.layouts.remove(0);
        }
        kept.layouts.push(layout.clone());
        layout
    }

    /// Layouts there are, and how often one of them was found.
    pub fn count(&self) -> (usize, usize) {
        let kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        (kept.layouts.len(), kept.found)
    }
}

/// The blocks that have unknowns, numbered anew, and their number.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::sparse::SparseCholesky;

    /// A ring of blocks of the given sizes, each coupled with the next; `couplings` joins more of
    /// them.
    fn ring(sizes: &[usize], couplings: &[(u32, u32)]) -> (SymmetricCsc, Vec<u32>) {
        let block: Vec<u32> =
            sizes.iter().enumerate().flat_map(|(b, &n)| vec![b as u32; n]).collect();
        let last = sizes.len() as u32 - 1;
        let joined = |i: u32, j: u32| {
            let (a, b) = (i.min(j), i.max(j));
            a + 1 >= b || (a, b) == (0, last) || couplings.contains(&(a, b))
        };
        let mut a = SymmetricCsc { n: block.len(), col_ptr: vec![0], ..SymmetricCsc::default() };
        for c in 0..block.len() {
            for r in 0..=c {
                if joined(block[r], block[c]) {
                    a.row_idx.push(r as u32);
                    a.values.push(if r == c { 50.0 + c as f64 } else { -1.0 / (1 + r + c) as f64 });
                }
            }
            a.col_ptr.push(a.row_idx.len());
        }
        (a, block)
    }

    #[test]
    fn equal_patterns_are_laid_out_once_and_give_the_same_bits() {
        let (a, block) = ring(&[3; 40], &[]);
        let mut b = a.clone();
        b.values.iter_mut().for_each(|v| *v *= 2.0);
        let patterns = Patterns::default();
        let rhs: Vec<f64> = (0..a.n).map(|i| (i % 7) as f64 - 3.0).collect();
        let solved = |a: &SymmetricCsc, patterns: &Patterns| {
            let mut factor = SparseCholesky::symbolic(a, &block, patterns).expect("laid out");
            factor.refactor(a).expect("the matrix is definite");
            factor.solve(&rhs)
        };
        let [first, second] = [&a, &b].map(|a| solved(a, &patterns));
        assert_eq!(patterns.count(), (1, 1));
        assert_eq!(first, solved(&a, &Patterns::default()));
        assert_eq!(second, solved(&b, &Patterns::default()));
    }

    #[test]
    fn patterns_that_differ_anywhere_have_layouts_of_their_own() {
        let patterns = Patterns::default();
        let mut sizes = [3; 20];
        let (a, block) = ring(&sizes, &[]);
        patterns.layout(&a, &block);
        let (joined, same) = ring(&sizes, &[(4, 11)]);
        patterns.layout(&joined, &same);
        sizes[7] = 2;
        let (smaller, of_it) = ring(&sizes, &[]);
        patterns.layout(&smaller, &of_it);
        assert_eq!(patterns.count(), (3, 0));
        // gaps in the numbers of blocks make no difference
        let gaps: Vec<u32> = block.iter().map(|b| 5 * b + 2).collect();
        patterns.layout(&a, &gaps);
        assert_eq!(patterns.count(), (3, 1));
    }

    #[test]
    fn the_store_stays_small_and_lets_go_of_what_was_not_used_for_longest() {
        let patterns = Patterns::default();
        let of = |k: u32| ring(&[2; 30], &[(3, 5 + k)]);
        let layout = |k: u32| {
            let (a, block) = of(k);
            drop(patterns.layout(&a, &block));
        };
        layout(0);
        layout(1);
        for k in 2..2 + MOST as u32 {
            // kept by its use
            layout(0);
            layout(k);
        }
        assert_eq!(patterns.count(), (MOST, MOST));
        layout(0);
        assert_eq!(patterns.count(), (MOST, MOST + 1));
        layout(1);
        assert_eq!(patterns.count(), (MOST, MOST + 1), "it was let go");
    }
}
