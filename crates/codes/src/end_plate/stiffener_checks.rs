//! Stiffeners of the column on their net section, and the welds of stiffeners, web plate and rib.
//!
//! The mesh has whole stiffeners that are one body with the column; the checks here cover the part
//! that is cut off at the root, and the size of the welds.

use super::at_plate;
use super::column_forces::PanelShear;
use super::component_joint::component_joint;
use super::doubler::doubler_fault;
use super::member_end::{LoadedEnd, MemberEnd};
use super::transformation::{beta, other_ends};
use super::weld_lengths;
use super::welded_steel;
use crate::check::{Check, CheckId, Status, Topic, Unit, largest, within};
use crate::component_method::assembly::Group;
use crate::component_method::column_web::compressed_thickness;
use crate::component_method::{Assessment, ComponentKind, Summed, assess};
use crate::eurocode::welds::{LineForce, either_method, full_strength_throat, least_size};
use crate::formula::{Derivation, Formula, Number, Traced};
use crate::subject::{Part, Place, Subject};
use crate::worked::Worked;
use bracket_joint::assembly::{ColumnSide, EndPlate, Way};
use std::f64::consts::SQRT_2;

/// Fraction of a weld leg and of a root radius in which no plastic hinge forms, figures 6.8 and
/// 6.11.
const HINGE: f64 = 0.8;

/// The stiffeners level with one flange of the beam.
struct Stiffeners<'a> {
    c: &'a ColumnSide,
    gamma_m0: f64,
}

impl Stiffeners<'_> {
    /// A_net f_y/γ_M0 of both sides of the web \[N\], with the net width `b_net` of either.
    fn resistance(&self) -> Traced {
        Traced::from(2.0)
            * Traced::length("b_net", contact(self.c))
            * Traced::length("t_s", self.c.stiffener)
            * self.yield_strength()
            / self.gamma_m0()
    }

    fn yield_strength(&self) -> Traced {
        Traced::stress("f_y", self.c.steel.fy.mpa())
    }

    fn gamma_m0(&self) -> Traced {
        Traced::number("γ_M0", self.gamma_m0)
    }
}

/// Force of a pair of stiffeners beside the web \[N\].
struct Share {
    /// Compressed stiffeners or stiffeners in tension.
    side: Part,
    /// Flange of the beam that they are level with.
    level: Way,
    /// Force of the stiffeners on both sides of the web.
    force: Traced,
}

impl Share {
    /// F_Ed of the welds: stiffeners bring no more than their net section carries.
    fn brought(&self, s: &Stiffeners<'_>) -> Formula {
        let (force, most) = (self.force.clone(), s.resistance());
        let beyond = force.value() > most.value();
        Formula::new("F_Ed", if beyond { force.min(most) } else { force }, Unit::Force)
    }
}

/// Net section and welds of the stiffeners under a load case.
pub(super) fn stiffeners(loaded: &LoadedEnd<'_>) -> Vec<Check> {
    let e = loaded.end.e;
    let Some(c) = e.column.as_ref().filter(|c| c.stiffener > 0.0) else { return Vec::new() };
    let beta = beta(e, loaded.end.a);
    let mut without = component_joint(e, beta);
    without.column.iter_mut().for_each(|c| c.stiffener = 0.0);
    // the tables covered the joint with stiffeners, so they cover it without them
    let Ok(bare) = assess(&without.turned(loaded.end.sense)) else { return Vec::new() };
    let s = Stiffeners { c, gamma_m0: e.factors.gamma_m0 };
    let doublers = without.column.as_ref().map_or(0, |c| c.doublers);
    let mut out = Vec::new();
    let mut shares = Vec::new();
    if let Some((check, share)) =
        compression(loaded, &s, &bare, compressed_thickness(c.section.tw, doublers))
    {
        out.push(check);
        shares.push(share);
    }
    if let Some((check, share)) = tension(loaded, &s, &bare) {
        out.push(check);
        shares.push(share);
    }
    out.extend(stiffener_welds(loaded, &s, &shares, beta));
    out
}

