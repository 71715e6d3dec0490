//! Shear of the bolts of flanges and webs.

use super::distances::span;
use super::flange_share::FlangeForces;
use super::side::{FLANGES, Side, flange_part, sides};
use super::web_share::WebForces;
use crate::check::{Check, CheckId, Status, Topic, Unit, largest};
use crate::eurocode::bolts::{ShearJoint, shear_in_joint};
use crate::formula::{Derivation, Formula, Traced};
use crate::subject::{Part, Place, Subject};
use crate::worked::Worked;
use bracket_joint::assembly::{CoverSplice, Way};

/// Planes in which a bolt of a web is sheared: there is a cover on either side.
const WEB_PLANES: u32 = 2;

/// The bolts, as a check names them.
pub(super) fn bolt(e: &CoverSplice) -> Place {
    Place::Bolt { size: e.bolt.size.clone(), grade: e.grade.grade.clone() }
}

/// Resistance of a bolt to shear in all its planes \[N\].
fn resistance(e: &CoverSplice, planes: u32, length: f64, pack: f64) -> Worked {
    let joint = ShearJoint { hole: e.hole, length, pack };
    let one = shear_in_joint(&e.bolt, &e.grade, joint, e.factors.gamma_m2);
    if planes == 1 {
        return one;
    }
    let both = Traced::from(f64::from(planes)) * one.traced();
    one.becomes("2 F_v,Rd", both)
}

/// Resistance of a bolt of a flange \[N\].
fn of_flange(e: &CoverSplice, side: &Side<'_>, flange: Way) -> Worked {
    resistance(e, e.flange_planes(), span(&e.flange_rows), side.pack(flange))
}

/// Resistance of a bolt of the web \[N\]. The end bolts lie at most the diagonal of the group
/// apart in the direction of a force.
fn of_web(e: &CoverSplice, side: &Side<'_>) -> Worked {
    let length = span(&e.web_rows).hypot(span(&e.web_columns));
    resistance(e, WEB_PLANES, length, side.member.web_packs)
}

/// Resistances of a bolt to shear, as information.
pub(super) fn resistances(e: &CoverSplice) -> Vec<Check> {
    let mut out = Vec::new();
    for side in sides(e) {
        let at = |part| side.of(bolt(e).into(), part).and(Place::Thread);
        let mut of_flanges: Vec<Worked> =
            FLANGES.into_iter().map(|flange| of_flange(e, &side, flange)).collect();
        of_flanges.dedup_by(|a, b| a == b);
        let weaker = largest(of_flanges, |w| -w.value);
        let known = [weaker, Some(of_web(e, &side))]
            .into_iter()
            .zip([at(Part::FlangeBolts), at(Part::WebBolts)]);
        out.extend(known.filter_map(|(w, at)| Some(w?.information(Topic::Bolts, at))));
    }
    out
}

/// The force of one bolt of a flange, `F_f/n_b`.
pub(super) fn of_bolt(e: &CoverSplice, force: &Formula) -> Derivation {
    let count = Traced::number("n_b", e.flange_bolts() as f64);
    let each = Formula::new("F_v,Ed", force.traced() / count, Unit::Force);
    Derivation::from(force.clone()).then(each)
}

/// The demand that the last formula of a derivation gives \[N\].
pub(super) fn demand(of: &Derivation) -> f64 {
    of.formulas().last().map_or(0.0, |f| f.value)
}

/// A bolt against its resistance to shear.
fn sheared(worked: Worked, force: Derivation, subject: Subject) -> Check {
    let demand = demand(&force);
    let mut worked = worked.after(force);
    worked.id = CheckId::SpliceBoltShear;
    worked.against(Topic::Bolts, subject, demand, Status::Failed)
}

/// Shear of the bolts of a flange; `None` where no force acts.
pub(super) fn flange(
    e: &CoverSplice,
    side: &Side<'_>,
    (flange, forces): (Way, &FlangeForces),
    subject: &Subject,
) -> Option<Check> {
    let force = largest(forces.of_bolts(), |f| f.value)?;
    let subject = side.of(subject.clone(), flange_part(flange)).and(Part::FlangeBolts);
    Some(sheared(of_flange(e, side, flange), of_bolt(e, force), subject))
}

/// The largest force of a bolt of a web, with its components.
pub(super) fn resultant(forces: &[WebForces]) -> Option<Derivation> {
    let worst = largest(forces, |f| f.bolts.resultant[2].value)?;
    Some(worst.bolts.resultant.iter().cloned().fold(worst.derivation(), Derivation::then))
}

/// Shear of the bolts of a web.
pub(super) fn web(
    e: &CoverSplice,
    side: &Side<'_>,
    forces: &[WebForces],
    subject: &Subject,
) -> Option<Check> {
    let force = resultant(forces)?;
    let subject = side.of(subject.clone(), Part::WebBolts);
    Some(sheared(of_web(e, side), force, subject))
}
