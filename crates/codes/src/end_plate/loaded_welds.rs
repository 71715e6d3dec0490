//! Fillet welds of the beam under the actions of a load case: those of the flanges take moment and
//! axial force, those of the web the shear force and what the flanges cannot take.

use super::weld_lengths;
use super::welded_steel;
use crate::check::{Check, Status, Topic, Unit, number as n, within};
use crate::eurocode::welds::{
    LineForce, WeldedSteel, either_method, full_strength_throat, transverse,
};
use crate::eurocode::yielding::plastic;
use crate::worked::Worked;
use bracket_joint::assembly::{EndPlate, PlaneActions};

/// Part of the compression that the welds take beside a prepared contact, EN 1993-1-8:2005 6.2.7.1
/// for splices in full contact.
const BESIDE_CONTACT: f64 = 0.25;

/// Title of a weld that is as strong as the part it joins.
pub(super) const FULL_STRENGTH: &str = "fillet weld of full strength";

/// Forces that the moment and the axial force put into the flanges of the beam.
struct FlangeForces {
    /// Of the weld of the flange that governs \[N\].
    weld: f64,
    /// Its derivation.
    formula: String,
    /// Axial force beyond the strength of the flanges, which goes through the web \[N\], ≥ 0.
    axial: f64,
    /// Moment beyond it \[N mm\], ≥ 0.
    moment: f64,
}

/// Resistance of a flange as a plate, `b t_f f_y/γ_M0` \[N\].
pub(super) fn flange_strength(e: &EndPlate) -> f64 {
    plastic(e.beam.b * e.beam.tf, e.beam_steel.fy, e.factors.gamma_m0)
}

/// Shares of the flanges: half of the axial force, and the moment on their lever arm, no more than
/// a flange can bring. What is beyond it goes through the web.
fn flange_forces(e: &EndPlate, axial: f64, my: f64) -> FlangeForces {
    let (lever, most) = (e.beam.h - e.beam.tf, flange_strength(e));
    let (bending, half) = (my.abs() / lever, 0.5 * axial);
    let (tension, compression) = (bending + half, bending - half);
    let (uncapped, words) = if axial >= 0.0 {
        (tension, "|My|/(h − t_f) + N/2")
    } else if !e.welds.bearing_in_contact {
        (compression, "|My|/(h − t_f) + |N|/2")
    } else {
        // the weld of the flange in tension, without the relief of the compression
        let words = "max(|My|/(h − t_f), (|My|/(h − t_f) + |N|/2)/4)";
        (bending.max(BESIDE_CONTACT * compression), words)
    };
    let over = |force: f64| force.signum() * (force.abs() - most).max(0.0);
    let by_contact = e.welds.bearing_in_contact && axial < 0.0;
    // compression of a flange goes through the contact
    let t = if by_contact { over(tension).max(0.0) } else { over(tension) };
    let c = if by_contact { over(compression).min(0.0) } else { over(compression) };
    let weld = uncapped.min(most);
    let mut formula = format!(
        "F_Ed = min({words}, b t_f f_y/γ_M0) = min({}, {}) = {}",
        Unit::Force.show(uncapped),
        Unit::Force.show(most),
        Unit::Force.show(weld)
    );
    if !within(uncapped, most) {
        formula +=
            &format!("; the rest, {}, goes through the web", Unit::Force.show(uncapped - most));
    }
    FlangeForces { weld, formula, axial: (t - c).abs(), moment: 0.5 * lever * (t + c).abs() }
}

/// The fillet welds of flanges and web under a load case.
pub(super) fn under_load(e: &EndPlate, a: &PlaneActions) -> Vec<Check> {
    let mut out = Vec::new();
    let Some(steel) = welded_steel::of_the_beam(e) else { return out };
    let [[axial, vy, vz], [_, my, _]] = a.at(1.0);
    let forces = flange_forces(e, axial, my);
    if e.flange_throat > 0.0 {
        let subject = format!("{}, beam flange", a.end);
        out.push(flange(e, &forces, vy, &steel, subject.clone()));
    }
    if e.web_throat > 0.0 {
        let subject = format!("{}, beam web", a.end);
        out.extend(web(e, &forces, vz, &steel, &subject));
    }
    out
}

