//! Stresses and tractions on faces.

use crate::certify::faces::{FaceRole, InterfaceFace};
use crate::certify::fields::StressField;
use crate::mesh::tet::FACES;
use crate::model::AnalysisModel;
use bracket_base::math::mandel::{self, Mandel};
use bracket_base::math::vec3::{self, V3};

/// Stress on a face of a tet, at the three vertices of local face `k`, [`FACES`] order.
pub(crate) fn face_stress(field: &StressField, tet: usize, k: usize) -> [Mandel; 3] {
    let s = &field.points[tet][k];
    [s[0], s[1], s[2]]
}

/// Stress on a boundary face at the given nodes.
pub(crate) fn stress_at(
    model: &AnalysisModel,
    field: &StressField,
    f: (u32, u8),
    nodes: [u32; 3],
) -> [Mandel; 3] {
    let (tet, k) = (f.0 as usize, f.1 as usize);
    let s = face_stress(field, tet, k);
    let own = FACES[k].map(|i| model.mesh.tets[tet][i]);
    nodes.map(|n| own.iter().position(|m| *m == n).map_or([0.0; 6], |p| s[p]))
}

/// Traction of an interface `r = −(σ n − load)` on side A at the face's vertices, pressure positive
/// along the normal \[MPa\].
pub fn contact_tractions<L>(
    model: &AnalysisModel,
    field: &StressField,
    face: &InterfaceFace<'_, L>,
    role: Option<&FaceRole>,
) -> [V3; 3] {
    let (n, _) = face.normal(model);
    let corners = face.corners(model);
    let s = stress_at(model, field, (face.a.tet, face.a.local), face.nodes_a);
    std::array::from_fn(|i| {
        let load = role.map_or([0.0; 3], |r| r.load(corners[i], n));
        vec3::sub(load, mandel::traction(&s[i], n))
    })
}

/// Value at barycentric coordinates `l` of a field that is linear on a triangle.
pub(crate) fn at_barycentric(v: &[V3; 3], l: [f64; 3]) -> V3 {
    std::array::from_fn(|d| (0..3).map(|i| l[i] * v[i][d]).sum())
}
