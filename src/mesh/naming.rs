//! Names for the faces of a freshly meshed joint, found by coordinates, and the checks that the
//! mesh is the joint.

use super::topology::{FaceRow, FaceTable, face_nodes};
use super::{NamedFaces, TetMesh};
use crate::assembly::assembly::Surface;
use crate::diag::{Diagnostic, Diagnostics};
use crate::geometry::exact::{self, MANTLE_TOLERANCE};
use crate::geometry::scene::Scene;
use crate::math::vec3::{V3, cross, dot, sub};

/// Nodes closer than this to a named plane are on it and are moved there exactly \[mm\].
const SNAP: f64 = 1e-6;

/// Allowed relative difference of meshed and exact volumes and areas. All facets are planes, so
/// both agree to the CAD kernel's rounding; 0.01 % leaves room for the strips `exact` approximates.
const AGREE: f64 = 1e-4;

/// Area of a mesh face set and what it should be.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct AreaCheck {
    /// What the area is of, for example `PLATE_R / COLUMN` or `SYM_X0`.
    pub name: String,
    /// Meshed area \[mm²\].
    pub meshed: f64,
    /// Exact area of the flat-faced solids \[mm²\].
    pub exact: f64,
}

/// Volume of a body and what it should be.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct VolumeCheck {
    /// The body.
    pub body: String,
    /// Meshed volume \[mm³\].
    pub meshed: f64,
    /// Exact volume of the flat-faced solid \[mm³\].
    pub exact: f64,
}

/// What was compared; kept for the report.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct Checks {
    /// One per body.
    pub volumes: Vec<VolumeCheck>,
    /// Touching pairs, then named faces.
    pub areas: Vec<AreaCheck>,
}

/// Name of the face on the symmetry plane `x[axis] = 0`.
pub fn symmetry_face(axis: usize) -> &'static str {
    ["SYM_X0", "SYM_Y0", "SYM_Z0"][axis]
}

/// Puts nodes that lie on symmetry planes up to rounding exactly there.
pub fn snap(mesh: &mut TetMesh, scene: &Scene) {
    for plane in &scene.symmetry {
        for x in &mut mesh.nodes {
            if x[plane.axis].abs() < SNAP {
                x[plane.axis] = 0.0;
            }
        }
    }
}

/// Names all faces the model needs and compares every volume, contact and face with the exact one.
///
/// The mesh's bodies must be the scene's, in any order; afterwards they are in the scene's order.
pub fn name_and_check(mesh: &mut TetMesh, scene: &Scene) -> Result<Checks, Diagnostics> {
    order_bodies(mesh, scene)?;
    snap(mesh, scene);
    let mut faults = Vec::new();
    let mut checks = Checks { volumes: volumes(mesh, scene, &mut faults), areas: Vec::new() };
    let table = FaceTable::new(&mesh.tets);
    let mut faces = Vec::new();
    contacts(mesh, scene, &table, &mut checks, &mut faults);
    for rule in &scene.assembly.interfaces {
        let on = rule.surface.as_ref().map(|(name, surface)| (name, surface));
        interface(mesh, scene, &table, (&rule.between, on), &mut faces, &mut checks, &mut faults);
    }
    for weld in &scene.assembly.welds {
        // parts that a plane of symmetry halves may have welds wholly on the side that is not
        // modelled
        if matches!(weld.surface, Surface::Plane { min, max, .. } if beyond(scene, &min, &max)) {
            continue;
        }
        let on = Some((&weld.name, &weld.surface));
        interface(mesh, scene, &table, (&weld.between, on), &mut faces, &mut checks, &mut faults);
    }
    outer_faces(mesh, scene, &table, &mut faces, &mut checks, &mut faults);
    symmetry_faces(mesh, scene, &table, &mut faces, &mut checks, &mut faults);
    preload_cuts(mesh, scene, &table, &mut faces, &mut checks, &mut faults);
    Diagnostics::refuse(faults)?;
    mesh.faces = faces;
    Ok(checks)
}

