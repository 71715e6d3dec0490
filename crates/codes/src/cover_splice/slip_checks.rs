//! Slip of the preloaded bolts of flanges and webs, and the kind of their holes.

use super::bolt_checks::{of_bolt, resultant};
use super::flange_share::FlangeForces;
use super::ply::hole_kind;
use super::side::{Side, flange_part};
use super::web_share::WebForces;
use crate::check::{Check, largest};
use crate::end_plate::{Preloaded, kind_of_holes};
use crate::subject::{Part, Subject};
use bracket_joint::assembly::{CoverSplice, PlaneActions, Way};

/// Friction surfaces of a bolt of a web: there is a cover on either side.
const WEB_SURFACES: u32 = 2;

fn preloaded(e: &CoverSplice) -> Preloaded<'_> {
    Preloaded {
        bolt: &e.bolt,
        grade: &e.grade,
        hole: e.hole,
        preload: e.preload,
        category: e.category,
        mu: e.mu,
        factors: &e.factors,
    }
}

/// Kind of the holes, preloaded assemblies, and the load cases that a category requires.
pub(super) fn assembly(e: &CoverSplice) -> Vec<Check> {
    let holes = kind_of_holes(&e.bolt, e.hole, hole_kind(e), None);
    let mut out: Vec<Check> = holes.into_iter().collect();
    out.extend(preloaded(e).assembly(e.actions.iter().map(|a| a.state)));
    out
}

/// Slip of the bolts of a flange; `None` where it is not checked.
pub(super) fn flange(
    e: &CoverSplice,
    side: &Side<'_>,
    a: &PlaneActions,
    (flange, forces): (Way, &FlangeForces),
    subject: &Subject,
) -> Option<Check> {
    let force = largest(forces.of_bolts(), |f| f.value)?;
    let subject = side.of(subject.clone(), flange_part(flange)).and(Part::FlangeBolts);
    preloaded(e).slip(a.state, subject, (e.flange_planes(), 0.0), of_bolt(e, force))
}

/// Slip of the bolts of a web; `None` where it is not checked.
pub(super) fn web(
    e: &CoverSplice,
    side: &Side<'_>,
    a: &PlaneActions,
    forces: &[WebForces],
    subject: &Subject,
) -> Option<Check> {
    let subject = side.of(subject.clone(), Part::WebBolts);
    preloaded(e).slip(a.state, subject, (WEB_SURFACES, 0.0), resultant(forces)?)
}
