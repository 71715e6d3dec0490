//! M–N diagram of a base, for the reports. No check needs it.

use super::compression::{IBase, under_flange, whole};
use super::forces::{Force, forces, moment_resistance};
use super::tension_side::tension_side;
use crate::end_plate::{Curve, MomentAxial, Point};
use bracket_joint::assembly::{ColumnBase, PlaneActions};

/// Axial forces at which the curve is computed.
const POINTS: usize = 96;

/// Steps that narrow an end of the curve to a part of 2⁻⁶⁰ of its axial force.
const STEPS: usize = 60;

/// What the code lets a base carry of N and My together, with the load cases; `None` where it has
/// no moment resistance.
///
/// # Source
/// EN 1993-1-8:2005 Table 6.7. Under N alone 6.2.5 may allow more compression, as the web presses
/// too.
pub fn moment_axial(e: &ColumnBase) -> Option<MomentAxial> {
    let e = &IBase::of(e)?;
    let border = border(e)?;
    let curves = vec![Curve { beta: 0.0, border, resistance: None }];
    let point = |a: &PlaneActions| {
        let [[n, ..], [_, m, _]] = a.at(1.0);
        Some(Point { case: a.case.clone(), at: [n, m], utilisation: utilisation(e, n, m)? })
    };
    let ultimate = e.actions.iter().filter(|a| a.state.is_ultimate());
    Some(MomentAxial { curves, small: None, demands: ultimate.filter_map(point).collect() })
}

/// Corners N, tension positive \[N\], and My \[N mm\]: with tension at positive x by rising N, then
/// with tension at negative x by falling N.
fn border(e: &IBase<'_>) -> Option<Vec<[f64; 2]>> {
    let both = |axial: f64| {
        let [one, other] = [1.0, -1.0].map(|side| moment_resistance(e, axial, side));
        one.zip(other).filter(|(a, b)| *a >= 0.0 && *b >= 0.0)
    };
    let rows = [1.0, -1.0].into_iter().filter_map(|side| tension_side(e, side).ok());
    let pull: f64 = rows.map(|row| row.resistance.value).sum();
    // both ends lie outside what is carried
    let (low, high) = (-1.01 * whole(e).value, 1.01 * pull + 1.0);
    let at = |i: usize| low + (high - low) * i as f64 / POINTS as f64;
    let inside: Vec<f64> = (0..=POINTS).map(at).filter(|n| both(*n).is_some()).collect();
    let step = (high - low) / POINTS as f64;
    let last_before = |within: f64, beyond: f64| {
        let ends = (0..STEPS).fold([within, beyond], |[within, beyond], _| {
            let middle = 0.5 * (within + beyond);
            if both(middle).is_some() { [middle, beyond] } else { [within, middle] }
        });
        ends[0]
    };
    let (first, last) = (*inside.first()?, *inside.last()?);
    let (start, end) = (last_before(first, first - step), last_before(last, last + step));
    let axial = || std::iter::once(start).chain(inside.iter().copied()).chain([end]);
    let one = axial().filter_map(|n| Some([n, both(n)?.0]));
    let other = axial().filter_map(|n| Some([n, -both(n)?.1]));
    let mut back: Vec<_> = other.collect();
    back.reverse();
    Some(one.chain(back).collect())
}

/// The largest utilisation of the forces under N and My; `None` where the tables have none.
fn utilisation(e: &IBase<'_>, axial: f64, moment: f64) -> Option<f64> {
    if moment == 0.0 && axial <= 0.0 {
        return Some(-axial / whole(e).value);
    }
    let of = |(side, force): (f64, Force)| match force {
        Force::Tension(row, force) => Some(force.value / row.resistance.value),
        Force::Compression(force) => Some(force.value / under_flange(e, side, 0.0).ok()?.value),
    };
    let found: Option<Vec<f64>> = forces(e, axial, moment).ok()?.into_iter().map(of).collect();
    found.map(|u| u.into_iter().fold(0.0, f64::max))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::column_base::tests::fixture::base;

    /// Every corner uses one force in full, no corner uses more; the curve closes where the base
    /// carries N with one moment alone.
    #[test]
    fn corners_use_a_force_in_full() {
        let base = base();
        let e = IBase::of(&base).expect("an I section");
        let border = border(&e).expect("a curve");
        assert!(border.len() > POINTS, "{}", border.len());
        // under N alone the web presses too
        let bent: Vec<_> = border.iter().filter(|c| c[1] != 0.0).collect();
        assert!(bent.len() + 4 >= border.len(), "{}", bent.len());
        for [n, m] in bent {
            let used = utilisation(&e, *n, *m).expect("rows outside the flanges");
            assert!((used - 1.0).abs() < 1e-9, "{used} at {n}, {m}");
        }
        let [low, high] = [border[0], border[border.len() / 2 - 1]].map(|c| c[0]);
        let rows = [1.0, -1.0].map(|s| tension_side(&e, s).expect("a row").resistance.value);
        let pressed = [1.0, -1.0].map(|s| under_flange(&e, s, 0.0).expect("class 1").value);
        assert!((high - rows[0] - rows[1]).abs() < 1e-3 * high, "{high}");
        assert!((low + pressed[0] + pressed[1]).abs() < 1e-3 * -low, "{low}");
    }
}
