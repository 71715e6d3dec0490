//! Bolts that stay elastic: the forces in their sections against every resistance of Table 3.4.

use super::evidence::{BoltSections, Evidence, SectionForce};
use super::facts::RouteFacts;
use super::step::{RouteStep, RouteUse, StepId, StepState};
use crate::unit::Unit;
use bracket_base::math::vec3::{self, V3};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::assembly::Grip;
use bracket_joint::assembly::axes::across;
use bracket_joint::strength::BoltLimits;

const SOURCE: &str = "EN 1993-1-8:2005 2.5(1), 3.12, Table 3.4";
const TABLE: &str = "EN 1993-1-8:2005 Table 3.4";
/// Largest difference of a utilisation between the two fields, where nothing else shows that the
/// forces have converged.
const SPREAD: f64 = 0.05;
/// Largest difference of a utilisation by displacement between two meshes, which shows it too. The
/// coarser mesh has half of the tets, so that the error left is about 1.7 times this difference.
const BETWEEN_MESHES: f64 = 0.03;
const NARROW: &str = "finer meshes (`max_passes`, `time_limit`, a smaller `--size-factor`)";
const NAMES: [&str; 3] = ["x", "y", "z"];

/// The step. With forces of elastic bolts within all resistances no bolt needs ductility.
pub(super) fn bolts(facts: &RouteFacts, meshes: &[Evidence], copies: usize) -> RouteStep {
    let open = |finding, next: &'static str| RouteStep::open(StepId::Bolts, finding, SOURCE, next);
    let lacking = || open("the forces of the bolts are not known".into(), NARROW);
    let Some((evidence, before)) = meshes.split_last() else { return lacking() };
    let before = before.last().filter(|before| before.tets < evidence.tets);
    let mut uses = Vec::new();
    let mut unsure: Option<(f64, Text)> = None;
    for (grip, limits) in &facts.bolts {
        // the bolts beyond a plane of symmetry are those before it
        let Some(found) = evidence.bolts.iter().find(|b| b.bolt == grip.part) else { continue };
        let fields = [forces(found, |s| s.by_stress), forces(found, |s| s.by_displacement)];
        let [Some(by_stress), Some(by_displacement)] = fields else {
            let finding = say!("the forces of {} are known from one field only", &grip.part);
            return open(finding, NARROW);
        };
        let [by_stress, by_displacement] =
            [by_stress, by_displacement].map(|f| values(grip, limits, &f));
        let coarse = before.and_then(|e| e.bolts.iter().find(|b| b.bolt == grip.part));
        let coarse = coarse.and_then(|found| forces(found, |s| s.by_displacement));
        let coarse = coarse.map(|f| values(grip, limits, &f));
        for (k, (s, d)) in by_stress.into_iter().zip(by_displacement).enumerate() {
            let spread = (s.value - d.value).abs();
            let apart = spread / s.limit;
            let moved = coarse.as_ref().and_then(|c| c.get(k)).map(|c| (c.value - d.value).abs());
            let converged = moved.is_some_and(|m| m / s.limit <= BETWEEN_MESHES);
            if apart > SPREAD && !converged && unsure.as_ref().is_none_or(|(most, _)| apart > *most)
            {
                unsure = Some((apart, s.what.clone()));
            }
            uses.push(RouteUse { value: s.value.max(d.value) + spread, spread: Some(spread), ..s });
        }
    }
    // every copy of the meshed part has the same bolts
    if copies * evidence.bolts.len() < facts.bolts.len() {
        return lacking();
    }
    let next = "stronger or more bolts, a stiffer plate, or a rule of rotation capacity with a \
                method of the code";
    let step = RouteStep::of_uses(StepId::Bolts, StepState::Estimated, uses, SOURCE, next);
    match unsure {
        Some((apart, what)) if step.holds() => {
            let apart = format!("{:.1} %", 100.0 * apart);
            let finding = say!("{}: the two fields differ by {} of the resistance", what, apart);
            step.left_open(finding, NARROW)
        }
        _ => step,
    }
}

/// The forces of all sections by one field.
fn forces(found: &BoltSections, of: fn(&SectionForce) -> Option<V3>) -> Option<Vec<V3>> {
    found.sections.iter().map(of).collect()
}

/// Every force of a bolt against its resistance, always the same ones in the same order.
fn values(grip: &Grip, limits: &BoltLimits, sections: &[V3]) -> Vec<RouteUse> {
    let bolt = &grip.part;
    let row = |what: Text, value: f64, limit: f64, unit| RouteUse {
        what,
        value,
        spread: None,
        limit,
        unit,
        source: TABLE.into(),
    };
    let parts = |force: V3| {
        let along = vec3::dot(force, grip.axis);
        (along.max(0.0), vec3::along(force, -along, grip.axis))
    };
    let mut out = Vec::new();
    for (i, force) in sections.iter().enumerate() {
        let (tension, across) = parts(*force);
        let shear = vec3::norm(across);
        let plane = (i + 1).to_string();
        let force = |what, value, limit| row(what, value, limit, Unit::Force);
        let outer = [(i == 0, limits.punching[0]), (i + 1 == sections.len(), limits.punching[1])];
        let punching = outer.iter().filter(|o| o.0).fold(f64::INFINITY, |x, o| x.min(o.1));
        let what = say!("{}, tension in shear plane {}", bolt, plane.clone());
        out.push(force(what, tension, limits.tension));
        if punching.is_finite() {
            out.push(force(say!("{}, punching under head or nut", bolt), tension, punching));
        }
        let what = say!("{}, shear in shear plane {}", bolt, plane.clone());
        out.push(force(what, shear, limits.shear));
        let both = shear / limits.shear + tension / (limits.interaction * limits.tension);
        let what = say!("{}, tension and shear in shear plane {}", bolt, plane);
        out.push(row(what, both, 1.0, Unit::Number));
    }
    for (i, (ply, resistances)) in grip.plies.iter().zip(&limits.bearing).enumerate() {
        let Some(resistances) = resistances else { continue };
        let at =
            |k: Option<usize>| k.and_then(|k| sections.get(k)).map_or([0.0; 3], |f| parts(*f).1);
        let force = vec3::sub(at(Some(i)), at(i.checked_sub(1)));
        if ply.room.is_some_and(|r| r.oblique) {
            // the least of all directions, for the resultant
            let least = resistances.as_flattened().iter().copied().fold(f64::INFINITY, f64::min);
            let what = say!("{}, bearing on {}", bolt, &ply.part);
            out.push(row(what, vec3::norm(force), least, Unit::Force));
            continue;
        }
        let along = (0..3).find(|&k| grip.axis[k] != 0.0).unwrap_or(0);
        for (k, [negative, positive]) in across(along).into_iter().zip(resistances) {
            for (sign, limit) in [(-1.0, negative), (1.0, positive)] {
                let way = format!("{}{}", if sign < 0.0 { "-" } else { "+" }, NAMES[k]);
                let what = say!("{}, bearing on {} toward {}", bolt, &ply.part, way);
                out.push(row(what, (sign * force[k]).max(0.0), *limit, Unit::Force));
            }
        }
    }
    out
}
