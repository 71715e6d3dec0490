//! Supplementary web plate of the column.

use crate::check::{number as n, within};
use crate::eurocode::i_section::Section;
use crate::eurocode::section::epsilon;
use bracket_joint::assembly::ColumnSide;

/// Reason why a supplementary web plate does not count; `None` where it counts.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.1, supplementary web plates (from paragraph 6 on): b_s ≤ 40 ε t_s, t_s ≥
/// t_wc.
pub(super) fn doubler_fault(c: &ColumnSide) -> Option<String> {
    let (s, width) = (&c.section, doubler_width(c));
    let widest = 40.0 * epsilon(c.steel.fy.mpa()) * c.doubler;
    if !within(s.tw, c.doubler) {
        return Some(format!(
            "t_s = {} mm is less than t_wc = {} mm (6.2.6.1)",
            n(c.doubler),
            n(s.tw)
        ));
    }
    let words =
        || format!("b_s = {} mm is more than 40 ε t_s = {} mm (6.2.6.1)", n(width), n(widest));
    (!within(width, widest)).then(words)
}

/// Width b_s of the plate \[mm\]: the flat part of the web.
pub(super) fn doubler_width(c: &ColumnSide) -> f64 {
    Section::from(&c.section).clear_depth()
}
