//! Notches of the beam: the moment beside the shear force, and local stability.

use super::actions::moment;
use super::plies::{last, web};
use super::shear_resistances::web_block;
use crate::check::{Check, CheckId, Status, Topic, Unit, within};
use crate::eurocode::i_section::Section;
use crate::eurocode::notched_section::NotchedSection;
use crate::eurocode::section::shear_reduction;
use crate::eurocode::yielding::plastic;
use crate::formula::{Formula, Number, Traced};
use crate::subject::{Part, Subject};
use crate::worked::Worked;
use bracket_joint::assembly::{PlaneActions, SimpleJoint, SimpleKind};

/// Bolt diameters between the last line of bolts and the end of the notch from which block tearing
/// does not weaken the section there.
const CLEAR: f64 = 2.0;

/// What notches at least `length` long leave of the beam.
fn section_at(e: &SimpleJoint, length: f64) -> NotchedSection {
    let depth = e.notches.map(|n| if within(length, n.length) { n.depth } else { 0.0 });
    NotchedSection::new(&Section::from(&e.beam), depth)
}

/// A section of a notched beam with its resistances.
struct Cut {
    id: CheckId,
    /// From the end of the beam \[mm\].
    at: f64,
    /// Whether a block that tears out weakens it.
    torn: bool,
}

/// The sections that the shear force bends: at the end of each notch, and at the last of several
/// lines of bolts in a notch.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 2.2.2, 3.2.5.2 and 3.2.6.
fn cuts(e: &SimpleJoint) -> Vec<Cut> {
    let ends = e.notches.iter().filter(|n| n.depth > 0.0 && n.length > 0.0);
    let ends: Vec<f64> = ends.map(|n| n.length).collect();
    let several = e.kind == SimpleKind::FinPlate && e.columns.len() > 1;
    let line = last(&e.columns) - e.beam_start;
    let mut out: Vec<Cut> = Vec::new();
    for at in &ends {
        let torn = several && !within(CLEAR * e.bolt.d, at - line);
        out.push(Cut { id: CheckId::NotchMoment, at: *at, torn });
    }
    if several && ends.iter().any(|at| !within(*at, line)) {
        out.push(Cut { id: CheckId::LastLineMoment, at: line, torn: true });
    }
    out
}

/// Moment of the notched beam with its shear and axial force.
///
/// Elastic, `W_el,N f_y/γ_M0`, beside a shear force above half of V_pl,N,Rd times
/// `1 − (2 V_Ed/V_pl,N,Rd − 1)²`. An axial force adds its stress.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 2.2.2, 3.2.5.2 and 3.2.6; EN 1993-1-1:2005 6.2.8(3),
/// 6.2.1(7).
pub(super) fn bending(e: &SimpleJoint, a: &PlaneActions) -> Vec<Check> {
    cuts(e).into_iter().filter_map(|cut| at_cut(e, a, &cut)).collect()
}

