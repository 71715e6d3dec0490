//! Bearing of flanges, webs and covers on the bolts.

use super::bolt_checks::{demand, of_bolt};
use super::flange_share::FlangeForces;
use super::ply::{Ply, of_flange, of_web};
use super::side::{Side, flange_part};
use super::web_share::WebForces;
use crate::check::{Check, CheckId, Status, Topic, Unit, largest};
use crate::eurocode::holes::Clearance;
use crate::formula::{Derivation, Formula, Traced};
use crate::subject::{Part, Subject};
use crate::worked::Worked;
use bracket_joint::assembly::{CoverSplice, Way};

/// Whether the code has a bearing resistance for the holes.
fn known(e: &CoverSplice) -> bool {
    Clearance::of(&e.bolt, e.hole) != Clearance::Beyond
}

/// A plate against the share of the force of a bolt that it takes.
fn borne(ply: &Ply<'_>, worked: Worked, force: Derivation, subject: Subject) -> Check {
    let mut force = force;
    let whole = demand(&force);
    if ply.share < 1.0 {
        let part = Traced::force("F_v,Ed", whole) / Traced::number("n_s", 1.0 / ply.share);
        force = force.then(Formula::new("F_b,Ed", part, Unit::Force));
    }
    worked.after(force).against(Topic::Bolts, subject, ply.share * whole, Status::Failed)
}

/// Bearing of the plates of a flange splice, the worse of tension and compression.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4, 3.7(1): the least resistance counts for every bolt.
pub(super) fn flange(
    e: &CoverSplice,
    side: &Side<'_>,
    (flange, forces): (Way, &FlangeForces),
    subject: &Subject,
) -> Vec<Check> {
    if !known(e) {
        return Vec::new();
    }
    let subject = side.of(subject.clone(), flange_part(flange));
    let single = e.inner.is_none() && e.flange_rows.len() == 1;
    let under = |force: &Option<Formula>, tension: bool| -> Vec<Check> {
        let Some(force) = force else { return Vec::new() };
        let check = |ply: Ply<'_>| {
            let worked = match single {
                true => ply.single_lap(e, tension),
                false => ply.bearing(e, tension),
            };
            let subject = match ply.part {
                Part::OuterCover | Part::InnerCovers => subject.clone().and(ply.part),
                _ => subject.clone(),
            };
            borne(&ply, worked, of_bolt(e, force), subject)
        };
        of_flange(e, side, flange, tension).into_iter().map(check).collect()
    };
    worse(under(&forces.tension, true), under(&forces.transferred, false))
}

/// Of two lists of checks of the same plates the worse check of each.
fn worse(a: Vec<Check>, b: Vec<Check>) -> Vec<Check> {
    if a.is_empty() || b.is_empty() {
        return if a.is_empty() { b } else { a };
    }
    let used = |c: &Check| c.utilisation.unwrap_or(f64::INFINITY);
    a.into_iter().zip(b).filter_map(|(a, b)| largest([a, b], used)).collect()
}

/// Bearing of the web and its covers, along the member and across it.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4: the components of a force that is not parallel to the edge are
/// checked separately.
pub(super) fn web(
    e: &CoverSplice,
    side: &Side<'_>,
    forces: &[WebForces],
    subject: &Subject,
) -> Vec<Check> {
    if !known(e) {
        return Vec::new();
    }
    let along = largest(forces, |f| f.bolts.along.value).map(|f| (f, &f.bolts.along));
    let across = largest(forces, |f| f.bolts.across.value).map(|f| (f, &f.bolts.across));
    let directions = [(along, CheckId::BearingResistance), (across, CheckId::BearingAcross)];
    let mut out = Vec::new();
    for (plies, (force, id)) in of_web(e, side).into_iter().zip(directions) {
        let Some((forces, force)) = force.filter(|(_, force)| force.value > 0.0) else { continue };
        for ply in plies {
            let mut worked = ply.bearing(e, true);
            worked.id = id;
            let subject = side.of(subject.clone(), ply.part);
            let force = forces.derivation().then(force.clone());
            out.push(borne(&ply, worked, force, subject));
        }
    }
    out
}
