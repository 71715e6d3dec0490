//! A meshed joint's `MODEL.yaml`: bodies, materials, interfaces, supports, symmetry and loads by the mesh's names.

use super::file::{
    AnalysisKind, Axis, Bounds, Friction, Gap, InterfaceEntry, Law, LoadEntry, MaterialEntry, ModelFile, Nodes,
    SupportEntry,
};
use crate::assembly::Assembly;
use crate::assembly::joint::{FaceLoad, SymmetryPlane};
use crate::mesh::TetMesh;
use crate::mesh::naming::symmetry_face;

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// Names of the load cases, in the order of their first load.
pub fn cases(assembly: &Assembly) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for load in &assembly.loads {
        if !out.contains(&load.case) {
            out.push(load.case.clone());
        }
    }
    out
}

/// The model of one load case on a joint's mesh.
///
/// `mesh` decides what is there: rules about parts or faces beyond a symmetry plane are left out. `mesh_name` is the
/// mesh file's path relative to the model file. Rigid-face, preload and adaptation entries are empty.
pub fn model_file(
    assembly: &Assembly,
    mesh: &TetMesh,
    symmetry_used: &[SymmetryPlane],
    mesh_name: &str,
    case: &str,
    analysis: AnalysisKind,
) -> ModelFile {
    let has_body = |name: &String| mesh.bodies.contains(name);
    let has_face = |name: &str| mesh.faces_named(name).is_some();
    let kept: Vec<_> = assembly.parts.iter().filter(|p| has_body(&p.name)).collect();
    let materials = assembly
        .materials
        .iter()
        .filter(|(name, _)| kept.iter().any(|p| p.material == **name))
        .map(|(name, m)| (name.clone(), MaterialEntry { e: m.e, nu: m.nu, fy: m.fy }))
        .collect();
    let interfaces = assembly
        .interfaces
        .iter()
        .filter(|rule| rule.between.iter().all(has_body))
        .map(|rule| InterfaceEntry {
            between: Some(rule.between.clone()),
            face: rule.surface.as_ref().map(|(name, _)| name.clone()),
            law: Law::Contact,
            mu: Some(rule.mu),
            gap: Some(Gap::Constant(rule.gap)),
            friction: Some(if rule.associated { Friction::Associated } else { Friction::Coulomb }),
            throat: None,
            thickness: None,
            strength: None,
            strength_traction: None,
        })
        .collect();
    let support = |face: &str, fix: [bool; 3]| SupportEntry {
        face: face.to_string(),
        fix: (0..3).filter(|&k| fix[k]).map(|k| AXES[k]).collect(),
        law: None,
        mu: None,
        gap: None,
        friction: None,
    };
    let mut supports: Vec<SupportEntry> =
        assembly.supports.iter().filter(|s| has_face(&s.face)).map(|s| support(&s.face, s.fix)).collect();
    for plane in symmetry_used {
        let face = symmetry_face(plane.axis);
        if has_face(face) {
            supports.push(support(face, std::array::from_fn(|k| k == plane.axis)));
        }
    }
    let loads = |dead: bool| -> Vec<LoadEntry> {
        let of_case = |l: &&FaceLoad| l.case == case && l.dead == dead && has_face(&l.face);
        assembly
            .loads
            .iter()
            .filter(of_case)
            .map(|l| LoadEntry { face: Some(l.face.clone()), traction: Some(l.traction), ..LoadEntry::default() })
            .collect()
    };
    ModelFile {
        mesh: mesh_name.to_string(),
        nodes: Nodes::Shared,
        analysis,
        bounds: Bounds::Both,
        materials,
        bodies: kept.iter().map(|p| (p.name.clone(), p.material.clone())).collect(),
        interfaces,
        supports,
        rigid: Vec::new(),
        loads: loads(false),
        dead: loads(true),
        preload: Vec::new(),
        adapt: None,
        symmetry: 1 << symmetry_used.len(),
    }
}
