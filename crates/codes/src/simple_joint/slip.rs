//! Slip of preloaded bolts of a simple joint, and the kind of its holes.

use super::actions::moment;
use super::plies::{bolt_shear, bolts, group, hole, least_bearing};
use crate::check::{Check, Unit};
use crate::end_plate::{Preloaded, kind_of_holes};
use crate::formula::{Formula, Traced};
use crate::subject::Subject;
use bracket_joint::assembly::{PlaneActions, SimpleJoint, SimpleKind};

fn preloaded(e: &SimpleJoint) -> Preloaded<'_> {
    Preloaded {
        bolt: &e.bolt,
        grade: &e.grade,
        hole: e.hole,
        preload: e.preload,
        category: e.category,
        mu: e.mu,
        factors: &e.factors,
    }
}

/// Kind of the holes, preloaded assemblies, and the load cases that a category requires.
pub(super) fn assembly(e: &SimpleJoint) -> Vec<Check> {
    let of_all = [bolt_shear(e, [0.0, -1.0]).value, least_bearing(e)].map(|f| bolts(e) * f);
    let kind = hole(e).and_then(|hole| kind_of_holes(&e.bolt, e.hole, hole, Some(of_all)));
    let mut out: Vec<Check> = kind.into_iter().collect();
    out.extend(preloaded(e).assembly(e.actions.iter().map(|a| a.state)));
    out
}

/// Slip of the most loaded bolt, elastic in the plane of a fin plate; a tension of a header plate
/// is shared by its bolts.
pub(super) fn slip(e: &SimpleJoint, a: &PlaneActions) -> Option<Check> {
    let [axial, vy, vz] = a.at(1.0)[0];
    let (tension, shear) = match e.kind {
        SimpleKind::FinPlate => {
            let centre = e.rows.iter().sum::<f64>() / e.rows.len().max(1) as f64;
            let m = moment(e, a, [e.centre(), centre]).value;
            let worst = group(e).most_loaded([axial, vz, m], |[x, z]| x.hypot(z))?;
            (0.0, worst.resultant())
        }
        SimpleKind::HeaderPlate => {
            let n = bolts(e);
            let shear = Traced::force("V_Ed", vy.hypot(vz)) / Traced::number("n_b", n);
            (axial.max(0.0) / n, Formula::new("", shear, Unit::Force))
        }
    };
    preloaded(e).slip(a.state, Subject::end(&a.end), (1, tension), shear.into())
}
