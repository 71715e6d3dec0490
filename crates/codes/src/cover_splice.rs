//! Hand checks of a bolted cover-plate splice of beams or columns of I sections.
//!
//! The flanges and the web take their elastic shares of axial force and moment, the web all of the
//! shear force. The covers and bolts of each part carry its share (EN 1993-1-8:2005 6.2.7.1(16)).
//! Both members are checked where they differ. No check counts a limit analysis in its place.

mod assumptions;
mod bearing_checks;
mod bolt_checks;
mod cover_buckling;
mod detailing;
mod distances;
mod flange_checks;
mod flange_plate;
mod flange_share;
mod least_forces;
mod load_cases;
mod member_checks;
mod ply;
mod side;
mod slip_checks;
mod web_checks;
mod web_group;
mod web_share;

use crate::end_plate::{HandChecks, not_checked, of_any_joint, unseen_loads};
use bracket_joint::assembly::CoverSplice;

/// All hand checks of a cover-plate splice.
pub fn splice_checks(e: &CoverSplice) -> HandChecks {
    let mut out = HandChecks { checks: detailing::detailing(e), ..HandChecks::default() };
    out.checks.extend(bolt_checks::resistances(e));
    out.checks.extend(slip_checks::assembly(e));
    out.checks.extend(assumptions::outside_range(e));
    out.checks.extend(assumptions::assumptions(e));
    out.checks.extend(of_any_joint(e.annex.as_deref(), e.fy_source, &e.grade, &[]));
    out.checks.extend(unseen_loads(&e.unseen));
    out.checks.extend(not_checked(&e.not_checked));
    let service = e.actions.iter().filter(|a| !a.state.is_ultimate());
    out.serviceability.extend(service.map(|a| a.case.clone()));
    out.checks.extend(load_cases::checks(e));
    out.checks.sort_by_key(|c| c.topic);
    out
}

#[cfg(test)]
mod tests;
