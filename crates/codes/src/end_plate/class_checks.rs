//! Classes of the joint by strength and stiffness under each load case, and its stiffness under the
//! moment. They are information, because they only determine how the frame is modelled.

use super::column_forces::columns;
use super::member_end::MemberEnd;
use crate::check::{Check, CheckId, Topic, Unit, number as n, within};
use crate::classification::{STIFF_COLUMNS, StiffnessLimits, stiffness_limits, strength_class};
use crate::component_method::stiffness::at_moment;
use crate::eurocode::yielding::plastic;
use crate::formula::{Derivation, Formula, Line, Number, Relation, Traced};
use crate::subject::{Frame, Place};
use crate::worked::Worked;
use bracket_base::say;
use bracket_joint::assembly::EndPlate;

/// Clause of the classes by stiffness.
const STIFFNESS: &str = "EN 1993-1-8:2005 5.2.2.5(1)";

/// All classes for a member end under a load case, whatever acts beside the moment.
pub(super) fn classes(end: &MemberEnd<'_>) -> Vec<Check> {
    let mut out = vec![strength(end)];
    out.extend(stiffness(end));
    if end.e.column.is_some() {
        out.extend(stiffness_classes(end));
    }
    out
}

/// Class by strength.
///
/// # Source
/// EN 1993-1-8:2005 5.2.3.
fn strength(end: &MemberEnd<'_>) -> Check {
    let e = end.e;
    let joint = end.assessment.moment.value;
    let beam = plastic(1e3 * e.beam.w_pl_y, e.beam_steel.fy.mpa(), e.factors.gamma_m0);
    let column = e.column.as_ref().map_or(f64::INFINITY, |c| {
        plastic(1e3 * c.section.w_pl_y, c.steel.fy.mpa(), e.factors.gamma_m0)
    });
    // a column that ends on both sides is one piece, no more than one column
    let count = e.column.as_ref().map_or(1, |c| columns(c).max(1));
    let class = strength_class(joint, beam, column, count);
    let moment = |symbol: &'static str, value| Traced::symbol(symbol, value, Unit::Moment);
    let mut full = moment("M_b,pl,Rd", beam);
    if e.column.is_some() {
        full = full.min(Traced::from(f64::from(count)) * moment("M_c,pl,Rd", column));
    }
    let full = Formula::new("M_full", full, Unit::Moment);
    let share = moment("M_j,Rd", joint) / full.traced();
    let words = Derivation::from(class.words())
        .then("full strength from M_full, pinned up to a quarter of it")
        .then(full);
    Worked::of("EN 1993-1-8:2005 5.2.3", CheckId::StrengthClass, "", share, Unit::Number)
        .after(words)
        .information(Topic::ComponentMethod, end.subject())
}

/// S_j at the moment of the case; `None` above M_j,Rd, up to which the formula holds.
fn stiffness(end: &MemberEnd<'_>) -> Option<Check> {
    let demand = end.a.at(1.0)[1][1].abs();
    let (initial, joint) = (end.assessment.stiffness.initial.value, end.assessment.moment.value);
    if !within(demand, joint) {
        return None;
    }
    let demand =
        Formula::new("M_j,Ed", Traced::symbol("M_j,Ed", demand, Unit::Moment), Unit::Moment);
    let worked = at_moment(initial, demand.value, joint).after(demand);
    Some(worked.information(Topic::Stiffness, end.subject()))
}

/// K_b/K_c of the beam and the column at the joint; the code uses the means over the storey.
fn slender_columns(e: &EndPlate) -> Option<Formula> {
    let column = e.column.as_ref()?;
    let of = |symbols: [&'static str; 2], i: f64, length: f64| {
        Traced::number(symbols[0], 1e4 * i) / Traced::length(symbols[1], length)
    };
    let beam = of(["I_b", "L_b"], e.beam.i_y, e.system_length?);
    let column = of(["I_c", "L_c"], column.section.i_y, column.system_length?);
    Some(Formula::new("K_b/K_c", beam / column, Unit::Number))
}

