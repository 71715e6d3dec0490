//! The beam's own cross-section under the actions at the joint.

use super::{EndPlate, Status, Topic, Worked};
use crate::assembly::PlaneActions;
use crate::checks::check::Check;
use crate::checks::eurocode::section::Beam;

/// Shear, axial force and moment of the beam at the bolt plane. They bind: a beam that cannot bring
/// these forces needs another joint.
///
/// # Source
/// EN 1993-1-1:2005 6.2.
pub(super) fn beam(e: &EndPlate, a: &PlaneActions) -> Vec<Check> {
    let [[axial, vy, vz], [_, my, _]] = a.at(1.0);
    let beam =
        Beam { section: (&e.beam).into(), fy: e.beam_steel.fy, gamma_m0: e.factors.gamma_m0 };
    let subject = format!("{}, beam", a.end);
    let against = |worked: Worked, demand: f64| {
        worked.against(Topic::Member, subject.clone(), demand.abs(), Status::Failed)
    };
    let mut out = Vec::new();
    if vz != 0.0 {
        out.push(against(beam.shear(), vz));
        let (slenderness, limit) = beam.stocky_web();
        if slenderness > limit {
            let worked = beam.shear_buckling(e.factors.gamma_m1);
            out.push(worked.against(Topic::Stability, subject.clone(), vz.abs(), Status::Failed));
        }
    }
    if vy != 0.0 {
        out.push(against(beam.shear_across(), vy));
    }
    if axial != 0.0 {
        out.push(against(beam.axial(), axial));
    }
    // a push alone may be too much for a slender web
    if my != 0.0 || axial < 0.0 {
        match beam.moment(vz, axial) {
            Ok(worked) => out.push(against(worked, my)),
            // of class 4
            Err(fault) => {
                let (clause, title) =
                    ("EN 1993-1-1:2005 5.5.2", "moment of the beam with its shear and axial force");
                out.push(Check::undecided(
                    Topic::Member,
                    subject,
                    clause,
                    title,
                    fault.to_string(),
                ));
            }
        }
    }
    out
}
