//! From an approximate stress field to a strict lower bound of the load factor.
//!
//! A solver's field misses equilibrium, yield surface and friction cones by its tolerance. Three
//! steps repair it, none of which asks the solver:
//!
//! 1. contact tractions are put inside their cones and brought into balance with
//!    `factor · live + dead` part by part, the factor giving way with them: where every contact
//!    slips, friction itself is the limit;
//! 2. one elastic solution (refined) carries the forces that the stress leaves unbalanced; rigid
//!    bodies, which a solver may leave without any stress, are so much stiffer that they carry what
//!    acts on them;
//! 3. the field is drawn towards a field of the dead loads alone, strictly inside, until every
//!    point is inside: `c σ + (1 − c) σ_d` is in equilibrium with `c factor · live + dead`. Without
//!    dead loads σ_d is zero.

use crate::certify::certificate::{TOLERANCE, contact_tractions, largest, largest_of_each};
use crate::certify::faces::{contact_faces, roles, weld_faces};
use crate::certify::fields::StressField;
use crate::certify::limit_certificate::{LowerCertificate, certify_lower, utilisation};
use crate::certify::welds;
use crate::elements::super_element::{PARAMETERS, PointStress};
use crate::math::mandel::{Mandel, deviator};
use crate::math::vec3::{self, V3};
use crate::model::AnalysisModel;
use crate::model::loads::{Loads, face_corners};
use crate::programs::Static;
use crate::programs::constraints::{self, hold};
use crate::programs::super_elements::SuperElements;
use crate::recover::elastic::{
    RecoverError, Within, add_interface_forces, balance, balance_elements, interface_sets,
    interface_work, into_cone, stress_field,
};
use crate::solve::sparse::{Patterns, SparseCholesky};

/// How much stiffer bodies are that never yield.
const RIGID: f64 = 1e8;
/// How far inside their cones contact tractions are put, relative to the pressure: the first that
/// can be balanced.
const INSIDE: [f64; 7] = [1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4];
/// Live tractions over the yield radius that count as none.
const NOTHING: f64 = 1e-6;
/// Largest violation of a friction cone, over the largest traction, that rounding explains.
const ROUNDING: f64 = 1e-12;

/// What a solver of the static limit program leaves, admissible to its tolerance.
#[derive(Clone, Copy, Debug)]
pub struct ApproximateStress<'a> {
    /// Parameters of every super-element, as
    /// [`crate::elements::super_element::SuperElement::stress`] takes them under
    /// `factor · live + dead`; those of bodies that never yield may be zero.
    pub parameters: &'a [[f64; PARAMETERS]],
    /// Multipliers of every contact vertex of the model, see [`Static::spread_contact`] \[MPa\].
    pub contact: &'a [f64],
    /// Tractions of side A at the vertices of every weld face, see [`Static::weld_tractions`]
    /// \[MPa\]; empty without welds.
    pub welds: &'a [f64],
    /// Load factor.
    pub factor: f64,
}

/// A stress field and what it proves.
#[derive(Clone, Debug, PartialEq)]
pub struct Lower {
    /// The field.
    pub field: StressField,
    /// Its certificate.
    pub certificate: LowerCertificate,
}

/// Why a stress field proves no load factor.
#[derive(Clone, Debug, thiserror::Error)]
pub enum LowerError {
    /// The projection failed.
    #[error(transparent)]
    Recover(#[from] RecoverError),
    /// There are dead loads and no field of theirs alone.
    #[error(
        "with dead loads a lower bound needs a stress field of the dead loads alone, and none is \
         given"
    )]
    NoDeadField,
    /// The dead loads' field is not strictly admissible.
    #[error(
        "the stress field of the dead loads alone is not strictly admissible ({what}): without \
         the live loads the structure may not stand"
    )]
    DeadField {
        /// What is wrong with it.
        what: String,
    },
    /// No equilibrium to rounding.
    #[error(
        "the stress field cannot be brought into equilibrium: a residual of {residual:.1e} is \
         left, the limit is {TOLERANCE:.0e}"
    )]
    Unbalanced {
        /// Largest relative residual.
        residual: f64,
    },
}

