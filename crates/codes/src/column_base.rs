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

use crate::check::number;
use crate::end_plate::HandChecks;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::ColumnBase;
use compression::IBase;

pub use diagram::moment_axial;
pub use forces::moment_resistance;
pub(crate) use stiffness::ground_stiffness;

/// N_j,Rd under axial compression alone \[N\], which counts the area under the web as well.
pub fn axial_resistance(e: &ColumnBase) -> f64 {
    compression::whole(e).value
}

/// C_f,d of sand-cement mortar, EN 1993-1-8:2005 6.2.2(6).
const MORTAR: f64 = 0.2;

/// A note where friction is taken for more than that of sand-cement mortar.
fn tested_friction(e: &ColumnBase) -> Option<Text> {
    let c = e.foundation.friction;
    (c > MORTAR).then(|| {
        say!(
            "C_f,d = {} is more than the {} of sand-cement mortar: EN 1993-1-8 6.2.2(6) asks for \
             tests by EN 1990, Annex D",
            number(c),
            number(MORTAR)
        )
    })
}

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
    out.notes.extend(tested_friction(e));
    out.checks.sort_by_key(|c| c.topic);
    out
}

#[cfg(test)]
mod tests;
