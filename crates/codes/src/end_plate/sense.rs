//! Senses of bending of a joint under its load cases.

use super::transformation::beta;
use crate::subject::Sense;
use bracket_joint::assembly::EndPlate;

/// Senses of bending of the load cases with their β.
pub(super) fn bent(e: &EndPlate) -> Vec<(Sense, f64)> {
    let mut out: Vec<(Sense, f64)> = Vec::new();
    for a in &e.actions {
        let entry = (Sense::of_moment(a.at(1.0)[1][1]), beta(e, a));
        if !out.contains(&entry) {
            out.push(entry);
        }
    }
    out
}

/// Senses of bending with their β: those of the load cases, and the template's β for a sense that
/// no load case has.
pub(super) fn senses(e: &EndPlate) -> Vec<(Sense, f64)> {
    let mut out = bent(e);
    for sense in [Sense::Top, Sense::Bottom] {
        if out.iter().all(|o| o.0 != sense) {
            out.push((sense, e.column.as_ref().map_or(0.0, |c| c.beta)));
        }
    }
    out.sort_by(|a, b| {
        (a.0 == Sense::Bottom).cmp(&(b.0 == Sense::Bottom)).then(a.1.total_cmp(&b.1))
    });
    out
}
