//! A header plate in tension: its T-stub, its bolts in shear and tension, the web of the beam.

use super::plies::{Ply, bolt_shear, bolts, plate, support};
use crate::check::{Check, CheckId, Status, Topic, Unit};
use crate::component_method::t_stub::{Prying, Resistance, TStub};
use crate::eurocode::bolts::tension_resistance;
use crate::eurocode::interaction::{Forces, utilisation};
use crate::eurocode::punching::{mean_diameter, punching_resistance};
use crate::eurocode::yielding::plastic;
use crate::formula::Traced;
use crate::subject::{Part, Subject};
use crate::worked::Worked;
use bracket_joint::assembly::{PlaneActions, SimpleJoint};
use std::f64::consts::{PI, SQRT_2};

/// Bolts of a row that a T-stub has: the two nearest to the web.
const IN_ROW: f64 = 2.0;

/// F_t,Rd of one bolt with the punching of the plies \[N\].
fn bolt_tension(e: &SimpleJoint, gamma: f64) -> f64 {
    let dm = mean_diameter(&e.bolt);
    let punching = |p: Ply<'_>| punching_resistance(dm, p.thickness, p.steel.fu.mpa(), gamma).value;
    let tension = tension_resistance(&e.bolt, &e.grade, gamma).value;
    [plate(e), support(e)].map(punching).into_iter().fold(tension, f64::min)
}

/// The T-stub of the plate over all rows, with the bolts nearest to the web; `strength` of the
/// plate \[MPa\], γ of the plate and of the bolts.
///
/// `m = (p_3 − t_w − 2 · 0.8 a √2)/2`, `n = min(e, 1.25 m)`, method 2 for mode 1. Every row has on
/// either side of it `min(2 m + 0.625 e, π m)`, at most half of the pitch, or e1 at an end.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 2.3.1; EN 1993-1-8:2005 Tables 6.2, 6.4 and 6.6.
pub(super) fn stub(e: &SimpleJoint, strength: f64, [plate_gamma, bolt_gamma]: [f64; 2]) -> TStub {
    let nearest = e.columns.iter().fold(f64::INFINITY, |n, y| n.min(y.abs()));
    let m = nearest - 0.5 * e.beam.tw - 0.8 * SQRT_2 * e.throat;
    let edge = 0.5 * e.width - nearest;
    let alone = (2.0 * m + 0.625 * edge).min(PI * m);
    let ends = 2.0 * alone.min(plate(e).e1);
    let between: f64 = e.rows.windows(2).map(|w| 2.0 * alone.min(0.5 * (w[0] - w[1]))).sum();
    let length = ends + between;
    TStub {
        m,
        n: edge.min(1.25 * m),
        thickness: e.thickness,
        fy: strength,
        length1: length,
        length2: length,
        bolts: IN_ROW * e.rows.len() as f64 * bolt_tension(e, bolt_gamma),
        gamma_m0: plate_gamma,
        prying: Prying::Develops,
        washer_quarter: Some(0.25 * e.bolt.washer_outer),
    }
}

/// Checks of a header plate under tension.
///
/// # Source
/// EN 1993-1-8:2005 Table 6.2, Table 3.4; EN 1993-1-1:2005 6.2.3(2).
pub(super) fn checks(e: &SimpleJoint, a: &PlaneActions) -> Vec<Check> {
    let [axial, _, vz] = a.at(1.0)[0];
    if axial <= 0.0 {
        return Vec::new();
    }
    let place = |part: Part| Subject::end(&a.end).and(part);
    let factors = &e.factors;
    let gammas = [factors.gamma_m0, factors.gamma_m2];
    let found = stub(e, e.plate_steel.fy.mpa(), gammas).resistance();
    let mut out = vec![
        found
            .worked
            .clone()
            .against(Topic::Member, place(Part::HeaderPlate), axial, Status::Failed)
            .of_strength(),
    ];
    out.push(shear_and_tension(e, &found, [axial, vz], place(Part::Bolts)));
    let web = plastic(
        Traced::length("h_p", e.height()) * Traced::length("t_w", e.beam.tw),
        Traced::stress("f_y", e.beam_steel.fy.mpa()),
        Traced::number("γ_M0", factors.gamma_m0),
    );
    let (clause, id) = ("EN 1993-1-8:2005 6.2.6.8", CheckId::BeamWebTension);
    let web = Worked::of(clause, id, "F_t,wb,Rd", web, Unit::Force);
    out.push(web.against(Topic::Member, place(Part::BeamWeb), axial, Status::Failed).of_strength());
    out
}

/// A bolt in shear and tension: its tension is that of the T-stub at its resistance, prying
/// included, in proportion to the axial force.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4, 3.11(1).
fn shear_and_tension(
    e: &SimpleJoint,
    found: &Resistance,
    [axial, vz]: [f64; 2],
    place: Subject,
) -> Check {
    let in_tension = IN_ROW * e.rows.len() as f64;
    let forces = Forces {
        shear: vz.abs() / bolts(e),
        tension: axial * found.bolts / found.worked.value / in_tension,
        shear_resistance: bolt_shear(e, [0.0, vz]).value,
        tension_resistance: bolt_tension(e, e.factors.gamma_m2),
    };
    utilisation(&forces).utilised(Topic::Bolts, place, Status::Failed)
}
