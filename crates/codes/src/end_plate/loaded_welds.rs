//! Fillet welds of the beam under the actions of a load case: those of the flanges take moment and
//! axial force, those of the web the shear force and what the flanges cannot take.

use super::at_plate::{self, PlateFlange};
use super::weld_lengths;
use super::welded_steel;
use crate::check::{Check, CheckId, Status, Topic, Unit, within};
use crate::eurocode::welds::{
    LineForce, WeldedSteel, either_method, full_strength_throat_inclined, simplified, transverse,
    transverse_inclined,
};
use crate::formula::{Derivation, Formula, Line, Number, Traced};
use crate::subject::{Part, Subject};
use crate::worked::Worked;
use bracket_base::say;
use bracket_joint::assembly::{EndPlate, PlaneActions};

/// Part of the compression that the welds take beside a prepared contact, EN 1993-1-8:2005 6.2.7.1
/// for splices in full contact.
const BESIDE_CONTACT: f64 = 0.25;

/// Words of a plate that yields before it has brought its weld all forces.
pub(super) const YIELDS: &str = "the web yields at a part η of the forces";

/// Forces that the moment and the axial force put into the flanges of the beam.
struct FlangeForces {
    /// F_Ed of the weld of the flange that governs \[N\].
    weld: f64,
    /// Its derivation.
    derivation: Derivation,
    /// Axial force beyond the strength of the flanges, which goes through the web \[N\], ≥ 0.
    axial: f64,
    /// Moment beyond it \[N mm\], ≥ 0.
    moment: f64,
}

impl FlangeForces {
    /// Measure of what goes through the web \[N\].
    fn beyond(&self) -> f64 {
        self.axial + self.moment
    }
}

/// Resistance of a flange as a plate, `b t_f f_y/γ_M0` \[N\].
pub(super) fn flange_strength(e: &EndPlate, f: &PlateFlange<'_>) -> Traced {
    Traced::length("b", f.width)
        * Traced::length("t_f", f.thickness)
        * Traced::stress("f_y", f.steel.fy.mpa())
        / Traced::number("γ_M0", e.factors.gamma_m0)
}

/// The same normal to the plate, times cos θ of the slope of the flange \[N\].
fn normal_strength(e: &EndPlate, f: &PlateFlange<'_>) -> Traced {
    match f.is_normal() {
        true => flange_strength(e, f),
        false => flange_strength(e, f) * cosine(f),
    }
}

/// cos of the angle of a flange with the normal of the plate.
fn cosine(f: &PlateFlange<'_>) -> Traced {
    Traced::number("cos θ", f.slope.cos())
}

/// Force along a flange whose part normal to the plate is `normal` \[N\].
pub(super) fn along_flange(f: &PlateFlange<'_>, normal: Traced) -> Traced {
    if f.is_normal() { normal } else { normal / cosine(f) }
}

/// Lever arm of the flanges, `h − t_f`, or z_f between the middles of sloped ones along the plate
/// \[mm\].
pub(super) fn flange_lever(e: &EndPlate) -> Traced {
    match at_plate::rafter(e) {
        Some(_) => Traced::length("z_f", at_plate::beam(e).lever()),
        None => Traced::length("h", e.beam.h) - Traced::length("t_f", e.beam.tf),
    }
}

/// Shares of the flanges: half of the axial force, and the moment on their lever arm, no more than
/// a flange can bring. What is beyond it goes through the web.
fn flange_forces(e: &EndPlate, f: &PlateFlange<'_>, axial: f64, my: f64) -> FlangeForces {
    let bending = Traced::symbol("My", my, Unit::Moment).abs() / flange_lever(e);
    let n = Traced::force("N", axial);
    let half = |n: Traced| n / Traced::from(2.0);
    let uncapped = if axial >= 0.0 {
        bending.clone() + half(n)
    } else {
        let compression = bending.clone() + half(n.abs());
        match e.welds.bearing_in_contact {
            false => compression,
            // the weld of the flange in tension, without the relief of the compression
            true => bending.clone().max(Traced::from(BESIDE_CONTACT) * compression),
        }
    };
    let most = normal_strength(e, f).value();
    let over = |force: f64| force.signum() * (force.abs() - most).max(0.0);
    let (bending, half) = (bending.value(), 0.5 * axial);
    let (tension, compression) = (bending + half, bending - half);
    let by_contact = e.welds.bearing_in_contact && axial < 0.0;
    // compression of a flange goes through the contact
    let t = if by_contact { over(tension).max(0.0) } else { over(tension) };
    let c = if by_contact { over(compression).min(0.0) } else { over(compression) };
    let whole = uncapped.value();
    let weld = Formula::new("F_Ed", uncapped.min(normal_strength(e, f)), Unit::Force);
    let force = weld.value;
    let mut derivation = Derivation::from(weld);
    if !within(whole, most) {
        let rest = Unit::Force.show(whole - most);
        derivation = derivation.then(say!("the rest, {}, goes through the web", rest));
    }
    let moment = 0.5 * flange_lever(e).value() * (t + c).abs();
    FlangeForces { weld: force, derivation, axial: (t - c).abs(), moment }
}

