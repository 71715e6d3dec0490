//! The haunch under a load case: what the change of direction of its flange brings into the web of
//! the beam, and the weld between its web and the flange of the beam.

use super::at_plate;
use super::beam_cuts;
use super::member_end::LoadedEnd;
use super::weld_lengths;
use super::welded_steel;
use crate::check::{Check, CheckId, Status, Topic, Unit, within};
use crate::component_method::column_web::{
    self, CompressedWeb, STIFFENER_SLENDERNESS, shear_interaction,
};
use crate::component_method::compressed_zone::StiffenerPair;
use crate::eurocode::i_section::Section;
use crate::eurocode::section::epsilon;
use crate::eurocode::welds::simplified;
use crate::formula::{Derivation, Formula, Line, Number, Relation, Traced};
use crate::subject::{Part, Place, Sense};
use crate::worked::Worked;
use bracket_joint::assembly::{EndPlate, Haunch, Rafter};

/// β of the shear in the web at the tip: one flange alone presses, and the shear force of the web
/// carries it.
const ONE_SIDED: f64 = 1.0;

/// All checks of the haunch of a member end.
pub(super) fn under_load(loaded: &LoadedEnd<'_>) -> Vec<Check> {
    let e = loaded.end.e;
    let Some(h) = at_plate::haunch(e) else { return Vec::new() };
    let mut out = Vec::new();
    if let Some(force) = compression(loaded) {
        out.extend(pressed(loaded, h, &force));
        out.extend(seam(loaded, h, &force));
    }
    if let Some(force) = tension(loaded) {
        out.extend(pulled(loaded, h, &force));
        out.extend(seam(loaded, h, &force));
    }
    out
}

/// F_h, the force along the haunch flange at the plate, which it is taken to keep up to the tip,
/// from its part `normal` to the plate.
fn flange_force(e: &EndPlate, normal: Traced) -> Formula {
    let slope = at_plate::rafter(e).map_or(0.0, Rafter::lower_slope);
    Formula::new("F_h", normal / Traced::number("cos(α + θ)", slope.cos()), Unit::Force)
}

/// M/z_f and N/2 of a flange \[N\].
fn shares(loaded: &LoadedEnd<'_>) -> [Traced; 2] {
    let [[axial, ..], [_, my, _]] = loaded.end.a.at(1.0);
    let lever = Traced::length("z_f", at_plate::beam(loaded.end.e).lever());
    let bending = Traced::symbol("M", my.abs(), Unit::Moment) / lever;
    [bending, Traced::force("N", axial) / Traced::from(2.0)]
}

/// F_h of the compressed haunch flange, by the component method; `None` where it is in tension.
fn compression(loaded: &LoadedEnd<'_>) -> Option<Formula> {
    let [bending, axial] = shares(loaded).map(|of| of.value());
    let pressed = loaded.end.sense == Sense::Top || bending + axial < 0.0;
    pressed.then(|| flange_force(loaded.end.e, Traced::force("F_c,Ed", loaded.push)))
}

/// F_h of the haunch flange in tension, by moment and axial force on the lever arm; compression
/// relieves nothing where the moment pulls. `None` where it is compressed.
fn tension(loaded: &LoadedEnd<'_>) -> Option<Formula> {
    let [bending, axial] = shares(loaded);
    let normal = match loaded.end.sense {
        Sense::Bottom if axial.value() > 0.0 => bending + axial,
        Sense::Bottom => bending,
        Sense::Top => axial - bending,
    };
    (normal.value() > 0.0).then(|| flange_force(loaded.end.e, normal))
}

/// Its part across the axis of the beam.
fn across(h: &Haunch, force: &Formula) -> Formula {
    let sine = Traced::number("sin θ", h.angle.sin().abs());
    Formula::new("F_Ed", force.traced() * sine, Unit::Force)
}

/// Length of web under the haunch flange at the tip, `t_fh + 5 (t_f + r)`: its thickness as stiff
/// bearing, no more, no welds \[mm\].
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.7(2) and (3), 6.2.6.2(1), formula 6.10; 6.2.6.3(2), formula 6.16.
fn bearing(e: &EndPlate, h: &Haunch) -> f64 {
    let s = Section::from(&e.beam);
    h.flange + 5.0 * (s.tf + s.root)
}

