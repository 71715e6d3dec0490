//! Velocities of a collapse mechanism as plain data, and the tets on which they are quadratic.

use crate::certify::fields::DisplacementField;
use crate::elements::hencky_kinematic::Flow;
use crate::elements::space::Tet10Space;
use crate::elements::{split_flow, split_tet10};
use crate::model::AnalysisModel;
use bracket_base::math::vec3::V3;

/// Velocities of vertices and mid-side nodes \[mm per unit of time\], and the kind of element of
/// the bodies that yield.
///
/// In split elements the inner velocities follow from the outer ones as in
/// [`crate::elements::split_flow`]: they are not stored.
#[derive(Clone, Debug, PartialEq)]
pub struct VelocityField {
    /// The velocity of each node.
    pub nodes: DisplacementField,
    /// Elements of the bodies with a yield strength; other bodies are rigid and consist of plain
    /// elements.
    pub flow: Flow,
    /// Motions of the resultant limits of the model, limit by limit
    /// ([`crate::model::resultant_limit`]) \[mm per unit of time\]; empty without limits.
    pub limit_motions: Vec<f64>,
}

/// A tet in which the velocity is quadratic: a plain element or a subtet of a split one.
pub struct Piece {
    /// Corners \[mm\].
    pub corners: [V3; 4],
    /// Volume \[mm³\].
    pub volume: f64,
    /// Velocities: vertices, then mid-sides.
    pub velocities: [V3; 10],
}

/// The pieces of tet `e`, one or four.
pub fn pieces(
    model: &AnalysisModel,
    space: &Tet10Space,
    field: &VelocityField,
    flows: bool,
    e: usize,
) -> Vec<Piece> {
    let (corners, volume) = (model.mesh.corners(e), model.mesh.volume(e));
    let outer = space.tet(&model.mesh, e).map(|n| field.nodes.u[n]);
    if !(flows && field.flow == Flow::Split) {
        return vec![Piece { corners, volume, velocities: outer }];
    }
    let all = split_flow::velocities(&corners, &std::array::from_fn(|i| outer[i / 3][i % 3]));
    (0..4)
        .map(|k| {
            let corners = split_tet10::subtet_corners(&corners, k);
            let velocities =
                split_tet10::subtet_nodes(k).map(|n| [all[3 * n], all[3 * n + 1], all[3 * n + 2]]);
            Piece { corners, volume: 0.25 * volume, velocities }
        })
        .collect()
}
