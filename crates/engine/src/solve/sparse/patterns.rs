//! Store of layouts: load cases and kinds of analysis of one mesh share orderings and symbolic
//! factors.
//!
//! The block of each unknown and the graph of blocks determine a layout. A layout from the store is
//! therefore equal, to the last bit, to a new one, and sharing changes no result. Patterns are
//! compared in full.

use super::layout::Layout;
use super::pattern::Pattern;
use crate::programs::conic::SymmetricCsc;
use std::sync::{Arc, Mutex, PoisonError};

/// Largest number of layouts kept. One mesh has two patterns for each of its programs, with and
/// without contact, and these again where a motion resisted by friction alone is pinned.
pub(super) const MOST: usize = 8;

/// The layouts of one mesh. Clones share one store; a new store for each mesh releases the layouts
/// of the last mesh.
#[derive(Clone, Default)]
pub struct Patterns {
    kept: Arc<Mutex<Kept>>,
}

/// The layouts in the order of their last use, and the number of times one was found.
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
    /// The layout for matrices with the pattern of `a`, made only if the store does not contain it.
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
        // made without the lock: two threads that need the same layout both make it, one is kept
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

    /// Number of layouts, and number of times one of them was found.
    pub fn count(&self) -> (usize, usize) {
        let kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        (kept.layouts.len(), kept.found)
    }
}