/// The web of the beam at the tip in compression, with its buckling, and with a pair of stiffeners
/// where there is one.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.7(3), 6.2.6.2(1), (2) and (4).
fn pressed(loaded: &LoadedEnd<'_>, h: &Haunch, force: &Formula) -> Vec<Check> {
    let (e, s) = (loaded.end.e, Section::from(&loaded.end.e.beam));
    let width = bearing(e, h);
    let web = CompressedWeb {
        effective_width: width,
        web: s.tw,
        clear_depth: s.clear_depth(),
        fy: e.beam_steel.fy.mpa(),
        young: e.beam_steel.e,
        omega: shear_interaction(ONE_SIDED, width, s.tw, s.shear_area()),
        longitudinal: longitudinal(loaded),
        gamma_m0: e.factors.gamma_m0,
        gamma_m1: e.factors.gamma_m1,
    };
    let bare = web.resistance();
    let pair = (h.stiffener > 0.0).then_some(StiffenerPair {
        outstand: 0.5 * (s.b - s.tw),
        thickness: h.stiffener,
        beside: [f64::INFINITY; 2],
    });
    let mut worked = match pair.map(|pair| web.stiffened(&pair)) {
        Some(cross) if cross.value > bare.value => cross,
        _ => bare,
    };
    worked.id = CheckId::HaunchTipWeb;
    let demand = across(h, force);
    let need = demand.value;
    worked = worked.after(Derivation::from(force.clone()).then(demand));
    let place = loaded.place(Part::HaunchTip);
    let mut out = vec![worked.against(Topic::Stability, place, need, Status::Failed)];
    out.extend(pair.and_then(|pair| outstand(loaded, &pair)));
    out
}

/// Stiffeners at the tip that may buckle about their weld: the code gives them no resistance.
///
/// # Source
/// EN 1993-1-5:2006 9.2.1(8).
fn outstand(loaded: &LoadedEnd<'_>, pair: &StiffenerPair) -> Option<Check> {
    let ratio = pair.outstand / pair.thickness;
    let eps = Traced::number("ε", epsilon(loaded.end.e.beam_steel.fy.mpa()));
    let limit = Traced::from(STIFFENER_SLENDERNESS) * eps;
    (!within(ratio, limit.value())).then(|| {
        let (clause, id) = ("EN 1993-1-5:2006 9.2.1(8)", CheckId::HaunchTipWeb);
        let line = Line::comparison("c/t_s", ratio, Relation::Above, limit, Unit::Number);
        let why =
            Derivation::from("the stiffeners at the tip of the haunch buckle about their weld")
                .then(line);
        let place = loaded.place(Part::HaunchStiffener);
        Check::undecided(Topic::Stability, place, clause, id, why, "thicker stiffeners")
    })
}

/// Largest longitudinal compressive stress at the root of the web at the tip \[MPa\], at most f_y.
fn longitudinal(loaded: &LoadedEnd<'_>) -> f64 {
    let e = loaded.end.e;
    let s = Section::from(&e.beam);
    let tip = beam_cuts::cuts(e, loaded.end.a).into_iter().find(|c| c.part == Part::HaunchTip);
    let [[axial, ..], [_, my, _]] = tip.map_or([[0.0; 3]; 2], |c| c.at);
    let stress = -axial / s.area + my.abs() * 0.5 * s.clear_depth() / s.i;
    stress.clamp(0.0, e.beam_steel.fy.mpa())
}