fn order_bodies(mesh: &mut TetMesh, scene: &Scene) -> Result<(), Diagnostics> {
    let mut faults = Vec::new();
    let mut new_index = vec![u32::MAX; mesh.bodies.len()];
    for (i, body) in scene.bodies.iter().enumerate() {
        match mesh.bodies.iter().position(|b| *b == body.part.name) {
            Some(k) => new_index[k] = i as u32,
            None => faults.push(
                Diagnostic::input(
                    "mesh/body-lost",
                    format!(
                        "the mesher lost the {} ({}): it has no tetrahedron",
                        body.part.label, body.part.name
                    ),
                )
                .help(
                    "parts overlap or a solid is degenerate: check the dimensions of this part \
                     and of its neighbours",
                ),
            ),
        }
    }
    Diagnostics::refuse(faults)?;
    for b in &mut mesh.tet_body {
        *b = new_index[*b as usize];
    }
    mesh.bodies = scene.bodies.iter().map(|b| b.part.name.clone()).collect();
    Ok(())
}

fn disagree(meshed: f64, exact: f64) -> bool {
    (meshed - exact).abs() > AGREE * exact.max(1e-3)
}

fn volumes(mesh: &TetMesh, scene: &Scene, faults: &mut Vec<Diagnostic>) -> Vec<VolumeCheck> {
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

fn corners(mesh: &TetMesh, nodes: [u32; 3]) -> [V3; 3] {
    nodes.map(|n| mesh.nodes[n as usize])
}

fn area(mesh: &TetMesh, nodes: [u32; 3]) -> f64 {
    let [a, b, c] = corners(mesh, nodes);
    let n = cross(sub(b, a), sub(c, a));
    0.5 * dot(n, n).sqrt()
}

fn total(mesh: &TetMesh, triangles: &[[u32; 3]]) -> f64 {
    triangles.iter().map(|t| area(mesh, *t)).sum()
}

fn nodes_of(mesh: &TetMesh, row: &FaceRow) -> [u32; 3] {
    face_nodes(&mesh.tets[row.tet as usize], row.local)
}

/// Faces between two bodies, ordered outward from `a`.
fn between(mesh: &TetMesh, table: &FaceTable, a: usize, b: usize) -> Vec<[u32; 3]> {
    let mut out = Vec::new();
    for rows in table.faces() {
        if let [p, q] = rows {
            let bodies =
                [mesh.tet_body[p.tet as usize] as usize, mesh.tet_body[q.tet as usize] as usize];
            if bodies == [a, b] {
                out.push(nodes_of(mesh, p));
            } else if bodies == [b, a] {
                out.push(nodes_of(mesh, q));
            }
        }
    }
    out
}

fn pair_name(a: &str, b: &str) -> String {
    format!("{a} / {b}")
}

/// Compares the area of every touching pair, tied or open, with the exact one.
fn contacts(
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
            checks.areas.push(AreaCheck { name: pair_name(&pa.name, &pb.name), meshed, exact });
        }
    }
}

