//! The 10-node tetrahedron that yields, plain or split: unknown deviatoric stresses at its yield
//! points in addition to its displacements.
//!
//! # Elastic, perfectly plastic (Hencky)
//! Energy with displacements u and traceless plastic strain p, linear in every (sub)tet:
//! `½ ∫ (ε − p):C:(ε − p) + ∫ √(2/3) f_y ‖p‖`. The elastic part is exact. The dissipation is
//! convex, so the vertex rule `V/4 Σ_i √(2/3) f_y ‖p_i‖` bounds it from above, and is exact where p
//! is constant or zero. The minimum over p equals the maximum, over deviators q conjugate to the
//! vertex strains with `‖q_i‖ ≤ V/4 √(2/3) f_y`, of `Σ q_i·dev ε_i − ½ Σ q_i (M⁻¹)_ij q_j / 2G`,
//! with M the mass matrix. The change of volume stays elastic.
//!
//! # Rigid-plastic (limit analysis)
//! The dissipation `∫ √(2/3) f_y ‖ε‖` by a rule is the maximum, over deviators q at its points with
//! `‖q_j‖ ≤ w_j √(2/3) f_y`, of `Σ q_j·ε_j`. Pressures enforce `tr ε = 0`. The split
//! element needs one, for `∫ div u = 0`, since its inner velocities follow from the outer ones; the
//! plain element needs four, at its vertices.
//!
//! # Sign
//! The multiplier of a point is `(‖p_i‖, −p_i)` times `V/4 √(2/3) f_y`: its deviatoric part points
//! against the plastic strain.

use crate::elements::columns::Columns;
use crate::elements::flow_maps;
use crate::elements::tet10::{self, strain_columns};
use crate::elements::yielding_element::{Rule, Shape, YieldingElement};
use crate::elements::{split_flow, split_tet10};
use bracket_base::math::mandel::{Isotropic, deviator};
use bracket_base::math::vec3::V3;

/// Element of a body that yields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flow {
    /// The plain 10-node tetrahedron: cheap, but it locks in isochoric plastic flow.
    Plain,
    /// The tetrahedron split at its centroid: the same outer unknowns, no locking.
    Split,
}

/// Data of one yielding element.
pub struct YieldingTet10 {
    /// Its corners \[mm\].
    pub corners: [V3; 4],
    /// Its volume \[mm³\].
    pub volume: f64,
    /// Its material.
    pub material: Isotropic,
    /// Radius √(2/3) f_y of the yield surface \[MPa\].
    pub radius: f64,
    /// Force per volume \[N/mm³\].
    pub body_force: V3,
    /// True: split into four subtets.
    pub split: bool,
    /// Its yield points, and whether it is elastic below yield.
    pub rule: Rule,
}

/// The part of the stiffness that resists a change of volume.
fn bulk(material: &Isotropic) -> Isotropic {
    Isotropic { lambda: material.lambda + material.two_mu / 3.0, two_mu: 0.0 }
}

impl YieldingTet10 {
    /// Stiffness on the outer displacements in P: the elastic resistance to a change of volume,
    /// with the inner displacements of the split element held. Zero for rigid-plastic elements.
    pub fn outer_stiffness(&self) -> tet10::Matrix30 {
        let material = bulk(&self.material);
        if self.rule != Rule::Hencky {
            return Box::new([[0.0; 30]; 30]);
        }
        match self.split {
            true => split_tet10::outer_stiffness(&split_tet10::stiffness(
                &self.corners,
                self.volume,
                &material,
            )),
            false => tet10::stiffness(&self.corners, self.volume, &material),
        }
    }

    /// Diagonal of the elastic stiffness on the outer displacements \[N/mm\].
    pub fn elastic_diagonal(&self) -> [f64; 30] {
        tet10::diagonal(&self.corners, self.volume, &self.material)
    }

