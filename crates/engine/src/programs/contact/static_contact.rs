//! Contact vertices of the static program: one traction cone at each vertex of a contact face.
//!
//! The cone bounds the mass-weighted jump `Σ_b M_ab (v_B − v_A)_b + ∫ φ_a g₀ n`, conjugate to the
//! traction at face vertex a. The traction is linear on the face, so the vertices suffice.

use crate::model::analysis::ContactLaw;
use crate::model::loads::{face_corners, face_nodes};
use crate::model::opening::bernstein_at;
use crate::programs::conic::ConicProgram;
use crate::programs::contact::cone::{self, Closing};
use crate::programs::dofs::DofMap;
use crate::programs::super_elements::SuperElements;
use bracket_base::math::quadrature::{TRIANGLE_4, triangle_mass};
use bracket_base::math::vec3::{self, V3};

/// A vertex of a contact face, which carries one traction cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactVertex {
    /// Contact it belongs to: interfaces first, then contacts with the ground.
    pub contact: usize,
    /// Unit normal out of side A.
    pub normal: V3,
    /// Friction coefficient.
    pub mu: f64,
    /// First full unknown of each vertex on side A; this cone's vertex is `index`.
    pub a: [usize; 3],
    /// The same on side B; `None`: rigid ground.
    pub b: Option<[usize; 3]>,
    /// Position of the vertex in the face, 0 to 2.
    pub index: usize,
    /// Area of the face \[mm²\].
    pub area: f64,
    /// Closing of ground that gives way.
    pub closing: Option<Closing>,
    /// `∫ φ_a (g₀ + s)` with the shift s of the cone, zero without one \[mm³\].
    pub gap: f64,
}

impl ContactVertex {
    /// True when both are the same vertex of the same face.
    pub fn is_at(&self, other: &Self) -> bool {
        (self.contact, self.a, self.index) == (other.contact, other.a, other.index)
    }

    /// Appends the contact cone of the vertex to a program; false when nothing of it can move.
    /// `closing`: the unknown of the closing of the ground, where it gives way. Closings of the
    /// vertices of a face follow one another.
    pub fn push_cone(
        &self,
        program: &mut ConicProgram,
        map: &DofMap,
        closing: Option<usize>,
    ) -> bool {
        let mass = |b: usize| triangle_mass(self.index, b) * self.area;
        let jump = |n: V3, factor: f64| {
            let mut full = Vec::new();
            for b in 0..3 {
                let w = factor * mass(b);
                for d in 0..3 {
                    if let Some(side) = self.b {
                        full.push((side[b] + d, w * n[d]));
                    }
                    full.push((self.a[b] + d, -w * n[d]));
                }
            }
            full
        };
        let closings = match (closing, self.closing) {
            (Some(k), Some(Closing::Crushing(_))) => vec![(k as u32, self.area / 3.0)],
            // mass-weighted as the jump is
            (Some(k), Some(Closing::Elastic)) => {
                (0..3).map(|b| ((k - self.index + b) as u32, mass(b))).collect()
            }
            _ => Vec::new(),
        };
        cone::push_cone(program, map, (self.normal, self.mu, self.gap), &closings, jump)
    }
}

/// Every contact vertex of the model, face by face, interfaces first.
pub fn contact_vertices(elements: &SuperElements) -> Vec<ContactVertex> {
    let model = elements.model();
    let mut out = Vec::new();
    let mut number = 0;
    let mut face = |contact: usize,
                    law: &ContactLaw,
                    corners: &[V3; 3],
                    a: [usize; 3],
                    b: Option<[usize; 3]>| {
        let vector = vec3::area_vector(corners);
        let area = vec3::norm(vector);
        let opening = model.opening(number, law, corners);
        number += 1;
        for index in 0..3 {
            let gap = TRIANGLE_4
                .iter()
                .map(|(l, w)| w * area * l[index] * bernstein_at(&opening, *l))
                .sum();
            let normal = vec3::scale(1.0 / area, vector);
            let closing = cone::closing_of(model, contact, area / 3.0);
            out.push(ContactVertex {
                contact,
                normal,
                mu: law.mu,
                a,
                b,
                index,
                area,
                closing,
                gap,
            });
        }
    };
    for (contact, interface) in model.interfaces.iter().enumerate() {
        for f in &interface.faces {
            let corners = f.nodes_a.map(|n| model.mesh.nodes[n as usize]);
            let b = elements.vertex_dofs(&f.b, f.nodes_b);
            face(contact, &interface.law, &corners, elements.vertex_dofs(&f.a, f.nodes_a), Some(b));
        }
    }
    for (contact, ground) in (model.interfaces.len()..).zip(&model.ground) {
        for f in &ground.faces {
            let nodes = face_nodes(&model.mesh, f);
            face(
                contact,
                &ground.law,
                &face_corners(&model.mesh, f),
                elements.vertex_dofs(f, nodes),
                None,
            );
        }
    }
    out
}