fn area_fault(what: String, meshed: f64, exact: f64) -> Diagnostic {
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

fn interface(
    mesh: &TetMesh,
    scene: &Scene,
    table: &FaceTable,
    (parts, on): (&[String; 2], Option<(&String, &Surface)>),
    faces: &mut Vec<NamedFaces>,
    checks: &mut Checks,
    faults: &mut Vec<Diagnostic>,
) {
    let (Some(a), Some(b)) = (scene.body(&parts[0]), scene.body(&parts[1])) else { return };
    let mut triangles = between(mesh, table, a, b);
    if let Some((name, surface)) = on {
        triangles.retain(|t| on_surface(surface, &corners(mesh, *t)));
        let exact = exact::contact_area(&scene.bodies[a], &scene.bodies[b], Some(surface));
        let meshed = total(mesh, &triangles);
        if disagree(meshed, exact) {
            faults.push(area_fault(format!("the surface {name} has"), meshed, exact));
        }
        checks.areas.push(AreaCheck { name: name.clone(), meshed, exact });
        if !triangles.is_empty() {
            faces.push(NamedFaces { name: name.clone(), triangles: triangles.clone() });
        }
    }
    if triangles.is_empty() {
        let (pa, pb) = (scene.bodies[a].part, scene.bodies[b].part);
        faults.push(
            Diagnostic::input(
                "mesh/interface-empty",
                format!(
                    "the {} ({}) and the {} ({}) do not touch{}, but an interface between them is \
                     asked for",
                    pa.label,
                    pa.name,
                    pb.label,
                    pb.name,
                    on.map_or_else(String::new, |(name, s)| format!(" {} ({name})", looked_for(s)))
                ),
            )
            .help("move the parts together, or remove the contact from the template"),
        );
    }
}

/// The faces on a surface whose tets are as asked; ordered outward from the first of them.
fn triangles_on(
    mesh: &TetMesh,
    table: &FaceTable,
    surface: &Surface,
    asked: impl Fn(&[FaceRow]) -> bool,
) -> Vec<[u32; 3]> {
    let faces = table.faces().filter(|rows| asked(rows)).filter_map(|rows| rows.first());
    faces
        .map(|row| nodes_of(mesh, row))
        .filter(|t| on_surface(surface, &corners(mesh, *t)))
        .collect()
}

/// A length to a micrometre, as messages tell it.
fn mm(x: f64) -> f64 {
    (1e3 * x).round() / 1e3
}

/// Where a surface was looked for, in words.
pub(super) fn looked_for(surface: &Surface) -> String {
    match surface {
        Surface::Plane { axis, at, min, max } => {
            format!(
                "on the plane {} = {} mm, {}",
                ["x", "y", "z"][*axis],
                mm(*at),
                extent(min, max, Some(*axis))
            )
        }
        Surface::Mantle { base, axis, radius, length } => {
            let [x, y, z] = base.map(mm);
            let [u, v, w] = axis.map(mm);
            let (r, l) = (mm(*radius), mm(*length));
            format!(
                "on the cylinder of radius {r} mm from ({x}, {y}, {z}) mm along ({u}, {v}, {w}), \
                 {l} mm long"
            )
        }
    }
}

/// `x from 0 to 200 mm, z from -9 to 9 mm`: the sides of a box, one left out.
fn extent(min: &V3, max: &V3, without: Option<usize>) -> String {
    let sides = (0..3).filter(|k| Some(*k) != without);
    let words =
        sides.map(|k| format!("{} from {} to {} mm", ["x", "y", "z"][k], mm(min[k]), mm(max[k])));
    words.collect::<Vec<_>>().join(", ")
}

/// True when a triangle lies on the surface.
fn on_surface(surface: &Surface, t: &[V3; 3]) -> bool {
    match surface {
        Surface::Plane { axis, at, min, max } => t.iter().all(|x| {
            (x[*axis] - at).abs() < SNAP
                && (0..3).all(|k| k == *axis || (x[k] > min[k] - SNAP && x[k] < max[k] + SNAP))
        }),
        Surface::Mantle { base, axis, radius, length } => {
            let normal = cross(sub(t[1], t[0]), sub(t[2], t[0]));
            // The ring around the mantle's end has corners at the right radius too: its normal is
            // the axis.
            dot(normal, *axis).abs() < 1e-3 * dot(normal, normal).sqrt()
                && t.iter().all(|x| {
                    let r = sub(*x, *base);
                    let h = dot(r, *axis);
                    let distance = (dot(r, r) - h * h).max(0.0).sqrt();
                    h > -SNAP
                        && h < length + SNAP
                        && (distance / radius - 1.0).abs() < MANTLE_TOLERANCE
                })
        }
    }
}

fn outer_faces(
    mesh: &TetMesh,
    scene: &Scene,
    table: &FaceTable,
    faces: &mut Vec<NamedFaces>,
    checks: &mut Checks,
    faults: &mut Vec<Diagnostic>,
) {
    for rule in &scene.assembly.faces {
        let Some(body) = scene.body(&rule.part) else { continue };
        let inside = |row: &FaceRow| mesh.tet_body[row.tet as usize] as usize == body;
        let triangles =
            triangles_on(mesh, table, &rule.surface, |rows| matches!(rows, [row] if inside(row)));
        if let Surface::Plane { axis, at, min, max } = rule.surface {
            let exact = exact::outer_area(&scene.bodies, body, axis, at, min, max);
            let meshed = total(mesh, &triangles);
            if triangles.is_empty()
                && exact < 1e-6
                && !scene.symmetry.is_empty()
                && beyond(scene, &min, &max)
            {
                // Wholly on the side that is not modelled.
                continue;
            }
            if disagree(meshed, exact) {
                faults.push(area_fault(format!("the face {} has", rule.name), meshed, exact));
            }
            checks.areas.push(AreaCheck { name: rule.name.clone(), meshed, exact });
        }
        if triangles.is_empty() {
            let (part, bounds) = (scene.bodies[body].part, scene.bodies[body].bounds);
            faults.push(
                Diagnostic::input(
                    "mesh/face-empty",
                    format!(
                        "the face {} was not found on the {} ({}): looked for {}",
                        rule.name,
                        part.label,
                        part.name,
                        looked_for(&rule.surface)
                    ),
                )
                .help(format!(
                    "the part reaches {}; move the face of this load or support, or its plane, to \
                     where the part ends",
                    extent(&bounds.min, &bounds.max, None)
                )),
            );
            continue;
        }
        faces.push(NamedFaces { name: rule.name.clone(), triangles });
    }
}

/// True when a box lies on the removed side of a symmetry plane.
fn beyond(scene: &Scene, min: &V3, max: &V3) -> bool {
    scene.symmetry.iter().any(|s| max[s.axis] <= SNAP && min[s.axis] < -SNAP)
}

/// The faces inside preloaded shanks; each covers the whole section.
fn preload_cuts(
    mesh: &TetMesh,
    scene: &Scene,
    table: &FaceTable,
    faces: &mut Vec<NamedFaces>,
    checks: &mut Checks,
    faults: &mut Vec<Diagnostic>,
) {
    for preload in &scene.assembly.preloads {
        let (Some(body), Surface::Plane { axis, at, .. }) =
            (scene.body(&preload.part), preload.surface)
        else {
            continue;
        };
        let inside = |row: &FaceRow| mesh.tet_body[row.tet as usize] as usize == body;
        let both = |rows: &[FaceRow]| matches!(rows, [p, q] if inside(p) && inside(q));
        let triangles = triangles_on(mesh, table, &preload.surface, both);
        let (meshed, exact) =
            (total(mesh, &triangles), exact::section_area(&scene.bodies[body], axis, at));
        if disagree(meshed, exact) {
            faults.push(area_fault(
                format!("the cut {} of a preloaded bolt has", preload.cut),
                meshed,
                exact,
            ));
        }
        checks.areas.push(AreaCheck { name: preload.cut.clone(), meshed, exact });
        faces.push(NamedFaces { name: preload.cut.clone(), triangles });
    }
}

fn symmetry_faces(
    mesh: &TetMesh,
    scene: &Scene,
    table: &FaceTable,
    faces: &mut Vec<NamedFaces>,
    checks: &mut Checks,
    faults: &mut Vec<Diagnostic>,
) {
    for plane in &scene.symmetry {
        let axis = plane.axis;
        let triangles: Vec<[u32; 3]> = table
            .faces()
            .filter_map(|rows| match rows {
                [row] => Some(nodes_of(mesh, row)),
                _ => None,
            })
            .filter(|t| corners(mesh, *t).iter().all(|x| x[axis] == 0.0))
            .collect();
        let meshed = total(mesh, &triangles);
        let exact: f64 = (0..scene.bodies.len())
            .filter(|&b| scene.bodies[b].bounds.min[axis] <= 0.0)
            .map(|b| {
                let bounds = scene.bodies[b].bounds;
                exact::outer_area(&scene.bodies, b, axis, 0.0, bounds.min, bounds.max)
            })
            .sum();
        if disagree(meshed, exact) {
            faults.push(area_fault(
                format!("the symmetry plane {} has", symmetry_face(axis)),
                meshed,
                exact,
            ));
        }
        checks.areas.push(AreaCheck { name: symmetry_face(axis).to_string(), meshed, exact });
        if !triangles.is_empty() {
            faces.push(NamedFaces { name: symmetry_face(axis).to_string(), triangles });
        }
    }
}
