//! Layout of a factor: a pattern, its symbolic factor and the plan of its threads.

use super::pattern::Pattern;
use super::plan::Plan;
use super::symbolic::Symbolic;

/// A pattern, ordered and laid out for its factor.
pub struct Layout {
    /// The pattern.
    pub pattern: Pattern,
    /// The factor's layout.
    pub symbolic: Symbolic,
    /// Cut of its tree for threads.
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
