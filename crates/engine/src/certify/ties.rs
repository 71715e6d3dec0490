//! Slip along tied interfaces in limit analysis.
//!
//! Any stress inside the yield surface of the weaker body has a traction of at most k = f_y/√3
//! along a face. Its power against velocities with a jump [v] is therefore at most `k ∫ ‖[v_T]‖`
//! where `n·[v] = 0`. The certificate of the upper bound requires `n·[v] = 0` at the six Bernstein
//! coefficients, hence everywhere on the face, and adds an upper bound of that integral.

use crate::certify::faces::{InterfaceFace, TieFace, tie_faces};
use crate::certify::measures::largest;
use crate::certify::welds::{coefficients, jumps, mean_norm};
use crate::elements::space::Tet10Space;
use crate::model::AnalysisModel;
use bracket_base::math::Sum;
use bracket_base::math::vec3::{self, V3};

/// Number of times the faces are subdivided for the dissipation.
const SUBDIVISIONS: u32 = 2;

/// Largest traction along a face, k = f_y/√3 of the weaker body \[MPa\]; zero between bodies
/// without a yield strength.
fn strength(model: &AnalysisModel, face: &TieFace<'_>) -> f64 {
    let fy = |tet: u32| {
        let body = model.mesh.tet_body[tet as usize] as usize;
        model.materials[model.body_material[body] as usize].fy
    };
    let sides = [Some(face.a), face.b.map(|b| b.0)].into_iter().flatten();
    sides.filter_map(|f| fy(f.tet)).reduce(f64::min).unwrap_or(0.0) / 3.0f64.sqrt()
}

/// Parts of a vector across a face and along it.
fn parts<L>(model: &AnalysisModel, face: &InterfaceFace<'_, L>, v: V3) -> (f64, V3) {
    let (mut n, _) = face.normal(model);
    // the nodes of a plane have its coordinate to rounding
    if let Some(axis) = vec3::axis_of(n) {
        n = std::array::from_fn(|d| if d == axis { 1.0 } else { 0.0 });
    }
    let across = vec3::dot(n, v);
    (across, vec3::along(v, -across, n))
}

/// Dissipation of a tie face, an upper bound \[N mm per unit of time\].
pub fn dissipation_of(
    model: &AnalysisModel,
    space: &Tet10Space,
    face: &TieFace<'_>,
    u: &[V3],
) -> f64 {
    let along = jumps(space, face, u).map(|v| parts(model, face, v).1);
    strength(model, face) * face.normal(model).1 * mean_norm(&along, SUBDIVISIONS)
}

/// Dissipation of each tie, an upper bound \[N mm per unit of time\].
pub fn dissipations(model: &AnalysisModel, space: &Tet10Space, u: &[V3]) -> Vec<f64> {
    let mut out = vec![Sum::default(); model.ties.len()];
    for face in tie_faces(model) {
        out[face.of].add(dissipation_of(model, space, &face, u));
    }
    out.iter().map(|d| d.value()).collect()
}

/// Largest jump across a tie: the normal part of the Bernstein coefficients.
pub fn opening(model: &AnalysisModel, space: &Tet10Space, u: &[V3]) -> f64 {
    let of_face = |f: &TieFace<'_>| {
        largest(coefficients(&jumps(space, f, u)).map(|v| parts(model, f, v).0.abs()))
    };
    largest(tie_faces(model).iter().map(of_face))
}

/// `∫ k` over the faces that slip \[N\]. Faces at rest can stay so when residuals are removed.
pub fn capacity(model: &AnalysisModel, space: &Tet10Space, u: &[V3]) -> f64 {
    let faces = tie_faces(model);
    let slipping = faces.iter().filter(|f| dissipation_of(model, space, f, u) > 0.0);
    Sum::of(slipping.map(|f| strength(model, f) * f.normal(model).1))
}
