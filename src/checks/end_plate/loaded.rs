//! What the actions of the load cases ask of an end plate: moment and axial force, bolts in shear
//! and tension, bearing, punching, the column web panel, welds.
//!
//! The component method spreads the moment over its rows; a row takes the part of its resistance
//! that the joint takes of its own, prying included (`RowForce::bolt_force`), also where that is
//! more than it carries: no demand is clipped without a word. Beside an axial force that counts the
//! rows have the forces of the plastic equilibrium (`component_method::equilibrium`). Shear goes to
//! the bolts by what tension leaves of them, `1 − F_t,Ed/(1.4 F_t,Rd)`: 1 for a bolt that no moment
//! pulls, 0.4/1.4 for one at F_t,Rd, the two values of 6.2.2(2).

use super::case::{self, Case};
use super::comparison::{Comparison, Method};
use super::{
    Along, EndPlate, EndPlateJoint, HandChecks, PureMoment, Sense, Status, Topic, Unit, Worked,
    assess, beam_checks, bearing, bearing_parts, joint, mean_diameter, n, pitches,
    punching_resistance, shear_resistance, slip_checks, tension_resistance, weld_checks, welded,
};
use crate::assembly::PlaneActions;
use crate::checks::check::Check;
use crate::checks::component_method::assembly::RowForce;
use crate::checks::component_method::beam::plastic_shear;
use crate::checks::component_method::equilibrium::{Carried, RowPull};
use crate::checks::component_method::joint::Section;
use crate::checks::component_method::{Assessment, Equilibrium, Summed};
use crate::checks::eurocode::bolts::ShearPlane;
use crate::checks::eurocode::interaction::{self, Forces};
use crate::checks::eurocode::welds::{least_size, simplified};

/// Part of the interaction formula of Table 3.4 that divides the tension.
const TENSION_PART: f64 = 1.4;

/// Transformation parameter β of a member end: `|1 − M_j,b2/M_j,b1| ≤ 2` with the moments at the
/// node, that of the other beam in the numerator; 1 where no other beam acts, 0 in a splice.
///
/// # Source
/// EN 1993-1-8:2005 5.3(8), formulas 5.4a and 5.4b. Moments in the members' own axes, so that equal
/// ones of two beams balance.
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

pub(super) fn others<'a>(
    e: &'a EndPlate,
    a: &'a PlaneActions,
) -> impl Iterator<Item = &'a PlaneActions> {
    e.actions.iter().filter(|o| o.case == a.case && o.end != a.end)
}

/// Adds the checks of every load case and member end.
pub(super) fn checks(e: &EndPlate, out: &mut HandChecks) {
    for a in &e.actions {
        let place = format!("{}, {}", a.case, a.end);
        out.notes.extend(beyond_the_beam(e, a).map(|what| format!("{place}: {what}")));
        let ultimate = a.state.is_ultimate();
        let mut alone: Vec<Check> = slip_checks::slip(e, a).into_iter().collect();
        if ultimate {
            alone.extend(no_formula(a));
            alone.extend(beam_checks::beam(e, a));
        }
        out.checks.extend(alone.into_iter().map(|c| c.of_case(&a.case)));
        let sense = Sense::of_moment(a.at(1.0)[1][1]);
        let joint = loaded_joint(e, a);
        let side = match assess(&sense.of(&joint)) {
            Ok(assessment) => Side { e, a, sense, joint, assessment },
            Err(fault) => {
                let (clause, title) =
                    ("EN 1993-1-8:2005 6.2", "resistance by the component method");
                let subject = format!("{}, {}", a.end, sense.words());
                let check = Check::undecided(
                    Topic::ComponentMethod,
                    subject,
                    clause,
                    title,
                    fault.to_string(),
                );
                out.checks.extend(ultimate.then(|| check.of_case(&a.case)));
                continue;
            }
        };
        let method = side.method();
        let mut found = Vec::new();
        if ultimate {
            found.push(side.moment(&method));
            // every state of the rows is a linear program or two: found once
            let (states, push) = (side.states(&method), side.push(&method));
            let stability = side.stability(&method, push);
            if !stability.is_empty() && !out.unstable.contains(&a.case) {
                out.unstable.push(a.case.clone());
            }
            found.extend(stability);
            let [[_, vy, vz], _] = a.at(1.0);
            found.extend(side.bolts(&method, &states).checks(e, vz.hypot(vy)));
            found.extend(side.panel());
            found.extend(side.welds());
            let rows = side.row_forces(&method, &states);
            found.extend(case::checks(&Case {
                e,
                a,
                sense,
                assessment: &side.assessment,
                rows,
                push,
            }));
        }
        out.checks.extend(found.into_iter().map(|c| c.of_case(&a.case)));
        out.comparisons.push(Comparison::new(e, a, &method, &side.assessment));
        out.moments.extend(PureMoment::new(e, a, beta(e, a), &side.assessment));
    }
}

