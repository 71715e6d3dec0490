//! The tension side of a base: one row of anchors outside a flange, as a T-stub of the plate.

use super::compression::IBase;
use crate::check::{CheckId, Unit, within};
use crate::component_method::effective_lengths::outside_flange;
use crate::component_method::t_stub::{Prying, Resistance, TStub, prying};
use crate::eurocode::bolts::tension_resistance;
use crate::formula::{Formula, Line, Number, Relation, Traced};
use crate::worked::Worked;

/// Share of a fillet weld that counts against m, EN 1993-1-8:2005 6.2.4.1, Figure 6.2.
const OF_WELD: f64 = 0.8;
/// Anchors of a row of Table 6.6.
const IN_A_ROW: usize = 2;

/// A row of anchors outside a flange with its T-stub. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TensionSide {
    /// Distance z_T of the row from the axis of the column.
    pub z: f64,
    /// m from the row to the weld of the flange.
    pub m: f64,
    /// ℓ_eff,1.
    pub length: f64,
    /// Whether prying forces develop.
    pub prying: Prying,
    /// Resistance of the T-stub.
    pub stub: Resistance,
    /// F_T,Rd, the least of plate, anchors and flange of the column \[N\].
    pub resistance: Worked,
}

/// The tension side at positive x (`side` 1) or negative x (−1); why there is none in the code's
/// tables otherwise.
///
/// # Source
/// EN 1993-1-8:2005 6.2.8.3(2), 6.2.6.11, 6.2.6.12: Table 6.6, row outside the flange; Table 6.2
/// with L_b* for prying, which by 6.2.6.11(2) counts for the anchors and not for the plate. Rows
/// between the flanges are not counted.
pub(super) fn tension_side(e: &IBase<'_>, side: f64) -> Result<TensionSide, &'static str> {
    let p = e.profile;
    let face = 0.5 * p.h;
    let outside: Vec<f64> = e.rows.iter().map(|x| side * x).filter(|x| *x > face).collect();
    let x = match outside[..] {
        [x] => x,
        [] => return Err("there is no row of anchors outside the flange on the side in tension"),
        _ => return Err("more than one row of anchors outside a flange: Table 6.6 has one"),
    };
    let [first, .., last] = e.across[..] else {
        return Err("a row of one anchor: Table 6.6 has rows of two");
    };
    if e.across.len() != IN_A_ROW {
        return Err("a row of more than two anchors: Table 6.6 has rows of two");
    }
    let m = x - face - OF_WELD * e.flange_throat * 2f64.sqrt();
    let (ex, w) = (e.to_edge(side) - x, last - first);
    let edge = (0.5 * e.plate[1] - last).min(0.5 * e.plate[1] + first);
    if [m, ex, w, edge].iter().any(|l| *l <= 0.0) {
        return Err("anchors in the weld of the flange or beyond the edge of the plate");
    }
    let lengths = outside_flange(m, ex, edge, w, e.plate[1]);
    let (a_s, length) = (e.bolt.stress_area, lengths.mode1());
    let pries = prying(e.elastic_length, m, a_s, 1, length, e.thickness);
    let anchor = tension_resistance(&e.bolt, &e.grade, e.factors.gamma_m2);
    let stub = TStub {
        m,
        n: ex.min(1.25 * m),
        thickness: e.thickness,
        fy: e.plate_steel.fy.mpa(),
        length1: length,
        length2: lengths.mode2(),
        bolts: IN_A_ROW as f64 * anchor.value,
        gamma_m0: e.factors.gamma_m0,
        prying: match pries {
            Prying::Absent => Prying::Absent,
            Prying::Develops | Prying::BoltsOnly => Prying::BoltsOnly,
        },
        washer_quarter: None,
    };
    let stub = stub.resistance();
    let resistance = least(e, &stub, pries, [m, length]);
    Ok(TensionSide { z: x, m, length, prying: pries, stub, resistance })
}

/// L_b beside L_b*, the T-stub, the flange of the column, and the smaller of these.
fn least(e: &IBase<'_>, stub: &Resistance, pries: Prying, [m, length]: [f64; 2]) -> Worked {
    let n = Traced::from;
    let limit = n(8.8) * Traced::length("m", m).powi(3) * Traced::area("A_s", e.bolt.stress_area)
        / (Traced::length("ℓ_eff,1", length) * Traced::length("t", e.thickness).powi(3));
    let relation = match pries {
        Prying::Develops | Prying::BoltsOnly => Relation::AtMost,
        Prying::Absent => Relation::Above,
    };
    let long = Line::comparison("L_b", e.elastic_length, relation, limit, Unit::Length);
    let p = e.profile;
    let flange = Traced::length("b", p.b)
        * Traced::length("t_f", p.tf)
        * Traced::stress("f_y", e.flange_steel.fy.mpa())
        / Traced::number("γ_M0", e.factors.gamma_m0);
    let flange = Formula::new("F_t,f,Rd", flange, Unit::Force);
    let mut worked = stub.worked.clone().after(long);
    worked.id = CheckId::BaseTension;
    worked.clause = "EN 1993-1-8:2005 6.2.8.3, 6.2.6.11, 6.2.6.12, Table 6.2";
    if within(worked.value, flange.value) {
        return worked;
    }
    let whole = worked.traced().min(flange.traced());
    worked.then(flange).becomes("F_T,Rd", whole)
}

/// Tension of one anchor under the force `force` of its row, prying included \[N\].
pub(super) fn of_anchor(side: &TensionSide, force: f64) -> f64 {
    let plate = side.stub.worked.value;
    let more = if plate > 0.0 { side.stub.bolts / plate } else { 1.0 };
    let more = if side.prying == Prying::Develops { more.max(1.0) } else { 1.0 };
    force * more / IN_A_ROW as f64
}
