//! What the actions of the load cases ask of an end plate: moment and axial force, bolts in shear and tension, bearing, punching,
//! the column web panel, welds.
//!
//! The component method spreads the moment over its rows; a row takes the part of its resistance that the joint takes of its
//! own, prying included (`RowForce::bolt_force`). Shear goes to the bolts by what tension leaves of them, `1 − F_t,Ed/(1.4 F_t,Rd)`:
//! 1 for a bolt that no moment pulls, 0.4/1.4 for one at F_t,Rd, the two values of 6.2.2(2).

use super::case::{self, Case};
use super::comparison::{Comparison, Method};
use super::{
    Along, EndPlate, HandChecks, PureMoment, Sense, Status, Topic, Unit, Worked, assess, bearing, bearing_parts,
    bolt_tension, joint, mean_diameter, n, pitches, punching_resistance, shear_resistance, tension_resistance, welded,
};
use super::{beam_checks, slip_checks};
use crate::assembly::PlaneActions;
use crate::checks::check::Check;
use crate::checks::component_method::Assessment;
use crate::checks::component_method::assembly::moment_and_axial;
use crate::checks::eurocode::bolts::ShearPlane;
use crate::checks::eurocode::interaction::{self, Forces};
use crate::checks::eurocode::welds::{least_size, simplified};
use std::f64::consts::SQRT_2;

/// Part of the interaction formula of Table 3.4 that divides the tension.
const TENSION_PART: f64 = 1.4;

/// Transformation parameter β of a member end: `|1 − M_j,b2/M_j,b1| ≤ 2` with the moments at the node, that of the other beam in
/// the numerator; 1 where no other beam acts, 0 in a splice.
///
/// # Source
/// EN 1993-1-8:2005 5.3(8), formulas 5.4a and 5.4b. Moments in the members' own axes, so that equal ones of two beams balance.
pub(super) fn beta(e: &EndPlate, a: &PlaneActions) -> f64 {
    if e.column.is_none() {
        return 0.0;
    }
    let other: f64 = others(e, a).map(PlaneActions::moment_at_node).sum();
    let own = a.moment_at_node();
    match (own, other) {
        (_, 0.0) => 1.0,
        (0.0, _) => 2.0,
        _ => (1.0 - other / own).abs().min(2.0),
    }
}

pub(super) fn others<'a>(e: &'a EndPlate, a: &'a PlaneActions) -> impl Iterator<Item = &'a PlaneActions> {
    e.actions.iter().filter(|o| o.case == a.case && o.end != a.end)
}

/// Adds the checks of every load case and member end.
pub(super) fn checks(e: &EndPlate, out: &mut HandChecks) {
    for a in &e.actions {
        let [[_, vy, _], [torsion, _, mz]] = a.at(1.0);
        let place = format!("{}, {}", a.case, a.end);
        let left: Vec<&str> =
            [("T", torsion), ("Mz", mz)].into_iter().filter(|(_, v)| v.abs() > 1e-6).map(|(name, _)| name).collect();
        if !left.is_empty() {
            out.notes
                .push(format!("hand checks, {place}: {} left out, they have no formula for it", left.join(" and ")));
        }
        let mut alone: Vec<Check> = slip_checks::slip(e, a).into_iter().collect();
        if a.state.is_ultimate() {
            alone.extend(beam_checks::beam(e, a));
        }
        out.checks.extend(alone.into_iter().map(|c| c.of_case(&a.case)));
        let sense = Sense::of_moment(a.at(1.0)[1][1]);
        let side = match assess(&sense.of(&joint(e, beta(e, a)))) {
            Ok(assessment) => Side { e, a, sense, assessment },
            // why is told with the tables of this sense
            Err(_) => {
                out.notes.push(format!("hand checks, {place}: none, for the component method gives no bolt forces"));
                continue;
            }
        };
        let method = side.method();
        let share = method.share(a.at(1.0));
        let mut found = Vec::new();
        if a.state.is_ultimate() {
            found.push(side.moment(&method));
            let bolts = side.bolts(&method, share.value.min(1.0));
            found.extend(bolts.checks(e, a.at(1.0)[0][2].hypot(vy)));
            found.extend(side.panel());
            found.extend(side.welds());
            found.extend(case::checks(&Case { e, a, sense, assessment: &side.assessment, share: share.value }));
        }
        out.checks.extend(found.into_iter().map(|c| c.of_case(&a.case)));
        out.comparisons.push(Comparison::new(e, a, &method, &side.assessment));
        out.moments.extend(PureMoment::new(e, a, beta(e, a), &side.assessment));
    }
}

