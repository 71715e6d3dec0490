//! Shear of a base: friction of the compressed plate, and the anchors.

use super::case_end::at;
use crate::check::{Check, CheckId, Status, Topic, Unit, within};
use crate::eurocode::bearing::{Along, Bearing, Hole};
use crate::eurocode::bolts::tension_resistance;
use crate::eurocode::concrete::{ANCHOR_YIELD, f_vb_rd};
use crate::eurocode::holes::Clearance;
use crate::formula::{Formula, Traced};
use crate::subject::{Part, Place, Subject};
use crate::worked::Worked;
use bracket_base::say;
use bracket_joint::assembly::{ColumnBase, PlaneActions};

/// Clause of the shear of a base.
const CLAUSE: &str = "EN 1993-1-8:2005 6.2.2";

fn anchors(e: &ColumnBase) -> Subject {
    Subject::from(Part::Anchors).and(Place::bolt(&e.bolt, &e.grade))
}

/// Resistances of an anchor to tension and, where it carries shear, to shear.
pub(super) fn resistances(e: &ColumnBase) -> Vec<Check> {
    let tension = tension_resistance(&e.bolt, &e.grade, e.factors.gamma_m2);
    let mut out = vec![tension.information(Topic::Bolts, anchors(e))];
    if e.shear.anchors {
        out.extend(anchor(e).map(|w| w.information(Topic::Bolts, anchors(e))));
    }
    out
}

/// F_vb,Rd, the smaller of bearing and of the anchor itself \[N\]; `None` outside the range of
/// f_yb or of the holes.
///
/// # Source
/// EN 1993-1-8:2005 6.2.2(7), formula 6.2; Table 3.4 for the bearing.
fn anchor(e: &ColumnBase) -> Option<Worked> {
    let [low, high] = ANCHOR_YIELD;
    if !(within(low, e.grade.fyb) && within(e.grade.fyb, high)) {
        return None;
    }
    let hole = match Clearance::of(&e.bolt, e.hole) {
        Clearance::Normal => Hole::Normal,
        Clearance::Beyond => return None,
        _ => Hole::Oversize,
    };
    let (first, last) = (e.rows.first()?, e.rows.last()?);
    let (near, far) = (e.across.first()?, e.across.last()?);
    let half = 0.5 * e.plate[1];
    let p2 = e.across.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
    let pitch = e.rows.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
    let end = (e.to_edge(1.0) - last).min(e.to_edge(-1.0) + first);
    // the smaller of end and inner anchors: α_d = e1/(3 d0) or p1/(3 d0) − 1/4
    let bearing = |along| Bearing {
        along,
        e2: (half - far).min(half + near),
        p2,
        hole,
        d: e.bolt.d,
        d0: e.hole,
        thickness: e.thickness,
        fu: e.plate_steel.fu.mpa(),
        fub: e.grade.fub,
    };
    let of_end = bearing(Along::End { e1: end }).resistance(e.factors.gamma_m2);
    let of_inner = match pitch.is_finite() {
        true => bearing(Along::Inner { p1: pitch }).resistance(e.factors.gamma_m2),
        false => of_end.clone(),
    };
    let plate = if of_inner.value < of_end.value { of_inner } else { of_end };
    let [f_yb, f_ub] = [("f_yb", e.grade.fyb), ("f_ub", e.grade.fub)]
        .map(|(symbol, value)| Traced::stress(symbol, value));
    let a_s = Traced::area("A_s", e.bolt.stress_area);
    let own = f_vb_rd(f_yb, f_ub, a_s, Traced::number("γ_M2", e.factors.gamma_m2));
    let own = Formula::new("F_2,vb,Rd", own, Unit::Force);
    let id = CheckId::AnchorShear;
    let value = crate::formula::Number::min(plate.traced(), own.traced());
    let worked = Worked::of("EN 1993-1-8:2005 6.2.2(7)", id, "F_vb,Rd", value, Unit::Force);
    Some(worked.after(plate.derivation.then(own)))
}