/// The joint of the component method under the actions of a load case.
fn loaded_joint(e: &EndPlate, a: &PlaneActions) -> EndPlateJoint {
    let mut joint = joint(e, beta(e, a));
    let [[_, vy, vz], _] = a.at(1.0);
    joint.beam.shear = vz.hypot(vy);
    joint
}

/// Torsion, weak-axis moment and horizontal shear: the hand checks of bolts, plates and welds leave
/// them out, and no bracket checks what they leave out.
fn no_formula(a: &PlaneActions) -> Option<Check> {
    let [[_, vy, _], [torsion, _, mz]] = a.at(1.0);
    let moments = [("T", torsion, Unit::Moment), ("Mz", mz, Unit::Moment), ("Vy", vy, Unit::Force)];
    let acts = moments.into_iter().filter(|(_, v, _)| v.abs() > 1e-6);
    let names: Vec<String> =
        acts.map(|(name, v, unit)| format!("{name} = {}", unit.show(v))).collect();
    (!names.is_empty()).then(|| {
        let why = format!(
            "the checks of bolts, plates and welds leave {} out: EN 1993-1-8 6.2 has no formula",
            names.join(" and ")
        );
        let (clause, title) =
            ("EN 1993-1-8:2005 6.2", "torsion, weak-axis moment and horizontal shear");
        Check::undecided(Topic::Bolts, a.end.clone(), clause, title, why)
    })
}

/// Actions that exceed what the beam itself carries are most likely a wrong number or unit.
fn beyond_the_beam(e: &EndPlate, a: &PlaneActions) -> Option<String> {
    let [[axial, vy, vz], [_, my, _]] = a.at(1.0);
    let section = Section::from(&e.beam);
    let fyd = e.beam_steel.fy / e.factors.gamma_m0;
    let moment = (my.abs(), section.w_pl * fyd, "My", "M_pl,Rd", Unit::Moment);
    let normal = (axial.abs(), section.area * fyd, "N", "N_pl,Rd", Unit::Force);
    let shear = (
        vy.hypot(vz),
        plastic_shear(&section, e.beam_steel.fy, e.factors.gamma_m0),
        "V",
        "V_pl,Rd",
        Unit::Force,
    );
    let worst =
        [moment, normal, shear].into_iter().max_by(|a, b| (a.0 / a.1).total_cmp(&(b.0 / b.1)))?;
    let (demand, capacity, action, resistance, unit) = worst;
    (demand > capacity).then(|| {
        format!(
            "{action} = {} is {} times {resistance} = {} of the beam {}: check the number and its \
             unit",
            unit.show(demand),
            n(demand / capacity),
            unit.show(capacity),
            e.beam.name
        )
    })
}

/// One member end under one load case.
struct Side<'a> {
    e: &'a EndPlate,
    a: &'a PlaneActions,
    sense: Sense,
    /// The joint as it stands; `assessment` is that of the sense.
    joint: EndPlateJoint,
    assessment: Assessment,
}

