//! Rules for the dimensions of a haunch and for the welds of inclined flanges.

use super::at_plate;
use crate::check::{Binding, Check, CheckId, Status, Topic, Unit, within};
use crate::formula::{Derivation, Line, Relation, Traced};
use crate::subject::Part;
use bracket_joint::assembly::{EndPlate, Haunch};

/// Clause of the rules for a haunch.
const RULES: &str = "EN 1993-1-8:2005 6.2.6.7(2)";
/// Greatest angle of the haunch flange with that of the beam \[deg\].
const STEEPEST: f64 = 45.0;
/// Greatest angle of a flange with the normal of the plate whose fillet welds stand at 60° to 120°
/// \[deg\].
const INCLINED: f64 = 30.0;

/// All rules that no load changes.
pub(super) fn rules(e: &EndPlate) -> Vec<Check> {
    let mut out = fillets(e);
    if let Some(h) = at_plate::haunch(e) {
        out.extend(dimensions(e, h));
        out.push(steel(e, h));
        out.extend(assumed());
    }
    out
}

/// What the checks assume of every haunch.
fn assumed() -> [Check; 2] {
    let tip = "a butt weld as strong as the flange joins it to the flange of the beam; it is not \
               checked";
    let held = "between plate and tip, and at the tip, so that they do not buckle sideways; \
                lateral torsional buckling of the beam is not checked here";
    let of = |topic, part, clause, id, why: &'static str| {
        Check::assumption(topic, part, clause, id, why)
    };
    [
        of(Topic::Welds, Part::HaunchFlange, "EN 1993-1-8:2005 4.7.1", CheckId::HaunchTipWeld, tip),
        of(Topic::Stability, Part::Haunch, "EN 1993-1-1:2005 6.3.2", CheckId::HaunchHeld, held),
    ]
}

/// Thickness, width and angle of the haunch beside those of the beam.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.7(2).
fn dimensions(e: &EndPlate, h: &Haunch) -> [Check; 4] {
    let least = |part, id, (symbol, of_beam): (&'static str, f64), provided: f64, own| {
        let rule = Traced::length(symbol, of_beam);
        Check::at_least((Topic::Member, part), (RULES, id), own, rule, provided, Status::Failed)
    };
    let flange = Part::HaunchFlange;
    [
        least(flange, CheckId::HaunchFlangeThickness, ("t_fb", e.beam.tf), h.flange, "t_f"),
        least(flange, CheckId::HaunchFlangeWidth, ("b_fb", e.beam.b), h.width, "b_f"),
        least(Part::HaunchWeb, CheckId::HaunchWebThickness, ("t_wb", e.beam.tw), h.web, "t_w"),
        Check::at_most(
            (Topic::Member, flange),
            (RULES, CheckId::HaunchAngle),
            "θ in degrees",
            STEEPEST,
            h.angle.abs().to_degrees(),
            Status::Failed,
        )
        .of_numbers(),
    ]
}

/// The steel grade of the haunch, by its yield strength beside that of the beam.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.7(2): the grade of the haunch matches that of the beam.
fn steel(e: &EndPlate, h: &Haunch) -> Check {
    let (of_haunch, of_beam) = (h.steel.fy.mpa(), e.beam_steel.fy.mpa());
    let holds = within(of_beam, of_haunch) || h.steel.grade == e.beam_steel.grade;
    let relation = if within(of_beam, of_haunch) { Relation::AtLeast } else { Relation::Below };
    let rule = Traced::stress("f_yb", of_beam);
    let line = Line::comparison("f_y", of_haunch, relation, rule, Unit::Stress);
    let derivation = match holds && !within(of_beam, of_haunch) {
        true => Derivation::from(line).then("the same grade, thicker"),
        false => line.into(),
    };
    let check =
        Check::assumption(Topic::Member, Part::Haunch, RULES, CheckId::HaunchSteel, derivation);
    let status = if holds { Status::Ok } else { Status::Failed };
    Check { status, binding: Binding::Beside, ..check }
}

/// Fillet welds of flanges that stand too askew on the plate.
///
/// # Source
/// EN 1993-1-8:2005 4.3.2.1(1) to (3): fusion faces at 60° to 120°.
fn fillets(e: &EndPlate) -> Vec<Check> {
    let askew = |slope: f64| !within(slope.abs().to_degrees(), INCLINED);
    let flanges = at_plate::flanges(e);
    let askew = flanges.iter().filter(|f| e.flange_throat > 0.0 && askew(f.slope));
    let check = |f: &at_plate::PlateFlange<'_>| {
        let (clause, id) = ("EN 1993-1-8:2005 4.3.2.1", CheckId::InclinedFillet);
        let beyond = Line::comparison(
            "θ in degrees",
            f.slope.abs().to_degrees(),
            Relation::Above,
            Traced::from(INCLINED),
            Unit::Number,
        );
        let why = Derivation::from(beyond)
            .then("the faces of these fillet welds do not stand at 60° to 120°");
        let step = "butt welds of the flanges (`flange_weld: 0`), or a longer haunch: slope and \
         angle \
                    of the haunch together at most 30°";
        Check::undecided(Topic::Welds, f.part, clause, id, why, step)
    };
    askew.map(check).collect()
}
