//! What lies outside the rules: parts, steels, holes, loads that the checks leave out, annexes.

use super::plies::{plate, support_part};
use crate::check::Check;
use crate::end_plate::{Piece, beyond, not_checked, of_any_joint, unseen_loads};
use crate::subject::Part;
use bracket_joint::assembly::{SimpleJoint, SimpleKind};

/// All of them.
pub(super) fn checks(e: &SimpleJoint) -> Vec<Check> {
    let piece = |part, thickness, steel, welded| Piece { part, thickness, steel, welded };
    let header = e.kind == SimpleKind::HeaderPlate;
    let (to, thickness) = (support_part(e), e.support.thickness());
    let parts = [
        piece(plate(e).part, e.thickness, &e.plate_steel, true),
        piece(Part::BeamWeb, e.beam.tw, &e.beam_steel, header),
        piece(to, thickness, &e.support.steel, !header),
    ];
    let mut out = beyond(&parts, &e.bolt, &e.grade, e.hole);
    let beside = if header { e.beam.tw } else { thickness };
    let weld = (plate(e).part, e.throat, e.thickness.max(beside));
    out.extend(of_any_joint(e.annex.as_deref(), e.fy_source, &e.grade, &[weld]));
    out.extend(unseen_loads(&e.unseen));
    out.extend(not_checked(&e.not_checked));
    out
}
