//! The displacement space of 10-node tetrahedra: vertices and mid-side nodes.

use crate::mesh::TetMesh;
use crate::mesh::numbering::EdgeNumbering;
use bracket_base::math::vec3::{self, V3};

/// Ends of the edges of a face, by position: mid-side nodes 3, 4, 5 of a 6-node triangle.
pub const FACE_EDGES: [[usize; 2]; 3] = [[0, 1], [1, 2], [0, 2]];

/// The displacement space: vertices, then mid-side nodes.
#[derive(Clone, Debug, Default)]
pub struct Tet10Space {
    /// Coordinates of vertices and mid-side nodes \[mm\].
    pub nodes: Vec<V3>,
    /// Number of vertices; edge `i` carries node `vertices + i`.
    pub vertices: usize,
    /// The edges.
    pub edges: EdgeNumbering,
}

impl Tet10Space {
    /// The space on a mesh.
    pub fn new(mesh: &TetMesh) -> Self {
        let edges = EdgeNumbering::new(mesh);
        let mut nodes = mesh.nodes.clone();
        nodes.extend(edges.nodes.iter().map(|e| {
            let (a, b) = (mesh.nodes[e[0] as usize], mesh.nodes[e[1] as usize]);
            vec3::scale(0.5, vec3::add(a, b))
        }));
        Self { nodes, vertices: mesh.nodes.len(), edges }
    }

    /// The node itself if it is a vertex, otherwise one end of its edge.
    pub fn a_vertex(&self, node: usize) -> usize {
        node.checked_sub(self.vertices).map_or(node, |edge| self.edges.nodes[edge][0] as usize)
    }

    /// The ten nodes of tet `e`.
    pub fn tet(&self, mesh: &TetMesh, e: usize) -> [usize; 10] {
        std::array::from_fn(|i| {
            if i < 4 {
                mesh.tets[e][i] as usize
            } else {
                self.vertices + self.edges.of_tet[e][i - 4] as usize
            }
        })
    }

    /// The six nodes of a triangle given by its vertices: the vertices, then the mid-sides of
    /// [`FACE_EDGES`].
    pub fn triangle(&self, v: [u32; 3]) -> [usize; 6] {
        std::array::from_fn(|i| {
            if i < 3 {
                v[i] as usize
            } else {
                let [a, b] = FACE_EDGES[i - 3];
                self.vertices
                    + self
                        .edges
                        .find(v[a], v[b])
                        .expect("every edge of a mesh face is in the table")
                        as usize
            }
        })
    }
}