/// Crushing of the web and of the net section of the stiffeners under the compressed flange of the
/// beam. The force is shared in proportion to the two resistances, so that both are reached
/// together.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.2(1) and (4) without buckling, which the component method checks on the
/// whole section; net section where the stiffener is cut, as in SCI P398.
fn compression(
    loaded: &LoadedEnd<'_>,
    s: &Stiffeners<'_>,
    bare: &Assessment,
    web: f64,
) -> Option<(Check, Share)> {
    let limit = bare.limit(Summed::ColumnWeb)?;
    let (width, kwc, omega) = (limit.step("b_eff")?, limit.step("k_wc")?, limit.step("ω")?);
    let alone = Traced::number("ω", omega)
        * Traced::number("k_wc", kwc)
        * Traced::length("b_eff", width)
        * Traced::length("t_wc", web)
        * s.yield_strength()
        / s.gamma_m0();
    let both = alone + s.resistance();
    let id = CheckId::StiffenedWebCrushing;
    let clause = "EN 1993-1-8:2005 6.2.6.2(4), SCI P398";
    let worked = Worked::of(clause, id, "F_Rd", both.clone(), Unit::Force)
        .with("b_eff", width, Unit::Length)
        .with("ω", omega, Unit::Number);
    let place = loaded.place(Part::CompressedStiffeners);
    let check = worked.against(Topic::Member, place, loaded.push, Status::Failed);
    let force = s.resistance() / both * Traced::force("F_c,Ed", loaded.push);
    let level = loaded.end.sense.compressed();
    Some((check, Share { side: Part::CompressedStiffeners, level, force }))
}

/// Net section of the stiffeners at the flange in tension, under the rows above and below: the
/// force beyond the resistance of the column web without them, or the share that bending of the
/// column flange brings into them, whichever is larger.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.3 for the web; the share m/(m + m2) of a row as in SCI/BCSA, Joints in
/// Steel Construction: Moment Connections.
fn tension(
    loaded: &LoadedEnd<'_>,
    s: &Stiffeners<'_>,
    bare: &Assessment,
) -> Option<(Check, Share)> {
    let (e, c) = (loaded.end.e, s.c);
    let rows = &loaded.end.assessment.rows;
    let level = at_plate::beam(e).middle(loaded.end.sense.pulled()).abs();
    let below = rows.iter().position(|r| r.z < level);
    let above = rows.iter().rposition(|r| r.z > level);
    let near: Vec<usize> = above.into_iter().chain(below).collect();
    let (first, last) = (*near.first()?, *near.last()?);
    let web = if first == last {
        bare.rows.get(last)?.alone.iter().find(|k| k.kind == ComponentKind::ColumnWeb)?
    } else {
        let of = |g: &&Group| g.first == first && g.component.kind == ComponentKind::ColumnWeb;
        &bare.rows.get(last)?.groups.iter().find(of)?.component
    };
    let m = 0.5 * (e.gauge - c.section.tw) - HINGE * c.section.r;
    let (mut pull, mut bent) = (Vec::new(), Vec::new());
    for (at, row) in near.iter().filter_map(|r| Some((*r, rows.get(*r)?))) {
        let m2 = (row.z - level).abs() - 0.5 * c.stiffener - HINGE * SQRT_2 * c.stiffener_throat;
        let force = Traced::force("F_r", loaded.row_force(at));
        let m = Traced::length("m", m);
        pull.push(force.clone());
        bent.push(force * m.clone() / (m + Traced::length("m2", m2)));
    }
    let of_web = Traced::force("F_t,wc,Rd", web.worked.value);
    let force = (Traced::series(pull) - of_web).max(Traced::series(bent));
    let demand = force.value();
    let id = CheckId::StiffenersInTension;
    let clause = "EN 1993-1-8:2005 6.2.6.3, SCI P398";
    let mut worked = Worked::of(clause, id, "F_Rd", s.resistance(), Unit::Force)
        .after(Formula::new("F_Ed", force.clone(), Unit::Force));
    if let Some(width) = web.worked.step("b_eff") {
        worked = worked.with("b_eff of the web", width, Unit::Length);
    }
    let place = loaded.place(Part::StiffenersInTension);
    let check = worked.against(Topic::Member, place, demand, Status::Failed);
    let level = loaded.end.sense.pulled();
    Some((check, Share { side: Part::StiffenersInTension, level, force }))
}

