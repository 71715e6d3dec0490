//! Points on ties: the points of both sides share an unknown in every component in which the bodies
//! cannot move relative to each other.
//!
//! In the kinematic program of limit analysis bodies may slip along a tie: a point of one side and
//! that of the other share the velocity along the normal, a coordinate axis, and the difference of
//! the tangential velocities costs `k ∫ ‖[v_T]‖` ([`jumps`]). That bound is strict: the power of a
//! stress field across the tie is `∫ t·[v] ≤ k ∫ ‖[v_T]‖`, because `[v]` has no normal part and no
//! stress inside the yield surface of the weaker body has a larger traction along the face than k.
//! In all other programs the points share all components.
//!
//! Where several ties meet, at an edge, each of them joins its own component, so that a point
//! satisfies the conditions of all its faces.

use crate::elements::space::Tet10Space;
use crate::model::AnalysisModel;
use crate::model::analysis::FacePair;
use crate::programs::constraints::FacePoints;
use crate::programs::weld_face::{Jump, kinematic_jumps};
use bracket_base::math::vec3;

/// The points that share components; each group is named by its first point.
#[derive(Clone, Debug, Default)]
pub struct TiedPoints {
    /// First point of the group of each point, by component; empty without ties.
    first: Vec<[u32; 3]>,
    /// True for points on ties.
    on_tie: Vec<bool>,
}

impl TiedPoints {
    /// The points of a program on the ties of a model. With `slipping` they share the normal
    /// component only.
    pub fn new(model: &AnalysisModel, points: &impl FacePoints, slipping: bool) -> Self {
        if model.ties.is_empty() {
            return Self::default();
        }
        let mut first: Vec<[u32; 3]> = (0..points.count() as u32).map(|p| [p; 3]).collect();
        let mut on_tie = vec![false; points.count()];
        for (_, face) in model.tie_faces() {
            let normal = normal(model, face);
            for [a, b] in points.pairs(face) {
                (on_tie[a], on_tie[b]) = (true, true);
                for d in (0..3).filter(|&d| !slipping || normal == Some(d)) {
                    let (a, b) = (root(&mut first, a, d), root(&mut first, b, d));
                    first[a.max(b)][d] = a.min(b) as u32;
                }
            }
        }
        for p in 0..first.len() {
            (0..3).for_each(|d| first[p][d] = root(&mut first, p, d) as u32);
        }
        Self { first, on_tie }
    }

    /// The first point with which a point shares component `d`.
    pub fn first(&self, point: usize, d: usize) -> usize {
        self.first.get(point).map_or(point, |f| f[d] as usize)
    }

    /// True for a point on a tie.
    pub fn contains(&self, point: usize) -> bool {
        self.on_tie.get(point).is_some_and(|on| *on)
    }
}

fn root(first: &mut [[u32; 3]], mut point: usize, d: usize) -> usize {
    while first[point][d] as usize != point {
        first[point][d] = first[first[point][d] as usize][d];
        point = first[point][d] as usize;
    }
    point
}

/// The coordinate axis along the normal of a face.
fn normal(model: &AnalysisModel, face: &FacePair) -> Option<usize> {
    let corners = face.nodes_a.map(|n| model.mesh.nodes[n as usize]);
    vec3::axis_of(vec3::unit(vec3::area_vector(&corners)))
}

/// The Bernstein coefficients of the tangential jump on a tie face, each times its weight in the
/// integral if `weighted`, on nodal velocities.
pub fn jumps(
    model: &AnalysisModel,
    space: &Tet10Space,
    tied: &TiedPoints,
    face: &FacePair,
    weighted: bool,
) -> Vec<Jump> {
    let axis = normal(model, face);
    let mut jumps = kinematic_jumps(space, face, weighted);
    for jump in &mut jumps {
        for (d, form) in jump.iter_mut().enumerate() {
            if axis == Some(d) {
                form.clear();
            }
            // unknowns that both sides share cancel
            form.iter_mut().for_each(|(dof, _)| *dof = 3 * tied.first(*dof / 3, d) + d);
        }
    }
    jumps
}
