//! The faces of a mesh and the tets at each face.

use super::tet::FACES;

/// One face of one tet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct FaceRow {
    /// Node indices of the face, increasing.
    pub key: [u32; 3],
    /// The tet.
    pub tet: u32,
    /// The face opposite this local vertex.
    pub local: u8,
    /// True when the outward order of the nodes is an even permutation of `key`.
    pub even: bool,
}

/// All faces of a mesh, sorted by nodes, then by tet.
#[derive(Clone, Debug, Default)]
pub struct FaceTable {
    rows: Vec<FaceRow>,
}

/// The nodes in increasing order, and whether that is an even permutation.
pub fn sorted(mut t: [u32; 3]) -> ([u32; 3], bool) {
    let mut even = true;
    for (i, j) in [(0, 1), (1, 2), (0, 1)] {
        if t[i] > t[j] {
            t.swap(i, j);
            even = !even;
        }
    }
    (t, even)
}

/// Nodes of the face of `tet` opposite local vertex `local`, ordered outward for a tet of positive
/// volume.
pub fn face_nodes(tet: &[u32; 4], local: u8) -> [u32; 3] {
    FACES[local as usize].map(|v| tet[v])
}

impl FaceTable {
    /// Collects and sorts the faces of all tets.
    pub fn new(tets: &[[u32; 4]]) -> Self {
        let mut rows = Vec::with_capacity(4 * tets.len());
        for (e, tet) in tets.iter().enumerate() {
            for local in 0..4u8 {
                let (key, even) = sorted(face_nodes(tet, local));
                rows.push(FaceRow { key, tet: e as u32, local, even });
            }
        }
        rows.sort_unstable();
        Self { rows }
    }

    /// The tets at the face with these nodes (in any order): none, one (outer face), two, or more
    /// in an invalid mesh.
    pub fn owners(&self, nodes: [u32; 3]) -> &[FaceRow] {
        let (key, _) = sorted(nodes);
        let start = self.rows.partition_point(|r| r.key < key);
        let end = start + self.rows[start..].iter().take_while(|r| r.key == key).count();
        &self.rows[start..end]
    }

    /// Every face once, with all its tets.
    pub fn faces(&self) -> impl Iterator<Item = &[FaceRow]> {
        self.rows.chunk_by(|a, b| a.key == b.key)
    }
}
