//! Finds the faces of a newly meshed joint by their coordinates and names them. Checks that the
//! mesh agrees with the joint.

mod agreement;
mod boundary;
pub(super) mod surface;
mod triangles;

pub use agreement::{AreaCheck, Checks, VolumeCheck};
pub use boundary::boundary_differences;

use crate::assembly::assembly::Surface;
use crate::geometry::exact;
use crate::geometry::scene::{Scene, ShankCut, shank_cuts};
use agreement::{area_fault, contacts, disagree, volumes};
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_engine::mesh::topology::{FaceRow, FaceTable};
use bracket_engine::mesh::{NamedFaces, TetMesh};
use surface::{SNAP, beyond, extent, looked_for, on_surface};
use triangles::{between, corners, nodes_of, total};

/// Name of the face on the symmetry plane `x[axis] = 0`.
pub fn symmetry_face(axis: usize) -> &'static str {
    ["SYM_X0", "SYM_Y0", "SYM_Z0"][axis]
}

/// Moves nodes that lie on a symmetry plane up to rounding exactly onto it.
fn snap(mesh: &mut TetMesh, scene: &Scene) {
    for plane in &scene.symmetry {
        for x in &mut mesh.nodes {
            if x[plane.axis].abs() < SNAP {
                x[plane.axis] = 0.0;
            }
        }
    }
}

/// Names all faces that the model needs. Compares every volume, contact area and face area with the
/// exact value.
///
/// The bodies of the mesh must be those of the scene, in any order. Afterwards they are in the
/// order of the scene.
pub fn name_and_check(mesh: &mut TetMesh, scene: &Scene) -> Result<Checks, Diagnostics> {
    order_bodies(mesh, scene)?;
    snap(mesh, scene);
    let (faces, checks) = Naming::new(mesh, scene).finish()?;
    mesh.faces = faces;
    Ok(checks)
}

/// Names, for the mending of a mesh that is not yet checked, what is imprinted on the faces that
/// bound bodies and the mesher's volumes: the parts of supports, loads, contacts and welds.
/// Symmetry planes are bounded by edges of the bodies anyway.
pub fn name_imprints(mesh: &mut TetMesh, scene: &Scene) {
    snap(mesh, scene);
    let table = FaceTable::new(&mesh.tets);
    let given = |r: &FaceRow| {
        let e = r.tet as usize;
        (mesh.tet_body[e], mesh.tet_region.get(e))
    };
    let bodies = |rows: &[FaceRow]| -> Vec<u32> {
        rows.iter().map(|r| mesh.tet_body[r.tet as usize]).collect()
    };
    let bounding: Vec<([u32; 3], Vec<u32>)> = table
        .faces()
        .filter(|rows| rows.len() == 1 || rows.windows(2).any(|w| given(&w[0]) != given(&w[1])))
        .map(|rows| (nodes_of(mesh, &rows[0]), bodies(rows)))
        .collect();
    let joint = scene.assembly;
    let faces = joint.faces.iter().map(|f| (&f.name, &f.surface));
    let welds = joint.welds.iter().map(|w| (&w.name, &w.surface));
    let contacts = joint.interfaces.iter().filter_map(|i| i.surface.as_ref().map(|(n, s)| (n, s)));
    let outer = faces.chain(welds).chain(contacts).map(|(name, surface)| (name, surface, None));
    // the plane of a section may be that of a contact beside the shank
    let cuts = shank_cuts(joint).map(|c| (c.name, c.surface, Some(c.part)));
    let named = outer.chain(cuts).map(|(name, surface, part)| {
        let inside = |bodies: &[u32]| {
            part.is_none_or(|part| bodies.iter().all(|b| mesh.bodies[*b as usize] == *part))
        };
        let here = bounding.iter().filter(|(_, bodies)| inside(bodies)).map(|(t, _)| *t);
        let triangles = here.filter(|t| on_surface(surface, &corners(mesh, *t))).collect();
        NamedFaces { name: name.clone(), triangles }
    });
    mesh.faces = named.collect();
}

/// Renumbers the bodies of the mesh in the order of the scene.
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

/// The faces named so far, with the comparisons and faults found for them.
struct Naming<'a> {
    mesh: &'a TetMesh,
    scene: &'a Scene<'a>,
    table: FaceTable,
    faces: Vec<NamedFaces>,
    checks: Checks,
    faults: Vec<Diagnostic>,
}

impl<'a> Naming<'a> {
    fn new(mesh: &'a TetMesh, scene: &'a Scene<'a>) -> Self {
        Self {
            mesh,
            scene,
            table: FaceTable::new(&mesh.tets),
            faces: Vec::new(),
            checks: Checks::default(),
            faults: Vec::new(),
        }
    }

    fn finish(mut self) -> Result<(Vec<NamedFaces>, Checks), Diagnostics> {
        let scene = self.scene;
        self.checks.volumes = volumes(self.mesh, scene, &mut self.faults);
        contacts(self.mesh, scene, &self.table, &mut self.checks, &mut self.faults);
        for rule in &scene.assembly.interfaces {
            let on = rule.surface.as_ref().map(|(name, surface)| (name, surface));
            self.interface(&rule.between, on);
        }
        for weld in &scene.assembly.welds {
            // welds of parts that a symmetry plane halves may lie wholly on the removed side
            if matches!(weld.surface, Surface::Plane { min, max, .. } if beyond(scene, &min, &max))
            {
                continue;
            }
            self.interface(&weld.between, Some((&weld.name, &weld.surface)));
        }
        self.outer_faces();
        self.symmetry_faces();
        self.shank_cuts();
        Diagnostics::refuse(self.faults)?;
        Ok((self.faces, self.checks))
    }

