//! The allowed range of a parameter.

use bracket_base::units::limits;

/// The allowed range of a parameter, in internal units and in words.
pub(super) struct Range<'a> {
    pub min: Option<f64>,
    pub max: Option<f64>,
    pub words: &'a str,
}

impl Range<'_> {
    /// True if the value lies in the range, but for rounding.
    pub fn holds(&self, value: f64) -> bool {
        self.min.is_none_or(|m| limits::at_least(value, m))
            && self.max.is_none_or(|m| limits::at_most(value, m))
    }
}
