//! Steel for which the fillet welds of a part are designed.

use crate::eurocode::welds::WeldedSteel;
use bracket_joint::assembly::{ColumnSide, EndPlate};

/// Steel of the welds between beam and end plate: the weaker of the parts joined. `None` for grades
/// without β_w, for which the code has no fillet welds.
pub(super) fn of_the_beam(e: &EndPlate) -> Option<WeldedSteel> {
    let weaker = e.beam_steel.weaker(&e.plate_steel);
    Some(WeldedSteel { fu: weaker.fu, beta_w: weaker.beta_w?, gamma_m2: e.factors.gamma_m2 })
}

/// Steel of the welds on the column.
pub(super) fn of_the_column(e: &EndPlate, c: &ColumnSide) -> Option<WeldedSteel> {
    Some(WeldedSteel { fu: c.steel.fu, beta_w: c.steel.beta_w?, gamma_m2: e.factors.gamma_m2 })
}
