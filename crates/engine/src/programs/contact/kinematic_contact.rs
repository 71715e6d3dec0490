//! Control points of the kinematic program: the Bernstein coefficients of gap and slip on contact
//! faces.
//!
//! Gap and slip are quadratic on a face. A quadratic polynomial lies in a convex cone wherever its
//! six Bernstein coefficients do, so a cone at each coefficient enforces the contact law at every
//! point of the face.

use crate::elements::space::{FACE_EDGES, Tet10Space};
use crate::model::analysis::AnalysisModel;
use crate::model::loads::{face_corners, face_nodes};
use crate::model::opening::Bernstein;
use crate::programs::conic::ConicProgram;
use crate::programs::contact::cone::{self, Closing};
use crate::programs::dofs::DofMap;
use bracket_base::math::vec3::{self, V3};
use std::collections::BTreeMap;

/// Contact, node on side A, node on side B and rounded normal of a control point.
pub type Key = (usize, usize, usize, [i64; 3]);

/// A Bernstein coefficient of the gap on an interface: a vertex, or an edge with its two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControlPoint {
    /// Contact it belongs to: interfaces first, then contacts with the ground.
    pub contact: usize,
    /// Unit normal out of side A.
    pub normal: V3,
    /// Friction coefficient.
    pub mu: f64,
    /// Coefficient of the initial gap, and of the shift where there is one \[mm\].
    pub gap: f64,
    /// Nodes on side A: vertex, or mid-side and ends.
    pub a: [usize; 3],
    /// Nodes on side B; `None`: rigid ground.
    pub b: Option<[usize; 3]>,
    /// Closing of ground that gives way; the dissipation of crushing ground is its strength times
    /// the integral of the Bernstein polynomials of the point.
    pub closing: Option<Closing>,
    /// True for an edge: the coefficient is `2 u_mid − ½ (u_i + u_j)`.
    pub edge: bool,
}

impl ControlPoint {
    /// Weights of the nodes in the coefficient.
    pub fn weights(&self) -> &'static [f64] {
        if self.edge { &[2.0, -0.5, -0.5] } else { &[1.0] }
    }

    /// Identity of the point: contact, node on each side and the normal, rounded so that faces in
    /// one plane share it.
    pub fn key(&self) -> Key {
        // normals of faces in one plane agree to rounding; faces that bend by more keep a cone
        // each, otherwise the upper bound would not be strict
        let rounded = self.normal.map(|x| (x * 1e12).round() as i64);
        (self.contact, self.a[0], self.b.map_or(usize::MAX, |b| b[0]), rounded)
    }

    /// Length of the coefficient of the slip under nodal displacements \[mm\].
    pub fn slip(&self, u: &[V3]) -> f64 {
        let jump = self.jump(u);
        vec3::norm(vec3::sub(jump, vec3::scale(vec3::dot(jump, self.normal), self.normal)))
    }

    /// Coefficient of the jump `u_B − u_A` under nodal displacements \[mm\].
    pub fn jump(&self, u: &[V3]) -> V3 {
        let side = |n: &[usize; 3]| {
            self.weights()
                .iter()
                .zip(n)
                .fold([0.0; 3], |s, (&w, &i)| vec3::add(s, vec3::scale(w, u[i])))
        };
        vec3::sub(self.b.as_ref().map_or([0.0; 3], &side), side(&self.a))
    }

    /// Appends the contact cone of the point to a program; false when nothing of it can move.
    /// `closing`: the unknown of the closing of the ground, where it gives way.
    pub fn push_cone(
        &self,
        program: &mut ConicProgram,
        map: &DofMap,
        closing: Option<usize>,
    ) -> bool {
        let jump = |n: V3, factor: f64| {
            let mut full = Vec::new();
            for (i, &w) in self.weights().iter().enumerate() {
                for d in 0..3 {
                    if let Some(b) = self.b {
                        full.push((3 * b[i] + d, factor * w * n[d]));
                    }
                    full.push((3 * self.a[i] + d, -factor * w * n[d]));
                }
            }
            full
        };
        let closing: Vec<_> = closing.map(|k| (k as u32, 1.0)).into_iter().collect();
        cone::push_cone(program, map, (self.normal, self.mu, self.gap), &closing, jump)
    }
}

/// The six control points of every contact face, interfaces first. Neighbours in one plane repeat
/// the points that they share.
pub fn points_of_faces(model: &AnalysisModel, space: &Tet10Space) -> Vec<[ControlPoint; 6]> {
    let interfaces = model.interfaces.iter().enumerate().flat_map(|(contact, interface)| {
        interface.faces.iter().map(move |f| {
            let corners = f.nodes_a.map(|n| model.mesh.nodes[n as usize]);
            (contact, corners, space.triangle(f.nodes_a), Some(space.triangle(f.nodes_b)))
        })
    });
    let ground = (model.interfaces.len()..).zip(&model.ground).flat_map(|(contact, ground)| {
        ground.faces.iter().map(move |f| {
            let a = space.triangle(face_nodes(&model.mesh, f));
            (contact, face_corners(&model.mesh, f), a, None)
        })
    });
    interfaces
        .chain(ground)
        .enumerate()
        .map(|(face, (contact, corners, a, b))| {
            let law = model.contact_law(contact);
            let area = vec3::norm(vec3::area_vector(&corners));
            let closing = cone::closing_of(model, contact, area / 6.0);
            let law = (law.mu, closing, model.opening(face, law, &corners));
            points_of_face(contact, law, &corners, a, b)
        })
        .collect()
}

/// Every distinct control point of the contacts of a model.
pub fn control_points(model: &AnalysisModel, space: &Tet10Space) -> Vec<ControlPoint> {
    let mut place: BTreeMap<Key, usize> = BTreeMap::new();
    let mut points: Vec<ControlPoint> = Vec::new();
    for point in points_of_faces(model, space).into_iter().flatten() {
        let at = *place.entry(point.key()).or_insert(points.len());
        match (points.get_mut(at).map(|p| &mut p.closing), point.closing) {
            (None, _) => points.push(point),
            (Some(Some(Closing::Crushing(sum))), Some(Closing::Crushing(more))) => *sum += more,
            (Some(_), _) => {}
        }
    }
    points
}

fn points_of_face(
    contact: usize,
    (mu, closing, opening): (f64, Option<Closing>, Bernstein),
    corners: &[V3; 3],
    a: [usize; 6],
    b: Option<[usize; 6]>,
) -> [ControlPoint; 6] {
    let area = vec3::area_vector(corners);
    let size = vec3::norm(area);
    let normal = vec3::scale(1.0 / size, area);
    std::array::from_fn(|i| {
        // the coefficient of a vertex has one node, that of an edge its mid-side node and two ends
        let picked = if i < 3 { [i; 3] } else { [i, FACE_EDGES[i - 3][0], FACE_EDGES[i - 3][1]] };
        let pick = |n: [usize; 6]| picked.map(|k| n[k]);
        ControlPoint {
            contact,
            normal,
            mu,
            gap: opening[i],
            a: pick(a),
            b: b.map(pick),
            closing,
            edge: i >= 3,
        }
    })
}
