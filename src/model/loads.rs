//! Loads as nodal forces: tractions on faces, forces in bodies; exact for the polynomials they are.

use super::analysis::{AnalysisModel, BoundaryFace, SurfaceLoad, Traction};
use crate::math::vec3::{self, V3};
use crate::mesh::TetMesh;
use crate::mesh::tet::FACES;

/// Corner nodes of a boundary face, outward order.
pub fn face_nodes(mesh: &TetMesh, f: &BoundaryFace) -> [u32; 3] {
    FACES[f.local as usize].map(|i| mesh.tets[f.tet as usize][i])
}

/// Coordinates of the corners of a boundary face, outward order \[mm\].
pub fn face_corners(mesh: &TetMesh, f: &BoundaryFace) -> [V3; 3] {
    face_nodes(mesh, f).map(|n| mesh.nodes[n as usize])
}

impl SurfaceLoad {
    /// The traction at `x` on a face with outward unit normal `n` \[MPa\].
    pub fn at(&self, x: V3, n: V3) -> V3 {
        match self.traction {
            Traction::Linear { traction0, gradient } => vec3::add(traction0, vec3::mul(&gradient, x)),
            Traction::Pressure(p) => vec3::scale(-p, n),
        }
    }
}

impl AnalysisModel {
    /// Force per volume of each body, all loads together \[N/mm³\].
    pub fn body_forces(&self) -> Vec<V3> {
        let mut f = vec![[0.0; 3]; self.mesh.bodies.len()];
        for load in &self.body_loads {
            f[load.body as usize] = vec3::add(f[load.body as usize], load.force);
        }
        f
    }

    /// Stiffness of the material of each body.
    pub fn stiffnesses(&self) -> Vec<crate::math::mandel::Isotropic> {
        self.body_material
            .iter()
            .map(|&m| {
                let m = &self.materials[m as usize];
                crate::math::mandel::Isotropic::new(m.e, m.nu)
            })
            .collect()
    }

    /// Radius of the yield surface `‖dev σ‖ ≤ √(2/3) f_y` of each body \[MPa\]; `None`: never yields.
    pub fn yield_radii(&self) -> Vec<Option<f64>> {
        let radius = |m: &u32| self.materials[*m as usize].fy.map(crate::math::mandel::yield_radius);
        self.body_material.iter().map(radius).collect()
    }

    /// Part of each node.
    pub fn node_parts(&self) -> Vec<u32> {
        let mut part = vec![0; self.mesh.nodes.len()];
        for (t, &p) in self.mesh.tets.iter().zip(&self.tet_part) {
            t.iter().for_each(|&n| part[n as usize] = p);
        }
        part
    }
}