/// The strict lower bound near an approximate field.
///
/// `dead`: a field in equilibrium with the dead loads alone, strictly admissible (see
/// [`dead_field`]); needed with dead loads. `patterns`, here and below: what is known of the mesh's
/// matrices.
pub fn project(
    model: &AnalysisModel,
    approximate: &ApproximateStress,
    dead: Option<&StressField>,
    patterns: &Patterns,
) -> Result<Lower, LowerError> {
    let dead =
        if model.has_dead_loads() { Some(dead.ok_or(LowerError::NoDeadField)?) } else { None };
    let found = equilibrium(model, approximate, dead.is_some(), patterns)
        .and_then(|(field, factor)| draw_inside(model, field, factor, dead));
    match found {
        // no stress of this mesh carries the live loads: none at all carries nothing, and that is a
        // bound
        Ok(lower) if dead.is_none() && lower.certificate.factor <= 0.0 => Ok(at_rest(model)),
        Err(_) if dead.is_none() && is_nothing(model, approximate.factor) => Ok(at_rest(model)),
        found => found,
    }
}

/// No stress, no load.
fn at_rest(model: &AnalysisModel) -> Lower {
    let field = StressField::none(model.mesh.tets.len());
    let certificate = LowerCertificate { scaled_by: 1.0, ..certify_lower(model, &field, 0.0) };
    Lower { field, certificate }
}

/// True when the live loads at the factor are nothing beside the strength: no structure of the
/// slenderness that a mesh can show collapses under so little, unless it carries nothing at all.
fn is_nothing(model: &AnalysisModel, factor: f64) -> bool {
    let mut traction = 0.0f64;
    for load in model.surface_loads.iter().filter(|l| !l.dead) {
        for f in &load.faces {
            let corners = face_corners(&model.mesh, f);
            let n = vec3::unit(vec3::area_vector(&corners));
            traction = traction.max(largest(corners.map(|x| vec3::norm(load.at(x, n)))));
        }
    }
    for r in &model.rigid {
        let corners = r.faces.iter().map(|f| face_corners(&model.mesh, f));
        let (area, reach) = corners.fold((0.0, 0.0f64), |(area, reach), c| {
            let far = largest(c.map(|x| vec3::norm(vec3::sub(x, r.at))));
            (area + vec3::norm(vec3::area_vector(&c)), reach.max(far))
        });
        let [x, y, z, mx, my, mz] = r.action;
        let per = [vec3::norm([x, y, z]) / area, vec3::norm([mx, my, mz]) / (area * reach)];
        traction = traction.max(largest(per));
    }
    let weakest = model.yield_radii().into_iter().flatten().fold(f64::INFINITY, f64::min);
    let bodies = model.body_loads.iter().any(|l| !l.dead);
    weakest.is_finite() && !bodies && factor.abs() * traction < NOTHING * weakest
}

/// A strictly admissible field of the dead loads alone, near an approximate one whose factor is
/// zero.
pub fn dead_field(
    model: &AnalysisModel,
    approximate: &ApproximateStress,
    patterns: &Patterns,
) -> Result<StressField, LowerError> {
    let (field, _) =
        equilibrium(model, &ApproximateStress { factor: 0.0, ..*approximate }, false, patterns)?;
    check_dead(model, &field)?;
    Ok(field)
}

fn check_dead(model: &AnalysisModel, field: &StressField) -> Result<(), LowerError> {
    let c = certify_lower(model, field, 0.0);
    let residual = c.equilibrium.max(c.traction_jump);
    let used = c.worst();
    let (balanced, below_yield) = (residual <= TOLERANCE, used + c.cover < 1.0);
    let what = match c.contact {
        _ if !balanced => format!("equilibrium is missed by {residual:.1e}"),
        _ if !below_yield && used > c.utilisation => {
            format!("{used:.4} times the strength of a weld")
        }
        _ if !below_yield => {
            let part = c.limiting_part.map_or("", |p| model.parts[p as usize].as_str());
            format!("{:.4} times the yield strength in part {part}", c.utilisation)
        }
        Some(violation) if violation > ROUNDING => {
            format!("a friction cone is violated by {violation:.1e}")
        }
        _ => return Ok(()),
    };
    Err(LowerError::DeadField { what })
}