/// Width of one stiffener in contact with the flange of the column \[mm\].
fn contact(c: &ColumnSide) -> f64 {
    0.5 * (c.section.b - c.section.tw) - c.stiffener_clip
}

/// Effective lengths of the fillet welds of a stiffener to the flange and to the web of the column.
fn seam_lengths(e: &EndPlate, c: &ColumnSide) -> [Formula; 2] {
    let along_web = c.section.h - 2.0 * (c.section.tf + c.stiffener_clip);
    [contact(c), along_web].map(|length| weld_lengths::run(e, length, c.stiffener_throat))
}

/// Least throat and length of the welds of the stiffeners and least throat of those of the web
/// plate, which no load changes.
pub(super) fn least_sizes(e: &EndPlate) -> Vec<Check> {
    let Some(c) = &e.column else { return Vec::new() };
    let mut out = Vec::new();
    if c.stiffener > 0.0 && c.stiffener_throat > 0.0 {
        let [flange, web] = seam_lengths(e, c);
        let shorter = flange.value.min(web.value);
        out.extend(least_size(Part::Stiffeners, c.stiffener_throat, shorter));
    }
    out.extend(doubler_throat(c));
    out
}

/// The throat from which a web plate counts in tension.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.3: fillet welds with a ≥ t_s/√2.
fn doubler_throat(c: &ColumnSide) -> Option<Check> {
    let counts = c.doubler > 0.0 && c.doubler_throat > 0.0 && doubler_fault(c).is_none();
    let what = ("EN 1993-1-8:2005 6.2.6.3", CheckId::DoublerThroat);
    let rule = Traced::length("t_s", c.doubler) / Traced::from(2.0).sqrt();
    let (topic, throat) = ((Topic::Welds, Part::Doubler), c.doubler_throat);
    counts.then(|| Check::at_least(topic, what, "a", rule, throat, Status::Failed))
}

/// Fillet welds of the stiffeners: to the flange of the column for the force of the stiffeners, to
/// its web for the share β of it that no beam on the other side balances. The stiffeners can bring
/// no more than they yield with.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.1(1), 4.5.1(1) for the effective length; four welds, one on either side
/// of each stiffener, two where the column ends with the stiffeners.
fn stiffener_welds(
    loaded: &LoadedEnd<'_>,
    s: &Stiffeners<'_>,
    shares: &[Share],
    beta: f64,
) -> Vec<Check> {
    let (e, c, mut out) = (loaded.end.e, s.c, Vec::new());
    let a = c.stiffener_throat;
    let Some(steel) = welded_steel::of_the_column(e, c).filter(|_| a > 0.0) else {
        return out;
    };
    let [flange, web] = seam_lengths(e, c);
    let full = full_strength_throat(c.stiffener, c.steel.fy, s.gamma_m0, &steel);
    let seams = |share: &Share| 2.0 * seams(e, c, share.level);
    // compared as forces, so that welds without any effective length fail
    let all = |count: f64, (force, before): (f64, Derivation), across: bool, place: Subject| {
        let length = if across { &flange } else { &web };
        let l = length.value.max(0.0);
        let line = if l > 0.0 { force / (count * l) } else { 0.0 };
        let line = match across {
            true => LineForce { across: line, along: 0.0 },
            false => LineForce { across: 0.0, along: line },
        };
        let each = either_method(line, a, &steel);
        let value = Traced::from(count) * weld_lengths::counted(length) * each.traced();
        let id = CheckId::StiffenerWelds;
        let mut worked = Worked::of(each.clause, id, "F_Rd", value, Unit::Force)
            .after(before.then(length.clone()).followed_by(each.derivation));
        // full strength by a weld on either side of each stiffener
        let both_sides = across && l > 0.0 && within(4.0, count);
        if both_sides && !within(force, worked.value) && within(full.value, a) {
            worked = worked.then(welded_steel::as_strong(a, &full)).becomes("F_Rd", s.resistance());
            worked.clause = "EN 1993-1-8:2005 6.2.3(4)";
        }
        worked.against(Topic::Welds, place, force, Status::Failed)
    };
    for share in shares {
        let place = loaded.place(Place::Seam { of: share.side, to: Part::ColumnFlange });
        let force = share.brought(s);
        out.push(all(seams(share), (force.value, force.into()), true, place));
    }
    // the pair with the largest force on a seam
    if let Some(share) = largest(shares, |s| s.force.value() / seams(s)) {
        let force = Traced::force("F", share.brought(s).value);
        let force = Formula::new("F_Ed", Traced::number("β", beta) * force, Unit::Force);
        let place = loaded.place(Place::Seam { of: share.side, to: Part::ColumnWeb });
        out.push(all(seams(share), (force.value, force.into()), false, place));
    }
    out
}

