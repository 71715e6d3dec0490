//! Resistances of the parts of a simple joint to the vertical shear force alone.

use super::header_bolts;
use super::plies::{Ply, edges, first, last, plate, web};
use super::resistance::Resistance;
use crate::check::{CheckId, Topic, within};
use crate::eurocode::i_section::Section;
use crate::eurocode::notched_section::NotchedSection;
use crate::eurocode::section::CrossSection;
use crate::eurocode::yielding::{in_shear, plastic_shear};
use crate::formula::{Number, Traced};
use crate::subject::Part;
use crate::unit::Unit;
use crate::worked::Worked;
use bracket_joint::assembly::{SimpleJoint, SimpleKind};

/// Factor on the area of the beam web over the height of a header plate.
///
/// # Source
/// SCI P358, check of the supported beam web; on the safe side of EN 1993-1-1:2005 6.2.6, which
/// takes the whole area of a plate.
const WEB_AT_PLATE: f64 = 0.9;

/// Height of a header plate over its gauge from which it does not bend in its plane.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 2.2.5.3.
pub(super) const STOCKY: f64 = 1.36;

/// All of them under a force on the joint, `down` or up.
pub(super) fn shear_resistances(e: &SimpleJoint, down: bool) -> Vec<Resistance> {
    let mut out = match e.kind {
        SimpleKind::FinPlate => fin_plate(e, down),
        SimpleKind::HeaderPlate => header_plate(e, down),
    };
    out.extend(web_buckling(e));
    out
}

/// Length of the face of a block of the plate from the row farthest from the end that it tears
/// towards, to that end; net \[mm\].
fn plate_face(e: &SimpleJoint, down: bool) -> f64 {
    let whole = if down { first(&e.rows) - e.bottom } else { e.top - last(&e.rows) };
    whole - (e.rows.len() as f64 - 0.5) * e.hole
}

/// Resistances of one ply of a fin-plate joint to the shear force \[N\].
pub(super) struct Faces {
    /// Of its gross section.
    pub gross: Worked,
    /// Of its net section.
    pub net: Worked,
    /// Of the block that the bolts tear out.
    pub block: Worked,
}

/// The plate and the web of the beam of a fin-plate joint under a force `down` or up.
pub(super) fn faces(e: &SimpleJoint, down: bool) -> [Faces; 2] {
    let (p, w) = (plate(e), web(e));
    let section = p.section(e, 1.0);
    let block = p.blocks(1.0, p.edge_face(e), plate_face(e, down));
    let block = block.eccentric(e.factors.gamma_m0, e.factors.gamma_m2);
    let plate = Faces { gross: section.gross_shear(), net: section.net_shear(), block };
    let block = web_block(e, &w, down);
    [plate, Faces { gross: web_shear(e), net: net_web(e), block }]
}

/// A fin plate with the web of its beam.
fn fin_plate(e: &SimpleJoint, down: bool) -> Vec<Resistance> {
    let parts = [Part::FinPlate, Part::BeamWeb];
    let of = |(part, f): (Part, Faces)| {
        [
            Resistance::of_member(f.gross, part).plastic(),
            Resistance::of_member(f.net, part),
            Resistance::of_member(f.block, part),
        ]
    };
    parts.into_iter().zip(faces(e, down)).flat_map(of).collect()
}

/// What notches leave of the beam at its end; `None` without notches.
pub(super) fn notched(e: &SimpleJoint) -> Option<NotchedSection> {
    let depths = e.notches.map(|n| if n.length > 0.0 { n.depth } else { 0.0 });
    let any = depths.iter().any(|d| *d > 0.0);
    any.then(|| NotchedSection::new(&Section::from(&e.beam), depths))
}

/// A_v of the beam at its end \[mm²\].
fn shear_area(e: &SimpleJoint) -> f64 {
    notched(e).map_or_else(|| Section::from(&e.beam).shear_area(), |n| n.shear_area())
}

/// Shear resistance of the gross section of the beam at its end \[N\].
///
/// # Source
/// EN 1993-1-1:2005 6.2.6(2); Steel Buildings in Europe, Part 5, 3.2.5.1.
pub(super) fn web_shear(e: &SimpleJoint) -> Worked {
    let (fy, gamma) = (e.beam_steel.fy.mpa(), e.factors.gamma_m0);
    if let Some(n) = notched(e) {
        return n.shear(fy, gamma);
    }
    let a_v = Traced::area("A_v", shear_area(e));
    let value = plastic_shear(a_v, Traced::stress("f_y", fy), Traced::number("γ_M0", gamma));
    let clause = "EN 1993-1-1:2005 6.2.6(2)";
    Worked::of(clause, CheckId::GrossShear, "V_Rd,g", value, Unit::Force)
}

/// Shear resistance of the net section of the beam through a line of bolts \[N\],
/// `(A_v − n_1 d_0 t_w) f_u/(√3 γ_M2)`.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 3.2.5.1.
pub(super) fn net_web(e: &SimpleJoint) -> Worked {
    let holes = Traced::number("n_1", e.rows.len() as f64)
        * Traced::length("d0", e.hole)
        * Traced::length("t_w", e.beam.tw);
    let net = Traced::area("A_v", shear_area(e)) - holes;
    let net = if net.value() < 0.0 { net.max(Traced::from(0.0)) } else { net };
    let f_u = Traced::stress("f_u", e.beam_steel.fu.mpa());
    let value = in_shear(net * f_u, Traced::number("γ_M2", e.factors.gamma_m2));
    let clause = "Steel Buildings in Europe 5, 3.2.5.1";
    Worked::of(clause, CheckId::NetShear, "V_Rd,n", value, Unit::Force)
}