/// The model with bodies that never yield made stiff: they carry, without help, whatever acts on
/// them.
fn stiffened(model: &AnalysisModel) -> AnalysisModel {
    let mut stiff = model.clone();
    let yields: Vec<bool> = model.yield_radii().iter().map(Option::is_some).collect();
    if yields.iter().all(|y| *y) || yields.iter().all(|y| !*y) {
        return stiff;
    }
    for (material, yields) in stiff.body_material.iter_mut().zip(yields) {
        if !yields {
            let mut m = stiff.materials[*material as usize].clone();
            m.e *= RIGID;
            *material = stiff.materials.len() as u32;
            stiff.materials.push(m);
        }
    }
    stiff
}

/// The field in equilibrium to rounding nearest to the approximate one, and its factor; with
/// `lenient` contact tractions may be left outside their cones.
fn equilibrium(
    model: &AnalysisModel,
    approximate: &ApproximateStress,
    lenient: bool,
    patterns: &Patterns,
) -> Result<(StressField, f64), LowerError> {
    let stiff = stiffened(model);
    let statics = Static::new(&stiff).map_err(RecoverError::from)?;
    let modes = statics.contact_modes();
    let motions: Vec<Vec<f64>> = modes.into_iter().map(|m| m.unknowns).collect();
    let (mut z, factor) = balanced(&statics, approximate, &motions, lenient)?;
    let welds = z.split_off(statics.program.g.nrows());
    let loads = Loads::at(factor);
    let mut p = statics.program.p.clone();
    hold(&mut p, &constraints::pins(motions, &statics.pinned), &[]);
    let cholesky =
        SparseCholesky::new(&p, &statics.map.block, patterns).map_err(RecoverError::from)?;
    let mut rhs = statics.forces(loads);
    add_interface_forces(&statics, &z, &welds, &mut rhs);
    let elements = SuperElements::new(&stiff).under(loads);
    let mut parameters = approximate.parameters.to_vec();
    balance_elements(&elements, &statics.map, &cholesky, &rhs, &mut parameters)
        .map_err(RecoverError::from)?;
    let field = stress_field(&elements, &parameters).map_err(RecoverError::from)?;
    Ok((field, factor))
}

/// Tractions of contacts inside their cones and of welds within their strength, in balance with the
/// loads on every rigid motion that only they resist, and the load factor that this leaves.
fn balanced(
    statics: &Static,
    approximate: &ApproximateStress,
    motions: &[Vec<f64>],
    lenient: bool,
) -> Result<(Vec<f64>, f64), RecoverError> {
    let factor = approximate.factor;
    let mut sets = interface_sets(statics);
    let mut tractions = statics.gather_contact(approximate.contact);
    tractions.extend_from_slice(approximate.welds);
    if motions.is_empty() || sets.is_empty() {
        return Ok((inside(&sets, &tractions, INSIDE[0], 0.0), factor));
    }
    let dot = |a: &[f64], b: &[f64]| crate::math::Sum::of(a.iter().zip(b).map(|(a, b)| a * b));
    let forces = |loads: Loads| -> Result<Vec<f64>, RecoverError> {
        let (f, p) = (statics.forces(loads), statics.particular_forces(loads)?);
        Ok(f.iter().zip(&p).map(|(a, b)| a - b).collect())
    };
    let (live, dead) = (forces(Loads::LIVE)?, forces(Loads::DEAD)?);
    // the load factor is one more force on a half-line
    let rows: Vec<Vec<f64>> = motions
        .iter()
        .map(|m| {
            let mut row = interface_work(statics, m);
            row.push(dot(m, &live));
            row
        })
        .collect();
    let needed: Vec<f64> = motions.iter().map(|m| -dot(m, &dead)).collect();
    let tied = sets.clone();
    sets.push(Within::Cone { start: tractions.len(), dim: 1 });
    let noise = 1e-7 * tractions.iter().fold(0.0f64, |m, z| m.max(z.abs()));
    let mut outside = None;
    for shrink in INSIDE {
        for least in [0.0, noise] {
            let mut z = inside(&tied, &tractions, shrink, least);
            z.push(factor);
            let found = balance(&sets, &rows, &needed, &mut z);
            let factor = z.pop().unwrap_or(factor);
            if found {
                return Ok((z, factor));
            }
            if outside.is_none() && factor.is_finite() {
                outside = Some((z, factor));
            }
        }
    }
    match outside {
        Some(found) if lenient => Ok(found),
        _ => Err(RecoverError::Unbalanced(statics.elements.model().parts.join(", "))),
    }
}

