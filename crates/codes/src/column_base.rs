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
mod hollow;
mod load_cases;
mod open_actions;
mod range_checks;
mod shear;
mod stiffness;
mod tension_side;
mod weld_checks;

use crate::end_plate::HandChecks;
use bracket_joint::assembly::ColumnBase;
use compression::IBase;

pub use diagram::moment_axial;
pub use forces::moment_resistance;
pub(crate) use stiffness::ground_stiffness;

/// All hand checks of a column base.
pub fn base_checks(e: &ColumnBase) -> HandChecks {
    let mut out = HandChecks { checks: range_checks::checks(e), ..HandChecks::default() };
    out.checks.extend(shear::resistances(e));
    let of_column = IBase::of(e).map(|i| (weld_checks::sizes(&i), load_cases::checks(&i)));
    let of_hollow = hollow::section(e).map(|h| (hollow::weld_size(e, &h), hollow::checks(e, &h)));
    let (welds, cases) = of_column.or(of_hollow).unwrap_or_default();
    out.checks.extend(welds);
    let service = e.actions.iter().filter(|a| !a.state.is_ultimate());
    out.serviceability.extend(service.map(|a| a.case.clone()));
    out.checks.extend(cases);
    out.checks.sort_by_key(|c| c.topic);
    out
}

#[cfg(test)]
mod tests;
