//! Difference between a shift of the friction cones and the shift of Coulomb's law.

use crate::certify::faces::contact_faces;
use crate::certify::fields::DisplacementField;
use crate::elements::space::{FACE_EDGES, Tet10Space};
use crate::model::AnalysisModel;
use crate::model::opening::ConeShift;
use bracket_base::math::vec3;

/// Largest difference between a shift and `μ‖g_T‖` of a displacement over the contact faces under
/// Coulomb's law, relative to the largest shift; 0 where nothing slips.
///
/// Only coefficients count where the faces touch to a thousandth of the largest shift.
pub fn distance_from_coulomb(
    model: &AnalysisModel,
    shift: &ConeShift,
    field: &DisplacementField,
) -> f64 {
    let space = Tet10Space::new(&model.mesh);
    let (mut off, mut largest) = (0.0f64, 0.0f64);
    let all = contact_faces(model);
    shift.faces.iter().flatten().for_each(|s| largest = largest.max(*s));
    for (f, shift) in all.iter().zip(&shift.faces).filter(|(f, _)| f.law.is_coulomb()) {
        let (n, _) = f.normal(model);
        let gap = f.law.gap.bernstein(&f.corners(model));
        let a = space.triangle(f.nodes_a);
        let b = f.b.map(|(_, nodes)| space.triangle(nodes));
        let jump = |i: usize| vec3::sub(b.map_or([0.0; 3], |b| field.u[b[i]]), field.u[a[i]]);
        for i in 0..6 {
            let g = if i < 3 {
                jump(i)
            } else {
                let [p, q] = FACE_EDGES[i - 3];
                vec3::sub(vec3::scale(2.0, jump(i)), vec3::scale(0.5, vec3::add(jump(p), jump(q))))
            };
            let normal = vec3::dot(g, n);
            if normal + gap[i] <= 1e-3 * largest {
                let slip = f.law.mu * vec3::norm(vec3::sub(g, vec3::scale(normal, n)));
                off = off.max((slip - shift[i]).abs());
            }
        }
    }
    if largest > 0.0 { off / largest } else { 0.0 }
}
