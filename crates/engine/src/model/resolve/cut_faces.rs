//! The mesh faces of a cross-section that severs a body: those of preloaded bolts and those whose
//! resultants are limited.

use super::claims::Claims;
use super::faults::Faults;
use super::names::Scene;
use crate::mesh::split::{OpenPair, SplitMesh, TetFace};
use crate::mesh::topology::face_nodes;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::math::vec3::{self, V3};
use std::collections::{BTreeMap, BTreeSet};

/// A cut is transverse where the normals of its faces have at least this component along the axis.
const TRANSVERSE: f64 = 0.1;

/// A cross-section as an entry of the model file gives it.
pub(super) struct Section<'a> {
    /// Name of the body.
    pub body: &'a str,
    /// Name of the physical surface.
    pub cut: &'a str,
    /// Direction out of side A.
    pub axis: [f64; 3],
    /// Code of its faults.
    pub code: &'static str,
    /// Path of the entry.
    pub path: &'a str,
}

impl Section<'_> {
    /// The unit axis; a fault where it has no direction.
    fn unit_axis(&self, faults: &mut Faults<'_>) -> Option<V3> {
        let length = vec3::norm(self.axis);
        if length.is_finite() && length > 0.0 {
            return Some(vec3::scale(1.0 / length, self.axis));
        }
        let (cut, axis) = (self.cut, self.axis);
        let m = format!("the axis of the cut `{cut}` is {axis:?}, it has no direction");
        let help = "write the direction across the cut, such as `[1, 0, 0]`";
        faults.add("model/value", &format!("{}.axis", self.path), m, help);
        None
    }

    /// The unit axis and both sides of every face, side A first; a fault where they do not sever
    /// the body or belong to another section, whose path is in `taken`.
    pub fn faces(
        &self,
        scene: &Scene<'_>,
        claims: &Claims,
        taken: &mut BTreeMap<TetFace, String>,
        faults: &mut Faults<'_>,
    ) -> Option<(V3, Vec<[TetFace; 2]>)> {
        let path = format!("{}.cut", self.path);
        let body = scene.body(self.body, &format!("{}.body", self.path), faults);
        let named = scene.face(self.cut, &path, faults);
        let (body, named) = (body?, named?);
        let axis = self.unit_axis(faults)?;
        let across = Section { axis, ..*self };
        let faces = sides(&across, body, &named.triangles, scene, claims, faults)?;
        let twice = |f: &[TetFace; 2]| taken.insert(f[0].min(f[1]), self.path.to_owned());
        if let Some(other) = faces.iter().find_map(twice) {
            let m = format!("the cut `{}` shares faces with {other}", self.cut);
            faults.add("model/face-twice", &path, m, "a face is cut once: remove one of the two");
            return None;
        }
        if !severs(body, &faces, scene) {
            let m = format!(
                "the cut `{}` does not sever the body `{}`: its two sides are connected elsewhere",
                self.cut, self.body
            );
            let help = "let the physical surface cover the whole cross-section of the body";
            faults.add(self.code, &path, m, help);
            return None;
        }
        Some((axis, faces))
    }
}

/// Both sides of every face of a cut, side A first: the one whose outward normal points along the
/// axis.
fn sides(
    &Section { body: name, cut, axis, code, path }: &Section<'_>,
    body: u32,
    triangles: &[[u32; 3]],
    scene: &Scene<'_>,
    claims: &Claims,
    faults: &mut Faults<'_>,
) -> Option<Vec<[TetFace; 2]>> {
    let mut found = Vec::with_capacity(triangles.len());
    let (mut outer, mut elsewhere, mut flat) = (0, None, false);
    for t in triangles {
        match scene.table.owners(*t) {
            [p, q] if scene.body_of(p) == body && scene.body_of(q) == body => {
                let x = face_nodes(&scene.mesh.tets[p.tet as usize], p.local)
                    .map(|n| scene.mesh.nodes[n as usize]);
                let n = vec3::area_vector(&x);
                let along = vec3::dot(n, axis) / vec3::norm(n);
                flat |= along.abs() < TRANSVERSE;
                let sides = [TetFace::from(p), TetFace::from(q)];
                found.push(if along > 0.0 { sides } else { [sides[1], sides[0]] });
            }
            [p, q] => elsewhere = elsewhere.or(Some((*p, *q))),
            _ => outer += 1,
        }
    }
    found.sort_unstable();
    found.dedup();
    let all = triangles.len();
    let (m, help) = if let Some((p, q)) = elsewhere {
        let [a, b] = [p, q].map(|r| scene.mesh.bodies[scene.body_of(&r) as usize].as_str());
        let open = if claims.is_open(TetFace::from(&p).min(TetFace::from(&q))) {
            ", in contact"
        } else {
            ""
        };
        let place = if a == b {
            format!("inside the body `{a}`")
        } else {
            format!("between `{a}` and `{b}`{open}")
        };
        (
            format!("a triangle of the cut `{cut}` lies {place}"),
            "name mesh faces inside the body only",
        )
    } else if outer > 0 {
        let m = format!(
            "{outer} of the {all} triangles of the cut `{cut}` are outer faces of the mesh"
        );
        (
            m,
            "a cut lies inside the body: let gmsh mesh a plane through it (`BooleanFragments`) \
             and name it",
        )
    } else if found.is_empty() {
        (format!("the cut `{cut}` is empty"), "name mesh faces inside the body")
    } else if flat {
        let m = format!("the cut `{cut}` runs along the axis given for `{name}`");
        (m, "cut the body across, or turn `axis` into its direction")
    } else {
        return Some(found);
    };
    faults.add(code, &format!("{path}.cut"), m, help);
    None
}

/// True when the two sides of the cut are connected nowhere else in the body.
fn severs(body: u32, faces: &[[TetFace; 2]], scene: &Scene<'_>) -> bool {
    let open: BTreeSet<TetFace> = faces.iter().flatten().copied().collect();
    let mut neighbours: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for rows in scene.table.faces() {
        let [p, q] = rows else { continue };
        let inside = scene.body_of(p) == body && scene.body_of(q) == body;
        if inside && !open.contains(&TetFace::from(p)) {
            neighbours.entry(p.tet).or_default().push(q.tet);
            neighbours.entry(q.tet).or_default().push(p.tet);
        }
    }
    let mut reached: BTreeSet<u32> = faces.iter().map(|f| f[0].tet).collect();
    let mut next: Vec<u32> = reached.iter().copied().collect();
    while let Some(t) = next.pop() {
        for &n in neighbours.get(&t).into_iter().flatten() {
            if reached.insert(n) {
                next.push(n);
            }
        }
    }
    faces.iter().all(|f| !reached.contains(&f[1].tet))
}

/// An error where something ties both sides of a cut together at its rim; `pairs` are its faces
/// after the nodes are split.
pub(super) fn check_open(
    cut: &str,
    pairs: &[OpenPair],
    split: &SplitMesh,
    code: &'static str,
) -> Result<(), Diagnostics> {
    let mut nodes = pairs.iter().flat_map(|p| p.nodes_a.into_iter().zip(p.nodes_b));
    let Some((node, _)) = nodes.find(|(a, b)| a == b) else { return Ok(()) };
    let [x, y, z] = split.mesh.nodes[node as usize];
    let m = format!(
        "something is tied to the body on both sides of the cut `{cut}`, at ({x}, {y}, {z})"
    );
    let help = "cut the body where nothing is tied to it: `law: contact` there, or another cut";
    Err(Diagnostic::input(code, m).help(help).into())
}
