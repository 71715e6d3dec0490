//! Reads preloaded bolts: the mesh faces that sever the shank, and the conditions under which one
//! side can be drawn towards the other.

use super::claims::Claims;
use super::faults::Faults;
use super::names::Scene;
use crate::mesh::split::{OpenPair, SplitMesh, TetFace};
use crate::mesh::topology::face_nodes;
use crate::model::AnalysisKind;
use crate::model::analysis::{FacePair, Preload};
use crate::model::file::{ModelFile, PreloadEntry};
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::math::vec3::{self, V3};
use bracket_base::say;
use bracket_base::words::Text;
use std::collections::{BTreeMap, BTreeSet};

/// A cut is transverse where the normals of its faces have at least this component along the axis.
const TRANSVERSE: f64 = 0.1;

/// A cut before the nodes are split: side A, side B of each face.
pub(super) struct Cut {
    preload: Preload,
    pub faces: Vec<[TetFace; 2]>,
}

/// Reads `preload`. In limit analysis preload has no effect: the cuts stay closed, and a note
/// reports it. Preload is not available in elastic, perfectly plastic analysis.
pub(super) fn read(
    file: &ModelFile,
    scene: &Scene<'_>,
    claims: &Claims,
    faults: &mut Faults<'_>,
    notes: &mut Vec<Text>,
) -> Vec<Cut> {
    if file.analysis == AnalysisKind::Elastoplastic && !file.preload.is_empty() {
        let m = "preload in an elastic, perfectly plastic analysis is not available yet in this \
                 version";
        let help = "available: `preload` with `analysis: elastic`, where it acts, and with \
                    `analysis: limit`, where it drops out";
        faults.add("model/unavailable", "preload", m, help);
        return Vec::new();
    }
    let mut cuts = Vec::new();
    let mut taken: BTreeMap<TetFace, usize> = BTreeMap::new();
    for (i, entry) in file.preload.iter().enumerate() {
        let path = format!("preload[{i}]");
        let numbers = numbers(entry, &path, faults);
        let body = scene.body(&entry.body, &format!("{path}.body"), faults);
        let named = scene.face(&entry.cut, &format!("{path}.cut"), faults);
        let (Some(axis), Some(body), Some(named)) = (numbers, body, named) else { continue };
        let Some(faces) = sides(entry, body, &named.triangles, axis, &path, scene, claims, faults)
        else {
            continue;
        };
        if let Some(other) = faces.iter().find_map(|f| taken.insert(f[0].min(f[1]), i)) {
            let m = format!("the cut `{}` shares faces with preload[{other}]", entry.cut);
            faults.add(
                "model/face-twice",
                &format!("{path}.cut"),
                m,
                "a shank is cut once: remove one of the two",
            );
            continue;
        }
        if severs(body, &faces, scene) {
            strength_note(file, entry, &faces, scene, notes);
            let preload = Preload {
                body: entry.body.clone(),
                cut: entry.cut.clone(),
                axis,
                force: entry.force,
                closure: None,
                faces: Vec::new(),
            };
            cuts.push(Cut { preload, faces });
        } else {
            let m = format!(
                "the cut `{}` does not sever the body `{}`: its two sides are connected elsewhere",
                entry.cut, entry.body
            );
            let help = "let the physical surface cover the whole cross-section of the shank";
            faults.add("model/preload", &format!("{path}.cut"), m, help);
        }
    }
    if file.analysis == AnalysisKind::Limit && !cuts.is_empty() {
        let bodies: Vec<&str> = cuts.iter().map(|c| c.preload.body.as_str()).collect();
        notes.push(say!("limit analysis: the preload of {} drops out", bodies.join(", ")));
        cuts.iter_mut().for_each(|c| c.faces.clear());
    }
    cuts
}