/// The nearest forces at least `shrink` times their pressure inside the cones, and times their
/// strength within the balls; those with less pressure than `least` are dropped.
fn inside(sets: &[Within], z: &[f64], shrink: f64, least: f64) -> Vec<f64> {
    let mut z = z.to_vec();
    for set in sets {
        let Within::Cone { start, dim } = *set else {
            set.draw_in(&mut z, shrink);
            continue;
        };
        let force = &mut z[start..start + dim];
        if least > 0.0 && force[0] < least {
            force.fill(0.0);
        }
        into_cone(force, 1.0 - shrink);
    }
    z
}

/// `c a + (1 − c) b`.
fn mixed(a: &StressField, b: Option<&StressField>, c: f64) -> StressField {
    let mix = |e: usize, k: usize, p: usize| -> Mandel {
        std::array::from_fn(|i| {
            c * a.points[e][k][p][i] + b.map_or(0.0, |b| (1.0 - c) * b.points[e][k][p][i])
        })
    };
    let tet = |e| -> PointStress { std::array::from_fn(|k| std::array::from_fn(|p| mix(e, k, p))) };
    StressField { points: (0..a.points.len()).map(tet).collect() }
}

/// Draws a field in equilibrium with `factor · live + dead` towards that of the dead loads until it
/// is admissible.
pub fn draw_inside(
    model: &AnalysisModel,
    field: StressField,
    factor: f64,
    dead: Option<&StressField>,
) -> Result<Lower, LowerError> {
    if let Some(dead) = dead {
        check_dead(model, dead)?;
    }
    let before = certify_lower(model, &field, factor);
    let residual = before.equilibrium.max(before.traction_jump);
    let balanced = residual <= TOLERANCE;
    if !balanced {
        return Err(LowerError::Unbalanced { residual });
    }
    let mut room = 1.0 - 2.0 * before.cover - 1e-12;
    let mut result = None;
    for _ in 0..3 {
        let c = part_inside(model, &field, factor, dead, room);
        // as it is, when nothing has to be drawn in
        let drawn = if c < 1.0 { mixed(&field, dead, c) } else { field.clone() };
        let certificate =
            LowerCertificate { scaled_by: c, ..certify_lower(model, &drawn, c * factor) };
        let over = certificate.worst() + certificate.cover - 1.0;
        let done = over <= 0.0;
        result = Some(Lower { field: drawn, certificate });
        if done {
            break;
        }
        room -= 2.0 * over;
    }
    result.ok_or(LowerError::Unbalanced { residual })
}

