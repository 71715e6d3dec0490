//! Small meshes for tests: blocks of cubes, each cut into six tets along its main diagonal.
//! Neighbouring cubes are mirror images of each other.

use super::tet::signed_volume;
use super::topology::{FaceTable, face_nodes};
use super::{NamedFaces, TetMesh};
use std::collections::BTreeMap;

/// Edge of a cube \[mm\].
pub const EDGE: f64 = 10.0;

/// Cubes `[i, j, k]`, each with the name of its body; they share nodes.
pub fn cubes(cells: &[([i32; 3], &str)]) -> TetMesh {
    let mut mesh = TetMesh::default();
    let mut numbers: BTreeMap<[i32; 3], u32> = BTreeMap::new();
    for (cell, body) in cells {
        let b = mesh.bodies.iter().position(|n| n == body).unwrap_or_else(|| {
            mesh.bodies.push(body.to_string());
            mesh.bodies.len() - 1
        });
        // the six paths from one corner to the opposite one, along one axis after another
        for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let start = cell.map(|c| c.rem_euclid(2));
            let mut p: [i32; 3] = std::array::from_fn(|d| cell[d] + start[d]);
            let mut tet = [0; 4];
            for v in 0..4 {
                tet[v] = *numbers.entry(p).or_insert_with(|| {
                    mesh.nodes.push(p.map(|c| EDGE * f64::from(c)));
                    (mesh.nodes.len() - 1) as u32
                });
                if v < 3 {
                    p[order[v]] = cell[order[v]] + 1 - start[order[v]];
                }
            }
            if signed_volume(&tet.map(|n| mesh.nodes[n as usize])) < 0.0 {
                tet.swap(2, 3);
            }
            mesh.tets.push(tet);
            mesh.tet_body.push(b as u32);
        }
    }
    mesh
}

/// Names all faces (outer and inner, each once) whose vertices all satisfy `on`.
pub fn name(mesh: &mut TetMesh, name: &str, on: impl Fn([f64; 3]) -> bool) {
    let table = FaceTable::new(&mesh.tets);
    let triangles = table
        .faces()
        .map(|o| face_nodes(&mesh.tets[o[0].tet as usize], o[0].local))
        .filter(|t| t.iter().all(|n| on(mesh.nodes[*n as usize])))
        .collect();
    mesh.faces.push(NamedFaces { name: name.to_string(), triangles });
}

/// Gives every body its own nodes; named faces follow the first body.
pub fn explode(mesh: &TetMesh) -> TetMesh {
    let table = FaceTable::new(&mesh.tets);
    let mut out = TetMesh { nodes: Vec::new(), ..mesh.clone() };
    let mut numbers: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    let mut new = |body: u32, n: u32| {
        *numbers.entry((body, n)).or_insert_with(|| {
            out.nodes.push(mesh.nodes[n as usize]);
            (out.nodes.len() - 1) as u32
        })
    };
    for (t, b) in out.tets.iter_mut().zip(&mesh.tet_body) {
        *t = t.map(|n| new(*b, n));
    }
    for t in out.faces.iter_mut().flat_map(|f| f.triangles.iter_mut()) {
        let owner = table.owners(*t)[0].tet;
        *t = t.map(|n| new(mesh.tet_body[owner as usize], n));
    }
    out
}

/// The mesh as gmsh 2.2 text.
pub fn msh_text(mesh: &TetMesh) -> String {
    let mut s = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n".to_string();
    s += &format!("{}\n", mesh.bodies.len() + mesh.faces.len());
    for (i, f) in mesh.faces.iter().enumerate() {
        s += &format!("2 {} \"{}\"\n", i + 101, f.name);
    }
    for (i, b) in mesh.bodies.iter().enumerate() {
        s += &format!("3 {} \"{b}\"\n", i + 1);
    }
    s += &format!("$EndPhysicalNames\n$Nodes\n{}\n", mesh.nodes.len());
    for (i, x) in mesh.nodes.iter().enumerate() {
        s += &format!("{} {} {} {}\n", i + 1, x[0], x[1], x[2]);
    }
    let mut elements = Vec::new();
    for (i, f) in mesh.faces.iter().enumerate() {
        elements.extend(f.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|n| n + 1);
            format!("2 2 {} 1 {a} {b} {c}", i + 101)
        }));
    }
    for (t, b) in mesh.tets.iter().zip(&mesh.tet_body) {
        let [p, q, r, w] = t.map(|n| n + 1);
        elements.push(format!("4 2 {} 1 {p} {q} {r} {w}", b + 1));
    }
    s += &format!("$EndNodes\n$Elements\n{}\n", elements.len());
    for (i, e) in elements.iter().enumerate() {
        s += &format!("{} {e}\n", i + 1);
    }
    s + "$EndElements\n"
}
