//! Faces and edges of a tet mesh, numbered once and in a fixed order.

use super::tet::{EDGES, FACES, TetMesh};

/// The distinct triangle faces of a mesh.
#[derive(Clone, Debug, Default)]
pub struct FaceNumbering {
    /// Node indices of each face, increasing.
    pub nodes: Vec<[u32; 3]>,
    /// Face index for each local face of each tet (local face `i` is opposite local vertex `i`).
    pub of_tet: Vec<[u32; 4]>,
    /// Tets at each face; the second is absent on the outer surface.
    pub tets: Vec<(u32, Option<u32>)>,
}

impl FaceNumbering {
    /// Numbers the faces in increasing order of their nodes.
    pub fn new(mesh: &TetMesh) -> Self {
        let mut all: Vec<([u32; 3], u32, u8)> = Vec::with_capacity(4 * mesh.tets.len());
        for (e, t) in mesh.tets.iter().enumerate() {
            for (k, f) in FACES.iter().enumerate() {
                let mut n = f.map(|i| t[i]);
                n.sort_unstable();
                all.push((n, e as u32, k as u8));
            }
        }
        all.sort_unstable();
        let mut table =
            FaceNumbering { of_tet: vec![[0; 4]; mesh.tets.len()], ..Default::default() };
        for (n, e, k) in all {
            if table.nodes.last() == Some(&n) {
                if let Some(owners) = table.tets.last_mut() {
                    owners.1 = Some(e);
                }
            } else {
                table.nodes.push(n);
                table.tets.push((e, None));
            }
            table.of_tet[e as usize][k as usize] = (table.nodes.len() - 1) as u32;
        }
        table
    }

    /// Position of each vertex of local face `k` of `tet` (in [`FACES`] order) among the increasing
    /// nodes of the face.
    pub fn positions(&self, mesh: &TetMesh, tet: usize, k: usize) -> [usize; 3] {
        let nodes = self.nodes[self.of_tet[tet][k] as usize];
        FACES[k].map(|i| {
            nodes
                .iter()
                .position(|n| *n == mesh.tets[tet][i])
                .expect("a tet's face has the tet's nodes")
        })
    }
}

/// The distinct edges of a mesh, which carry the mid-side nodes of its 10-node tets.
#[derive(Clone, Debug, Default)]
pub struct EdgeNumbering {
    /// End nodes of each edge, increasing.
    pub nodes: Vec<[u32; 2]>,
    /// Edge index for each local edge of each tet.
    pub of_tet: Vec<[u32; 6]>,
}

impl EdgeNumbering {
    /// Numbers the edges in increasing order of their nodes.
    pub fn new(mesh: &TetMesh) -> Self {
        let key = |t: &[u32; 4], e: &[usize; 2]| {
            let (a, b) = (t[e[0]], t[e[1]]);
            [a.min(b), a.max(b)]
        };
        let mut nodes: Vec<[u32; 2]> =
            mesh.tets.iter().flat_map(|t| EDGES.iter().map(move |e| key(t, e))).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let of_tet = mesh
            .tets
            .iter()
            .map(|t| {
                EDGES.map(|e| {
                    nodes.binary_search(&key(t, &e)).expect("the table holds every edge") as u32
                })
            })
            .collect();
        Self { nodes, of_tet }
    }

    /// The edge between two nodes.
    pub fn find(&self, a: u32, b: u32) -> Option<u32> {
        self.nodes.binary_search(&[a.min(b), a.max(b)]).ok().map(|i| i as u32)
    }
}
