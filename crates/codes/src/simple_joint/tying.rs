//! Tying resistance of a simple joint: information for structural integrity.

use super::header_tension::stub;
use super::plies::{Ply, bolts, hole, plate, web};
use super::tension_checks::along;
use crate::check::{Check, CheckId, Topic, Unit};
use crate::end_plate::GAMMA_MU;
use crate::eurocode::bolts::shear_resistance;
use crate::eurocode::yielding::{in_shear, plastic};
use crate::formula::{Derivation, Formula, Number, Traced};
use crate::worked::Worked;
use bracket_joint::assembly::{SimpleJoint, SimpleKind};

/// The least of the parts in tension, with ultimate strengths and γ_Mu; `None` where the code has
/// no bearing resistance. Welds and the support are left out.
///
/// # Source
/// EN 1991-1-7:2006 A.5; Steel Buildings in Europe, Part 5, 2.3 and 3.3.
pub(super) fn tying(e: &SimpleJoint) -> Option<Check> {
    let parts = match e.kind {
        SimpleKind::FinPlate => fin_plate(e)?,
        SimpleKind::HeaderPlate => header_plate(e),
    };
    let least = parts.iter().map(Formula::traced).reduce(Number::min)?;
    let (clause, id) = ("EN 1991-1-7:2006 A.5, Steel Buildings in Europe 5", CheckId::Tying);
    let lines = parts.into_iter().map(Into::into).collect();
    let worked = Worked::of(clause, id, "N_Rd,u", least, Unit::Force).after(Derivation { lines });
    Some(worked.information(Topic::Member, plate(e).part))
}

fn force(symbol: &'static str, of: Traced) -> Formula {
    Formula::new(symbol, of, Unit::Force)
}

fn gamma() -> Traced {
    Traced::number("γ_Mu", GAMMA_MU)
}

/// Bolts in shear, then bearing, net section and block tearing of plate and web.
fn fin_plate(e: &SimpleJoint) -> Option<Vec<Formula>> {
    let hole = hole(e)?;
    let all = || Traced::number("n", bolts(e));
    let one = shear_resistance(&e.bolt, &e.grade, GAMMA_MU);
    let mut out = vec![force("F_v,u", all() * one.traced())];
    let ultimate = |ply: &Ply<'_>, symbols: [&'static str; 3]| {
        // the same formula with γ_Mu in place of γ_M2
        let ratio = Traced::number("γ_M2", e.factors.gamma_m2) / gamma();
        let bearing = all() * ply.along(e, hole).traced() * ratio;
        let section = ply.section(e, 1.0);
        let height = (section.height - section.holes as f64 * e.hole).max(0.0);
        let net = Traced::area("A_net", height * ply.thickness);
        let net =
            plastic(Traced::from(0.9) * net, Traced::stress("f_u", ply.steel.fu.mpa()), gamma());
        let faces = along(e, ply);
        let area = |length: f64| length.max(0.0) * ply.thickness;
        let pulled = Traced::area("A_nt", area(faces.tension));
        let sheared = Traced::area("A_nv", area(faces.shear));
        let pulled = plastic(pulled, Traced::stress("f_u", ply.steel.fu.mpa()), gamma());
        let f_y = Traced::stress("f_y", ply.steel.fy.mpa());
        let block = pulled + in_shear(sheared * f_y, Traced::number("γ_M0", e.factors.gamma_m0));
        let [b, n, t] = symbols;
        [force(b, bearing), force(n, net), force(t, block)]
    };
    out.extend(ultimate(&plate(e), ["F_b,p,u", "F_n,p,u", "F_eff,p,u"]));
    out.extend(ultimate(&web(e), ["F_b,w,u", "F_n,w,u", "F_eff,w,u"]));
    Some(out)
}

/// The T-stub of the plate, and the web of the beam over its height.
fn header_plate(e: &SimpleJoint) -> Vec<Formula> {
    let stub = stub(e, e.plate_steel.fu.mpa(), [GAMMA_MU; 2]).resistance();
    let web = plastic(
        Traced::length("h_p", e.height()) * Traced::length("t_w", e.beam.tw),
        Traced::stress("f_u", e.beam_steel.fu.mpa()),
        gamma(),
    );
    vec![force("F_T,u", stub.worked.traced()), force("F_t,w,u", web)]
}
