//! Classes of the joint by strength and stiffness under each load case, and its stiffness under the
//! moment. They are information, because they only determine how the frame is modelled.

use super::column_forces::columns;
use super::member_end::MemberEnd;
use crate::check::{Check, Topic, Unit, number as n, within};
use crate::classification::{
    Frame, STIFF_COLUMNS, StiffnessLimits, stiffness_limits, strength_class,
};
use crate::component_method::stiffness::at_moment;
use crate::eurocode::yielding::plastic;
use crate::worked::Worked;
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
    let beam = plastic(1e3 * e.beam.w_pl_y, e.beam_steel.fy, e.factors.gamma_m0);
    let column = e
        .column
        .as_ref()
        .map_or(f64::INFINITY, |c| plastic(1e3 * c.section.w_pl_y, c.steel.fy, e.factors.gamma_m0));
    // a column that ends on both sides is one piece, no more than one column
    let count = e.column.as_ref().map_or(1, |c| columns(c).max(1));
    let class = strength_class(joint, beam, column, count);
    let full = beam.min(f64::from(count) * column);
    let least = if column.is_finite() {
        format!(
            "min(M_b,pl,Rd, {count} M_c,pl,Rd) = min({}, {count} · {})",
            Unit::Moment.show(beam),
            Unit::Moment.show(column)
        )
    } else {
        format!("M_b,pl,Rd = {}", Unit::Moment.show(beam))
    };
    let formula = format!(
        "{}: M_j,Rd = {}, full strength from {least}, pinned up to a quarter of it; M_j,Rd/M_full",
        class.words(),
        Unit::Moment.show(joint)
    );
    Worked::new("EN 1993-1-8:2005 5.2.3", "class by strength", joint / full, Unit::Number, formula)
        .information(Topic::ComponentMethod, end.subject())
}

/// S_j at the moment of the case; `None` above M_j,Rd, up to which the formula holds.
fn stiffness(end: &MemberEnd<'_>) -> Option<Check> {
    let demand = end.a.at(1.0)[1][1].abs();
    let (initial, joint) = (end.assessment.stiffness.initial.value, end.assessment.moment.value);
    if !within(demand, joint) {
        return None;
    }
    let mut worked = at_moment(initial, demand, joint);
    worked.formula += &format!(" at M_j,Ed = {}", Unit::Moment.show(demand));
    Some(worked.information(Topic::Stiffness, end.subject()))
}

/// K_b/K_c of the beam and the column at the joint; the code uses the means over the storey.
fn slender_columns(e: &EndPlate) -> Option<f64> {
    let column = e.column.as_ref()?;
    let of = |i: f64, length: f64| 1e4 * i / length;
    Some(of(e.beam.i_y, e.system_length?) / of(column.section.i_y, column.system_length?))
}

/// Limits of the classes by stiffness in a kind of frame; `None` if the length of the beam is not
/// known.
fn limits(e: &EndPlate, frame: Frame) -> Option<StiffnessLimits> {
    let stiff = slender_columns(e).is_some_and(|r| !within(STIFF_COLUMNS, r));
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
        Some(r) => {
            format!(
                "K_b/K_c = {} of this beam and column, the code takes the means of the storey; \
                 rigid from {}",
                n(r),
                n(STIFF_COLUMNS)
            )
        }
        None => format!(
            "where K_b/K_c < {} in the storey it is semi-rigid however stiff",
            n(STIFF_COLUMNS)
        ),
    };
    let each = [
        (Frame::Braced, "braced frame", String::new()),
        (Frame::Unbraced, "other frames", format!("; {storey}")),
    ];
    let class = |(frame, words, note): (Frame, &'static str, String)| {
        let place = format!("{}, {words}", end.subject());
        let Some(limits) = limits(e, frame) else {
            let rigid = frame.factor() * e.beam_steel.e * inertia / initial;
            let formula = format!(
                "L_b ≥ k_b E I_b/S_j,ini = {} · {} · {}/{}",
                n(frame.factor()),
                n(e.beam_steel.e),
                n(inertia),
                Unit::Rotational.show(initial)
            );
            let title = "system length of the beam from which the joint is rigid";
            let mut worked = Worked::new(STIFFNESS, title, rigid, Unit::Length, formula);
            worked.formula += &note;
            return worked.information(Topic::Stiffness, place);
        };
        let rigid = match limits.rigid.value.is_finite() {
            true => limits.rigid.formula.clone(),
            false => "none, for K_b/K_c < 0.1".into(),
        };
        let formula = format!(
            "{}: rigid from {rigid}, pinned up to {}{note}; S_j,ini",
            limits.class(initial).words(),
            limits.pinned.formula
        );
        Worked::new(STIFFNESS, "class by stiffness", initial, Unit::Rotational, formula)
            .information(Topic::Stiffness, place)
    };
    each.into_iter().map(class).collect()
}