impl Side<'_> {
    fn subject(&self) -> String {
        format!("{}, {}", self.a.end, self.sense.words())
    }

    /// Resistance of the joint, for the sense of bending of the case; the equilibrium only where an
    /// axial force acts.
    fn method(&self) -> Method {
        let axial = self.a.at(1.0)[0][0];
        let acts = axial != 0.0 || self.a.dead[0][0] != 0.0;
        Method {
            moment: self.assessment.moment.value,
            equilibrium: if acts { Equilibrium::new(&self.joint).ok() } else { None },
            beta: self.joint.beta,
            sense: self.sense.words(),
        }
    }

    fn moment(&self, method: &Method) -> Check {
        let Some(mut check) = method.share(self.a.at(1.0)) else {
            let (clause, title) =
                ("EN 1993-1-8:2005 6.2.7.1", "moment and axial force of the joint");
            let why = "no plastic equilibrium of the rows with an axial force beyond 5 % of \
                       N_pl,Rd is covered";
            return Check::undecided(Topic::ComponentMethod, self.subject(), clause, title, why);
        };
        check.steps.push(step("M_j,Rd", method.moment, Unit::Moment));
        if let Some(e) = &method.equilibrium {
            check.steps.push(step("N_j,Rd in tension", e.tension, Unit::Force));
            check.steps.push(step("N_j,Rd in compression", e.compression, Unit::Force));
        }
        if self.e.column.is_some() {
            check.steps.push(step("β", method.beta, Unit::Number));
        }
        check.utilised(Topic::ComponentMethod, self.subject(), Status::Failed)
    }

    /// What may buckle: the compressed column web against its reduced resistance; what the code
    /// gives no resistance for is undecided.
    fn stability(&self, method: &Method, push: f64) -> Vec<Check> {
        let mut out = Vec::new();
        for s in &self.assessment.stability {
            let web = self.assessment.limit(Summed::ColumnWeb).filter(|_| s.covered);
            let Some(web) = web else {
                let title = "stability that a limit analysis does not see";
                out.push(Check::undecided(
                    Topic::Stability,
                    self.subject(),
                    s.clause,
                    title,
                    s.why.clone(),
                ));
                continue;
            };
            let mut worked = web.clone();
            worked.title = "column web in compression, with its buckling";
            worked.formula = format!("{}; {}", s.why, worked.formula);
            out.push(worked.against(Topic::Stability, self.subject(), push, Status::Failed));
        }
        let axial = self.a.at(1.0)[0][0];
        let buckling = method.equilibrium.as_ref().filter(|_| axial < 0.0);
        if let Some((e, why)) = buckling.and_then(|e| Some((e, e.buckles.as_ref()?))) {
            let formula = format!("{why}; N_j,Rd by the plastic equilibrium of the joint");
            let title = "axial compression of the joint, with the buckling of the column web";
            let worked =
                Worked::new("EN 1993-1-8:2005 6.2.6.2", title, e.compression, Unit::Force, formula);
            out.push(worked.against(Topic::Stability, self.subject(), -axial, Status::Failed));
        }
        out
    }

    /// Sign of z in the joint's own axes: the assessment has its tension at the top.
    fn upside(&self) -> f64 {
        if self.sense == Sense::Bottom { -1.0 } else { 1.0 }
    }

    /// States of the rows that the actions may bring: the axial force alone, and together with the
    /// moment where it counts.
    fn states(&self, method: &Method) -> Vec<Carried> {
        let at = self.a.at(1.0);
        let alone = method.equilibrium.as_ref().and_then(|e| e.at(at[0][0], 0.0));
        alone.into_iter().chain(method.with_axial(at)).filter(|c| c.factor > 0.0).collect()
    }

    /// What a row at `z` \[mm\] has under the actions, beyond any resistance: the moment's share,
    /// or more where the axial force gives it more. A push that relieves a row counts for nothing,
    /// so that a larger load never has smaller forces.
    fn at_row(
        &self,
        states: &[Carried],
        z: f64,
        by_moment: impl Fn(&RowForce) -> f64,
        of: fn(&RowPull) -> f64,
    ) -> f64 {
        let row = self.assessment.rows.iter().find(|r| (self.upside() * r.z - z).abs() < 1e-9);
        let pulled = states
            .iter()
            .filter_map(|c| Some(of(c.rows.iter().find(|r| (r.z - z).abs() < 1e-9)?) / c.factor));
        pulled.fold(row.map_or(0.0, by_moment), f64::max)
    }

    /// Force of every row of the assessment under the actions \[N\].
    fn row_forces(&self, method: &Method, states: &[Carried]) -> Vec<f64> {
        let share = self.a.at(1.0)[1][1].abs() / method.moment;
        let force = |r: &RowForce| {
            self.at_row(states, self.upside() * r.z, |row| share * row.force, |pull| pull.force)
        };
        self.assessment.rows.iter().map(force).collect()
    }

    /// Largest compression of a flange of the beam under the actions \[N\].
    fn push(&self, method: &Method) -> f64 {
        let at = self.a.at(1.0);
        // a push that does not count for the joint is there all the same, half of it in either
        // flange
        let bending = at[1][1].abs() / method.moment * self.assessment.tension();
        let plain = bending + 0.5 * (-at[0][0]).max(0.0);
        let together = method.with_axial(at).filter(|c| c.factor > 0.0);
        let of = |c: Carried| c.compression.into_iter().fold(0.0, f64::max) / c.factor;
        together.map_or(plain, |c| of(c).max(bending))
    }

    /// Tension of the bolts of every row under the actions, prying included.
    fn bolts(&self, method: &Method, states: &[Carried]) -> Bolts {
        let e = self.e;
        let tension = tension_resistance(&e.bolt, &e.grade, false, e.factors.gamma_m2).value;
        let share = self.a.at(1.0)[1][1].abs() / method.moment;
        let pull = |z: f64| self.at_row(states, z, |row| row.bolt_force(share), |pull| pull.bolt);
        let mut rows: Vec<(f64, f64)> = e.rows.iter().map(|&z| (z, pull(z))).collect();
        rows.sort_by(|a, b| b.0.total_cmp(&a.0));
        let shear =
            shear_resistance(&e.bolt, &e.grade, ShearPlane::Thread, 1.0, e.factors.gamma_m2).value;
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
        let relief = self.e.column.as_ref().map_or(0.0, |c| c.shear);
        // V_Ed is positive against what a positive moment at an end along +x brings
        let shear = self.a.outward * (own - other) / lever;
        let demand = (shear - relief).abs();
        let mut check = resistance;
        check.title = match relief == 0.0 {
            true => "column web panel in shear (column shear not given, V_Ed = 0)",
            false => "column web panel in shear",
        };
        check.formula = format!(
            "V_wp,Ed = |(M_b1 − M_b2)/z{}| = |({} − {})/{}{}| = {}; {}",
            if relief == 0.0 { "" } else { " − (V_c1 − V_c2)/2" },
            Unit::Moment.show(own),
            Unit::Moment.show(other),
            Unit::Length.show(lever),
            if relief == 0.0 {
                String::new()
            } else {
                format!(" − {}", Unit::Force.show(self.a.outward * relief))
            },
            Unit::Force.show(demand),
            check.formula
        );
        check.clause = "EN 1993-1-8:2005 5.3(3), 6.2.6.1";
        Some(check.against(Topic::ComponentMethod, self.subject(), demand, Status::Failed))
    }

    /// Fillet welds: those of the flanges take moment and axial force, those of the web the shear
    /// force.
    fn welds(&self) -> Vec<Check> {
        let e = self.e;
        let (b, mut out) = (&e.beam, Vec::new());
        let Some(steel) = welded(e) else { return out };
        let [[axial, vy, vz], [_, my, _]] = self.a.at(1.0);
        if e.flange_throat > 0.0 {
            let subject = format!("{}, beam flange", self.a.end);
            let length = weld_checks::flange_run(e);
            let force = my.abs() / (b.h - b.tf) + 0.5 * axial.max(0.0);
            let mut worked =
                simplified(e.flange_throat, &steel).with("l_eff", length, Unit::Length);
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
            let length = weld_checks::web_run(e);
            let force = vz.hypot(vy);
            let mut worked = simplified(e.web_throat, &steel).with("l_eff", length, Unit::Length);
            worked.formula = format!(
                "F_w,Ed = V/(2 l_eff) = {}/(2 · {}); {}",
                Unit::Force.show(force),
                Unit::Length.show(length),
                worked.formula
            );
            out.push(worked.against(
                Topic::Welds,
                subject.clone(),
                0.5 * force / length,
                Status::Failed,
            ));
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
    /// Tension that a bolt has beside its shear: at F_t,Rd it yields, and what is beyond stands in
    /// the check of tension.
    fn held(&self, tension: f64) -> f64 {
        tension.min(self.tension)
    }

    /// What tension leaves of the shear resistance of a bolt.
    fn left(&self, tension: f64) -> f64 {
        1.0 - self.held(tension) / (TENSION_PART * self.tension)
    }

    fn checks(&self, e: &EndPlate, shear: f64) -> Vec<Check> {
        let weights: f64 = self.rows.iter().map(|r| 2.0 * self.left(r.1)).sum();
        let of_row = |tension: f64| shear * self.left(tension) / weights;
        let place = |z: f64| format!("{}, row at z = {} mm", self.end, n(z));
        let mut out = vec![self.shear(weights, shear)];
        if let Some((z, tension)) = worst(self.rows.iter().copied(), |r| r.1) {
            let mut worked = tension_resistance(&e.bolt, &e.grade, false, e.factors.gamma_m2);
            worked.title =
                "tension of a bolt, prying included, by the row forces of the component method";
            out.push(worked.against(Topic::ComponentMethod, place(z), tension, Status::Failed));
        }
        // by Table 3.4 each bolt on its own
        let forces = |&(z, tension): &(f64, f64)| {
            let f = Forces {
                shear: of_row(tension),
                tension: self.held(tension),
                shear_resistance: self.shear,
                tension_resistance: self.tension,
            };
            let mut worked = interaction::utilisation(&f);
            if tension > self.tension {
                worked.formula +=
                    &format!("; F_t,Ed = {} counts as F_t,Rd here", Unit::Force.show(tension));
            }
            (z, worked)
        };
        if let Some((z, worked)) = worst(self.rows.iter().map(forces), |w| w.1.value) {
            out.push(worked.utilised(Topic::Bolts, place(z), Status::Failed));
        }
        let end = self.rows.len().saturating_sub(1);
        for (part, t, fu, width) in bearing_parts(e) {
            let rows = self.rows.iter().enumerate().map(|(i, &(z, tension))| {
                let inner = pitches(e).map(|[p1, _]| Along::Inner { p1 });
                // of the plate the end rows, whichever way the force points; the ends of the column
                // are far
                let e1 = (e.top - z).min(z - e.bottom);
                let outer =
                    (part == "end plate" && (i == 0 || i == end)).then_some(Along::End { e1 });
                let far = inner.is_none() && outer.is_none();
                let all = [inner, outer, far.then_some(Along::End { e1: 3.0 * e.hole })];
                let all = all.into_iter().flatten().map(|along| bearing(e, along, (t, fu, width)));
                let least = all.reduce(|a, b| if b.value < a.value { b } else { a });
                (z, of_row(tension), least)
            });
            let rows = rows.filter_map(|(z, force, worked)| Some((z, force, worked?)));
            if let Some((z, force, worked)) = worst(rows, |(_, force, w)| force / w.value) {
                out.push(worked.against(
                    Topic::Bolts,
                    format!("{part}, {}", place(z)),
                    force,
                    Status::Failed,
                ));
            }
            if let Some((z, tension)) = worst(self.rows.iter().copied(), |r| r.1) {
                let mut worked =
                    punching_resistance(mean_diameter(&e.bolt), t, fu, e.factors.gamma_m2);
                if tension > self.tension {
                    worked.formula +=
                        &format!("; F_t,Ed = {} counts as F_t,Rd here", Unit::Force.show(tension));
                }
                let held = self.held(tension);
                out.push(worked.against(
                    Topic::Bolts,
                    format!("{part}, {}", place(z)),
                    held,
                    Status::Failed,
                ));
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
        let mut worked =
            Worked::new("EN 1993-1-8:2005 6.2.2(2), Table 3.4", title, value, Unit::Force, formula);
        for (z, tension) in &self.rows {
            worked = worked.with(
                &format!("F_t,Ed of the row at z = {} mm", n(*z)),
                *tension,
                Unit::Force,
            );
        }
        worked.against(Topic::Bolts, self.end.clone(), shear, Status::Failed)
    }
}

/// The one with the largest value.
fn worst<T>(of: impl Iterator<Item = T>, value: impl Fn(&T) -> f64) -> Option<T> {
    of.reduce(|a, b| if value(&b) > value(&a) { b } else { a })
}