/// Block tearing of the beam web \[N\]: the bolts tear a block out of the end of the beam, upwards
/// where the force on the joint points down.
///
/// # Source
/// EN 1993-1-8:2005 3.10.2(3); Steel Buildings in Europe, Part 5, 3.2.5.1 for the faces: the shear
/// face passes n_1 − 1/2 holes where it ends at a notch, n_1 − 1 where it ends at a flange.
pub(super) fn web_block(e: &SimpleJoint, w: &Ply<'_>, down: bool) -> Worked {
    let side = usize::from(!down);
    let notch = &e.notches[side];
    let open = notch.depth > 0.0 && within(last(&e.columns) - e.beam_start, notch.length);
    let edge = if open { edges(e)[side].abs() } else { 0.5 * e.beam.h };
    let whole = if down { edge - last(&e.rows) } else { first(&e.rows) + edge };
    let holes = e.rows.len() as f64 - if open { 0.5 } else { 1.0 };
    let block = w.blocks(1.0, w.edge_face(e), whole - holes * e.hole);
    block.eccentric(e.factors.gamma_m0, e.factors.gamma_m2)
}

/// Shear buckling of the web of the whole beam; `None` where it is not slender.
fn web_buckling(e: &SimpleJoint) -> Option<Resistance> {
    let (section, fy) = (Section::from(&e.beam), e.beam_steel.fy);
    let beam = CrossSection { section, fy, gamma_m0: e.factors.gamma_m0 };
    let (slenderness, limit) = beam.web_slenderness();
    (!within(slenderness, limit)).then(|| {
        let worked = beam.shear_buckling(e.factors.gamma_m1);
        let buckling = Resistance::of_member(worked, Part::BeamWeb);
        Resistance { topic: Topic::Stability, ..buckling }
    })
}

/// A header plate with its bolts, the support and the web of its beam.
fn header_plate(e: &SimpleJoint, down: bool) -> Vec<Resistance> {
    let p = plate(e);
    let section = p.section(e, 2.0);
    let mut out = header_bolts::shear_resistances(e);
    out.push(Resistance::of_member(section.gross_shear(), p.part).plastic());
    out.push(Resistance::of_member(section.net_shear(), p.part));
    let block = p.blocks(2.0, p.edge_face(e), plate_face(e, down));
    let bends = !within(STOCKY * gauge(e), e.height());
    let (m0, m2) = (e.factors.gamma_m0, e.factors.gamma_m2);
    // Part 5, 2.2.5.3: a plate that bends tears like one under an eccentric force
    let tears = match bends && e.rows.len() > 1 {
        true => block.eccentric(m0, m2),
        false => block.resistance(m0, m2),
    };
    out.push(Resistance::of_member(tears, p.part));
    if bends {
        out.push(Resistance::of_member(bending(e, &p), p.part).plastic());
    }
    out.push(Resistance::of_member(web_at_plate(e), Part::BeamWeb).plastic());
    if notched(e).is_some() {
        out.push(Resistance::of_member(web_shear(e), Part::BeamWeb).plastic());
    }
    out
}

/// Gauge p_3 of the bolts on either side of the web of a header plate \[mm\]: twice their mean
/// distance from it.
pub(super) fn gauge(e: &SimpleJoint) -> f64 {
    let sum: f64 = e.columns.iter().map(|y| y.abs()).sum();
    2.0 * sum / e.columns.len().max(1) as f64
}

/// Shear force that bends a header plate in its plane beside the web \[N\],
/// `2 W_el f_y/(γ_M0 (p_3 − t_w)/2)`.
///
/// # Source
/// NCCI SN014, 9; SCI P358.
fn bending(e: &SimpleJoint, p: &Ply<'_>) -> Worked {
    let both = p.section(e, 2.0).bending();
    let arm =
        (Traced::length("p_3", gauge(e)) - Traced::length("t_w", e.beam.tw)) / Traced::from(2.0);
    let value = both.traced() / arm;
    let clause = "NCCI SN014, 9";
    Worked::of(clause, CheckId::PlateBending, "V_Rd", value, Unit::Force).after(both.derivation)
}

/// Shear resistance of the beam web over the height of a header plate \[N\],
/// `0.9 h_p t_w f_y/(√3 γ_M0)`.
fn web_at_plate(e: &SimpleJoint) -> Worked {
    let area = Traced::from(WEB_AT_PLATE)
        * Traced::length("h_p", e.height())
        * Traced::length("t_w", e.beam.tw);
    let f_y = Traced::stress("f_y", e.beam_steel.fy.mpa());
    let value = plastic_shear(area, f_y, Traced::number("γ_M0", e.factors.gamma_m0));
    let clause = "EN 1993-1-1:2005 6.2.6(2), SCI P358";
    Worked::of(clause, CheckId::WebAtPlate, "V_Rd", value, Unit::Force)
}
