//! Rigid motions that no support resists, only contact: there the stiffness is zero.

use crate::elements::space::Tet10Space;
use crate::model::analysis::AnalysisModel;
use crate::programs::dofs::DofMap;
use bracket_base::math::dense::{Mat, null_space};
use bracket_base::math::rigid_motion::rigid_displacement;
use bracket_base::math::vec3::{self, V3};

/// A rigid motion of parts and rigid faces that no support resists, only contact.
pub struct ContactMode {
    /// The motion in the program's unknowns.
    pub unknowns: Vec<f64>,
    /// The motion `[U, θ]` about the origin of each part.
    pub parts: Vec<[f64; 6]>,
}

/// All such motions of a program whose points are the nodes of a displacement space.
pub fn contact_modes_of_nodes(
    model: &AnalysisModel,
    space: &Tet10Space,
    map: &DofMap,
) -> Vec<ContactMode> {
    let part = model.node_parts();
    let nodes = space.nodes.iter().enumerate();
    let points: Vec<(usize, V3)> =
        nodes.map(|(i, x)| (part[space.a_vertex(i)] as usize, *x)).collect();
    contact_modes(model, map, &points)
}

/// All such motions of a program whose full unknowns `3 i + d` are displacements of `points[i]`,
/// each given with its part.
pub fn contact_modes(
    model: &AnalysisModel,
    map: &DofMap,
    points: &[(usize, V3)],
) -> Vec<ContactMode> {
    let parts = model.parts.len();
    // motions about the centre of the model, rotations scaled to its size
    let (lo, hi) = model.mesh.nodes.iter().fold(([f64::MAX; 3], [f64::MIN; 3]), |(lo, hi), x| {
        (std::array::from_fn(|d| lo[d].min(x[d])), std::array::from_fn(|d| hi[d].max(x[d])))
    });
    let centre: V3 = std::array::from_fn(|d| 0.5 * (lo[d] + hi[d]));
    let size = vec3::norm(vec3::sub(hi, lo)).max(f64::MIN_POSITIVE);
    let unit: [[f64; 6]; 6] = std::array::from_fn(|m| {
        let mut v = [0.0; 6];
        v[m] = if m < 3 { 1.0 } else { 1.0 / size };
        v
    });
    let rigid = map.rigid();
    let n = 6 * parts + rigid;
    let mut gram = Mat::<f64>::zeros(n, n);
    for (i, &(part, x)) in points.iter().enumerate() {
        for d in 0..3 {
            // the motion is the same on both sides of a frozen cut
            if map.own(3 * i + d).is_some() || map.follows(3 * i + d) {
                continue;
            }
            let mut row: Vec<(usize, f64)> = (0..6)
                .map(|m| (6 * part + m, rigid_displacement(&unit[m], centre, x)[d]))
                .collect();
            row.extend(
                map.terms(3 * i + d).iter().map(|&(k, c)| (6 * parts + k as usize - map.plain, -c)),
            );
            for &(i, a) in &row {
                for &(j, b) in &row {
                    gram[(i, j)] += a * b;
                }
            }
        }
    }
    null_space(&gram, 1e-11)
        .into_iter()
        .map(|c| {
            let motions: Vec<[f64; 6]> = (0..parts)
                .map(|p| {
                    let theta: V3 = std::array::from_fn(|d| c[6 * p + 3 + d] / size);
                    let u: V3 = std::array::from_fn(|d| c[6 * p + d]);
                    // about the origin: U + θ × (x − centre) = (U − θ × centre) + θ × x
                    let u = vec3::sub(u, vec3::cross(theta, centre));
                    [u[0], u[1], u[2], theta[0], theta[1], theta[2]]
                })
                .collect();
            let mut unknowns = vec![0.0; map.n];
            for (i, &(part, x)) in points.iter().enumerate() {
                let u = rigid_displacement(&motions[part], [0.0; 3], x);
                for d in 0..3 {
                    if let Some(k) = map.own(3 * i + d) {
                        unknowns[k] = u[d];
                    }
                }
            }
            unknowns[map.plain..map.plain + rigid].copy_from_slice(&c[6 * parts..]);
            ContactMode { unknowns, parts: motions }
        })
        .collect()
}
