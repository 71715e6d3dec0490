//! Tetrahedral meshes: 4-node tets in bodies, and named triangle faces.

/// A named set of triangles (a physical surface of the mesh file).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NamedFaces {
    /// Name of the physical surface.
    pub name: String,
    /// Node indices of each triangle, in file order (the orientation has no meaning).
    pub triangles: Vec<[u32; 3]>,
}

/// A mesh of straight 4-node tetrahedra.
///
/// In a mesh as read from a file, bodies that touch share nodes. [`crate::mesh::split`] gives each
/// side of an open interface its own nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TetMesh {
    /// Node coordinates \[mm\].
    pub nodes: Vec<[f64; 3]>,
    /// Node indices of each tet, in an order that makes its volume positive.
    pub tets: Vec<[u32; 4]>,
    /// Body (index into `bodies`) of each tet.
    pub tet_body: Vec<u32>,
    /// Region of each tet: the mesher's volume that it lies in. A body may consist of several
    /// regions (the two halves of a plate); remeshing keeps their common faces. Empty: each body is
    /// one region.
    pub tet_region: Vec<u32>,
    /// Names of the bodies (physical volumes).
    pub bodies: Vec<String>,
    /// Named faces (physical surfaces).
    pub faces: Vec<NamedFaces>,
}

/// Local vertices of the face opposite vertex `i`, ordered outward for a tet of positive volume.
pub const FACES: [[usize; 3]; 4] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

/// Local vertices of edge `i`, which carries mid-side node `4 + i` of the 10-node tet.
pub const EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [0, 2], [0, 3], [1, 3], [2, 3]];

impl TetMesh {
    /// Corner coordinates of tet `e` \[mm\].
    pub fn corners(&self, e: usize) -> [[f64; 3]; 4] {
        self.tets[e].map(|n| self.nodes[n as usize])
    }

    /// Signed volume of tet `e` \[mm³\].
    pub fn volume(&self, e: usize) -> f64 {
        signed_volume(&self.corners(e))
    }

    /// The faces with the name `name`, if the mesh has them.
    pub fn faces_named(&self, name: &str) -> Option<&NamedFaces> {
        self.faces.iter().find(|f| f.name == name)
    }
}

/// Signed volume of a tet given by its corners, positive when `(b-a)×(c-a)·(d-a) > 0`.
pub fn signed_volume(x: &[[f64; 3]; 4]) -> f64 {
    let d = |i: usize, k: usize| x[i][k] - x[0][k];
    (d(1, 0) * (d(2, 1) * d(3, 2) - d(2, 2) * d(3, 1))
        - d(1, 1) * (d(2, 0) * d(3, 2) - d(2, 2) * d(3, 0))
        + d(1, 2) * (d(2, 0) * d(3, 1) - d(2, 1) * d(3, 0)))
        / 6.0
}
