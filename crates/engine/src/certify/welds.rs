//! Welds of finite strength: utilisation by a stress field, dissipation of a displacement jump.

use crate::certify::faces::{InterfaceFace, WeldFace, weld_faces};
use crate::certify::fields::StressField;
use crate::certify::tractions::contact_tractions;
use crate::elements::space::{FACE_EDGES, Tet10Space};
use crate::model::AnalysisModel;
use bracket_base::math::Sum;
use bracket_base::math::quadrature::triangle_p2;
use bracket_base::math::vec3::{self, V3};

/// Number of times the faces are subdivided for the dissipation.
const SUBDIVISIONS: u32 = 2;

/// Jump of displacements (or velocities) u at the nodes of a face, from side A to side B.
pub fn jumps<L>(space: &Tet10Space, face: &InterfaceFace<'_, L>, u: &[V3]) -> [V3; 6] {
    let a = space.triangle(face.nodes_a);
    let b = face.b.map(|(_, nodes)| space.triangle(nodes));
    std::array::from_fn(|i| vec3::sub(b.map_or([0.0; 3], |b| u[b[i]]), u[a[i]]))
}

/// The six Bernstein coefficients of a quadratic function with the given values at vertices and
/// mid-sides of a triangle.
pub fn coefficients(g: &[V3; 6]) -> impl Iterator<Item = V3> {
    let edges = FACE_EDGES.iter().enumerate().map(|(e, &[p, q])| {
        vec3::sub(vec3::scale(2.0, g[3 + e]), vec3::scale(0.5, vec3::add(g[p], g[q])))
    });
    g[..3].iter().copied().chain(edges)
}

/// An upper bound of the mean of `‖g‖` over a triangle, g quadratic with the given values at
/// vertices and mid-sides.
pub fn mean_norm(g: &[V3; 6], subdivisions: u32) -> f64 {
    mean_of(g, subdivisions, &vec3::norm)
}

/// An upper bound of the mean of a convex function of g over a triangle, g quadratic with the given
/// values at vertices and mid-sides.
///
/// g is a convex combination of its six Bernstein coefficients, each with a mean weight of 1/6.
/// Each subdivision applies this to the four triangles that the mid-sides make.
pub fn mean_of(g: &[V3; 6], subdivisions: u32, convex: &impl Fn(V3) -> f64) -> f64 {
    if subdivisions == 0 {
        return coefficients(g).map(convex).sum::<f64>() / 6.0;
    }
    0.25 * quarters(g).iter().map(|g| mean_of(g, subdivisions - 1, convex)).sum::<f64>()
}

/// Values at vertices and mid-sides of the four triangles that the mid-sides of a triangle make, of
/// a quadratic g with the given values.
pub fn quarters(g: &[V3; 6]) -> [[V3; 6]; 4] {
    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let middle =
        |p: [f64; 3], q: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| 0.5 * (p[i] + q[i])) };
    let middles = FACE_EDGES.map(|[p, q]| middle(corners[p], corners[q]));
    let parts = [
        [corners[0], middles[0], middles[2]],
        [middles[0], corners[1], middles[1]],
        [middles[2], middles[1], corners[2]],
        [middles[1], middles[2], middles[0]],
    ];
    let at = |l: [f64; 3]| {
        let shape = triangle_p2(l);
        (0..6).fold([0.0; 3], |s, i| vec3::add(s, vec3::scale(shape[i], g[i])))
    };
    parts.map(|x| {
        std::array::from_fn(|i| {
            at(if i < 3 { x[i] } else { middle(x[FACE_EDGES[i - 3][0]], x[FACE_EDGES[i - 3][1]]) })
        })
    })
}

/// Dissipation of a weld face, an upper bound \[N mm\].
pub fn dissipation_of(
    model: &AnalysisModel,
    space: &Tet10Space,
    face: &WeldFace<'_>,
    u: &[V3],
) -> f64 {
    let (_, area) = face.normal(model);
    face.law.strength * area * mean_norm(&jumps(space, face, u), SUBDIVISIONS)
}

/// Dissipation of each weld, an upper bound \[N mm\].
pub fn dissipations(model: &AnalysisModel, u: &[V3]) -> Vec<f64> {
    let space = Tet10Space::new(&model.mesh);
    let mut out = vec![Sum::default(); model.welds.len()];
    for face in weld_faces(model) {
        out[face.of].add(dissipation_of(model, &space, &face, u));
    }
    out.iter().map(|d| d.value()).collect()
}

/// Utilisation of a weld by a stress field.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Utilisation {
    /// Largest traction over the strength; NaN if any traction is NaN.
    pub largest: f64,
    /// Upper bound of the mean traction over the strength: the mean of the values at the vertices
    /// of the faces, between which the traction is linear.
    pub mean: f64,
}

/// Largest traction of each weld over its strength; NaN if any traction is NaN.
pub fn utilisations(model: &AnalysisModel, field: &StressField) -> Vec<f64> {
    demands(model, field).into_iter().map(|u| u.largest).collect()
}

/// Utilisation of each weld by a stress field.
pub fn demands(model: &AnalysisModel, field: &StressField) -> Vec<Utilisation> {
    let mut out = vec![0.0f64; model.welds.len()];
    let mut means = vec![[Sum::default(); 2]; model.welds.len()];
    for face in weld_faces(model) {
        let (_, area) = face.normal(model);
        means[face.of][1].add(area);
        for t in contact_tractions(model, field, &face, None) {
            let used = vec3::norm(t) / face.law.strength;
            means[face.of][0].add(area / 3.0 * used);
            let worst = &mut out[face.of];
            *worst = if used.is_nan() || worst.is_nan() { f64::NAN } else { worst.max(used) };
        }
    }
    let mean = means.into_iter().map(|[used, area]| used.value() / area.value());
    out.into_iter().zip(mean).map(|(largest, mean)| Utilisation { largest, mean }).collect()
}