/// F_f,Rd by friction, of the compression in the column.
///
/// # Source
/// EN 1993-1-8:2005 6.2.2(6), formula 6.1.
fn friction(e: &ColumnBase, a: &PlaneActions) -> Formula {
    let push = (-a.at(1.0)[0][0]).max(0.0);
    let c = Traced::number("C_f,d", e.foundation.friction);
    Formula::new("F_f,Rd", c * Traced::force("N_c,Ed", push), Unit::Force)
}

/// The shear force, the resultant of both directions \[N\].
fn demand(a: &PlaneActions) -> f64 {
    let [_, across, along] = a.at(1.0)[0];
    across.hypot(along)
}

/// Shear of one anchor, what friction leaves \[N\].
pub(super) fn of_anchor(e: &ColumnBase, a: &PlaneActions) -> f64 {
    let left = demand(a) - friction(e, a).value;
    match e.shear.anchors && e.anchors() > 0 {
        true => left.max(0.0) / e.anchors() as f64,
        false => 0.0,
    }
}

/// V against friction and anchors, and an anchor in shear and tension; `tension` of the most loaded
/// anchor \[N\].
///
/// # Source
/// EN 1993-1-8:2005 6.2.2(8), formula 6.3; the interaction is that of Table 3.4.
pub(super) fn checks(e: &ColumnBase, a: &PlaneActions, tension: f64) -> Vec<Check> {
    let v = demand(a);
    if v == 0.0 {
        return Vec::new();
    }
    let (topic, subject) = (Topic::Bolts, at(a).and(Part::BasePlate));
    let by_friction = friction(e, a);
    let id = CheckId::BaseShear;
    let only = Worked::of(CLAUSE, id, "F_v,Rd", by_friction.traced(), Unit::Force)
        .after(by_friction.clone());
    if within(v, by_friction.value) {
        return vec![only.against(topic, subject, v, Status::Failed)];
    }
    if e.shear.nib {
        let why = say!(
            "V_Ed = {} is more than friction carries, F_f,Rd = {}: the checks have no resistance \
             of a nib",
            Unit::Force.show(v),
            Unit::Force.show(by_friction.value)
        );
        let step = "a check of the nib and of the concrete before it by hand";
        return vec![Check::undecided(topic, subject, CLAUSE, id, why, step)];
    }
    if !e.shear.anchors {
        return vec![only.against(topic, subject, v, Status::Failed)];
    }
    if a.at(1.0)[0][1] != 0.0 {
        let why = say!(
            "V_Ed = {} is more than friction carries, F_f,Rd = {}, and acts across the column too: \
             the bearing of the anchors is known along its depth only",
            Unit::Force.show(v),
            Unit::Force.show(by_friction.value)
        );
        let step = "a check of the anchors in that direction by hand";
        return vec![Check::undecided(topic, subject, CLAUSE, id, why, step)];
    }
    let Some(one) = anchor(e) else {
        let why = "F_vb,Rd needs f_yb from 235 to 640 MPa and holes that are no wider than \
                   oversize";
        let step = "other anchors or holes, or washers that are welded to the plate";
        return vec![Check::undecided(topic, subject, CLAUSE, id, why, step)];
    };
    let count = Traced::number("n", e.anchors() as f64);
    let all = by_friction.traced() + count * one.traced();
    let worked = Worked::of(CLAUSE, id, "F_v,Rd", all, Unit::Force);
    let before = one.derivation.clone().then(by_friction);
    let mut out = vec![worked.after(before).against(topic, subject, v, Status::Failed)];
    if tension > 0.0 {
        let [f_t, f_v] = [("F_t,Ed", tension), ("F_v,Ed", of_anchor(e, a))]
            .map(|(symbol, value)| Traced::force(symbol, value));
        let pull = tension_resistance(&e.bolt, &e.grade, e.factors.gamma_m2);
        let used = f_v / one.traced() + f_t / (Traced::from(1.4) * pull.traced());
        let (clause, id) = ("EN 1993-1-8:2005 Table 3.4, 6.2.2(7)", CheckId::AnchorShearAndTension);
        let worked = Worked::of(clause, id, "", used, Unit::Number);
        let worked = worked.after(pull.derivation).after(one.derivation);
        out.push(worked.utilised(topic, at(a).and(Part::Anchors), Status::Failed));
    }
    out
}
