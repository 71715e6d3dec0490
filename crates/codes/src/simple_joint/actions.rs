//! Moments of a load case at the sections of a simple joint.

use crate::check::{Unit, balance};
use crate::formula::{Formula, Traced};
use bracket_joint::assembly::{PlaneActions, SimpleJoint};

/// M_Ed at the section `x` from the support about the height `z` \[mm\], from N, Vz and My of the
/// bolt plane; positive: it pulls at the top \[N mm\].
///
/// `My − d Vz − z N`, with the distance d = x_plane − x towards the support, as
/// [`PlaneActions::moment_at_node`] has it; N acts in the axis of the beam, z = 0.
pub(super) fn moment(e: &SimpleJoint, a: &PlaneActions, [x, z]: [f64; 2]) -> Formula {
    let [[n, _, v], [_, my, _]] = a.at(1.0);
    let d = e.centre() - x;
    let value = balance([my, -d * v, -z * n]);
    let mut of = Traced::symbol("My", my, Unit::Moment);
    if d * v != 0.0 {
        of = of - Traced::length("d", d) * Traced::force("Vz", v);
    }
    if z * n != 0.0 {
        of = of - Traced::length("z", z) * Traced::force("N", n);
    }
    Formula { value, ..Formula::new("M_Ed", of, Unit::Moment) }
}

/// z of the middle of the plate \[mm\].
pub(super) fn middle(e: &SimpleJoint) -> f64 {
    0.5 * (e.top + e.bottom)
}

/// The moment of the larger size.
pub(super) fn larger(a: Formula, b: Formula) -> Formula {
    if b.value.abs() > a.value.abs() { b } else { a }
}
