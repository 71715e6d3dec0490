//! Unknowns held against the free rigid motions of the model: motions that nothing resists and on
//! which no load works.

use crate::elements::space::Tet10Space;
use crate::model::analysis::AnalysisModel;
use crate::programs::constraints;
use crate::programs::dofs::DofMap;
use crate::programs::rigid_motions::{self, RigidMotions, RigidPieces};
use crate::programs::super_elements::SuperElements;
use bracket_base::math::rigid_motion::rigid_displacement;

/// Unknowns of the kinematic program to hold: one vertex displacement for each free rigid motion.
pub fn kinematic_pins(
    model: &AnalysisModel,
    space: &Tet10Space,
    map: &DofMap,
    rigid: &[RigidMotions],
    pieces: &RigidPieces,
) -> Vec<usize> {
    if model.free_modes.is_empty() {
        return Vec::new();
    }
    let part = model.node_parts();
    let motions = model
        .free_modes
        .iter()
        .map(|mode| {
            let motion = |node: usize| {
                let vertex = space.a_vertex(node);
                rigid_displacement(
                    &mode.motions[part[vertex] as usize],
                    [0.0; 3],
                    space.nodes[node],
                )
            };
            let mut x = vec![0.0; map.n];
            if !pieces.is_empty() {
                // a part may be rigid as a whole, with no unknown but its motion
                let nearest = rigid_motions::nearest_unknowns(map, rigid, |i| motion(i / 3)[i % 3]);
                x[map.plain..].copy_from_slice(&nearest[map.plain..]);
            }
            for v in 0..space.vertices {
                let u = motion(v);
                for d in 0..3 {
                    if let Some(k) = map.own(3 * v + d) {
                        x[k] = u[d];
                    }
                }
            }
            x
        })
        .collect();
    constraints::pins(motions, &[])
}

/// The motion of every part as displacements of single face unknowns; the motions of rigid faces
/// are left at zero.
fn part_motions(
    elements: &SuperElements,
    map: &DofMap,
    motion_of_part: impl Fn(usize) -> [f64; 6],
) -> Vec<f64> {
    let mesh = &elements.model().mesh;
    let mut x = vec![0.0; map.n];
    for (f, nodes) in elements.faces.nodes.iter().enumerate() {
        let motion = motion_of_part(elements.part(f));
        for (p, &n) in nodes.iter().enumerate() {
            let u = rigid_displacement(&motion, [0.0; 3], mesh.nodes[n as usize]);
            for d in 0..3 {
                if let Some(k) = map.own(9 * f + 3 * p + d) {
                    x[k] = u[d];
                }
            }
        }
    }
    x
}

/// Unknowns of the static program to hold: one face displacement for each free rigid motion.
pub fn static_pins(
    elements: &SuperElements,
    map: &DofMap,
    rigid: &[RigidMotions],
    pieces: &RigidPieces,
) -> Vec<usize> {
    let modes = elements.model().free_modes.iter().map(|mode| {
        let mut x = part_motions(elements, map, |part| mode.motions[part]);
        if !pieces.is_empty() {
            // a part may be rigid as a whole, with no unknown but its motion
            let nearest = rigid_motions::nearest_unknowns(map, rigid, |i| {
                let node = elements.faces.nodes[i / 9][i % 9 / 3] as usize;
                let motion = &mode.motions[elements.part(i / 9)];
                rigid_displacement(motion, [0.0; 3], elements.model().mesh.nodes[node])[i % 3]
            });
            x[map.plain..].copy_from_slice(&nearest[map.plain..]);
        }
        x
    });
    constraints::pins(modes.collect(), &[])
}
