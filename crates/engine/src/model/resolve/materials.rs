//! Reads materials and the material of each body.

use super::faults::Faults;
use crate::mesh::TetMesh;
use crate::model::AnalysisKind;
use crate::model::analysis::Material;
use crate::model::file::ModelFile;
use bracket_base::diag::{did_you_mean, number};
use bracket_base::say;
use bracket_base::words::Text;

/// Young's moduli with which the programs still find their bounds \[MPa\].
const STIFFNESS: [f64; 2] = [1e-9, 1e15];
/// Yield strengths with which they do \[MPa\].
const STRENGTH: [f64; 2] = [1e-9, 1e9];
/// Largest Poisson's ratio: above, the rounding of nearly incompressible elements is as large as
/// their stiffness in shear.
const LARGEST_NU: f64 = 0.499_99;

/// The materials in the order of their names, and the material of each body.
pub(super) fn read(
    file: &ModelFile,
    mesh: &TetMesh,
    faults: &mut Faults<'_>,
) -> (Vec<Material>, Vec<u32>) {
    let mut materials = Vec::new();
    for (name, m) in &file.materials {
        let mut check = |key: &str, value: f64, good: bool, limit: &str, help: &str| {
            if !good {
                let value = number(value);
                let message =
                    format!("`{key}` of material `{name}` is {value}, it must be {limit}");
                faults.add("model/value", &format!("materials.{name}.{key}"), message, help);
            }
        };
        let within = |x: f64, limits: [f64; 2]| x >= limits[0] && x <= limits[1];
        let limit = "1e-9 MPa to 1e15 MPa";
        check("E", m.e, within(m.e, STIFFNESS), limit, "steel: 210000 MPa");
        let help = "steel: 0.3; for a nearly incompressible material write 0.4999";
        check("nu", m.nu, m.nu > -1.0 && m.nu <= LARGEST_NU, "> -1 and at most 0.49999", help);
        if let Some(fy) = m.fy {
            check(
                "fy",
                fy,
                within(fy, STRENGTH),
                "1e-9 MPa to 1e9 MPa",
                "leave `fy` out where nothing yields",
            );
        }
        materials.push(Material { name: name.clone(), e: m.e, nu: m.nu, fy: m.fy });
    }
    let names = || file.materials.keys().map(String::as_str);
    for (body, material) in &file.bodies {
        let path = format!("bodies.{body}");
        if !mesh.bodies.contains(body) {
            let hint = did_you_mean(body, mesh.bodies.iter().map(String::as_str));
            let m = format!("the mesh has no physical volume `{body}`{hint}");
            faults.add(
                "model/unknown-body",
                &path,
                m,
                format!("the bodies are: {}", mesh.bodies.join(", ")),
            );
        }
        if !file.materials.contains_key(material) {
            let m = format!(
                "body `{body}` is of material `{material}`, which is not defined{}",
                did_you_mean(material, names())
            );
            let help = format!("the materials are: {}", names().collect::<Vec<_>>().join(", "));
            faults.add("model/unknown-material", &path, m, help);
        }
    }
    let mut body_material = Vec::new();
    for body in &mesh.bodies {
        let Some(material) = file.bodies.get(body) else {
            let m = format!("body `{body}` of the mesh has no material");
            faults.add(
                "model/no-material",
                "bodies",
                m,
                format!("add `{body}: MATERIAL` under `bodies`"),
            );
            continue;
        };
        body_material.push(file.materials.keys().position(|n| n == material).unwrap_or(0) as u32);
    }
    (materials, body_material)
}

/// Adds a note when the analysis is plastic but no material can yield.
pub(super) fn note_strengths(file: &ModelFile, notes: &mut Vec<Text>) {
    if file.analysis == AnalysisKind::Elastoplastic
        && file.materials.values().all(|m| m.fy.is_none())
    {
        notes.push(
            "no material has a yield strength `fy`: the elastic, perfectly plastic analysis is an \
             elastic one"
                .into(),
        );
    }
}

/// Adds notes where numbers seem to be in another unit.
pub(super) fn check_units(file: &ModelFile, mesh: &TetMesh, notes: &mut Vec<Text>) {
    let largest = (0..3)
        .map(|k| {
            let c = mesh.nodes.iter().map(|x| x[k]);
            c.clone().fold(f64::NEG_INFINITY, f64::max) - c.fold(f64::INFINITY, f64::min)
        })
        .fold(0.0, f64::max);
    if largest < 10.0 && file.materials.values().any(|m| (1e3..1e7).contains(&m.e)) {
        notes.push(say!(
            "warning: the largest dimension of the mesh is {} mm: if its lengths are in m, scale \
             them to mm",
            largest.to_string()
        ));
    }
    for (name, m) in &file.materials {
        if m.e >= 1e8 {
            notes.push(say!(
                "warning: E of material `{}` is {} MPa: if it is in Pa, divide by 1e6",
                name,
                format!("{:e}", m.e)
            ));
        }
    }
}