/// The web and the flange of the beam at the tip in tension; stiffeners are not counted.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.3(1) and (2), formulas 6.15 and 6.16; 6.2.6.4.3, formula 6.20, with
/// b_eff of 4.10(2).
fn pulled(loaded: &LoadedEnd<'_>, h: &Haunch, force: &Formula) -> Vec<Check> {
    let (e, s) = (loaded.end.e, Section::from(&loaded.end.e.beam));
    let (width, fy, gamma) = (bearing(e, h), e.beam_steel.fy.mpa(), e.factors.gamma_m0);
    let omega = shear_interaction(ONE_SIDED, width, s.tw, s.shear_area());
    let of_web = column_web::tension(width, s.tw, fy, omega, gamma);
    let (own, other) = (s.tf * fy, h.flange * h.steel.fy.mpa());
    let k = Traced::number("k", (own / other).min(1.0));
    let (n, length) = (Traced::from, Traced::length);
    let b_eff =
        (length("t_w", s.tw) + n(2.0) * length("r", s.root) + n(7.0) * k * length("t_f", s.tf))
            .min(length("b", h.width.min(s.b)));
    let b_eff = Formula::new("b_eff", b_eff, Unit::Length);
    let value =
        b_eff.traced() * length("t_fh", h.flange) * Traced::stress("f_y", h.steel.fy.mpa().min(fy))
            / Traced::number("γ_M0", gamma);
    let clause = "EN 1993-1-8:2005 6.2.6.4.3, 4.10(2)";
    let of_flange =
        Worked::of(clause, CheckId::HaunchTipFlange, "F_Rd", value, Unit::Force).after(b_eff);
    let demand = across(h, force);
    let each = [Worked { id: CheckId::HaunchTipWeb, ..of_web }, of_flange];
    let before = Derivation::from(force.clone()).then(demand.clone());
    each.into_iter()
        .map(|worked| {
            let place = loaded.place(Part::HaunchTip);
            let worked = worked.after(before.clone());
            worked.against(Topic::Member, place, demand.value, Status::Failed)
        })
        .collect()
}

/// The weld of the haunch web to the flange of the beam under the part of F_h along the beam:
/// fillets on both sides, or full penetration, as strong in shear as the haunch web. The haunch web
/// in shear is compared with the same force.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.3, 4.7.1; EN 1993-1-1:2005 6.2.6(2) for the web.
fn seam(loaded: &LoadedEnd<'_>, h: &Haunch, force: &Formula) -> Vec<Check> {
    let e = loaded.end.e;
    let along = force.traced() * Traced::number("cos θ", h.angle.cos());
    let along = Formula::new("F_∥", along, Unit::Force);
    let flow = |formula: Traced| Formula::new("F_w,Ed", formula, Unit::ForcePerLength);
    let place = || loaded.place(Place::Seam { of: Part::HaunchWeb, to: Part::BeamFlange });
    let length = Traced::length("l", h.length);
    let web = Traced::length("t_w", h.web) * Traced::stress("f_y", h.steel.fy.mpa())
        / (Traced::from(3.0).sqrt() * Traced::number("γ_M0", e.factors.gamma_m0));
    let line = flow(along.traced() / length);
    let mut words = Derivation::from(force.clone()).then(along.clone()).then(line.clone());
    if h.seam_throat == 0.0 {
        words = words.then("full penetration: as strong as the web (4.7.1)");
    }
    let clause = "EN 1993-1-1:2005 6.2.6(2)";
    let shear = Worked::of(clause, CheckId::HaunchWebShear, "F_Rd", web, Unit::ForcePerLength);
    let shear = shear.after(words);
    let mut out = vec![shear.against(Topic::Welds, place(), line.value, Status::Failed)];
    let Some(steel) = welded_steel::of_the_haunch(e, h).filter(|_| h.seam_throat > 0.0) else {
        return out;
    };
    let run = weld_lengths::run(e, h.length, h.seam_throat);
    // compared as forces, so that a weld without any effective length fails
    let each = simplified(h.seam_throat, &steel);
    let value = Traced::from(2.0) * weld_lengths::counted(&run) * each.traced();
    let words = Derivation::from(force.clone()).then(along.clone()).then(run);
    let worked = Worked::of(each.clause, CheckId::HaunchSeam, "F_Rd", value, Unit::Force)
        .after(words.followed_by(each.derivation));
    out.push(worked.against(Topic::Welds, place(), along.value, Status::Failed));
    out
}
