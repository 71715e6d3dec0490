//! Actions that the checks of a base have no method for.

use super::case_end::at;
use crate::check::{Check, CheckId, Topic, Unit};
use crate::subject::Part;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::PlaneActions;

/// An action: name, value, unit and the check that stays open.
pub(super) type Action = (&'static str, f64, Unit, CheckId);

/// The open check of an action that a limit analysis decides; `known`: what the checks know. None
/// where the action is zero.
pub(super) fn for_analysis(a: &PlaneActions, action: Action, known: &'static str) -> Option<Check> {
    open(a, action, known, "a limit analysis of the base").map(Check::without_method)
}

/// The open check of a torsion. In the model the edges of the plate carry it: how concrete and
/// grout resist it is not in it.
pub(super) fn torsion(a: &PlaneActions, known: &'static str) -> Option<Check> {
    let value = a.at(1.0)[1][0];
    let action = ("T", value, Unit::Moment, CheckId::TorsionOfJoint);
    open(a, action, known, "a check of the torsion by hand")
}

fn open(
    a: &PlaneActions,
    (name, value, unit, id): Action,
    known: &'static str,
    step: &'static str,
) -> Option<Check> {
    let why: Text = say!("{} = {}: these checks know {} alone", name, unit.show(value), known);
    let (subject, clause) = (at(a).and(Part::Joint), "EN 1993-1-8:2005 6.2.8");
    let check = Check::undecided(Topic::ComponentMethod, subject, clause, id, why, step);
    (value != 0.0).then_some(check)
}
