//! Loads as forces on the unknowns of the programs.

use crate::elements::space::Tet10Space;
use crate::elements::{split_flow, split_tet10, tet10};
use crate::model::analysis::AnalysisModel;
use crate::model::loads::{Loads, face_corners, face_nodes};
use crate::programs::dofs::DofMap;
use crate::programs::rigid_motions::{self, RigidMotions};
use crate::programs::super_elements::SuperElements;
use bracket_base::math::quadrature::{TRIANGLE_4, triangle_mass, triangle_p2};
use bracket_base::math::vec3;

/// How the body force of an element is distributed to its outer nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyForceNodes {
    /// Plain element: all nodes are outer ones.
    Plain,
    /// Split element whose inner displacements are unknowns of their own: the inner nodes carry
    /// their own part.
    Split,
    /// Split element whose inner velocities follow the outer ones at constant divergence: the outer
    /// nodes carry all of the force.
    Flow,
}

/// Distribution of the body force of each tet.
pub type BodyForceNodesOf<'a> = &'a dyn Fn(usize) -> BodyForceNodes;

/// Forces of the loads on the nodes of 10-node tetrahedra \[N\].
fn nodal_forces(
    model: &AnalysisModel,
    space: &Tet10Space,
    body_force_nodes: BodyForceNodesOf,
    loads: Loads,
) -> Vec<f64> {
    let mut f = vec![0.0; 3 * space.nodes.len()];
    let body = model.body_forces(loads);
    if body.iter().any(|b| *b != [0.0; 3]) {
        let (plain, split) = (tet10::shape_integrals(), split_tet10::shape_integrals());
        for e in 0..model.mesh.tets.len() {
            let of = model.mesh.tet_body[e] as usize;
            let (b, v) = (body[of], model.mesh.volume(e));
            let forces: [f64; 30] = match body_force_nodes(e) {
                BodyForceNodes::Plain => std::array::from_fn(|i| plain[i / 3] * v * b[i % 3]),
                BodyForceNodes::Split => std::array::from_fn(|i| split[i / 3] * v * b[i % 3]),
                BodyForceNodes::Flow => split_flow::body_forces(&model.mesh.corners(e), v, b),
            };
            for (n, force) in space.tet(&model.mesh, e).into_iter().zip(forces.chunks_exact(3)) {
                (0..3).for_each(|d| f[3 * n + d] += force[d]);
            }
        }
    }
    for load in model.surface_loads.iter().filter(|l| loads.share(l.dead) != 0.0) {
        let share = loads.share(load.dead);
        for face in &load.faces {
            let corners = face_corners(&model.mesh, face);
            let nodes = space.triangle(face_nodes(&model.mesh, face));
            let area = vec3::area_vector(&corners);
            let size = vec3::norm(area);
            let normal = vec3::scale(1.0 / size, area);
            for (l, w) in TRIANGLE_4 {
                let x = std::array::from_fn(|d| (0..3).map(|i| l[i] * corners[i][d]).sum());
                let t = vec3::scale(share, load.at(x, normal));
                for (n, s) in nodes.iter().zip(triangle_p2(l)) {
                    (0..3).for_each(|d| f[3 * n + d] += w * size * s * t[d]);
                }
            }
        }
    }
    f
}

/// Loads and actions of rigid faces on the shared unknowns of the kinematic program \[N\].
pub fn kinematic_forces(
    model: &AnalysisModel,
    space: &Tet10Space,
    map: &DofMap,
    rigid: &[RigidMotions],
    body_force_nodes: BodyForceNodesOf,
    loads: Loads,
) -> Vec<f64> {
    let mut f = map.reduce(&nodal_forces(model, space, body_force_nodes, loads));
    rigid_motions::add_rigid_actions(model, rigid, loads, &mut f);
    f
}

/// Mass-weighted surface loads on the full unknowns of the static program \[N\].
fn face_forces(elements: &SuperElements, loads: Loads) -> Vec<f64> {
    let model = elements.model();
    let mut f = vec![0.0; 9 * elements.faces.nodes.len()];
    for load in model.surface_loads.iter().filter(|l| loads.share(l.dead) != 0.0) {
        let share = loads.share(load.dead);
        for face in &load.faces {
            let corners = face_corners(&model.mesh, face);
            let dofs = elements.vertex_dofs(face, face_nodes(&model.mesh, face));
            let vector = vec3::area_vector(&corners);
            let area = vec3::norm(vector);
            let normal = vec3::scale(1.0 / area, vector);
            let t = corners.map(|x| vec3::scale(share, load.at(x, normal)));
            for a in 0..3 {
                for b in 0..3 {
                    (0..3).for_each(|d| f[dofs[a] + d] += triangle_mass(a, b) * area * t[b][d]);
                }
            }
        }
    }
    f
}

/// Surface loads and actions of rigid faces on the unknowns of the static program \[N\].
pub fn static_forces(
    elements: &SuperElements,
    map: &DofMap,
    rigid: &[RigidMotions],
    loads: Loads,
) -> Vec<f64> {
    let mut f = map.reduce(&face_forces(elements, loads));
    rigid_motions::add_rigid_actions(elements.model(), rigid, loads, &mut f);
    f
}