/// Sides of a stiffener that have room for a fillet weld: one where the column ends nearer to the
/// stiffener than the leg of the weld, otherwise two.
fn seams(e: &EndPlate, c: &ColumnSide, level: Way) -> f64 {
    let z = at_plate::beam(e).middle(level);
    let leg = SQRT_2 * c.stiffener_throat;
    let room = c.ends().from(z, level).map(|end| end - 0.5 * c.stiffener);
    if room.is_none_or(|room| within(leg, room)) { 2.0 } else { 1.0 }
}

/// Fillet welds round the web plate: the shear flow of its share of the panel.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.1, welds of supplementary web plates for the forces that act on them.
pub(super) fn doubler_welds(end: &MemberEnd<'_>) -> Vec<Check> {
    let mut out = Vec::new();
    let e = end.e;
    let counts =
        |c: &&ColumnSide| c.doubler > 0.0 && c.doubler_throat > 0.0 && doubler_fault(c).is_none();
    let Some(c) = e.column.as_ref().filter(counts) else { return out };
    let (subject, a) = (Subject::end(&end.a.end).and(Part::Doubler), c.doubler_throat);
    let (Some(steel), Some(panel)) = (welded_steel::of_the_column(e, c), &end.assessment.panel)
    else {
        return out;
    };
    let Some(area) = panel.step("A_vc") else {
        return out;
    };
    let other: f64 = other_ends(e, end.a).map(|o| o.at(1.0)[1][1]).sum();
    let panel = PanelShear::new(e, end.a, other, end.assessment.stiffness.lever);
    // the plate brings no more than it yields with
    let most = Traced::length("t_s", c.doubler) * Traced::stress("f_y", c.steel.fy.mpa())
        / (Traced::from(3.0).sqrt() * Traced::number("γ_M0", e.factors.gamma_m0));
    let flow = Traced::force("V_wp,Ed", panel.demand) * Traced::length("t_wc", c.section.tw)
        / Traced::area("A_vc", area);
    let flow = Formula::new("F_w,Ed", flow.min(most), Unit::ForcePerLength);
    let demand = flow.value;
    let line = LineForce { across: 0.0, along: demand };
    let worked = Worked {
        clause: "EN 1993-1-8:2005 6.2.6.1, 4.5.3.3",
        id: CheckId::DoublerWelds,
        ..either_method(line, a, &steel).after(panel.derivation.then(flow))
    };
    out.push(worked.against(Topic::Welds, subject, demand, Status::Failed));
    out
}

/// Fillet welds of the rib: as strong as the rib, because no formula gives its force.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.2(6).
pub(super) fn rib_weld(e: &EndPlate) -> Option<Check> {
    let steel = welded_steel::of_the_beam(e).filter(|_| e.rib > 0.0 && e.rib_throat > 0.0)?;
    let full = full_strength_throat(e.rib, e.beam_steel.fy, e.factors.gamma_m0, &steel);
    let what = ("EN 1993-1-8:2005 4.5.3.2(6)", CheckId::RibThroat);
    let rule = welded_steel::full_throat(&full);
    Some(Check::at_least((Topic::Welds, Part::Rib), what, "a", rule, e.rib_throat, Status::Failed))
}
