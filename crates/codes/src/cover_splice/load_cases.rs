//! Checks of every load case with actions at the splice axis.

use super::bearing_checks;
use super::bolt_checks;
use super::flange_checks;
use super::flange_share::flange_forces;
use super::least_forces::{self, demands};
use super::member_checks;
use super::side::{FLANGES, Side, sides};
use super::slip_checks;
use super::web_checks;
use super::web_group::WebGroup;
use super::web_share::web_forces;
use crate::check::{Check, CheckId, Topic, Unit};
use crate::subject::{Part, Subject};
use bracket_base::say;
use bracket_joint::assembly::{CoverSplice, PlaneActions};

/// The checks of every load case and member end.
pub(super) fn checks(e: &CoverSplice) -> Vec<Check> {
    let mut out = Vec::new();
    for a in &e.actions {
        let mut found = Vec::new();
        match WebGroup::new(e) {
            Some(group) if e.flange_bolts() > 0 => {
                for side in sides(e) {
                    found.extend(of_side(e, a, &side, &group));
                }
            }
            _ => found.push(no_bolts(a)),
        }
        if a.state.is_ultimate() {
            found.extend(least_forces::checks(e, a));
            found.extend(no_formula(a));
        }
        out.extend(found.into_iter().map(|c| c.of_case(&a.case)));
    }
    out
}

/// The checks of one member with its bolts and the covers.
fn of_side(e: &CoverSplice, a: &PlaneActions, side: &Side<'_>, group: &WebGroup) -> Vec<Check> {
    let demands = demands(e, a, side);
    let subject = &Subject::end(&a.end);
    let ultimate = a.state.is_ultimate();
    let mut out = Vec::new();
    for flange in FLANGES {
        let forces = flange_forces(e, side, flange, &demands);
        let of = (flange, &forces);
        out.extend(slip_checks::flange(e, side, a, of, subject));
        if ultimate {
            out.extend(bolt_checks::flange(e, side, of, subject));
            out.extend(bearing_checks::flange(e, side, of, subject));
            out.extend(flange_checks::checks(e, side, of, subject));
        }
    }
    let forces = web_forces(e, side, group, &demands);
    let forces: Vec<_> = forces
        .into_iter()
        .filter(|f| [&f.axial, &f.shear, &f.moment].iter().any(|x| x.value != 0.0))
        .collect();
    out.extend(slip_checks::web(e, side, a, &forces, subject));
    if ultimate {
        out.extend(bolt_checks::web(e, side, &forces, subject));
        out.extend(bearing_checks::web(e, side, &forces, subject));
        out.extend(web_checks::checks(e, side, &forces, subject));
        out.extend(member_checks::checks(e, side, &demands, subject));
    }
    out
}

/// A flange without bolts, or a web with fewer than two, transfers no share of the actions.
fn no_bolts(a: &PlaneActions) -> Check {
    let (clause, id) = ("EN 1993-1-8:2005 6.2.7.1(16)", CheckId::SpliceShares);
    let why = "each flange needs bolts, and the web two at least: these checks give each part its \
               elastic share";
    let step = "a splice with bolts in both flanges and in the web";
    Check::undecided(Topic::Bolts, Subject::end(&a.end), clause, id, why, step)
}

/// Actions across the web and torsion: these checks have no shares for them.
fn no_formula(a: &PlaneActions) -> Vec<Check> {
    let [[_, vy, _], [torsion, _, mz]] = a.at(1.0);
    let acting = [
        ("Vy", vy, Unit::Force, CheckId::ShearAcross),
        ("Mz", mz, Unit::Moment, CheckId::WeakAxisOfJoint),
        ("T", torsion, Unit::Moment, CheckId::TorsionOfJoint),
    ];
    let check = |(name, value, unit, id): (&'static str, f64, Unit, CheckId)| {
        let why = say!(
            "{} = {}: these checks share axial force, shear force along the web and moment about \
             the strong axis alone",
            name,
            unit.show(value)
        );
        let (clause, step) =
            ("EN 1993-1-8:2005 6.2.7.1", "a check of flanges and covers across the web");
        let subject = Subject::end(&a.end).and(Part::Joint);
        Check::undecided(Topic::Bolts, subject, clause, id, why, step).without_method()
    };
    acting.into_iter().filter(|(_, value, ..)| *value != 0.0).map(check).collect()
}
