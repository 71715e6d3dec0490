//! Triangles of the mesh: corners, areas, selection by body.

use bracket_base::math::vec3::{V3, cross, dot, sub};
use bracket_engine::mesh::TetMesh;
use bracket_engine::mesh::topology::{FaceRow, FaceTable, face_nodes};

/// Coordinates of three nodes \[mm\].
pub fn corners(mesh: &TetMesh, nodes: [u32; 3]) -> [V3; 3] {
    nodes.map(|n| mesh.nodes[n as usize])
}

/// Area of a triangle \[mm²\].
pub fn area(mesh: &TetMesh, nodes: [u32; 3]) -> f64 {
    let [a, b, c] = corners(mesh, nodes);
    let n = cross(sub(b, a), sub(c, a));
    0.5 * dot(n, n).sqrt()
}

/// Sum of the areas of triangles \[mm²\].
pub fn total(mesh: &TetMesh, triangles: &[[u32; 3]]) -> f64 {
    triangles.iter().map(|t| area(mesh, *t)).sum()
}

/// Nodes of a face, ordered outward from its tet.
pub fn nodes_of(mesh: &TetMesh, row: &FaceRow) -> [u32; 3] {
    face_nodes(&mesh.tets[row.tet as usize], row.local)
}

/// Faces between bodies `a` and `b`, ordered outward from `a`.
pub fn between(mesh: &TetMesh, table: &FaceTable, a: usize, b: usize) -> Vec<[u32; 3]> {
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
