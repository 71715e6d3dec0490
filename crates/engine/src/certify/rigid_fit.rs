//! Rigid motion of a rigid face, fitted to nodal displacements or velocities.

use crate::certify::measures::largest;
use crate::elements::space::Tet10Space;
use crate::model::AnalysisModel;
use crate::model::analysis::RigidFace;
use crate::model::loads::face_nodes;
use bracket_base::math::dense::{Mat, damped_least_squares};
use bracket_base::math::rigid_motion::rigid_displacement;
use bracket_base::math::vec3::{self, V3};

/// Motions of the rigid faces under the displacements or velocities `u` of the nodes, about their
/// reference points \[mm, rad\].
pub fn rigid_motions(model: &AnalysisModel, u: &[V3]) -> Vec<[f64; 6]> {
    let space = Tet10Space::new(&model.mesh);
    model.rigid.iter().map(|r| fit_rigid(model, &space, u, r).0).collect()
}

/// The rigid motion nearest to the displacement of a rigid face, among its free motions, and the
/// largest deviation in its components \[mm\].
pub(crate) fn fit_rigid(
    model: &AnalysisModel,
    space: &Tet10Space,
    u: &[V3],
    rigid: &RigidFace,
) -> ([f64; 6], f64) {
    let mut nodes: Vec<usize> =
        rigid.faces.iter().flat_map(|f| space.triangle(face_nodes(&model.mesh, f))).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let free: Vec<usize> = (0..6).filter(|&i| rigid.free[i]).collect();
    let reach =
        largest(nodes.iter().map(|&n| vec3::norm(vec3::sub(space.nodes[n], rigid.at)))).max(1e-12);
    let unit = |i: usize| -> [f64; 6] {
        let mut m = [0.0; 6];
        m[i] = if i < 3 { 1.0 } else { 1.0 / reach };
        m
    };
    let samples: Vec<(usize, usize)> = nodes
        .iter()
        .flat_map(|&n| (0..3).filter(|&d| rigid.components[d]).map(move |d| (n, d)))
        .collect();
    let mut motion = [0.0; 6];
    if !free.is_empty() && samples.len() >= free.len() {
        let a = Mat::from_fn(samples.len(), free.len(), |s, c| {
            let (n, d) = samples[s];
            rigid_displacement(&unit(free[c]), rigid.at, space.nodes[n])[d]
        });
        let b = Mat::from_fn(samples.len(), 1, |s, _| u[samples[s].0][samples[s].1]);
        // motions that the face cannot show (a rotation about the normal with only x listed) stay
        // zero
        let x = damped_least_squares(&a, &b);
        for (c, &i) in free.iter().enumerate() {
            motion[i] = x[(c, 0)] * unit(i)[i];
        }
    }
    let error =
        largest(samples.iter().map(|&(n, d)| {
            (rigid_displacement(&motion, rigid.at, space.nodes[n])[d] - u[n][d]).abs()
        }));
    (motion, error)
}
