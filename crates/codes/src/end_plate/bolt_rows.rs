//! Rows of bolts of an end plate and their distances \[mm\].

use crate::subject::Place;
use bracket_joint::assembly::EndPlate;

/// The bolts, as a check names them.
pub(super) fn bolt(e: &EndPlate) -> Place {
    Place::bolt(&e.bolt, &e.grade)
}

/// z of the rows, from the top.
pub(super) fn from_top(e: &EndPlate) -> Vec<f64> {
    let mut rows = e.rows.clone();
    rows.sort_by(|a, b| b.total_cmp(a));
    rows
}

/// Smallest and largest pitch of the rows; `None` for a single row.
pub(super) fn pitches(e: &EndPlate) -> Option<[f64; 2]> {
    let rows = from_top(e);
    let pitches = rows.windows(2).map(|w| w[0] - w[1]);
    pitches.fold(None, |range: Option<[f64; 2]>, p| {
        Some(range.map_or([p, p], |[a, b]| [a.min(p), b.max(p)]))
    })
}

/// Smallest distance of a row from the ends `bottom` and `top` of a part.
pub(super) fn end_distance(e: &EndPlate, bottom: f64, top: f64) -> f64 {
    e.rows.iter().map(|z| (top - z).min(z - bottom)).fold(f64::INFINITY, f64::min)
}
