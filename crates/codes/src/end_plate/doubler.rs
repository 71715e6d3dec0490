//! Supplementary web plate of the column.

use crate::check::{Unit, within};
use crate::eurocode::i_section::Section;
use crate::eurocode::section::epsilon;
use crate::formula::{Formula, Number, Traced};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::ColumnSide;

/// Reason why a supplementary web plate does not count; `None` where it counts.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.1, supplementary web plates (from paragraph 6 on): b_s ≤ 40 ε t_s, t_s ≥
/// t_wc.
pub(super) fn doubler_fault(c: &ColumnSide) -> Option<Text> {
    let (s, width) = (&c.section, doubler_width(c));
    let show = |length: f64| Unit::Length.show(length);
    if !within(s.tw, c.doubler) {
        let (plate, web) = (show(c.doubler), show(s.tw));
        return Some(say!("t_s = {} is less than t_wc = {} (6.2.6.1)", plate, web));
    }
    let widest = Traced::from(40.0)
        * Traced::number("ε", epsilon(c.steel.fy.mpa()))
        * Traced::length("t_s", c.doubler);
    (!within(width, widest.value())).then(|| {
        let widest = Formula::new("", widest, Unit::Length).text();
        say!("b_s = {} is more than {} (6.2.6.1)", show(width), widest)
    })
}

/// Width b_s of the plate \[mm\]: the flat part of the web.
pub(super) fn doubler_width(c: &ColumnSide) -> f64 {
    Section::from(&c.section).clear_depth()
}
