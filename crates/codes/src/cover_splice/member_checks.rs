//! The spliced members' own cross-sections under the actions at the splice axis.

use super::least_forces::Demand;
use super::side::Side;
use crate::check::{Check, CheckId, Status, Topic, largest, within};
use crate::subject::{Part, Subject};
use crate::worked::Worked;
use bracket_joint::assembly::{CoverSplice, SpliceUse};

/// Ids of shear, axial force and moment for a kind of member, and the member.
fn ids(e: &CoverSplice) -> ([CheckId; 3], Part) {
    match e.used {
        SpliceUse::Beam => {
            ([CheckId::BeamShear, CheckId::BeamAxial, CheckId::BeamMoment], Part::Beam)
        }
        SpliceUse::Column { .. } => {
            ([CheckId::ColumnShear, CheckId::ColumnAxial, CheckId::ColumnMoment], Part::Column)
        }
    }
}

/// Shear, axial force and moment of a member. They bind: a member that cannot carry these forces
/// cannot load the splice with them.
///
/// # Source
/// EN 1993-1-1:2005 6.2.
pub(super) fn checks(
    e: &CoverSplice,
    side: &Side<'_>,
    demands: &[Demand],
    subject: &Subject,
) -> Vec<Check> {
    let section = side.cross_section(e.factors.gamma_m0);
    let ([shear, axial, moment], all) = ids(e);
    let subject = side.member(subject.clone(), all);
    let against = |mut worked: Worked, id: CheckId, demand: f64| {
        worked.id = id;
        worked.against(Topic::Member, subject.clone(), demand.abs(), Status::Failed)
    };
    let Some(d) = largest(demands, |d| d.moment.abs()) else { return Vec::new() };
    let mut out = Vec::new();
    if d.shear > 0.0 {
        out.push(against(section.shear(), shear, d.shear));
        let (slenderness, limit) = section.web_slenderness();
        if !within(slenderness, limit) {
            let worked = section.shear_buckling(e.factors.gamma_m1);
            out.push(worked.against(Topic::Stability, subject.clone(), d.shear, Status::Failed));
        }
    }
    if d.axial != 0.0 {
        out.push(against(section.axial(), axial, d.axial));
    }
    if d.moment != 0.0 || d.axial < 0.0 {
        out.push(match section.bending_6_2_10(d.shear, d.axial) {
            Ok(worked) => against(worked, moment, d.moment),
            // class 4
            Err(fault) => Check::undecided(
                Topic::Member,
                subject,
                "EN 1993-1-1:2005 5.5.2",
                moment,
                fault.text(),
                fault.step(),
            ),
        });
    }
    out
}
