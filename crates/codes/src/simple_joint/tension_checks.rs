//! A fin plate and the web of its beam under an axial tension, alone and with the shear force.

use super::actions::moment;
use super::plies::{Ply, first, last, plate, web};
use super::shear_resistances::{Faces, faces};
use crate::check::{Check, CheckId, Status, Topic, Unit};
use crate::eurocode::block_tearing::Blocks;
use crate::formula::{Number, Traced};
use crate::subject::Subject;
use crate::worked::Worked;
use bracket_joint::assembly::{PlaneActions, SimpleJoint};

/// Checks of plate and web in tension.
///
/// Sections in tension and shear follow von Mises with both forces over the whole section. Blocks
/// have no rule for two forces; their utilisations are added, on the safe side.
///
/// # Source
/// EN 1993-1-1:2005 6.2.3(2), 6.2.1(5); EN 1993-1-8:2005 3.10.2.
pub(super) fn checks(e: &SimpleJoint, a: &PlaneActions) -> Vec<Check> {
    let [axial, _, vz] = a.at(1.0)[0];
    if axial <= 0.0 {
        return Vec::new();
    }
    let centre = 0.5 * (first(&e.rows) + last(&e.rows));
    let concentric = vz == 0.0 && moment(e, a, [e.centre(), centre]).value == 0.0;
    let [p, w] = [plate(e), web(e)];
    let beside = faces(e, vz <= 0.0);
    let mut out = Vec::new();
    for (ply, face) in [(&p, &beside[0]), (&w, &beside[1])] {
        let tension = ply.section(e, 1.0).tension();
        let block = block_along(e, ply, concentric);
        let place = || Subject::end(&a.end).and(ply.part);
        let failed = Status::Failed;
        out.push(tension.clone().against(Topic::Member, place(), axial, failed));
        out.push(block.clone().against(Topic::Member, place(), axial, failed));
        if vz == 0.0 {
            continue;
        }
        let Faces { gross, net, block: torn } = face;
        let least = if net.value < gross.value { net } else { gross };
        let of =
            |force: &'static str, size: f64, r: &Worked| Traced::force(force, size) / r.traced();
        let n = |r: &Worked| of("N_Ed", axial, r);
        let v = |r: &Worked| of("V_Ed", vz.abs(), r);
        let together = n(&tension).powi(2) + v(least).powi(2);
        let (clause, id) = ("EN 1993-1-1:2005 6.2.1(5)", CheckId::ShearAndTension);
        let both = Worked::of(clause, id, "", together.sqrt(), Unit::Number);
        out.push(both.utilised(Topic::Member, place(), failed));
        let together = n(&block) + v(torn);
        let (clause, id) = ("EN 1993-1-8:2005 3.10.2", CheckId::BlockShearAndTension);
        let both = Worked::of(clause, id, "", together, Unit::Number);
        out.push(both.utilised(Topic::Member, place(), failed));
    }
    out
}

/// Block tearing along the beam \[N\]: the bolts tear out a block between the outermost rows.
///
/// # Source
/// EN 1993-1-8:2005 3.10.2(2), and (3) where the force on the group is eccentric.
fn block_along(e: &SimpleJoint, ply: &Ply<'_>, concentric: bool) -> Worked {
    let block = along(e, ply);
    let (m0, m2) = (e.factors.gamma_m0, e.factors.gamma_m2);
    if concentric { block.resistance(m0, m2) } else { block.eccentric(m0, m2) }
}

/// Faces of the block between the outermost rows: one in tension, two in shear.
pub(super) fn along(e: &SimpleJoint, ply: &Ply<'_>) -> Blocks {
    let height = first(&e.rows) - last(&e.rows);
    let tension = height - (e.rows.len() as f64 - 1.0) * e.hole;
    ply.blocks(1.0, tension, 2.0 * ply.edge_face(e).max(0.0))
}