/// The weld of a flange, across it under moment and axial force, along it under half of Vy; welds
/// of full strength carry all that the flange can bring.
fn flange(
    e: &EndPlate,
    forces: &FlangeForces,
    vy: f64,
    steel: &WeldedSteel,
    subject: String,
) -> Check {
    let (a, length) = (e.flange_throat, weld_lengths::flange(e));
    // a weld without any effective length carries nothing
    let line = |force: f64| if length.value > 0.0 { force / length.value } else { f64::INFINITY };
    let along = if vy == 0.0 { 0.0 } else { line(0.5 * vy.abs()) };
    let force = LineForce { across: line(forces.weld), along };
    let demand = force.resultant();
    let mut worked = either_method(force, a, steel);
    let full = full_strength_throat(e.beam.tf, e.beam_steel.fy, e.factors.gamma_m0, steel);
    if demand.is_finite() && !within(demand, worked.value) && within(full.value, a) {
        worked.title = FULL_STRENGTH;
        worked.clause = "EN 1993-1-8:2005 6.2.3(4)";
        worked.value = flange_strength(e) / length.value;
        worked.formula += &format!("; a = {} mm ≥ {}: F_Rd = b t_f f_y/γ_M0", n(a), full.formula);
    }
    let together = match vy == 0.0 {
        true => "F_w,Ed = F_Ed/l_eff".into(),
        false => format!("F_w,Ed = √(F_Ed² + (Vy/2)²)/l_eff, Vy = {}", Unit::Force.show(vy.abs())),
    };
    worked.formula = format!(
        "{}; {}; {together} = {}; {}",
        forces.formula,
        length.formula,
        Unit::ForcePerLength.show(demand),
        worked.formula
    );
    worked.with("l_eff", length.value, Unit::Length).against(
        Topic::Welds,
        subject,
        demand,
        Status::Failed,
    )
}

/// The two welds of the web: Vz along them, and across them what the flanges cannot take,
/// elastically over their length. Vy goes through the flanges. The web itself can bring no more
/// than it yields with.
fn web(
    e: &EndPlate,
    forces: &FlangeForces,
    vz: f64,
    steel: &WeldedSteel,
    subject: &str,
) -> Option<Check> {
    let length = weld_lengths::web(e);
    if length.value <= 0.0 {
        // the check of the least length fails
        return None;
    }
    let l = length.value;
    let rest = forces.axial / l + 6.0 * forces.moment / (l * l);
    let whole = LineForce { across: 0.5 * rest, along: 0.5 * vz.abs() / l };
    let most = plastic(0.5 * e.beam.tw, e.beam_steel.fy, e.factors.gamma_m0);
    let (capped, part) = web_yields(whole, most);
    let demand = capped.resultant();
    let mut worked = either_method(capped, e.web_throat, steel);
    let mut terms = String::new();
    if rest > 0.0 {
        terms += &format!(
            "; F_⊥ = (N_w/l_eff + 6 M_w/l_eff²)/2 = ({}/{} + 6 · {}/{}²)/2",
            Unit::Force.show(forces.axial),
            n(l),
            Unit::Moment.show(forces.moment),
            n(l)
        );
    }
    if part < 1.0 {
        terms += &format!(
            "; the web yields at √(F_⊥² + 3 F_∥²) = t_w f_y/(2 γ_M0) = {}",
            Unit::ForcePerLength.show(most)
        );
    }
    worked.formula = format!(
        "F_w,Ed = V/(2 l_eff) = {}/(2 · {}){terms}; {}; {}",
        Unit::Force.show(vz.abs()),
        Unit::Length.show(l),
        length.formula,
        worked.formula
    );
    Some(worked.with("l_eff", l, Unit::Length).against(
        Topic::Welds,
        subject,
        demand,
        Status::Failed,
    ))
}

/// A force per length of one of two welds of a plate, reduced to what the plate yields with, and
/// the part of the force that this is, at most 1. `most` is half of the strength of the plate per
/// length in tension \[N/mm\].
pub(super) fn web_yields(force: LineForce, most: f64) -> (LineForce, f64) {
    let equivalent = (force.across.powi(2) + 3.0 * force.along.powi(2)).sqrt();
    let part = if within(equivalent, most) { 1.0 } else { most / equivalent };
    (LineForce { across: part * force.across, along: part * force.along }, part)
}

/// Resistance of the welds of a flange, with their length.
pub(super) fn flange_resistance(e: &EndPlate, clause: &'static str) -> Option<Worked> {
    let (a, most) = (e.flange_throat, flange_strength(e));
    let steel = welded_steel::of_the_beam(e)?;
    let full = full_strength_throat(e.beam.tf, e.beam_steel.fy, e.factors.gamma_m0, &steel);
    let length = weld_lengths::flange(e);
    let each = transverse(a, &steel);
    let along = each.value * length.value.max(0.0);
    let (value, formula) = if within(full.value, a) && most > along {
        (
            most,
            format!("a = {} mm ≥ {} of full strength; F_Rd = b t_f f_y/γ_M0", n(a), full.formula),
        )
    } else {
        let numbers = format!("{} · {}", n(each.value), n(length.value));
        (along, format!("{}; {}; F_Rd = F_w,Rd l_eff = {numbers}", length.formula, each.formula))
    };
    Some(Worked::new(clause, "", value, Unit::Force, formula))
}
