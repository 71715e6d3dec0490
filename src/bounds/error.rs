//! Contributions to the gap: Fenchel's inequality element by element and interface face by interface face.
//!
//! `Π_p + Π_c = Σ_K ½ ∫ (σ − Cε):C⁻¹:(σ − Cε) + Σ_contact ∫ r_N (g_N + g₀) + r_T·g_T + Σ_weld (D − ∫ t·g)`, every term ≥ 0;
//! D is the dissipation of a weld face, an upper bound of `∫ strength ‖g‖`.
//!
//! # Source
//! Ladevèze and Pelle; section 4.1 of the paper, equations (11) and (12).

use super::certificate::contact_tractions;
use super::faces::{contact_faces, roles, weld_faces};
use super::fields::{DisplacementField, StressField};
use super::welds;
use crate::math::Sum;
use crate::math::quadrature::{TRIANGLE_4, triangle_p2};
use crate::math::vec3::{self, V3};
use crate::mesh::tet::FACES;
use crate::model::AnalysisModel;
use crate::model::kinematic::Tet10Space;
use crate::model::loads::Loads;
use crate::model::opening::bernstein_at;
use crate::model::super_element::{PointStress, integrate};
use crate::model::tet10;

/// The gap of a pair of fields, split over elements and contact faces \[N mm\].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contributions {
    /// Of each macro tet.
    pub elements: Vec<f64>,
    /// Of each contact face, in the order of [`contact_faces`].
    pub contacts: Vec<f64>,
    /// Of each weld face, in the order of [`weld_faces`].
    pub welds: Vec<f64>,
}

impl Contributions {
    /// Their sum: `Π_p + Π_c`.
    pub fn total(&self) -> f64 {
        Sum::of(self.elements.iter().chain(&self.contacts).chain(&self.welds).copied())
    }
}

/// Contributions of a pair of fields.
pub fn contributions(model: &AnalysisModel, u: &DisplacementField, s: &StressField) -> Contributions {
    let space = Tet10Space::new(&model.mesh);
    let materials = model.stiffnesses();
    let elements = (0..model.mesh.tets.len())
        .map(|e| {
            let nodes = space.tet(&model.mesh, e).map(|n| u.u[n]);
            let material = &materials[model.mesh.tet_body[e] as usize];
            let v = tet10::vertex_strains(&model.mesh.corners(e), &nodes).map(|x| material.stress(&x));
            let centre = std::array::from_fn(|c| 0.25 * (v[0][c] + v[1][c] + v[2][c] + v[3][c]));
            let difference: PointStress = std::array::from_fn(|k| {
                std::array::from_fn(|p| {
                    let kinematic = if p < 3 { &v[FACES[k][p]] } else { &centre };
                    std::array::from_fn(|c| s.points[e][k][p][c] - kinematic[c])
                })
            });
            0.5 * integrate(model.mesh.volume(e), material, &difference, &difference)
        })
        .collect();
    let roles = roles(model, Loads::ALL);
    let contacts = contact_faces(model)
        .iter()
        .map(|f| {
            let r = contact_tractions(model, s, f, roles.get(&(f.a.tet, f.a.local)));
            let (n, area) = f.normal(model);
            let opening = f.opening(model);
            let a = space.triangle(f.nodes_a).map(|n| u.u[n]);
            let b = f.b.map_or([[0.0; 3]; 6], |(_, nodes)| space.triangle(nodes).map(|n| u.u[n]));
            let terms = TRIANGLE_4.iter().map(|(l, w)| {
                let shape = triangle_p2(*l);
                let g = (0..6).fold([0.0; 3], |s, i| vec3::add(s, vec3::scale(shape[i], vec3::sub(b[i], a[i]))));
                let at = |v: &[V3; 3]| -> V3 { std::array::from_fn(|d| (0..3).map(|i| l[i] * v[i][d]).sum()) };
                let r = at(&r);
                w * area * (vec3::dot(r, g) + vec3::dot(r, n) * bernstein_at(&opening, *l))
            });
            terms.sum()
        })
        .collect();
    let welds = weld_faces(model)
        .iter()
        .map(|f| {
            let r = contact_tractions(model, s, f, roles.get(&(f.a.tet, f.a.local)));
            let (_, area) = f.normal(model);
            let g = welds::jumps(&space, f, &u.u);
            let terms = TRIANGLE_4.iter().map(|(l, w)| {
                let shape = triangle_p2(*l);
                let g = (0..6).fold([0.0; 3], |s, i| vec3::add(s, vec3::scale(shape[i], g[i])));
                let r: V3 = std::array::from_fn(|d| (0..3).map(|i| l[i] * r[i][d]).sum());
                w * area * vec3::dot(r, g)
            });
            welds::dissipation_of(model, &space, f, &u.u) + terms.sum::<f64>()
        })
        .collect();
    Contributions { elements, contacts, welds }
}