    /// The element; `columns` are its 30 outer displacements.
    pub fn element(&self, columns: &Columns) -> YieldingElement {
        let subtets = if self.split { 4 } else { 1 };
        let inner =
            if self.split && self.rule == Rule::Hencky { split_tet10::INNER_UNKNOWNS } else { 0 };
        let pressures = match (self.rule, self.split) {
            (Rule::Hencky, _) => 0,
            (_, true) => 1,
            (_, false) => 4,
        };
        let shape = Shape::Flow { subtets, rule: self.rule, inner, pressures };
        let mut data = Vec::with_capacity(shape.len(columns.unknowns.len()));
        for subtet in 0..subtets {
            self.push_strain(subtet, columns, &mut data);
        }
        let volume = self.volume / subtets as f64;
        let flexibility = match self.rule {
            Rule::Hencky => volume * self.radius * self.radius / (16.0 * self.material.two_mu),
            Rule::TenPoints | Rule::Gauss | Rule::Vertices => 0.0,
        };
        data.extend(std::iter::repeat_n(flexibility, subtets));
        for row in self.pressure_rows(pressures) {
            data.extend(columns.row(&row.map(|x| self.radius * x)));
        }
        let mut q = vec![0.0; shape.parameters()];
        let mut inner_stiffness = Vec::new();
        if inner > 0 {
            self.push_inner(columns, &mut data, &mut q, &mut inner_stiffness);
        }
        let h = (0..shape.points()).flat_map(|_| [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]).collect();
        let plain = columns.terms.is_none() && self.split && self.rule != Rule::Hencky;
        let maps = match plain {
            true => flow_maps::numbers(&self.corners, volume * self.radius),
            false => Vec::new(),
        };
        let columns = columns.unknowns.clone();
        YieldingElement { shape, columns, data, maps, q, h, inner_stiffness }
    }

    /// Deviatoric strains at the vertices of a subtet, times its volume and the yield radius.
    fn push_strain(&self, subtet: usize, columns: &Columns, data: &mut Vec<f64>) {
        if !self.split {
            let strains = strain_columns(&self.corners);
            let factor = self.volume * self.radius;
            for at_vertex in &strains {
                let e = at_vertex.map(|e| deviator(&e));
                for a in 0..5 {
                    data.extend(columns.row(&e.map(|e| factor * e[a])));
                }
            }
            return;
        }
        let strains = strain_columns(&split_tet10::subtet_corners(&self.corners, subtet));
        let nodes = split_tet10::subtet_nodes(subtet);
        let factor = 0.25 * self.volume * self.radius;
        // rigid-plastic: the inner displacements follow the outer ones
        let follow = (self.rule != Rule::Hencky).then(|| split_flow::inner_rows(&self.corners));
        for at_vertex in &strains {
            let e = at_vertex.map(|e| deviator(&e));
            for a in 0..5 {
                let mut full = [0.0; 45];
                for (c, e) in e.iter().enumerate() {
                    full[3 * nodes[c / 3] + c % 3] += factor * e[a];
                }
                let (outer, inner) = full.split_at_mut(30);
                match &follow {
                    Some(rows) => {
                        for (w, row) in inner.iter().zip(rows.iter()) {
                            outer.iter_mut().zip(row).for_each(|(o, r)| *o += w * r);
                        }
                    }
                    None => data.extend_from_slice(inner),
                }
                data.extend(columns.row(outer));
            }
        }
    }

    /// Linear forms that vanish when the volume is constant: `∫ div u` of the split element,
    /// `V/4 tr ε` at the vertices of the plain element.
    fn pressure_rows(&self, count: usize) -> Vec<[f64; 30]> {
        match count {
            0 => Vec::new(),
            1 => vec![split_flow::volume_row(&self.corners)],
            _ => strain_columns(&self.corners)
                .iter()
                .map(|vertex| vertex.map(|e| 0.25 * self.volume * (e[0] + e[1] + e[2])))
                .collect(),
        }
    }

    /// Appends the volumetric stiffness of the inner displacements, their loads and the elastic
    /// stiffness that scales them.
    fn push_inner(
        &self,
        columns: &Columns,
        data: &mut Vec<f64>,
        q: &mut Vec<f64>,
        measure: &mut Vec<f64>,
    ) {
        let k = split_tet10::stiffness(&self.corners, self.volume, &bulk(&self.material));
        let elastic = split_tet10::stiffness(&self.corners, self.volume, &self.material);
        let weights = split_tet10::shape_integrals();
        for i in 0..split_tet10::INNER_UNKNOWNS {
            let row = &k[3 * split_tet10::OUTER + i];
            data.extend_from_slice(&row[30..]);
            data.extend(columns.row(&row[..30]));
            q.push(-weights[split_tet10::OUTER + i / 3] * self.volume * self.body_force[i % 3]);
            measure.push(elastic[30 + i][30 + i]);
        }
    }
}