    /// Records the meshed and the exact area; `what` is the start of the message of a fault.
    fn compare(&mut self, what: String, name: &str, meshed: f64, exact: f64) {
        if disagree(meshed, exact) {
            self.faults.push(area_fault(what, meshed, exact));
        }
        self.checks.areas.push(AreaCheck { name: name.to_string(), meshed, exact });
    }

    fn add(&mut self, name: &str, triangles: Vec<[u32; 3]>) {
        self.faces.push(NamedFaces { name: name.to_string(), triangles });
    }

    /// The triangles on a surface whose tets satisfy `owners`, ordered outward from the first tet.
    fn triangles_on(
        &self,
        surface: &Surface,
        owners: impl Fn(&[FaceRow]) -> bool,
    ) -> Vec<[u32; 3]> {
        let faces = self.table.faces().filter(|rows| owners(rows)).filter_map(|rows| rows.first());
        faces
            .map(|row| nodes_of(self.mesh, row))
            .filter(|t| on_surface(surface, &corners(self.mesh, *t)))
            .collect()
    }

    /// True when the face belongs to a tet of the body.
    fn is_of(&self, row: &FaceRow, body: usize) -> bool {
        self.mesh.tet_body[row.tet as usize] as usize == body
    }

    fn interface(&mut self, parts: &[String; 2], on: Option<(&String, &Surface)>) {
        let (mesh, scene) = (self.mesh, self.scene);
        let (Some(a), Some(b)) = (scene.body(&parts[0]), scene.body(&parts[1])) else { return };
        let mut triangles = between(mesh, &self.table, a, b);
        if let Some((name, surface)) = on {
            triangles.retain(|t| on_surface(surface, &corners(mesh, *t)));
            let exact = exact::contact_area(&scene.bodies[a], &scene.bodies[b], Some(surface));
            self.compare(format!("the surface {name} has"), name, total(mesh, &triangles), exact);
            if !triangles.is_empty() {
                self.add(name, triangles.clone());
            }
        }
        if triangles.is_empty() {
            let (pa, pb) = (scene.bodies[a].part, scene.bodies[b].part);
            let place =
                on.map_or_else(String::new, |(name, s)| format!(" {} ({name})", looked_for(s)));
            let message = format!(
                "the {} ({}) and the {} ({}) do not touch{place}, but the template defines an \
                 interface between them",
                pa.label, pa.name, pb.label, pb.name
            );
            self.faults.push(
                Diagnostic::input("mesh/interface-empty", message)
                    .help("move the parts together, or remove the contact from the template"),
            );
        }
    }

    fn outer_faces(&mut self) {
        let (mesh, scene) = (self.mesh, self.scene);
        for rule in &scene.assembly.faces {
            let Some(body) = scene.body(&rule.part) else { continue };
            let outer = |rows: &[FaceRow]| matches!(rows, [row] if self.is_of(row, body));
            let triangles = self.triangles_on(&rule.surface, outer);
            if let Surface::Plane { axis, at, min, max } = rule.surface {
                let exact = exact::outer_area(&scene.bodies, body, axis, at, min, max);
                let meshed = total(mesh, &triangles);
                if triangles.is_empty()
                    && exact < 1e-6
                    && !scene.symmetry.is_empty()
                    && beyond(scene, &min, &max)
                {
                    // the face lies wholly on the removed side
                    continue;
                }
                self.compare(format!("the face {} has", rule.name), &rule.name, meshed, exact);
            }
            if triangles.is_empty() {
                let (part, bounds) = (scene.bodies[body].part, scene.bodies[body].bounds);
                self.faults.push(
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
                        "the part reaches {}; move the face of this load or support, or its \
                         plane, to where the part ends",
                        extent(&bounds.min, &bounds.max, None)
                    )),
                );
                continue;
            }
            self.add(&rule.name, triangles);
        }
    }

    /// The sections of shanks. Each covers the whole shank.
    fn shank_cuts(&mut self) {
        let (mesh, scene) = (self.mesh, self.scene);
        for ShankCut { part, name, surface } in shank_cuts(scene.assembly) {
            let (Some(body), &Surface::Plane { axis, at, .. }) = (scene.body(part), surface) else {
                continue;
            };
            let of_body = |row: &FaceRow| self.is_of(row, body);
            let inner = |rows: &[FaceRow]| matches!(rows, [p, q] if of_body(p) && of_body(q));
            let triangles = self.triangles_on(surface, inner);
            let exact = exact::section_area(&scene.bodies[body], axis, at);
            self.compare(
                format!("the section {name} of a bolt has"),
                name,
                total(mesh, &triangles),
                exact,
            );
            self.add(name, triangles);
        }
    }

    fn symmetry_faces(&mut self) {
        let (mesh, scene) = (self.mesh, self.scene);
        for plane in &scene.symmetry {
            let axis = plane.axis;
            let triangles: Vec<[u32; 3]> = self
                .table
                .faces()
                .filter_map(|rows| match rows {
                    [row] => Some(nodes_of(mesh, row)),
                    _ => None,
                })
                .filter(|t| corners(mesh, *t).iter().all(|x| x[axis] == 0.0))
                .collect();
            let exact: f64 = (0..scene.bodies.len())
                .filter(|&b| scene.bodies[b].bounds.min[axis] <= 0.0)
                .map(|b| {
                    let bounds = scene.bodies[b].bounds;
                    exact::outer_area(&scene.bodies, b, axis, 0.0, bounds.min, bounds.max)
                })
                .sum();
            let name = symmetry_face(axis);
            let what = format!("the symmetry plane {name} has");
            self.compare(what, name, total(mesh, &triangles), exact);
            if !triangles.is_empty() {
                self.add(name, triangles);
            }
        }
    }
}
