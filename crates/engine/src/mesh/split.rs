//! Separates the nodes of the two sides of every open interface.
//!
//! A node gets one copy for each connected component of its tets. Tets are connected through shared
//! faces that contain the node and are not open. No list of special junctions is needed. A bolt
//! whose head is tied to a plate and whose shank is in contact with the same plate keeps common
//! nodes on the circle where both meet. Two bodies that touch only in a line or a point are
//! separated.

use super::TetMesh;
use super::tet::FACES;
use super::topology::{FaceRow, FaceTable, face_nodes};

/// A face of a tet, opposite local vertex `local`; see [`FACES`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TetFace {
    /// The tet.
    pub tet: u32,
    /// Its local vertex opposite the face.
    pub local: u8,
}

impl From<&FaceRow> for TetFace {
    fn from(row: &FaceRow) -> Self {
        Self { tet: row.tet, local: row.local }
    }
}

/// The two sides of an opened face.
///
/// `nodes_a[i]` and `nodes_b[i]` have the same coordinates, bit for bit. `nodes_a` is ordered
/// around the normal out of side A. Where the two sides stay connected around an end of the
/// opening, the two indices are equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OpenPair {
    /// Side A.
    pub a: TetFace,
    /// Side B.
    pub b: TetFace,
    /// Vertices of side A.
    pub nodes_a: [u32; 3],
    /// The matching vertices of side B.
    pub nodes_b: [u32; 3],
}

/// A mesh after splitting. Tets keep their numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct SplitMesh {
    /// The mesh. Named triangles on an open face have the nodes of the first of its two tets.
    pub mesh: TetMesh,
    /// One pair for each open face, in the order given.
    pub pairs: Vec<OpenPair>,
    /// Component of each tet; tets are connected through faces that are not open. Components are
    /// numbered by their first tet.
    pub tet_part: Vec<u32>,
    /// Number of components.
    pub parts: usize,
}

/// Splits the nodes of `mesh` along the faces `open` (side A, side B).
///
/// `table` is the face table of `mesh`. Every pair in `open` must be the two sides of one interior
/// face.
pub fn split(mesh: &TetMesh, table: &FaceTable, open: &[[TetFace; 2]]) -> SplitMesh {
    let ne = mesh.tets.len();
    let mut is_open = vec![[false; 4]; ne];
    for side in open.iter().flatten() {
        is_open[side.tet as usize][side.local as usize] = true;
    }
    let mut corners = UnionFind::new(4 * ne);
    let mut tets = UnionFind::new(ne);
    for owners in table.faces() {
        let inner = owners.len() == 2 && !is_open[owners[0].tet as usize][owners[0].local as usize];
        if !inner {
            continue;
        }
        let [p, q] = [owners[0].tet as usize, owners[1].tet as usize];
        tets.join(p, q);
        for node in owners[0].key {
            corners.join(4 * p + vertex(&mesh.tets[p], node), 4 * q + vertex(&mesh.tets[q], node));
        }
    }

    // the first component of a node, in the order of the tets, keeps its number; the others get new
    // numbers at the end
    let mut out = mesh.clone();
    let mut taken = vec![false; mesh.nodes.len()];
    let mut number = vec![u32::MAX; 4 * ne];
    for e in 0..ne {
        for v in 0..4 {
            let root = corners.root(4 * e + v);
            let node = mesh.tets[e][v];
            if number[root] == u32::MAX {
                number[root] = if taken[node as usize] {
                    out.nodes.push(mesh.nodes[node as usize]);
                    (out.nodes.len() - 1) as u32
                } else {
                    taken[node as usize] = true;
                    node
                };
            }
            out.tets[e][v] = number[root];
        }
    }
    for (named, old) in out.faces.iter_mut().zip(&mesh.faces) {
        for (t, old) in named.triangles.iter_mut().zip(&old.triangles) {
            if let Some(row) = table.owners(*old).first() {
                let e = row.tet as usize;
                *t = old.map(|n| out.tets[e][vertex(&mesh.tets[e], n)]);
            }
        }
    }
    let pairs = open
        .iter()
        .map(|[a, b]| {
            let (ta, tb) = (a.tet as usize, b.tet as usize);
            let nodes_a = face_nodes(&out.tets[ta], a.local);
            let nodes_b = FACES[a.local as usize]
                .map(|v| out.tets[tb][vertex(&mesh.tets[tb], mesh.tets[ta][v])]);
            OpenPair { a: *a, b: *b, nodes_a, nodes_b }
        })
        .collect();

    let mut part_of_root = vec![u32::MAX; ne];
    let mut parts = 0;
    let tet_part = (0..ne)
        .map(|e| {
            let root = tets.root(e);
            if part_of_root[root] == u32::MAX {
                part_of_root[root] = parts;
                parts += 1;
            }
            part_of_root[root]
        })
        .collect();
    SplitMesh { mesh: out, pairs, tet_part, parts: parts as usize }
}

/// Local vertex of `tet` at the node `node`.
fn vertex(tet: &[u32; 4], node: u32) -> usize {
    tet.iter().position(|n| *n == node).expect("both tets at a face have its nodes")
}

/// Disjoint sets with the smallest member as root.
pub(super) struct UnionFind {
    parent: Vec<u32>,
}

impl UnionFind {
    pub(super) fn new(n: usize) -> Self {
        Self { parent: (0..n as u32).collect() }
    }

    pub(super) fn root(&mut self, mut i: usize) -> usize {
        while self.parent[i] as usize != i {
            self.parent[i] = self.parent[self.parent[i] as usize];
            i = self.parent[i] as usize;
        }
        i
    }

    pub(super) fn join(&mut self, i: usize, j: usize) {
        let (i, j) = (self.root(i), self.root(j));
        self.parent[i.max(j)] = i.min(j) as u32;
    }
}

#[cfg(test)]
mod tests;