/// One member end under one load case.
struct Side<'a> {
    e: &'a EndPlate,
    a: &'a PlaneActions,
    sense: Sense,
    assessment: Assessment,
}

impl Side<'_> {
    fn subject(&self) -> String {
        format!("{}, {}", self.a.end, self.sense.words())
    }

    /// Resistances of the joint against moment and axial force, for the sense of bending of the case.
    fn method(&self) -> Method {
        let e = self.e;
        let plastic_axial = 1e2 * e.beam.area * e.beam_steel.fy / e.gamma_m0;
        let compressed = self.a.at(1.0)[0][0] < 0.0;
        // both flanges carry a push, as the lower one does under the moment; a panel is not sheared by it
        let push = || self.assessment.limits.iter().filter(|l| !l.title.contains("panel")).map(|l| 2.0 * l.value);
        let axial = if compressed { push().fold(plastic_axial, f64::min) } else { self.pull().min(plastic_axial) };
        Method {
            moment: self.assessment.moment.value,
            axial,
            plastic_axial,
            beta: beta(e, self.a),
            sense: self.sense.words(),
        }
    }

    /// N_j,Rd of tension \[N\]: the sum of the rows, each with the lesser of what either sense of bending gives it before
    /// compression and shear limit the sum.
    fn pull(&self) -> f64 {
        let other = if self.sense == Sense::Top { Sense::Bottom } else { Sense::Top };
        let turned = assess(&other.of(&joint(self.e, beta(self.e, self.a)))).map(|t| t.rows).unwrap_or_default();
        // z of the other sense is upside down
        let of = |z: f64| turned.iter().find(|r| (r.z + z).abs() < 1e-9).map(|r| r.grouped);
        let mine = self.assessment.rows.iter().map(|r| of(r.z).map_or(r.grouped, |g| g.min(r.grouped)));
        let only = turned.iter().filter(|t| self.assessment.rows.iter().all(|r| (r.z + t.z).abs() >= 1e-9));
        mine.sum::<f64>() + only.map(|t| t.grouped).sum::<f64>()
    }

    fn moment(&self, method: &Method) -> Check {
        let [force, moment] = self.a.at(1.0);
        let mut check = method.share([force, moment]);
        check.steps.push(step("M_j,Rd", method.moment, Unit::Moment));
        check.steps.push(step("N_j,Rd", method.axial, Unit::Force));
        if self.e.column.is_some() {
            check.steps.push(step("β", method.beta, Unit::Number));
        }
        check.utilised(Topic::ComponentMethod, self.subject(), Status::Warning)
    }

    /// Tension of the bolts of every row, where the joint uses the part `share` of its resistance.
    fn bolts(&self, method: &Method, share: f64) -> Bolts {
        let e = self.e;
        let axial = self.a.at(1.0)[0][0];
        let tension = tension_resistance(&e.bolt, &e.grade, false, e.gamma_m2).value;
        // a pull that counts opens the compressed side as well
        let pulled = axial > 0.0 && !method.small(axial);
        let rest = if pulled { bolt_tension(e) * (axial / method.axial).min(1.0) } else { 0.0 };
        let upside = if self.sense == Sense::Bottom { -1.0 } else { 1.0 };
        let rows = e.rows.iter().map(|&z| {
            let row = self.assessment.rows.iter().find(|r| (upside * r.z - z).abs() < 1e-9);
            (z, row.map_or(rest, |r| r.bolt_force(share)).min(tension))
        });
        let mut rows: Vec<(f64, f64)> = rows.collect();
        rows.sort_by(|a, b| b.0.total_cmp(&a.0));
        let shear = shear_resistance(&e.bolt, &e.grade, ShearPlane::Thread, 1.0, e.gamma_m2).value;
        Bolts { end: self.a.end.clone(), rows, tension, shear }
    }

    /// The web panel of the column, once a case: at the end with the larger moment.
    fn panel(&self) -> Option<Check> {
        let resistance = self.assessment.panel.clone()?;
        let own = self.a.at(1.0)[1][1];
        let mut other = 0.0;
        for o in others(self.e, self.a) {
            let m = o.at(1.0)[1][1];
            other += m;
            if m.abs() > own.abs() || (m.abs() == own.abs() && o.end < self.a.end) {
                return None;
            }
        }
        let lever = self.assessment.stiffness.lever;
        let demand = (own - other).abs() / lever;
        let mut check = resistance;
        check.title = "column web panel in shear, without what the shear of the column takes off";
        check.formula = format!(
            "V_wp,Ed = |M_b1 − M_b2|/z = |{} − {}|/{} = {}; {}",
            Unit::Moment.show(own),
            Unit::Moment.show(other),
            Unit::Length.show(lever),
            Unit::Force.show(demand),
            check.formula
        );
        check.clause = "EN 1993-1-8:2005 5.3(3), 6.2.6.1";
        Some(check.against(Topic::ComponentMethod, self.subject(), demand, Status::Warning))
    }

    /// Fillet welds: those of the flanges take moment and axial force, those of the web the shear force.
    fn welds(&self) -> Vec<Check> {
        let e = self.e;
        let (b, mut out) = (&e.beam, Vec::new());
        let Some(steel) = welded(e) else { return out };
        let [[axial, vy, vz], [_, my, _]] = self.a.at(1.0);
        if e.flange_throat > 0.0 {
            let subject = format!("{}, beam flange", self.a.end);
            let length = 2.0 * b.b - b.tw - 2.0 * b.r - 2.0 * SQRT_2 * e.flange_throat;
            let force = my.abs() / (b.h - b.tf) + 0.5 * axial.max(0.0);
            let mut worked = simplified(e.flange_throat, &steel).with("l_eff", length, Unit::Length);
            worked.formula = format!(
                "F_w,Ed = (|My|/(h − t_f) + N/2)/l_eff = ({} + {})/{}; {}",
                Unit::Force.show(my.abs() / (b.h - b.tf)),
                Unit::Force.show(0.5 * axial.max(0.0)),
                Unit::Length.show(length),
                worked.formula
            );
            out.push(worked.against(Topic::Welds, subject.clone(), force / length, Status::Failed));
            out.extend(least_size(&subject, e.flange_throat, b.b - 2.0 * e.flange_throat));
        }
        if e.web_throat > 0.0 {
            let subject = format!("{}, beam web", self.a.end);
            let length = b.h - 2.0 * (b.tf + b.r) - 2.0 * e.web_throat;
            let force = vz.hypot(vy);
            let mut worked = simplified(e.web_throat, &steel).with("l_eff", length, Unit::Length);
            worked.formula = format!(
                "F_w,Ed = V/(2 l_eff) = {}/(2 · {}); {}",
                Unit::Force.show(force),
                Unit::Length.show(length),
                worked.formula
            );
            out.push(worked.against(Topic::Welds, subject.clone(), 0.5 * force / length, Status::Failed));
            out.extend(least_size(&subject, e.web_throat, length));
        }
        out
    }
}

