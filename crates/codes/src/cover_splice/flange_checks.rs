//! The flanges and their covers: tension beside holes, compression between bolts, block tearing.

use super::cover_buckling::{Buckling, buckling, free_length};
use super::flange_plate::{FlangePlate, plates};
use super::flange_share::FlangeForces;
use super::side::{Side, flange_part};
use crate::check::{Check, CheckId, Status, Topic, Unit, largest};
use crate::eurocode::holes::Clearance;
use crate::formula::{Derivation, Formula, Number, Traced};
use crate::subject::Subject;
use crate::worked::Worked;
use bracket_joint::assembly::{CoverSplice, Way};
use bracket_joint::spec::connection::BoltCategory;

/// Whether holes count in compression: those that bolts do not fill.
///
/// # Source
/// EN 1993-1-1:2005 6.2.4(3).
fn unfilled(e: &CoverSplice) -> bool {
    !matches!(Clearance::of(&e.bolt, e.hole), Clearance::Normal)
}

/// The force of a plate: its share of that of the flange.
fn carried(plate: &FlangePlate<'_>, force: &Formula) -> Derivation {
    let whole = Derivation::from(force.clone());
    if plate.share == 1.0 {
        return whole;
    }
    let planes = Traced::number("n_s", 1.0 / plate.share);
    whole.then(Formula::new("F_p,Ed", force.traced() / planes, Unit::Force))
}

/// Checks of a flange and its covers under its forces.
pub(super) fn checks(
    e: &CoverSplice,
    side: &Side<'_>,
    (flange, forces): (Way, &FlangeForces),
    subject: &Subject,
) -> Vec<Check> {
    let mut out = Vec::new();
    let in_flange = side.of(subject.clone(), flange_part(flange));
    for plate in plates(e, side, flange) {
        let subject = match plate.is_cover() {
            true => in_flange.clone().and(plate.part),
            false => in_flange.clone(),
        };
        let against = |worked: Worked, force: &Formula| {
            let demand = plate.share * force.value;
            let worked = worked.after(carried(&plate, force));
            worked.against(Topic::Member, subject.clone(), demand, Status::Failed)
        };
        if let Some(force) = &forces.tension {
            let id = if plate.is_cover() { CheckId::CoverTension } else { CheckId::FlangeTension };
            let no_slip = e.category == Some(BoltCategory::C);
            out.push(against(plate.section(e).tension(id, no_slip), force));
            out.extend(block(e, &plate).map(|worked| against(worked, force)));
        }
        let pressed = if plate.is_cover() { &forces.transferred } else { &forces.compression };
        if let Some(force) = pressed {
            let worked = match plate.is_cover() {
                true => between_bolts(e, &plate),
                false => plate.section(e).compression(CheckId::FlangeCompression, unfilled(e)),
            };
            out.push(against(worked, force));
        }
        if !plate.is_cover() && forces.tension.is_some() {
            let worked = plate.section(e).yields_first(CheckId::FlangeYieldsFirst);
            out.push(worked.utilised(Topic::Ductility, subject.clone(), Status::Warning));
        }
    }
    out
}

/// The weakest of the blocks that the bolts can tear out of a plate.
fn block(e: &CoverSplice, plate: &FlangePlate<'_>) -> Option<Worked> {
    let factors = &e.factors;
    let each = plate.torn().map(|b| b.resistance(factors.gamma_m0, factors.gamma_m2));
    largest(each, |w| -w.value)
}

/// Resistance of a cover to compression, with its buckling between the bolts \[N\].
fn between_bolts(e: &CoverSplice, plate: &FlangePlate<'_>) -> Worked {
    let whole = plate.section(e).compression(CheckId::CoverCompression, unfilled(e));
    let Buckling { before, chi } =
        buckling(free_length(&e.flange_rows), plate.thickness, plate.steel);
    let whole = whole.after(before);
    match chi {
        None => whole,
        Some(chi) => {
            let area = plate.count * plate.width * plate.thickness;
            let strength = Traced::stress("f_y", plate.steel.fy.mpa())
                / Traced::number("γ_M1", e.factors.gamma_m1);
            let buckles = chi.traced() * Traced::area("A", area) * strength;
            let least = buckles.min(whole.traced());
            let mut worked = whole.then(chi).becomes("N_b,Rd", least);
            worked.clause = "EN 1993-1-8:2005 Table 3.3 note 2; EN 1993-1-1:2005 6.3.1";
            worked
        }
    }
}
