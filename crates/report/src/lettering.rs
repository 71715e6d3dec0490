//! Size of the texts in drawings and diagrams.

/// Height of the letters \[pixels\].
pub const LETTERS: f64 = 12.0;

/// Width of a text \[pixels\]. The estimate is on the safe side: letters of common fonts are
/// narrower.
pub fn width(text: &str) -> f64 {
    0.58 * LETTERS * text.chars().count() as f64
}