/// The fillet welds of flanges and web under a load case.
pub(super) fn under_load(e: &EndPlate, a: &PlaneActions) -> Vec<Check> {
    let mut out = Vec::new();
    let Some(steel) = welded_steel::of_the_beam(e) else { return out };
    let [[axial, vy, vz], [_, my, _]] = a.at(1.0);
    let flanges = at_plate::flanges(e);
    let each = flanges.iter().map(|f| (f, flange_forces(e, f, axial, my)));
    let each: Vec<_> = each.collect();
    if e.flange_throat > 0.0 {
        for (f, forces) in &each {
            let subject = Subject::end(&a.end).and(f.part);
            out.push(flange(e, f, forces, vy, &steel, subject));
        }
    }
    // the weaker flange leaves the web more
    let left =
        each.iter().map(|(_, forces)| forces).max_by(|a, b| a.beyond().total_cmp(&b.beyond()));
    if let Some(forces) = left.filter(|_| e.web_throat > 0.0) {
        let subject = Subject::end(&a.end).and(Part::BeamWeb);
        let shear = at_plate::web_shear(e, [[axial, vy, vz], [0.0, my, 0.0]]);
        out.extend(web(e, forces, shear, &steel, subject));
    }
    out
}

/// The weld of a flange, across it under moment and axial force, along it under half of Vy; welds
/// of full strength carry all that the flange can bring.
///
/// The welds of an inclined flange take its force along it, F_Ed/cos θ, by the directional method
/// with its angle; beside a force along the weld by the simplified method, which holds for any
/// direction.
fn flange(
    e: &EndPlate,
    f: &PlateFlange<'_>,
    forces: &FlangeForces,
    vy: f64,
    steel: &WeldedSteel,
    subject: Subject,
) -> Check {
    let (a, length) = (e.flange_throat, weld_lengths::flange(e, f));
    let l = length.traced();
    let pull = along_flange(f, Traced::force("F_Ed", forces.weld));
    // a weld without any effective length carries nothing
    let line = |force: f64| if length.value > 0.0 { force / length.value } else { f64::INFINITY };
    let along = if vy == 0.0 { 0.0 } else { line(0.5 * vy.abs()) };
    let force = LineForce { across: line(pull.value()), along };
    let demand = force.resultant();
    let mut worked = match f.is_normal() {
        true => either_method(force, a, steel),
        false if along == 0.0 => transverse_inclined(a, f.slope, steel),
        false => simplified(a, steel),
    };
    let full = full_throat_of(e, f, steel);
    let short = demand.is_finite() && !within(demand, worked.value);
    if short && within(full.value, a) {
        worked = worked
            .then(welded_steel::as_strong(a, &full))
            .becomes("F_w,Rd", flange_strength(e, f) / l.clone());
        worked.id = CheckId::WeldFullStrength;
        worked.clause = "EN 1993-1-8:2005 6.2.3(4)";
    }
    let across = pull;
    let together = match vy == 0.0 {
        true => across,
        false => {
            let half = Traced::force("Vy", vy.abs()) / Traced::from(2.0);
            (across.powi(2) + half.powi(2)).sqrt()
        }
    };
    let together: Line = match length.value > 0.0 {
        // with the rounding of the resultant
        true => {
            Formula { value: demand, ..Formula::new("F_w,Ed", together / l, Unit::ForcePerLength) }
                .into()
        }
        false => "a weld without any effective length carries nothing".into(),
    };
    let before = forces.derivation.clone().then(length.clone()).then(together);
    worked.after(before).with("l_eff", length.value, Unit::Length).against(
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
    subject: Subject,
) -> Option<Check> {
    let length = weld_lengths::web(e);
    if length.value <= 0.0 {
        // the check of the least length fails
        return None;
    }
    let (l, two) = (length.traced(), Traced::from(2.0));
    let axial = Traced::force("N_w", forces.axial);
    let moment = Traced::symbol("M_w", forces.moment, Unit::Moment);
    let rest = axial / l.clone() + Traced::from(6.0) * moment / l.clone().powi(2);
    let across = rest / two.clone();
    let along = Traced::force("V", vz.abs()) / two.clone() / l.clone();
    let (force, before) = brought_by_the_web([across, along], most_of_web(e) / two);
    let worked = either_method(force, e.web_throat, steel);
    Some(worked.after(before.then(length)).with("l_eff", l.value(), Unit::Length).against(
        Topic::Welds,
        subject,
        force.resultant(),
        Status::Failed,
    ))
}

/// Forces per length of one of the two welds of the web, reduced to what the web yields with, and
/// their derivation up to F_w,Ed. `most` is half of the strength of the web per length \[N/mm\].
fn brought_by_the_web([across, along]: [Traced; 2], most: Traced) -> (LineForce, Derivation) {
    let line = |symbol: &'static str, of: Traced| Formula::new(symbol, of, Unit::ForcePerLength);
    let bends = across.value() > 0.0;
    let yields = yielding_part([across.clone(), along.clone()], most.clone()).value() < 1.0;
    if !bends && !yields {
        let along = line("F_w,Ed", along);
        return (LineForce { across: 0.0, along: along.value }, along.into());
    }
    // forces across the weld stand only where there are any
    let both = |along: &Formula, across: &Formula| {
        let across = Some(across).filter(|_| bends);
        let lines = [Some(along), across].into_iter().flatten();
        lines.map(|of| Line::from(of.clone())).collect::<Vec<_>>()
    };
    let [s_across, s_along] = if yields { ["F_⊥,el", "F_∥,el"] } else { ["F_⊥", "F_∥"] };
    let (mut across, mut along) = (line(s_across, across), line(s_along, along));
    let mut lines = both(&along, &across);
    if yields {
        let part = yielding_part([across.traced(), along.traced()], most);
        let part = Formula::new("η", part, Unit::Number);
        across = line("F_⊥", part.traced() * across.traced());
        along = line("F_∥", part.traced() * along.traced());
        lines.extend([YIELDS.into(), part.into()]);
        lines.extend(both(&along, &across));
    }
    let force = LineForce { across: across.value, along: along.value };
    let (across, along) = (across.traced(), along.traced());
    let together = if bends { (across.powi(2) + along.powi(2)).sqrt() } else { along };
    // the resultant, which rounds in its own way
    let demand = Formula { value: force.resultant(), ..line("F_w,Ed", together) };
    lines.push(demand.into());
    (force, Derivation { lines })
}

/// Part of the forces per length across and along one of two welds of a plate that the plate brings
/// before it yields, at most 1: `F_y/√(F_⊥² + 3 F_∥²)`. `most` is F_y, half of the strength of the
/// plate per length in tension \[N/mm\].
pub(super) fn yielding_part([across, along]: [Traced; 2], most: Traced) -> Traced {
    let equivalent = (across.powi(2) + Traced::from(3.0) * along.powi(2)).sqrt();
    match within(equivalent.value(), most.value()) {
        true => Traced::from(1.0),
        false => most / equivalent,
    }
}

/// Strength of the web per length in tension, `t_w f_y/γ_M0`, of the weaker web of a haunched beam
/// \[N/mm\].
pub(super) fn web_strength(e: &EndPlate) -> Traced {
    let ([t_w, _], f_y) = (at_plate::webs(e), at_plate::steel(e).fy.mpa());
    Traced::length("t_w", t_w) * Traced::stress("f_y", f_y)
        / Traced::number("γ_M0", e.factors.gamma_m0)
}

/// Strength of the web per length in tension that its welds must not be spared, that of the
/// stronger web of a haunched beam \[N/mm\].
pub(super) fn most_of_web(e: &EndPlate) -> Traced {
    let Some(h) = at_plate::haunch(e) else { return web_strength(e) };
    let ([_, t_w], f_y) = (at_plate::webs(e), h.steel.fy.mpa().max(e.beam_steel.fy.mpa()));
    Traced::length("t_w", t_w) * Traced::stress("f_y", f_y)
        / Traced::number("γ_M0", e.factors.gamma_m0)
}

/// Throat of the welds of a flange that are as strong as it \[mm\].
pub(super) fn full_throat_of(e: &EndPlate, f: &PlateFlange<'_>, steel: &WeldedSteel) -> Worked {
    let inclined = (f.slope, steel);
    full_strength_throat_inclined(f.thickness, f.steel.fy, e.factors.gamma_m0, inclined)
}

/// Resistance of the welds of a flange, with their length.
pub(super) fn flange_resistance(
    e: &EndPlate,
    f: &PlateFlange<'_>,
    clause: &'static str,
) -> Option<Worked> {
    let (a, most) = (e.flange_throat, flange_strength(e, f));
    let steel = welded_steel::of_the_beam(e)?;
    let full = full_throat_of(e, f, &steel);
    let length = weld_lengths::flange(e, f);
    let each = match f.is_normal() {
        true => transverse(a, &steel),
        false => transverse_inclined(a, f.slope, &steel),
    };
    let along = each.traced() * weld_lengths::counted(&length);
    let of = |value: Traced| {
        let id = CheckId::FlangeWeldNotWeakest;
        Worked::of(clause, id, "F_Rd", value, Unit::Force)
    };
    Some(match within(full.value, a) && most.value() > along.value() {
        true => {
            let why = Derivation::from(welded_steel::as_strong(a, &full))
                .then(CheckId::WeldFullStrength.title());
            of(most).after(why)
        }
        false => of(along).after(Derivation::from(length).followed_by(each.derivation)),
    })
}
