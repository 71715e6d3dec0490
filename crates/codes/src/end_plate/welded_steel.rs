//! Steel for which the fillet welds of a part are designed, and throats of full strength.

use super::at_plate;
use crate::check::Unit;
use crate::eurocode::welds::WeldedSteel;
use crate::formula::{Line, Relation, Traced};
use crate::worked::Worked;
use bracket_joint::assembly::{ColumnSide, EndPlate, Haunch};

/// Steel of the welds between beam and end plate: the weaker of the parts joined. `None` for grades
/// without β_w, for which the code has no fillet welds.
pub(super) fn of_the_beam(e: &EndPlate) -> Option<WeldedSteel> {
    let beam = at_plate::haunch(e).map_or(&e.beam_steel, |h| e.beam_steel.weaker(&h.steel));
    WeldedSteel::of(beam.weaker(&e.plate_steel), e.factors.gamma_m2)
}

/// Steel of the welds between the web of a haunch and the flange of the beam.
pub(super) fn of_the_haunch(e: &EndPlate, h: &Haunch) -> Option<WeldedSteel> {
    WeldedSteel::of(e.beam_steel.weaker(&h.steel), e.factors.gamma_m2)
}

/// Steel of the welds on the column.
pub(super) fn of_the_column(e: &EndPlate, c: &ColumnSide) -> Option<WeldedSteel> {
    WeldedSteel::of(&c.steel, e.factors.gamma_m2)
}

/// The throat of full strength, written out; `full` is that of
/// [`full_strength_throat`](crate::eurocode::welds::full_strength_throat).
pub(super) fn full_throat(full: &Worked) -> Traced {
    full.derivation.formulas().last().map_or_else(|| full.traced(), Traced::from)
}

/// A throat `a` \[mm\] that is at least that of full strength.
pub(super) fn as_strong(a: f64, full: &Worked) -> Line {
    Line::comparison("a", a, Relation::AtLeast, full_throat(full), Unit::Length)
}
