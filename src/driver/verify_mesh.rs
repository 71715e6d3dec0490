//! The meshes and models of a result, compared with the joint of its spec.

use crate::driver::spec_cases::AskedCase;
use crate::driver::spec_file::SpecFile;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::text_file;
use bracket_base::yaml;
use bracket_engine::mesh::{NamedFaces, TetMesh, msh};
use bracket_engine::model::file::ModelFile;
use bracket_joint::geometry::Scene;
use bracket_joint::meshing::naming::{boundary_differences, name_and_check};
use bracket_report::result::verify::first_difference;
use serde_json::json;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The model files of a case: of the upper bound, and of lower bounds on other meshes.
pub fn model_paths(folder: &Path, stem: &str) -> Vec<PathBuf> {
    let own = folder.join(format!("model_{stem}.yaml"));
    let mut files = vec![if own.exists() { own } else { folder.join("model.yaml") }];
    for kind in ["static", "static_frictionless"] {
        let beside = folder.join("fields").join(format!("{stem}_{kind}.yaml"));
        files.extend(beside.exists().then_some(beside));
    }
    files
}

/// The mesh file that a stored model names.
pub fn mesh_path(model: &Path, stored: &ModelFile) -> PathBuf {
    model.parent().unwrap_or(Path::new("")).join(&stored.mesh)
}

/// Reads a stored model file.
pub fn read_model(path: &Path) -> Result<ModelFile, Diagnostics> {
    let text = text_file::read(path, |e| {
        Diagnostic::input("verify/read", format!("the model cannot be read: {e}")).file(path)
    })?;
    Ok(yaml::parse::<ModelFile>(&text, path)?.value)
}

/// The meshes of a result, each compared once with the solids of the joint.
pub struct Meshes<'a> {
    scene: &'a Scene<'a>,
    read: BTreeMap<PathBuf, TetMesh>,
}

impl<'a> Meshes<'a> {
    /// No mesh yet. `scene`: the meshed part of the joint.
    pub fn new(scene: &'a Scene<'a>) -> Self {
        Self { scene, read: BTreeMap::new() }
    }

    /// One of the meshes that were read.
    pub fn any(&self) -> Option<&TetMesh> {
        self.read.values().next()
    }

    /// Differences between the stored models of a case, with their meshes, and those that the spec
    /// gives.
    pub fn models_differ(
        &mut self,
        folder: &Path,
        stem: &str,
        case: &AskedCase,
        spec: &SpecFile,
    ) -> Result<Vec<String>, Diagnostics> {
        let mut out = Vec::new();
        for path in model_paths(folder, stem) {
            let stored = read_model(&path)?;
            let file = mesh_path(&path, &stored);
            let file = file.canonicalize().unwrap_or(file);
            if !self.read.contains_key(&file) {
                let mesh = msh::read(&file)?;
                let faults = mesh_differences(&mesh, self.scene);
                out.extend(faults.into_iter().map(|what| format!("{}: {what}", stored.mesh)));
                self.read.insert(file.clone(), mesh);
            }
            let Some(mesh) = self.read.get(&file) else { continue };
            let found = case.model_file(spec, mesh, &self.scene.symmetry);
            let found = ModelFile { mesh: stored.mesh.clone(), ..found };
            let place = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            out.extend(first_difference(&json!(stored), &json!(found), &place));
        }
        Ok(out)
    }
}

/// Differences between a mesh and the solids of the joint: volumes, areas, the triangles of every
/// named face, and the surface of every body.
fn mesh_differences(mesh: &TetMesh, scene: &Scene<'_>) -> Vec<String> {
    let bodies = |names: &mut Vec<&str>| {
        names.sort_unstable();
        names.join(", ")
    };
    let mut stored: Vec<&str> = mesh.bodies.iter().map(String::as_str).collect();
    let mut wanted: Vec<&str> = scene.bodies.iter().map(|b| b.part.name.as_str()).collect();
    let (stored, wanted) = (bodies(&mut stored), bodies(&mut wanted));
    if stored != wanted {
        return vec![format!("the bodies of the mesh are {stored}, those of the joint {wanted}")];
    }
    let mut found = mesh.clone();
    if let Err(faults) = name_and_check(&mut found, scene) {
        return faults.iter().map(|d| d.message.clone()).collect();
    }
    let (stored, wanted) = (triangles_by_name(mesh), triangles_by_name(&found));
    let mut names = wanted.keys().chain(stored.keys());
    let differs = names.find(|name| stored.get(*name) != wanted.get(*name));
    let what = |name: &&str| format!("the face {name} of the mesh is not that of the joint");
    let mut out: Vec<String> = differs.map(what).into_iter().collect();
    out.extend(boundary_differences(&found, scene));
    out
}

/// The triangles of every named face.
fn triangles_by_name(mesh: &TetMesh) -> BTreeMap<&str, Vec<[u32; 3]>> {
    mesh.faces.iter().map(triangles).collect()
}

/// Name and triangles of a face, whatever their order.
fn triangles(face: &NamedFaces) -> (&str, Vec<[u32; 3]>) {
    let sorted = |t: &[u32; 3]| {
        let mut t = *t;
        t.sort_unstable();
        t
    };
    let mut all: Vec<[u32; 3]> = face.triangles.iter().map(sorted).collect();
    all.sort_unstable();
    (&face.name, all)
}