fn step(symbol: &str, value: f64, unit: Unit) -> super::Step {
    super::Step { symbol: symbol.into(), value, unit }
}

/// The bolts of an end plate with their tension.
struct Bolts {
    end: String,
    /// z of every row from the top and the tension of one of its bolts, prying included \[mm, N\].
    rows: Vec<(f64, f64)>,
    /// F_t,Rd.
    tension: f64,
    /// F_v,Rd, thread in the shear plane.
    shear: f64,
}

impl Bolts {
    /// What tension leaves of the shear resistance of a bolt.
    fn left(&self, tension: f64) -> f64 {
        1.0 - tension / (TENSION_PART * self.tension)
    }

    fn checks(&self, e: &EndPlate, shear: f64) -> Vec<Check> {
        let weights: f64 = self.rows.iter().map(|r| 2.0 * self.left(r.1)).sum();
        let of_row = |tension: f64| shear * self.left(tension) / weights;
        let place = |z: f64| format!("{}, row at z = {} mm", self.end, n(z));
        let mut out = vec![self.shear(weights, shear)];
        // by Table 3.4 each bolt on its own
        let forces = |&(z, tension): &(f64, f64)| {
            let f = Forces {
                shear: of_row(tension),
                tension,
                shear_resistance: self.shear,
                tension_resistance: self.tension,
            };
            (z, interaction::utilisation(&f))
        };
        if let Some((z, worked)) = worst(self.rows.iter().map(forces), |w| w.1.value) {
            out.push(worked.utilised(Topic::Bolts, place(z), Status::Failed));
        }
        let end = self.rows.len().saturating_sub(1);
        for (part, t, fu, width) in bearing_parts(e) {
            let rows = self.rows.iter().enumerate().map(|(i, &(z, tension))| {
                let inner = pitches(e).map(|[p1, _]| Along::Inner { p1 });
                // of the plate the end rows, whichever way the force points; the ends of the column are far
                let e1 = (e.top - z).min(z - e.bottom);
                let outer = (part == "end plate" && (i == 0 || i == end)).then_some(Along::End { e1 });
                let far = inner.is_none() && outer.is_none();
                let all = [inner, outer, far.then_some(Along::End { e1: 3.0 * e.hole })];
                let all = all.into_iter().flatten().map(|along| bearing(e, along, (t, fu, width)));
                let least = all.reduce(|a, b| if b.value < a.value { b } else { a });
                (z, of_row(tension), least)
            });
            let rows = rows.filter_map(|(z, force, worked)| Some((z, force, worked?)));
            if let Some((z, force, worked)) = worst(rows, |(_, force, w)| force / w.value) {
                out.push(worked.against(Topic::Bolts, format!("{part}, {}", place(z)), force, Status::Failed));
            }
            if let Some((z, tension)) = worst(self.rows.iter().copied(), |r| r.1) {
                let worked = punching_resistance(mean_diameter(&e.bolt), t, fu, e.gamma_m2);
                out.push(worked.against(Topic::Bolts, format!("{part}, {}", place(z)), tension, Status::Failed));
            }
        }
        out
    }

