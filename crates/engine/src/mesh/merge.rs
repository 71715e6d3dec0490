//! Merges coincident nodes of different bodies in meshes that are already split. All meshes can
//! then be treated in the same way.

use super::TetMesh;
use super::error::MeshError;
use super::topology::{FaceTable, face_nodes};
use bracket_base::math::vec3::{cross, dot, sub, unit};
use std::collections::{BTreeMap, HashMap};

/// Nodes of different bodies are merged when their distance is below this fraction of the size of
/// the mesh (diagonal of its bounding box).
pub const COINCIDENT: f64 = 1e-6;

/// Merges coincident nodes of different bodies; returns the number of removed nodes.
pub fn merge_coincident(mesh: &mut TetMesh) -> Result<usize, MeshError> {
    let tolerance = COINCIDENT * diagonal(&mesh.nodes);
    let mut body = vec![u32::MAX; mesh.nodes.len()];
    let mut shared = vec![false; mesh.nodes.len()];
    for (t, b) in mesh.tets.iter().zip(&mesh.tet_body) {
        for n in t {
            let known = &mut body[*n as usize];
            shared[*n as usize] |= *known != u32::MAX && known != b;
            *known = *b;
        }
    }
    // only outer nodes can lie on another body
    let mut outer: Vec<u32> = FaceTable::new(&mesh.tets)
        .faces()
        .filter(|owners| owners.len() == 1)
        .flat_map(|owners| face_nodes(&mesh.tets[owners[0].tet as usize], owners[0].local))
        .collect();
    outer.sort_unstable();
    outer.dedup();

    let cell = |x: &[f64; 3]| x.map(|c| (c / (2.0 * tolerance)).floor() as i64);
    let mut grid: HashMap<[i64; 3], Vec<u32>> = HashMap::with_capacity(outer.len());
    let mut target: Vec<u32> = (0..mesh.nodes.len() as u32).collect();
    // bodies of the nodes merged into each node so far
    let mut gathered: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for n in outer {
        let x = mesh.nodes[n as usize];
        let mut found = None;
        // cells are two tolerances wide, so a near node lies in this cell or, on each axis, in the
        // neighbour on the nearer side
        let near: Vec<[i64; 2]> = x
            .iter()
            .map(|c| [c - tolerance, c + tolerance].map(|c| (c / (2.0 * tolerance)).floor() as i64))
            .collect();
        'search: for i in near[0] {
            for j in near[1] {
                for k in near[2] {
                    for m in grid.get(&[i, j, k]).into_iter().flatten() {
                        let d: f64 =
                            (0..3).map(|a| (mesh.nodes[*m as usize][a] - x[a]).powi(2)).sum();
                        if d.sqrt() <= tolerance {
                            found = Some(*m);
                            break 'search;
                        }
                    }
                }
            }
        }
        match found {
            None => grid.entry(cell(&x)).or_default().push(n),
            Some(m) => {
                let bodies = gathered.entry(m).or_insert_with(|| vec![body[m as usize]]);
                if bodies.contains(&body[n as usize]) || shared[n as usize] || shared[m as usize] {
                    return Err(MeshError::NearNodes {
                        body: mesh.bodies[body[n as usize] as usize].clone(),
                        x,
                        distance: tolerance,
                    });
                }
                bodies.push(body[n as usize]);
                target[n as usize] = m;
            }
        }
    }

    let mut new_index = vec![0u32; mesh.nodes.len()];
    let mut nodes = Vec::with_capacity(mesh.nodes.len());
    for (i, x) in mesh.nodes.iter().enumerate() {
        if target[i] as usize == i {
            new_index[i] = nodes.len() as u32;
            nodes.push(*x);
        }
    }
    let gone = mesh.nodes.len() - nodes.len();
    let new = |n: u32| new_index[target[n as usize] as usize];
    for t in &mut mesh.tets {
        *t = t.map(new);
    }
    for t in mesh.faces.iter_mut().flat_map(|f| f.triangles.iter_mut()) {
        *t = t.map(new);
    }
    mesh.nodes = nodes;
    Ok(gone)
}

/// Rejects interfaces whose two triangulations differ, that is, outer faces of two bodies that
/// share an edge, lie in one plane, face each other and overlap.
pub fn check_matching(mesh: &TetMesh, table: &FaceTable) -> Result<(), MeshError> {
    let mut by_edge: Vec<([u32; 2], u32, u32, [u32; 3])> = Vec::new();
    for owners in table.faces().filter(|o| o.len() == 1) {
        let e = owners[0].tet;
        let t = face_nodes(&mesh.tets[e as usize], owners[0].local);
        for i in 0..3 {
            let (p, q) = (t[i], t[(i + 1) % 3]);
            by_edge.push(([p.min(q), p.max(q)], mesh.tet_body[e as usize], t[(i + 2) % 3], t));
        }
    }
    by_edge.sort_unstable();
    for group in by_edge.chunk_by(|a, b| a.0 == b.0) {
        for (i, f) in group.iter().enumerate() {
            for g in &group[..i] {
                if f.1 != g.1 && facing_overlap(mesh, f.0, (f.2, f.3), (g.2, g.3)) {
                    let [a, b] = [g.1, f.1].map(|b| mesh.bodies[b as usize].clone());
                    return Err(MeshError::NotMatching { a, b, x: mesh.nodes[f.0[0] as usize] });
                }
            }
        }
    }
    Ok(())
}

/// True if two outward triangles with a common edge lie in one plane, face each other and lie on
/// the same side of the edge.
fn facing_overlap(mesh: &TetMesh, edge: [u32; 2], f: (u32, [u32; 3]), g: (u32, [u32; 3])) -> bool {
    let x = |n: u32| mesh.nodes[n as usize];
    let normal = |t: [u32; 3]| unit(cross(sub(x(t[1]), x(t[0])), sub(x(t[2]), x(t[0]))));
    if dot(normal(f.1), normal(g.1)) > -1.0 + 1e-9 {
        return false;
    }
    let along = unit(sub(x(edge[1]), x(edge[0])));
    let across = |n: u32| {
        let d = sub(x(n), x(edge[0]));
        let s = dot(d, along);
        [0, 1, 2].map(|i| d[i] - s * along[i])
    };
    dot(across(f.0), across(g.0)) > 0.0
}

/// Diagonal of the bounding box \[mm\].
pub fn diagonal(nodes: &[[f64; 3]]) -> f64 {
    let mut sum = 0.0;
    for k in 0..3 {
        let lo = nodes.iter().map(|x| x[k]).fold(f64::INFINITY, f64::min);
        let hi = nodes.iter().map(|x| x[k]).fold(f64::NEG_INFINITY, f64::max);
        sum += (hi - lo).powi(2);
    }
    sum.sqrt()
}

#[cfg(test)]
mod tests;