fn at_cut(e: &SimpleJoint, a: &PlaneActions, cut: &Cut) -> Option<Check> {
    let [axial, _, vz] = a.at(1.0)[0];
    let section = section_at(e, cut.at);
    let m = moment(e, a, [e.beam_start + cut.at, section.centroid()]);
    if m.value == 0.0 && axial == 0.0 {
        return None;
    }
    let (fy, gamma) = (e.beam_steel.fy.mpa(), e.factors.gamma_m0);
    let symbols = || (Traced::stress("f_y", fy), Traced::number("γ_M0", gamma));
    let (f_y, gamma_m0) = symbols();
    let mut shear = section.shear(fy, gamma);
    if cut.torn {
        let block = web_block(e, &web(e), vz < 0.0);
        if block.value < shear.value {
            shear = block;
        }
    }
    let ratio = Traced::force("V_Ed", vz.abs()) / Traced::force("V_pl,N,Rd", shear.value);
    let rho = shear_reduction(ratio);
    let whole = plastic(Traced::number("W_el,N", section.modulus()), f_y, gamma_m0);
    let resistance = if rho.value() > 0.0 {
        let left = Traced::from(1.0) - rho;
        let left = if left.value() < 0.0 { left.max(Traced::from(0.0)) } else { left };
        whole * left
    } else {
        whole
    };
    let clause = "Steel Buildings in Europe 5, 3.2.6";
    let worked = Worked::of(clause, cut.id, "M_v,N,Rd", resistance, Unit::Moment).with(
        "V_pl,N,Rd",
        shear.value,
        Unit::Force,
    );
    let subject = Subject::end(&a.end).and(Part::BeamWeb);
    if axial == 0.0 {
        let demand = m.value.abs();
        let check = worked.after(m).against(Topic::Member, subject, demand, Status::Failed);
        return Some(check);
    }
    let (f_y, gamma_m0) = symbols();
    let gross = plastic(Traced::area("A_N", section.area()), f_y, gamma_m0);
    let gross = Formula::new("N_N,Rd", gross, Unit::Force);
    let used =
        m.traced().abs() / worked.traced() + Traced::force("N_Ed", axial.abs()) / gross.traced();
    let check = Worked::of(clause, cut.id, "", used, Unit::Number)
        .after(gross)
        .after(worked.derivation)
        .after(m);
    Some(check.utilised(Topic::Member, subject, Status::Failed))
}

/// h_b/t_w up to which a notch may be as long as the beam is high, and the constant of a shorter
/// notch, with the yield strength up to which they hold \[MPa\].
///
/// # Source
/// Steel Buildings in Europe, Part 5, 2.2.3 and 4.2.5, for S275 and S355. A weaker steel reaches
/// its own yield strength with less slenderness, so that the limits of the stronger one hold for
/// it.
const SLENDERNESS: [(f64, f64, f64); 2] = [(275.0, 54.3, 160_000.0), (355.0, 48.0, 110_000.0)];

/// Whether the notches need no further check of local stability. A beam that exceeds a limit is
/// not proved unstable: it stays undecided.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 2.2.3 and 4.2.5, for beams restrained against lateral
/// torsional buckling.
pub(super) fn stability(e: &SimpleJoint) -> Vec<Check> {
    let there: Vec<_> = e.notches.iter().filter(|n| n.depth > 0.0 && n.length > 0.0).collect();
    let clause = "Steel Buildings in Europe 5, 2.2.3, 4.2.5";
    let step = "a shorter or lower notch, a stiffener, or a check of the notch for buckling";
    let of = || (Topic::Stability, Part::BeamWeb);
    let Some(depth) = there.iter().map(|n| n.depth).reduce(f64::max) else { return Vec::new() };
    let length = there.iter().map(|n| n.length).fold(0.0, f64::max);
    let part = if there.len() > 1 { 5.0 } else { 2.0 };
    let h = || Traced::length("h_b", e.beam.h);
    let limit = h() / Traced::from(part);
    let (what, undecided) = ((clause, CheckId::NotchDepth), Status::Undecided);
    let mut out = vec![Check::at_most(of(), what, "d_n", limit, depth, undecided).decided_by(step)];
    let fy = e.beam_steel.fy.mpa();
    let Some((_, most, constant)) = SLENDERNESS.into_iter().find(|(f, ..)| within(fy, *f)) else {
        let why = "Part 5 has limits for S275 and S355 alone";
        let id = CheckId::NotchLength;
        out.push(Check::undecided(Topic::Stability, Part::BeamWeb, clause, id, why, step));
        return out;
    };
    let slenderness = e.beam.h / e.beam.tw;
    let limit = if within(slenderness, most) {
        h()
    } else {
        let ratio = h() / Traced::length("t_w", e.beam.tw);
        Traced::from(constant) * h() / ratio.powi(3)
    };
    let what = (clause, CheckId::NotchLength);
    let mut check = Check::at_most(of(), what, "l_n", limit, length, undecided);
    let words = "for a beam that is restrained against lateral torsional buckling";
    check.derivation.lines.push(words.into());
    out.push(check.decided_by(step));
    out
}
