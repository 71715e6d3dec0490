//! Ground that crushes: utilisation of its strength by a stress field, dissipation of velocities.
//!
//! Contact with such ground carries a pressure of at most the strength f of the ground, inside the
//! friction cone. The power of any such traction against velocities that close the contact is at
//! most `f ∫ max(0, μ‖g_T‖ − g_N)`, g the jump from the steel to the ground at rest. The integrand
//! is convex in g: the mean over the Bernstein coefficients of a face bounds its mean.

use crate::certify::faces::{ContactFace, contact_faces, roles};
use crate::certify::fields::StressField;
use crate::certify::measures::largest_of_each;
use crate::certify::tractions::contact_tractions;
use crate::certify::welds::{jumps, mean_of};
use crate::elements::space::Tet10Space;
use crate::model::AnalysisModel;
use crate::model::loads::Loads;
use bracket_base::math::Sum;
use bracket_base::math::vec3::{self, V3};

/// Number of times the faces are subdivided for the dissipation.
const SUBDIVISIONS: u32 = 2;

/// Every contact face on ground that crushes, with the strength of the ground \[MPa\].
fn faces(model: &AnalysisModel) -> impl Iterator<Item = (f64, ContactFace<'_>)> {
    let all = contact_faces(model).into_iter();
    all.filter_map(|f| model.crushing_strength(f.of).map(|strength| (strength, f)))
}

/// The pressure on crushing ground at the vertices of a face.
struct Pressed {
    /// Number of the contact with the ground.
    ground: usize,
    /// Strength of the ground \[MPa\].
    strength: f64,
    /// Pressures \[MPa\].
    pressure: [f64; 3],
}

/// The pressures on all crushing ground under `loads`, face by face.
fn pressures(model: &AnalysisModel, field: &StressField, loads: Loads) -> Vec<Pressed> {
    let roles = roles(model, loads);
    let of_face = |(strength, f): (f64, ContactFace<'_>)| {
        let (n, _) = f.normal(model);
        let tractions = contact_tractions(model, field, &f, roles.get(&(f.a.tet, f.a.local)));
        let ground = f.of - model.interfaces.len();
        Pressed { ground, strength, pressure: tractions.map(|t| vec3::dot(t, n)) }
    };
    faces(model).map(of_face).collect()
}

/// Largest pressure on each contact with the ground over the strength of the ground, zero on ground
/// that does not crush; empty without crushing ground, NaN if any traction is NaN.
pub fn utilisations(model: &AnalysisModel, field: &StressField, loads: Loads) -> Vec<f64> {
    if !model.has_crushing_ground() {
        return Vec::new();
    }
    let mut out = vec![0.0; model.ground.len()];
    for face in pressures(model, field, loads) {
        let [a, b, c] = face.pressure.map(|p| p / face.strength);
        let worst = &mut out[face.ground];
        *worst = largest_of_each(&[*worst, a, b, c]).unwrap_or(*worst);
    }
    out
}

/// Pressures of two fields at the vertices of each face on crushing ground, with its strength
/// \[MPa\].
pub fn pressure_pairs(
    model: &AnalysisModel,
    a: (&StressField, Loads),
    b: (&StressField, Loads),
) -> Vec<(f64, [f64; 2])> {
    let (a, b) = (pressures(model, a.0, a.1), pressures(model, b.0, b.1));
    let of_face = |(a, b): (Pressed, Pressed)| {
        let both = a.pressure.into_iter().zip(b.pressure);
        both.map(move |(x, y)| (a.strength, [x, y]))
    };
    a.into_iter().zip(b).flat_map(of_face).collect()
}

/// Dissipation of a face on crushing ground, an upper bound \[N mm per unit of time\].
fn dissipation_of(
    model: &AnalysisModel,
    space: &Tet10Space,
    (strength, face): (f64, &ContactFace<'_>),
    u: &[V3],
) -> f64 {
    let (n, area) = face.normal(model);
    let closing = |g: V3| {
        let across = vec3::dot(g, n);
        let along = vec3::norm(vec3::along(g, -across, n));
        (face.law.mu * along - across).max(0.0)
    };
    strength * area * mean_of(&jumps(space, face, u), SUBDIVISIONS, &closing)
}

/// Dissipation of each contact with the ground, an upper bound \[N mm per unit of time\]; empty
/// without crushing ground.
pub fn dissipations(model: &AnalysisModel, space: &Tet10Space, u: &[V3]) -> Vec<f64> {
    if !model.has_crushing_ground() {
        return Vec::new();
    }
    let mut out = vec![Sum::default(); model.ground.len()];
    for (strength, face) in faces(model) {
        let of = face.of - model.interfaces.len();
        out[of].add(dissipation_of(model, space, (strength, &face), u));
    }
    out.iter().map(|d| d.value()).collect()
}

/// Dissipation of each contact face of the model by its number, zero on ground that does not crush
/// \[N mm per unit of time\].
pub fn dissipations_of_faces(model: &AnalysisModel, space: &Tet10Space, u: &[V3]) -> Vec<f64> {
    let of_face = |f: &ContactFace<'_>| {
        let strength = model.crushing_strength(f.of);
        strength.map_or(0.0, |strength| dissipation_of(model, space, (strength, f), u))
    };
    contact_faces(model).iter().map(of_face).collect()
}

/// `∫ f` over the ground \[N\]: what a residual of the velocities at the ground can dissipate.
pub fn capacity(model: &AnalysisModel) -> f64 {
    Sum::of(faces(model).map(|(strength, f)| strength * f.normal(model).1))
}