/// The unit axis, if all numbers of an entry are valid.
fn numbers(entry: &PreloadEntry, path: &str, faults: &mut Faults<'_>) -> Option<V3> {
    let length = vec3::norm(entry.axis);
    let axis = length.is_finite() && length > 0.0;
    if !axis {
        let m = format!(
            "the axis of the preload of `{}` is {:?}, it has no direction",
            entry.body, entry.axis
        );
        faults.add(
            "model/value",
            &format!("{path}.axis"),
            m,
            "write the direction of the shank, such as `[1, 0, 0]`",
        );
    }
    let force = entry.force.is_finite() && entry.force > 0.0;
    if !force {
        let m = format!("the preload of `{}` is {} N, a preload is > 0", entry.body, entry.force);
        let help = "write the tension of the meshed part of the bolt in N; a bolt without preload \
                    needs no entry";
        faults.add("model/value", &format!("{path}.force"), m, help);
    }
    (axis && force).then(|| vec3::scale(1.0 / length, entry.axis))
}

/// Both sides of every face of a cut, side A first: the one whose outward normal points along the
/// axis.
fn sides(
    entry: &PreloadEntry,
    body: u32,
    triangles: &[[u32; 3]],
    axis: V3,
    path: &str,
    scene: &Scene<'_>,
    claims: &Claims,
    faults: &mut Faults<'_>,
) -> Option<Vec<[TetFace; 2]>> {
    let (cut, name) = (&entry.cut, &entry.body);
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
            "name mesh faces inside the shank only",
        )
    } else if outer > 0 {
        let m = format!(
            "{outer} of the {all} triangles of the cut `{cut}` are outer faces of the mesh"
        );
        (
            m,
            "a cut lies inside the shank: let gmsh mesh a plane through it (`BooleanFragments`) \
             and name it",
        )
    } else if found.is_empty() {
        (format!("the cut `{cut}` is empty"), "name mesh faces inside the shank")
    } else if flat {
        let m = format!("the cut `{cut}` runs along the axis of the preload of `{name}`");
        (m, "cut the shank across, or turn `axis` into its direction")
    } else {
        return Some(found);
    };
    faults.add("model/preload", &format!("{path}.cut"), m, help);
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

/// Adds a note where a preload exceeds the yield force of the shank.
fn strength_note(
    file: &ModelFile,
    entry: &PreloadEntry,
    faces: &[[TetFace; 2]],
    scene: &Scene<'_>,
    notes: &mut Vec<Text>,
) {
    let material = file.bodies.get(&entry.body).and_then(|m| file.materials.get(m));
    let Some(fy) = material.and_then(|m| m.fy) else { return };
    let area = faces.iter().map(|f| {
        let t = &scene.mesh.tets[f[0].tet as usize];
        vec3::norm(vec3::area_vector(
            &face_nodes(t, f[0].local).map(|n| scene.mesh.nodes[n as usize]),
        ))
    });
    let yields = fy * area.sum::<f64>();
    if entry.force > yields {
        notes.push(say!(
            "warning: the preload of `{}`, {} N, exceeds the {} N at which its shank yields",
            &entry.body,
            entry.force.to_string(),
            format!("{yields:.0}")
        ));
    }
}

/// The preloads after the nodes are split; `pairs` are in the order of the cuts. An error where
/// something ties both halves together at the rim of a cut.
pub(super) fn preloads(
    cuts: Vec<Cut>,
    pairs: &[OpenPair],
    split: &SplitMesh,
) -> Result<Vec<Preload>, Diagnostics> {
    let mut rest = pairs;
    cuts.into_iter()
        .map(|cut| {
            let (mine, others) = rest.split_at(cut.faces.len());
            rest = others;
            let held = mine
                .iter()
                .flat_map(|p| p.nodes_a.into_iter().zip(p.nodes_b))
                .find(|(a, b)| a == b);
            if let Some((node, _)) = held {
                let [x, y, z] = split.mesh.nodes[node as usize];
                let m = format!(
                    "something is tied to the shank of `{}` on both sides of the cut `{}`, at \
                     ({x}, {y}, {z})",
                    cut.preload.body, cut.preload.cut
                );
                let help = "cut the shank where nothing is tied to it: `law: contact` on the \
                            shank, or another cut";
                return Err(Diagnostic::input("model/preload", m).help(help).into());
            }
            Ok(Preload { faces: mine.iter().map(FacePair::from).collect(), ..cut.preload })
        })
        .collect()
}
