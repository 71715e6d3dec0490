//! The super-elements of a mesh: elements, face numbering and body forces shared by the static
//! program and the recovery of its stresses.

use crate::elements::super_element::{SuperElement, TRACTIONS};
use crate::mesh::numbering::FaceNumbering;
use crate::mesh::quality;
use crate::model::ModelError;
use crate::model::analysis::{AnalysisModel, BoundaryFace};
use crate::model::loads::Loads;
use bracket_base::math::mandel::Isotropic;
use bracket_base::math::vec3::V3;

/// The super-elements of a model under some of its loads.
pub struct SuperElements<'a> {
    model: &'a AnalysisModel,
    /// The faces, each with 9 displacement unknowns (3 vertices in increasing node order × 3
    /// components).
    pub faces: FaceNumbering,
    materials: Vec<Isotropic>,
    body: Vec<V3>,
    origin: V3,
}

impl<'a> SuperElements<'a> {
    /// Numbers the faces of the model's mesh.
    pub fn new(model: &'a AnalysisModel) -> Self {
        // the particular stress of a body force vanishes at the first node of the mesh: the numbers
        // stay small wherever the origin of the axes lies
        let origin = model.mesh.nodes.first().copied().unwrap_or_default();
        Self {
            model,
            faces: FaceNumbering::new(&model.mesh),
            materials: model.stiffnesses(),
            body: model.body_forces(Loads::ALL),
            origin,
        }
    }

    /// The same elements under other loads: the body forces among `loads` set their particular
    /// stress.
    pub fn under(self, loads: Loads) -> Self {
        Self { body: self.model.body_forces(loads), ..self }
    }

    /// Force per volume of each body \[N/mm³\].
    pub fn body_forces(&self) -> &[V3] {
        &self.body
    }

    /// True when some body carries a force per volume.
    pub fn has_body_forces(&self) -> bool {
        self.body.iter().any(|b| *b != [0.0; 3])
    }

    /// The element of tet `e`.
    pub fn element(&self, e: usize) -> Result<SuperElement, ModelError> {
        let corners = self.model.mesh.corners(e);
        let body = self.model.mesh.tet_body[e] as usize;
        let force = self.body[body];
        let force = (force != [0.0; 3]).then_some((force, self.origin));
        SuperElement::new(corners, self.materials[body], force).ok_or_else(|| ModelError::FlatTet {
            tet: e,
            words: quality::tet_words(&self.model.mesh, e),
        })
    }

    /// Full unknowns of tet `e` in the element's order.
    pub fn dofs(&self, e: usize) -> [usize; TRACTIONS] {
        let mut d = [0; TRACTIONS];
        for k in 0..4 {
            let at = self.faces.positions(&self.model.mesh, e, k);
            for p in 0..3 {
                for c in 0..3 {
                    d[9 * k + 3 * p + c] = 9 * self.faces.of_tet[e][k] as usize + 3 * at[p] + c;
                }
            }
        }
        d
    }

    /// Part a face belongs to.
    pub fn part(&self, face: usize) -> usize {
        self.model.tet_part[self.faces.tets[face].0 as usize] as usize
    }

    /// The model the elements belong to.
    pub fn model(&self) -> &'a AnalysisModel {
        self.model
    }

    /// First full unknown of each vertex of a triangle that is local face `face.local` of
    /// `face.tet`; `nodes` gives the order.
    pub fn vertex_dofs(&self, face: &BoundaryFace, nodes: [u32; 3]) -> [usize; 3] {
        let f = self.faces.of_tet[face.tet as usize][face.local as usize] as usize;
        nodes.map(|n| {
            9 * f
                + 3 * self.faces.nodes[f]
                    .iter()
                    .position(|m| *m == n)
                    .expect("the nodes are those of the face")
        })
    }
}
