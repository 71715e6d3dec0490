//! Agreement of the mesh with the joint: comparison of meshed and exact volumes and areas.

use super::triangles::{area, nodes_of};
use crate::geometry::exact;
use crate::geometry::scene::Scene;
use bracket_base::diag::Diagnostic;
use bracket_engine::mesh::TetMesh;
use bracket_engine::mesh::topology::FaceTable;

/// Allowed relative difference between meshed and exact volumes and areas. All facets are planes,
/// so both agree up to the rounding of the CAD kernel; 0.01 % allows for the strips that `exact`
/// approximates.
const AGREE: f64 = 1e-4;

/// Meshed and exact area of a set of faces.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct AreaCheck {
    /// Name of the set, for example `PLATE_R / COLUMN` or `SYM_X0`.
    pub name: String,
    /// Meshed area \[mm²\].
    pub meshed: f64,
    /// Exact area of the flat-faced solids \[mm²\].
    pub exact: f64,
}

/// Meshed and exact volume of a body.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct VolumeCheck {
    /// The body.
    pub body: String,
    /// Meshed volume \[mm³\].
    pub meshed: f64,
    /// Exact volume of the flat-faced solid \[mm³\].
    pub exact: f64,
}

/// All comparisons, for the report.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct Checks {
    /// One per body.
    pub volumes: Vec<VolumeCheck>,
    /// Touching pairs, then named faces.
    pub areas: Vec<AreaCheck>,
}

/// True when a meshed and an exact value differ by more than rounding.
pub fn disagree(meshed: f64, exact: f64) -> bool {
    (meshed - exact).abs() > AGREE * exact.max(1e-3)
}

/// Compares the volume of every body with the exact one.
pub fn volumes(mesh: &TetMesh, scene: &Scene, faults: &mut Vec<Diagnostic>) -> Vec<VolumeCheck> {
    let mut meshed = vec![0.0; scene.bodies.len()];
    for (e, b) in mesh.tet_body.iter().enumerate() {
        meshed[*b as usize] += mesh.volume(e);
    }
    let mut out = Vec::new();
    for (body, meshed) in scene.bodies.iter().zip(meshed) {
        let exact = exact::volume(body);
        if disagree(meshed, exact) {
            faults.push(
                Diagnostic::input(
                    "mesh/volume",
                    format!(
                        "the {} ({}) has {meshed:.0} mm³ in the mesh and {exact:.0} mm³ by its \
                         dimensions, at most {} % may differ",
                        body.part.label,
                        body.part.name,
                        100.0 * AGREE
                    ),
                )
                .help(
                    "parts overlap or nearly touch: check the dimensions of this part and of its \
                     neighbours",
                ),
            );
        }
        out.push(VolumeCheck { body: body.part.name.clone(), meshed, exact });
    }
    out
}

/// Compares the area of every touching pair, tied or open, with the exact one.
pub fn contacts(
    mesh: &TetMesh,
    scene: &Scene,
    table: &FaceTable,
    checks: &mut Checks,
    faults: &mut Vec<Diagnostic>,
) {
    let n = scene.bodies.len();
    let mut meshed = vec![0.0; n * n];
    for rows in table.faces() {
        if let [p, q] = rows {
            let (a, b) =
                (mesh.tet_body[p.tet as usize] as usize, mesh.tet_body[q.tet as usize] as usize);
            if a != b {
                meshed[a.min(b) * n + a.max(b)] += area(mesh, nodes_of(mesh, p));
            }
        }
    }
    for a in 0..n {
        for b in a + 1..n {
            let exact = exact::contact_area(&scene.bodies[a], &scene.bodies[b], None);
            let meshed = meshed[a * n + b];
            if meshed == 0.0 && exact < 1e-6 {
                continue;
            }
            let (pa, pb) = (scene.bodies[a].part, scene.bodies[b].part);
            if disagree(meshed, exact) {
                faults.push(area_fault(
                    format!(
                        "the {} ({}) and the {} ({}) share",
                        pa.label, pa.name, pb.label, pb.name
                    ),
                    meshed,
                    exact,
                ));
            }
            checks.areas.push(AreaCheck {
                name: format!("{} / {}", pa.name, pb.name),
                meshed,
                exact,
            });
        }
    }
}

/// The fault of an area that disagrees; `what` is the start of the message.
pub fn area_fault(what: String, meshed: f64, exact: f64) -> Diagnostic {
    Diagnostic::input(
        "mesh/area",
        format!(
            "{what} {meshed:.1} mm² in the mesh and {exact:.1} mm² by their dimensions, at most \
             {} % may differ",
            100.0 * AGREE
        ),
    )
    .help("parts overlap or nearly touch, or a footprint crosses an edge: check these dimensions")
}