    /// The bolts together in shear, with what their tension leaves them.
    fn shear(&self, weights: f64, shear: f64) -> Check {
        let each = self.rows.iter().map(|(_, t)| format!("2 · {}", n(self.left(*t))));
        let formula = format!(
            "V_Rd = Σ (1 − F_t,Ed/(1.4 F_t,Rd)) F_v,Rd = ({}) · {}",
            each.collect::<Vec<_>>().join(" + "),
            Unit::Force.show(self.shear)
        );
        let title = "shear of all bolts, with what their tension leaves";
        let value = weights * self.shear;
        let mut worked = Worked::new("EN 1993-1-8:2005 6.2.2(2), Table 3.4", title, value, Unit::Force, formula);
        for (z, tension) in &self.rows {
            worked = worked.with(&format!("F_t,Ed of the row at z = {} mm", n(*z)), *tension, Unit::Force);
        }
        worked.against(Topic::Bolts, self.end.clone(), shear, Status::Failed)
    }
}

/// The one with the largest value.
fn worst<T>(of: impl Iterator<Item = T>, value: impl Fn(&T) -> f64) -> Option<T> {
    of.reduce(|a, b| if value(&b) > value(&a) { b } else { a })
}

impl Method {
    /// Utilisation of the joint under forces and moments of a member end.
    pub(super) fn share(&self, [force, moment]: [[f64; 3]; 2]) -> Worked {
        moment_and_axial([moment[1], self.moment], [force[0], self.axial], self.plastic_axial)
    }
}