/// The largest c ≤ 1 at which `c field + (1 − c) dead` is within `room` times the yield surface
/// and, with dead loads, inside the friction cones.
fn part_inside(
    model: &AnalysisModel,
    field: &StressField,
    factor: f64,
    dead: Option<&StressField>,
    room: f64,
) -> f64 {
    let radii = model.yield_radii();
    let Some(dead) = dead else {
        let welds = largest_of_each(&welds::utilisations(model, field)).unwrap_or(0.0);
        let worst = utilisation(model, field).0.max(welds);
        return if worst > room { room / worst } else { 1.0 };
    };
    let mut c = 1.0f64;
    for (e, (s, d)) in field.points.iter().zip(&dead.points).enumerate() {
        let Some(radius) = radii[model.mesh.tet_body[e] as usize] else { continue };
        for (s, d) in s.iter().flatten().zip(d.iter().flatten()) {
            let (s, d) = (deviator(s), deviator(d));
            let slack = |c: f64| {
                let norm =
                    (0..5).map(|i| (c * s[i] + (1.0 - c) * d[i]).powi(2)).sum::<f64>().sqrt();
                room * radius - norm
            };
            c = largest_part(c, slack);
        }
    }
    for f in weld_faces(model) {
        let (t, d) =
            (contact_tractions(model, field, &f, None), contact_tractions(model, dead, &f, None));
        for (t, d) in t.iter().zip(&d) {
            let slack = |c: f64| {
                let mixed = vec3::add(vec3::scale(c, *t), vec3::scale(1.0 - c, *d));
                room * f.law.strength - vec3::norm(mixed)
            };
            c = largest_part(c, slack);
        }
    }
    let (here, there) = (roles(model, Loads::at(factor)), roles(model, Loads::DEAD));
    let contacts = contact_faces(model);
    let pairs: Vec<([V3; 3], [V3; 3])> = contacts
        .iter()
        .map(|f| {
            let key = (f.a.tet, f.a.local);
            (
                contact_tractions(model, field, f, here.get(&key)),
                contact_tractions(model, dead, f, there.get(&key)),
            )
        })
        .collect();
    let rounding = ROUNDING
        * largest(pairs.iter().flat_map(|(r, d)| r.iter().chain(d)).map(|r| vec3::norm(*r)));
    for (f, (r, d)) in contacts.iter().zip(&pairs) {
        let (n, _) = f.normal(model);
        for (r, d) in r.iter().zip(d) {
            let slack = |c: f64| {
                let x = vec3::add(vec3::scale(c, *r), vec3::scale(1.0 - c, *d));
                let pressure = vec3::dot(x, n);
                let shear = vec3::norm(vec3::sub(x, vec3::scale(pressure, n)));
                // a frictionless contact carries no shear at all
                let cone =
                    if f.law.mu > 0.0 { f.law.mu * pressure - shear } else { pressure.min(-shear) };
                cone + rounding
            };
            c = largest_part(c, slack);
        }
    }
    c
}

/// The largest part up to `c` with slack ≥ 0, for a concave slack that is ≥ 0 at 0.
fn largest_part(c: f64, slack: impl Fn(f64) -> f64) -> f64 {
    if slack(c) >= 0.0 {
        return c;
    }
    let (mut low, mut high) = (0.0, c);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if !(middle > low && middle < high) {
            break;
        }
        if slack(middle) >= 0.0 { low = middle } else { high = middle }
    }
    low
}

#[cfg(test)]
mod tests {
    use super::*;
    /// Every force lands inside its cone or ball, forces inside stay as they are, and no nearer
    /// force inside exists (compared with random ones).
    #[test]
    fn nearest_forces_inside() {
        let sets = [
            Within::Cone { start: 0, dim: 3 },
            Within::Cone { start: 3, dim: 1 },
            Within::Ball { start: 4, radius: 0.5 },
        ];
        let mut seed = 1u64;
        let mut random = || {
            seed ^= seed << 13;
            seed ^= seed >> 7;
            seed ^= seed << 17;
            2.0 * ((seed >> 11) as f64 / (1u64 << 53) as f64) - 1.0
        };
        let shear = |z: &[f64]| z[1].hypot(z[2]);
        for _ in 0..100 {
            let z: Vec<f64> = (0..7).map(|_| random()).collect();
            let got = inside(&sets, &z, 1e-3, 0.0);
            let length = |z: &[f64]| z[4].hypot(z[5]).hypot(z[6]);
            let (before, after) = (length(&z), length(&got));
            assert!((after - before.min(0.999 * 0.5)).abs() < 1e-15, "{before} {after}");
            (4..7).for_each(|i| assert!((got[i] * before - z[i] * after).abs() < 1e-15));
            assert!(
                got[0] >= 0.0 && shear(&got) <= 0.999 * got[0] && got[3] == z[3].max(0.0),
                "{z:?} {got:?}"
            );
            if shear(&z) <= 0.999 * z[0] {
                assert_eq!(got[..3], z[..3]);
            }
            let distance = |x: &[f64]| (0..3).map(|i| (x[i] - z[i]).powi(2)).sum::<f64>();
            for _ in 0..100 {
                let mut other = [random(), random(), random()];
                other[0] = other[0].abs() + other[1].hypot(other[2]) / 0.999;
                assert!(distance(&got) <= distance(&other) + 1e-12, "{z:?} {got:?} {other:?}");
            }
            assert_eq!(inside(&sets, &z, 1e-3, 2.0)[..4], [0.0; 4]);
        }
    }
}