/// Limits of the classes by stiffness in a kind of frame; `None` if the length of the beam is not
/// known.
fn limits(e: &EndPlate, frame: Frame) -> Option<StiffnessLimits> {
    let stiff = slender_columns(e).is_some_and(|r| !within(STIFF_COLUMNS, r.value));
    let inertia = 1e4 * e.beam.i_y;
    let of = |length| stiffness_limits(frame, stiff, e.beam_steel.e, inertia, length);
    e.system_length.map(of)
}

/// Limits of the classes by stiffness of a beam of known length: their factor of E I_b/L_b, and the
/// stiffness \[N mm/rad\]. Empty without a column or a length.
///
/// # Source
/// EN 1993-1-8:2005 5.2.2.5(1), Figure 5.4.
pub fn stiffness_class_limits(e: &EndPlate) -> Vec<(f64, f64)> {
    let of = |frame: Frame| limits(e, frame).filter(|_| e.column.is_some());
    let (Some(braced), Some(unbraced)) = (of(Frame::Braced), of(Frame::Unbraced)) else {
        return Vec::new();
    };
    [
        (Frame::Braced.factor(), braced.rigid.value),
        (Frame::Unbraced.factor(), unbraced.rigid.value),
        (0.5, braced.pinned.value),
    ]
    .into_iter()
    .filter(|(_, s)| s.is_finite())
    .collect()
}

/// The class for both kinds of frame where the length of the beam is known, otherwise the length
/// from which the joint is rigid.
///
/// # Source
/// EN 1993-1-8:2005 5.2.2.5(1), Figure 5.4.
fn stiffness_classes(end: &MemberEnd<'_>) -> Vec<Check> {
    let e = end.e;
    let initial = end.assessment.stiffness.initial.value;
    let inertia = 1e4 * e.beam.i_y;
    let storey = match slender_columns(e) {
        Some(ratio) => Derivation::from(ratio)
            .then("for this beam and column, the code takes the means of the storey")
            .then(say!("rigid from {}", n(STIFF_COLUMNS))),
        None => say!(
            "where K_b/K_c < {} in the storey it is semi-rigid however stiff",
            n(STIFF_COLUMNS)
        )
        .into(),
    };
    let each = [(Frame::Braced, Derivation::default()), (Frame::Unbraced, storey)];
    let class = |(frame, note): (Frame, Derivation)| {
        let place = end.subject().and(Place::Frame(frame));
        let stiffness = Traced::symbol("S_j,ini", initial, Unit::Rotational);
        let Some(limits) = limits(e, frame) else {
            let (k_b, young) = (frame.factor(), Traced::stress("E", e.beam_steel.e));
            let bending = Traced::number("k_b", k_b) * young * Traced::number("I_b", inertia);
            let id = CheckId::RigidLength;
            let mut worked = Worked::of(STIFFNESS, id, "L_b", bending / stiffness, Unit::Length);
            worked.derivation = worked.derivation.followed_by(note);
            return worked.information(Topic::Stiffness, place);
        };
        let derivation = Derivation::from(limits.class(initial).words())
            .followed_by(beside_limits(initial, &limits))
            .followed_by(note);
        Worked::of(STIFFNESS, CheckId::StiffnessClass, "S_j,ini", stiffness, Unit::Rotational)
            .after(derivation)
            .information(Topic::Stiffness, place)
    };
    each.into_iter().map(class).collect()
}

/// An initial stiffness \[N mm/rad\] beside the limits of the classes.
fn beside_limits(initial: f64, limits: &StiffnessLimits) -> Derivation {
    let rigid =
        if within(limits.rigid.value, initial) { Relation::AtLeast } else { Relation::Below };
    let pinned =
        if within(initial, limits.pinned.value) { Relation::AtMost } else { Relation::Above };
    let line = |limit: &Worked, relation: Relation| match limit.derivation.formulas().last() {
        Some(limit) if limit.value.is_finite() => Line::Comparison {
            symbol: "S_j,ini".into(),
            value: initial,
            relation,
            limit: limit.clone(),
        },
        _ => "no joint is rigid where K_b/K_c < 0.1".into(),
    };
    Derivation::from(line(&limits.rigid, rigid)).then(line(&limits.pinned, pinned))
}
