//! Fillet welds of a simple joint: of a fin plate to its support, of a header plate to the web.

use super::actions::{middle, moment};
use super::plies::support_part;
use crate::check::{Check, CheckId, Status, Topic};
use crate::end_plate::without_strength;
use crate::eurocode::plate_section::BENDING_BESIDE_SHEAR;
use crate::eurocode::welds::{
    PairForce, WeldedSteel, directional_pair, effective_run, full_strength_throat, least_size,
};
use crate::formula::{Formula, Number, Traced};
use crate::subject::{Part, Place, Subject};
use crate::unit::Unit;
use crate::worked::Worked;
use bracket_joint::assembly::{PlaneActions, SimpleJoint, SimpleKind};
use bracket_joint::strength::Strength;

/// The two welds and the piece between them.
struct Welds<'a> {
    /// The piece that stands on the other part.
    piece: Part,
    /// The other part.
    to: Part,
    /// Thickness of the piece \[mm\].
    thickness: f64,
    /// Steel of the piece.
    steel: &'a Strength,
    /// The weaker steel of the two.
    weaker: &'a Strength,
}

fn welds(e: &SimpleJoint) -> Welds<'_> {
    match e.kind {
        SimpleKind::FinPlate => Welds {
            piece: Part::FinPlate,
            to: support_part(e),
            thickness: e.thickness,
            steel: &e.plate_steel,
            weaker: e.plate_steel.weaker(&e.support.steel),
        },
        SimpleKind::HeaderPlate => Welds {
            piece: Part::BeamWeb,
            to: Part::HeaderPlate,
            thickness: e.beam.tw,
            steel: &e.beam_steel,
            weaker: e.beam_steel.weaker(&e.plate_steel),
        },
    }
}

/// l_eff of each of the two welds, over the height of the plate.
fn length(e: &SimpleJoint) -> Formula {
    effective_run(e.welds.ends, e.height(), e.throat)
}

/// Least sizes of the welds, the throat of full strength, and steels that give them no strength.
///
/// Full strength is a recommendation: the joint turns, and its welds shall not be its weakest part.
///
/// # Source
/// EN 1993-1-8:2005 4.5.1(2), 4.5.2(2), 4.5.3.2(6); Steel Buildings in Europe, Part 5, 2.2.6.
pub(super) fn sizes(e: &SimpleJoint) -> Vec<Check> {
    if e.throat == 0.0 {
        return Vec::new();
    }
    let w = welds(e);
    let mut out = least_size(w.piece, e.throat, length(e).value).to_vec();
    let Some(steel) = WeldedSteel::of(w.weaker, e.factors.gamma_m2) else {
        out.push(without_strength(w.piece, w.weaker));
        return out;
    };
    let full = full_strength_throat(w.thickness, w.steel.fy, e.factors.gamma_m0, &steel);
    let limit = full.derivation.formulas().last().map_or_else(|| full.traced(), Traced::from);
    let seam = Subject::from(Place::Seam { of: w.piece, to: w.to });
    let what = ("EN 1993-1-8:2005 4.5.3.2(6)", CheckId::WeldFullStrength);
    out.push(Check::at_least((Topic::Welds, seam), what, "a", limit, e.throat, Status::Warning));
    out
}

/// The welds under N, V and M by the directional method: an elastic distribution over their length.
/// A header plate brings the moment of its rotation as the factor 1.27 on V.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.2(6), 2.5(1); SCI AD 370 for the factor.
pub(super) fn under_load(e: &SimpleJoint, a: &PlaneActions) -> Option<Check> {
    let w = welds(e);
    let steel = WeldedSteel::of(w.weaker, e.factors.gamma_m2).filter(|_| e.throat > 0.0)?;
    let [axial, _, vz] = a.at(1.0)[0];
    let m = match e.kind {
        SimpleKind::FinPlate => Some(moment(e, a, [0.0, middle(e)])).filter(|m| m.value != 0.0),
        SimpleKind::HeaderPlate => None,
    };
    if axial == 0.0 && vz == 0.0 && m.is_none() {
        return None;
    }
    let run = length(e);
    let subject = Subject::end(&a.end).and(Place::Seam { of: w.piece, to: w.to });
    if run.value <= 0.0 {
        let (clause, id) = ("EN 1993-1-8:2005 4.5.1", CheckId::WeldDirectional);
        let value = Traced::from(f64::INFINITY);
        let worked = Worked::of(clause, id, "", value, Unit::Number).after(run);
        return Some(worked.utilised(Topic::Welds, subject, Status::Failed));
    }
    let l = || run.traced();
    let line = |symbol: &'static str, of: Traced| Formula::new(symbol, of, Unit::ForcePerLength);
    let mut normal = Traced::force("N_Ed", axial.abs()) / l();
    if let Some(m) = &m {
        normal = normal + Traced::from(6.0) * m.traced().abs() / l().powi(2);
    }
    let normal = line("n", normal);
    let shear = Traced::force("V_Ed", vz.abs()) / l();
    let along = line(
        "l",
        match e.kind {
            SimpleKind::FinPlate => shear,
            SimpleKind::HeaderPlate => Traced::from(BENDING_BESIDE_SHEAR) * shear,
        },
    );
    let force = PairForce { normal: normal.value, along: along.value, ..PairForce::default() };
    let mut worked =
        directional_pair(&force, w.thickness, e.throat, &steel).after(along).after(normal);
    worked = worked.after(run);
    if let Some(m) = m {
        worked = worked.after(m);
    }
    Some(worked.utilised(Topic::Welds, subject, Status::Failed))
}
