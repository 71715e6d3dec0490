//! Hand checks of a column base: a column of I section on a plate with anchors, on grout and
//! concrete, under N, Vz and My.
//!
//! Compression is carried by the effective area of the plate (EN 1993-1-8:2005 6.2.5), with a
//! moment by the areas under the flanges and by the anchor rows outside them (6.2.8). What anchors
//! need of the concrete is the matter of EN 1992-4: these checks print the forces.

mod anchorage;
mod case_end;
mod compression;
mod diagram;
pub mod effective_area;
mod forces;
mod load_cases;
mod range_checks;
mod shear;
mod stiffness;
mod tension_side;
mod weld_checks;

use crate::end_plate::HandChecks;
use bracket_joint::assembly::ColumnBase;

pub use diagram::moment_axial;
pub use forces::moment_resistance;

/// All hand checks of a column base.
pub fn base_checks(e: &ColumnBase) -> HandChecks {
    let mut out = HandChecks { checks: range_checks::checks(e), ..HandChecks::default() };
    out.checks.extend(shear::resistances(e));
    out.checks.extend(weld_checks::sizes(e));
    let service = e.actions.iter().filter(|a| !a.state.is_ultimate());
    out.serviceability.extend(service.map(|a| a.case.clone()));
    out.checks.extend(load_cases::checks(e));
    out.checks.sort_by_key(|c| c.topic);
    out
}

#[cfg(test)]
mod tests;
