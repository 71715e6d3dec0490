//! Stiffness of the ground under a base, and initial stiffness of the base.

use super::case_end::at;
use super::compression::{IBase, flange_area, whole_area, z_c};
use super::forces::{Force, Forces};
use crate::check::{Check, CheckId, Topic, Unit};
use crate::component_method::t_stub::Prying;
use crate::eurocode::concrete::e_cm;
use crate::formula::{Formula, Number, Traced};
use crate::subject::Part;
use crate::worked::Worked;
use bracket_joint::assembly::{ColumnBase, PlaneActions};

/// Pressure per settlement of the concrete under a base \[N/mm³\]: that of the spring k_13 over its
/// area, `E_c / (1.275 √A)`. A is the area under one flange, the mean of both on an eccentric
/// plate, and half of the whole area under a hollow section.
///
/// # Source
/// EN 1993-1-8:2005 6.3.4 with Table 6.11: k_13 = E_c √(b_eff l_eff)/(1.275 E).
pub(crate) fn ground_stiffness(e: &ColumnBase) -> f64 {
    let area = match IBase::of(e) {
        Some(i) => 0.5 * (flange_area(&i, 1.0) + flange_area(&i, -1.0)),
        None => 0.5 * whole_area(e),
    };
    e_cm(e.foundation.f_ck.mpa()) / (K_13 * area.sqrt())
}

/// Divisor of k_13, EN 1993-1-8:2005 Table 6.11.
const K_13: f64 = 1.275;

/// The spring of one side of a base.
struct Spring {
    /// Lines that lead to its stiffness, the stiffness last.
    lines: Vec<Formula>,
    /// Its stiffness coefficient.
    k: Formula,
    /// Its distance from the axis of the column.
    z: Traced,
}

/// The spring of a side; `second`: the names differ from those of a spring of the same kind.
fn spring(e: &IBase<'_>, side: f64, force: &Force, second: bool) -> Spring {
    let num = Traced::from;
    let modulus = || Traced::stress("E", e.plate_steel.e);
    let length = |symbol: &'static str, value| Traced::length(symbol, value);
    let named = |symbol: &'static str, of: Traced| Formula::new(symbol, of, Unit::Length);
    let pick = |names: [&'static str; 2]| names[usize::from(second)];
    match force {
        Force::Compression(_) => {
            let e_c = e_cm(Traced::stress("f_ck", e.foundation.f_ck.mpa()));
            let e_c = Formula::new("E_c", e_c, Unit::Stress);
            let area = Traced::area("b_eff l_eff", flange_area(e, side)).sqrt();
            let k13 = e_c.traced() * area / (num(K_13) * modulus());
            let k13 = named(pick(["k_13", "k_13,o"]), k13);
            let lines = if second { vec![k13.clone()] } else { vec![e_c, k13.clone()] };
            Spring { lines, k: k13, z: length("z_C", z_c(e)) }
        }
        Force::Tension(row, _) => {
            let (of_plate, of_anchor) = match row.prying {
                Prying::Develops | Prying::BoltsOnly => (0.85, 1.6),
                Prying::Absent => (0.425, 2.0),
            };
            let k15 =
                num(of_plate) * length("ℓ_eff", row.length) * length("t", e.thickness).powi(3)
                    / length("m", row.m).powi(3);
            let k15 = named(pick(["k_15", "k_15,o"]), k15);
            let k16 = num(of_anchor) * Traced::area("A_s", e.bolt.stress_area)
                / length("L_b", e.elastic_length);
            let k16 = named(pick(["k_16", "k_16,o"]), k16);
            let k_t = num(1.0) / (num(1.0) / k15.traced() + num(1.0) / k16.traced());
            let k_t = named(pick(["k_T", "k_T,o"]), k_t);
            let z = length(pick(["z_T", "z_T,o"]), row.z);
            Spring { lines: vec![k15, k16, k_t.clone()], k: k_t, z }
        }
    }
}

/// S_j,ini under the moment of a case, and the length of the column from which it is rigid.
///
/// # Source
/// EN 1993-1-8:2005 Tables 6.11 and 6.12, μ = 1, its four rows of one kind: two springs, and the
/// moment about the centre of their stiffness; 5.2.2.5(2): S_j,ini ≥ 30 E I_c/L_c. The milder
/// limits of frames held by bracing need the slenderness of the column.
pub(super) fn checks(e: &IBase<'_>, a: &PlaneActions, forces: &Forces) -> Vec<Check> {
    let [(side, first), (other, second)] = &forces[..] else { return Vec::new() };
    let alike = std::mem::discriminant(first) == std::mem::discriminant(second);
    let [[n, ..], [_, m, _]] = a.at(1.0);
    let num = Traced::from;
    let modulus = || Traced::stress("E", e.plate_steel.e);
    let (near, far) = (spring(e, *side, first, false), spring(e, *other, second, alike));
    let (k, k_o) = (|| near.k.traced(), || far.k.traced());
    let (z, z_o) = (|| near.z.clone(), || far.z.clone());
    let e_k = Formula::new("e_k", (z_o() * k_o() - z() * k()) / (k() + k_o()), Unit::Length);
    let left = m.abs() + n * e_k.value;
    if m == 0.0 || left <= 0.0 {
        return Vec::new();
    }
    let moment = || Traced::symbol("M_Ed", m.abs(), Unit::Moment);
    let flexible = num(1.0) / k() + num(1.0) / k_o();
    let whole = modulus() * (z() + z_o()).powi(2) / flexible;
    let share = moment() / (moment() + Traced::force("N_Ed", n) * e_k.traced());
    let value = whole * share;
    let (clause, id) = ("EN 1993-1-8:2005 Table 6.12", CheckId::InitialStiffness);
    let lines = near.lines.into_iter().chain(far.lines).chain([e_k]);
    let before = lines.fold(crate::formula::Derivation::default(), |d, f| d.then(f));
    let stiffness = Worked::of(clause, id, "S_j,ini", value, Unit::Rotational).after(before);
    let inertia = Traced::number("I_c", 1e4 * e.profile.i_y);
    let rigid = num(30.0) * modulus() * inertia / stiffness.traced();
    let (clause, id) = ("EN 1993-1-8:2005 5.2.2.5(2)", CheckId::BaseRigidLength);
    let rigid = Worked::of(clause, id, "L_c", rigid, Unit::Length);
    let subject = || at(a).and(Part::Joint);
    [stiffness, rigid].map(|w| w.information(Topic::Stiffness, subject())).into()
}
