//! Bolts of a fin plate as an elastic group, and the resistances of one bolt.

use super::actions::moment;
use super::plies::{Ply, bolt_shear, group, hole, plies};
use crate::check::{Check, CheckId, Status, Topic, Unit};
use crate::eurocode::bearing::Hole;
use crate::formula::{Formula, Number};
use crate::subject::{Part, Place, Subject};
use crate::worked::Worked;
use bracket_joint::assembly::{PlaneActions, SimpleJoint, SimpleKind};

/// Resistances of one bolt in shear, and in bearing of either ply, as information.
pub(super) fn resistances(e: &SimpleJoint) -> Vec<Check> {
    let thread = Subject::from(Place::bolt(&e.bolt, &e.grade)).and(Place::Thread);
    let mut out = vec![bolt_shear(e, [0.0, -1.0]).information(Topic::Bolts, thread)];
    let Some(hole) = hole(e) else { return out };
    for ply in plies(e) {
        let part = Subject::from(ply.part);
        let vertical = part.clone().and(Place::VerticalForce);
        out.push(ply.vertical(e, hole).information(Topic::Bolts, vertical));
        if e.kind == SimpleKind::FinPlate {
            out.push(along(&ply, e, hole).information(Topic::Bolts, part));
        }
    }
    out
}

/// Bearing resistance of a ply along the beam, with its own title.
fn along(ply: &Ply<'_>, e: &SimpleJoint, hole: Hole) -> Worked {
    Worked { id: CheckId::BearingAlong, ..ply.along(e, hole) }
}

/// N, V and the moment about the centre of the group, with its formula \[N, N mm\].
fn on_group(e: &SimpleJoint, a: &PlaneActions) -> ([f64; 3], Formula) {
    let [axial, _, vz] = a.at(1.0)[0];
    let centre = e.rows.iter().sum::<f64>() / e.rows.len().max(1) as f64;
    let m = Formula { symbol: "M".into(), ..moment(e, a, [e.centre(), centre]) };
    ([axial, vz, m.value], m)
}

/// Shear of the most loaded bolt of a fin plate, and bearing of either ply at the bolt that loads
/// it most.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4, 3.8, 3.12; the components of bearing as in Steel Buildings in
/// Europe, Part 5, 3.2.1.
pub(super) fn in_group(e: &SimpleJoint, a: &PlaneActions) -> Vec<Check> {
    let (forces, m) = on_group(e, a);
    let [axial, vz, _] = forces;
    if forces == [0.0; 3] {
        return Vec::new();
    }
    let bolts = group(e);
    let place = |part: Part| Subject::end(&a.end).and(part);
    let mut out = Vec::new();
    if let Some(worst) = bolts.most_loaded(forces, |[x, z]| x.hypot(z)) {
        let resistance = bolt_shear(e, [axial, vz]);
        let demand = worst.resultant();
        let shear = demand.value;
        let mut worked = resistance.after(demand).after(worst.upwards).after(worst.along);
        if m.value != 0.0 {
            worked = worked.after(m.clone());
        }
        worked.id = CheckId::BoltInGroup;
        out.push(worked.against(Topic::Bolts, place(Part::Bolts), shear, Status::Failed));
    }
    let Some(hole) = hole(e) else { return out };
    for ply in plies(e) {
        let (upright, along) = (ply.vertical(e, hole), ply.along(e, hole));
        let named = |w: &Worked, symbol: &'static str| {
            let last = w.derivation.formulas().last().cloned();
            last.map(|f| Formula { symbol: symbol.into(), ..f })
        };
        let [ver, hor] = [named(&upright, "F_b,ver,Rd"), named(&along, "F_b,hor,Rd")];
        let (Some(ver), Some(hor)) = (ver, hor) else { continue };
        let measure = |[x, z]: [f64; 2]| (x / hor.value).hypot(z / ver.value);
        let Some(worst) = bolts.most_loaded(forces, measure) else { continue };
        let [x, z] = [worst.along.traced(), worst.upwards.traced()];
        let used = (z / ver.traced()).powi(2) + (x / hor.traced()).powi(2);
        let (clause, id) = ("EN 1993-1-8:2005 Table 3.4", CheckId::BearingInGroup);
        let mut worked = Worked::of(clause, id, "", used.sqrt(), Unit::Number)
            .after(worst.upwards)
            .after(worst.along)
            .after(hor)
            .after(ver);
        if m.value != 0.0 {
            worked = worked.after(m.clone());
        }
        out.push(worked.utilised(Topic::Bolts, place(ply.part), Status::Failed));
    }
    out
}
