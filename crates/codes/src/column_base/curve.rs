//! The moment resistance of a base beside every axial force, as a curve.

use super::compression::whole;
use super::forces::moment_resistance;
use super::tension_side::tension_side;
use bracket_joint::assembly::ColumnBase;
use serde::{Deserialize, Serialize};

/// Axial forces at which the curve is computed.
const POINTS: usize = 96;

/// What the code lets a base carry of N and My together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AxialMomentCurve {
    /// Member end.
    pub end: String,
    /// Clause.
    pub clause: String,
    /// Corners N, tension positive \[N\], and My \[N mm\]: first with tension at positive x, by
    /// increasing N, then with tension at negative x, by decreasing N.
    pub corners: Vec<[f64; 2]>,
}

/// The curve of a base; `None` where the code has no moment resistance.
///
/// # Source
/// EN 1993-1-8:2005 Table 6.7. Under N alone 6.2.5 may allow more compression, as the web presses
/// too.
pub(super) fn curve(e: &ColumnBase, end: &str) -> Option<AxialMomentCurve> {
    let both = |axial: f64| {
        let sides = [1.0, -1.0].map(|side| moment_resistance(e, axial, side));
        sides[0].zip(sides[1]).filter(|(a, b)| *a >= 0.0 && *b >= 0.0)
    };
    let pull: f64 =
        [1.0, -1.0].iter().filter_map(|s| tension_side(e, *s).ok()).map(|r| r.resistance.value).sum();
    let (low, high) = (-1.01 * whole(e).value, 1.01 * pull);
    let at = |i: usize| low + (high - low) * i as f64 / POINTS as f64;
    let inside: Vec<f64> = (0..=POINTS).map(at).filter(|n| both(*n).is_some()).collect();
    let (first, last) = (*inside.first()?, *inside.last()?);
    // the ends of the range, between a point of it and one outside
    let end_of = |mut within: f64, mut beyond: f64| {
        for _ in 0..60 {
            let middle = 0.5 * (within + beyond);
            *(if both(middle).is_some() { &mut within } else { &mut beyond }) = middle;
        }
        within
    };
    let step = (high - low) / POINTS as f64;
    let ends = [end_of(first, first - step), end_of(last, last + step)];
    let forces = || std::iter::once(ends[0]).chain(inside.iter().copied()).chain([ends[1]]);
    let one = forces().filter_map(|n| both(n).map(|(m, _)| [n, m]));
    let mut other: Vec<_> = forces().filter_map(|n| both(n).map(|(_, m)| [n, -m])).collect();
    other.reverse();
    let clause = "EN 1993-1-8:2005 Table 6.7".to_owned();
    Some(AxialMomentCurve { end: end.to_owned(), clause, corners: one.chain(other).collect() })
}
