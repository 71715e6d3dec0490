//! Looks up names of bodies and faces in the mesh.

use super::claims::Claims;
use super::faults::Faults;
use crate::mesh::split::TetFace;
use crate::mesh::topology::{FaceRow, FaceTable};
use crate::mesh::{NamedFaces, TetMesh};
use crate::model::analysis::BoundaryFace;
use bracket_base::diag::did_you_mean;

/// The mesh before splitting, bodies sharing nodes, and its faces.
pub(super) struct Scene<'a> {
    /// The mesh.
    pub mesh: &'a TetMesh,
    /// Its faces.
    pub table: &'a FaceTable,
}

impl<'a> Scene<'a> {
    /// The body called `name`, or a fault at `path`.
    pub fn body(&self, name: &str, path: &str, faults: &mut Faults<'_>) -> Option<u32> {
        if let Some(i) = self.mesh.bodies.iter().position(|b| b == name) {
            return Some(i as u32);
        }
        let hint = did_you_mean(name, self.mesh.bodies.iter().map(String::as_str));
        let m = format!("the mesh has no physical volume `{name}`{hint}");
        faults.add(
            "model/unknown-body",
            path,
            m,
            format!("the bodies are: {}", self.mesh.bodies.join(", ")),
        );
        None
    }

    /// The physical surface called `name`, or a fault at `path`.
    pub fn face(&self, name: &str, path: &str, faults: &mut Faults<'_>) -> Option<&'a NamedFaces> {
        let found = self.mesh.faces_named(name);
        if found.is_none() {
            let names: Vec<&str> = self.mesh.faces.iter().map(|f| f.name.as_str()).collect();
            let m = format!(
                "the mesh has no physical surface `{name}`{}",
                did_you_mean(name, names.iter().copied())
            );
            let help = if names.is_empty() {
                "name surfaces in gmsh with `Physical Surface(\"NAME\")`".to_string()
            } else {
                format!("the physical surfaces are: {}", names.join(", "))
            };
            faults.add("model/unknown-face", path, m, help);
        }
        found
    }

    /// Body of one side of a face.
    pub fn body_of(&self, row: &FaceRow) -> u32 {
        self.mesh.tet_body[row.tet as usize]
    }

    /// The outer faces called `name`; a face between two tets is a fault.
    pub fn outer_faces(
        &self,
        name: &str,
        path: &str,
        claims: &Claims,
        faults: &mut Faults<'_>,
    ) -> Vec<BoundaryFace> {
        let Some(named) = self.face(name, path, faults) else { return Vec::new() };
        let mut faces = Vec::with_capacity(named.triangles.len());
        let mut inner = 0;
        let mut first_inner = None;
        for t in &named.triangles {
            match self.table.owners(*t) {
                [one] => faces.push(BoundaryFace { tet: one.tet, local: one.local }),
                owners => {
                    inner += 1;
                    first_inner = first_inner.or(owners.first().zip(owners.get(1)));
                }
            }
        }
        if let Some((a, b)) = first_inner {
            let [ba, bb] = [a, b].map(|r| self.mesh.bodies[self.body_of(r) as usize].as_str());
            let (n, all) = (inner, named.triangles.len());
            let m = if ba == bb {
                format!(
                    "{n} of the {all} triangles of `{name}` lie inside body `{ba}`, not on the \
                     outside"
                )
            } else if claims.is_open(TetFace::from(a)) {
                format!(
                    "{n} of the {all} triangles of `{name}` lie in the contact between `{ba}` and \
                     `{bb}`"
                )
            } else {
                format!(
                    "{n} of the {all} triangles of `{name}` lie between the bodies `{ba}` and \
                     `{bb}`, which are tied there"
                )
            };
            faults.add(
                "model/not-outer",
                path,
                m,
                "supports, rigid faces and loads need free outer faces: name those only",
            );
        }
        // a mesh that was split may name both sides and so, after merging, one face twice
        faces.sort_unstable_by_key(|f| (f.tet, f.local));
        faces.dedup();
        if named.triangles.is_empty() {
            faults.add(
                "model/unknown-face",
                path,
                format!("the face `{name}` is empty"),
                "name outer faces",
            );
        }
        faces
    }
}
