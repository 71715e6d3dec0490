//! Patterns that were ordered before: load cases and kinds of analysis of one mesh share orderings
//! and symbolic factors.
//!
//! A layout follows from the block of each unknown and the graph of blocks alone, so what is found
//! is, to the last bit, what would be made anew: sharing changes no result. Patterns are compared
//! in full.

use super::layout::Layout;
use super::pattern::Pattern;
use crate::programs::conic::SymmetricCsc;
use std::sync::{Arc, Mutex, PoisonError};

/// Patterns kept at most. One mesh has two of each of its programs, with contact and without, and
/// those again where a motion that friction held is pinned.
pub(super) const MOST: usize = 8;

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
