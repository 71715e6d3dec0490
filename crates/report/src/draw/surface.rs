//! The outer surface of a mesh for the pictures: triangles by body, mirrored copies, feature edges.

use bracket_base::math::vec3::{cross, dot, sub, unit};
use bracket_engine::mesh::TetMesh;
use bracket_engine::mesh::tet::FACES;

/// One triangle of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SurfaceTriangle {
    /// Nodes, ordered so that the normal points outward.
    pub nodes: [u32; 3],
    /// Body it belongs to.
    pub body: u32,
}

/// A triangulated surface. Nodal arrays of the caller keep the mesh's numbering through `origin`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Node coordinates \[mm\].
    pub points: Vec<[f64; 3]>,
    /// The triangles.
    pub triangles: Vec<SurfaceTriangle>,
    /// Names of the bodies.
    pub bodies: Vec<String>,
    /// The node of the mesh that each point is, or is a mirrored copy of.
    pub origin: Vec<u32>,
    /// Signs of the components of a vector field of the mesh at each point: −1 along the axes in
    /// which the point was mirrored.
    pub signs: Vec<[f64; 3]>,
}

/// Style of an edge of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeKind {
    /// A line of the mesh only.
    Mesh,
    /// A crease of the shape or a border between bodies.
    Feature,
}

impl Surface {
    /// The faces that belong to one tet only. At interfaces of a split mesh both sides have outer
    /// faces.
    pub fn of(mesh: &TetMesh) -> Self {
        let mut faces: Vec<([u32; 3], SurfaceTriangle)> = Vec::with_capacity(4 * mesh.tets.len());
        for (tet, &body) in mesh.tets.iter().zip(&mesh.tet_body) {
            for face in FACES {
                let nodes = face.map(|i| tet[i]);
                let mut key = nodes;
                key.sort_unstable();
                faces.push((key, SurfaceTriangle { nodes, body }));
            }
        }
        faces.sort_unstable_by_key(|(key, triangle)| (*key, triangle.nodes));
        let triangles = faces
            .chunk_by(|a, b| a.0 == b.0)
            .filter(|same| same.len() == 1)
            .map(|same| same[0].1)
            .collect();
        let n = mesh.nodes.len();
        Self {
            points: mesh.nodes.clone(),
            triangles,
            bodies: mesh.bodies.clone(),
            origin: (0..n as u32).collect(),
            signs: vec![[1.0; 3]; n],
        }
    }

    /// The surface together with its mirror image in the plane `x[axis] = 0`. The two are joined
    /// along the plane; triangles in the plane become interior and are removed.
    pub fn mirrored(mut self, axis: usize) -> Self {
        let (low, high) = self.extents();
        let tolerance = 1e-6 * (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
        let in_plane: Vec<bool> = self.points.iter().map(|p| p[axis].abs() <= tolerance).collect();
        self.triangles.retain(|t| !t.nodes.iter().all(|&n| in_plane[n as usize]));
        let twin: Vec<u32> = (0..self.points.len())
            .map(|i| {
                if in_plane[i] {
                    return i as u32;
                }
                let (mut point, mut sign) = (self.points[i], self.signs[i]);
                point[axis] = -point[axis];
                sign[axis] = -sign[axis];
                self.points.push(point);
                self.signs.push(sign);
                self.origin.push(self.origin[i]);
                (self.points.len() - 1) as u32
            })
            .collect();
        for i in 0..self.triangles.len() {
            let SurfaceTriangle { nodes: [a, b, c], body } = self.triangles[i];
            let nodes = [a, c, b].map(|n| twin[n as usize]);
            self.triangles.push(SurfaceTriangle { nodes, body });
        }
        self
    }

    /// Lowest and highest coordinates of the points that triangles use \[mm\].
    pub fn extents(&self) -> ([f64; 3], [f64; 3]) {
        let mut box_ = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in self.triangles.iter().flat_map(|t| t.nodes).map(|n| self.points[n as usize]) {
            for k in 0..3 {
                box_.0[k] = box_.0[k].min(point[k]);
                box_.1[k] = box_.1[k].max(point[k]);
            }
        }
        box_
    }

    /// Kind of the edge from node `i` to node `i + 1` of every triangle. A feature is an edge whose
    /// triangles meet at more than `angle` \[rad\], belong to different bodies, or are not exactly
    /// two.
    pub fn edge_kinds(&self, angle: f64) -> Vec<[EdgeKind; 3]> {
        let normals: Vec<[f64; 3]> = self
            .triangles
            .iter()
            .map(|t| unit_normal(t.nodes.map(|n| self.points[n as usize])))
            .collect();
        let mut edges: Vec<(u32, u32, usize, usize)> = Vec::with_capacity(3 * self.triangles.len());
        for (t, triangle) in self.triangles.iter().enumerate() {
            for i in 0..3 {
                let (a, b) = (triangle.nodes[i], triangle.nodes[(i + 1) % 3]);
                edges.push((a.min(b), a.max(b), t, i));
            }
        }
        edges.sort_unstable();
        let mut kinds = vec![[EdgeKind::Mesh; 3]; self.triangles.len()];
        for same in edges.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let smooth = match same {
                [one, two] => {
                    let (n, m) = (normals[one.2], normals[two.2]);
                    self.triangles[one.2].body == self.triangles[two.2].body
                        && dot(n, m) >= angle.cos()
                }
                _ => false,
            };
            if !smooth {
                for &(_, _, t, i) in same {
                    kinds[t][i] = EdgeKind::Feature;
                }
            }
        }
        kinds
    }
}

pub(crate) fn unit_normal(x: [[f64; 3]; 3]) -> [f64; 3] {
    unit(cross(sub(x[1], x[0]), sub(x[2], x[0])))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tet of the origin and the three unit points, with a second body glued to its inclined
    /// face.
    fn two_tets() -> TetMesh {
        TetMesh {
            nodes: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0; 3]],
            tets: vec![[0, 1, 2, 3], [4, 1, 3, 2]],
            tet_body: vec![0, 1],
            tet_region: vec![],
            bodies: vec!["A".into(), "B".into()],
            faces: vec![],
        }
    }

    #[test]
    fn shared_faces_are_inside_and_normals_point_out() {
        let mesh = two_tets();
        assert!((0..2).all(|e| mesh.volume(e) > 0.0));
        let surface = Surface::of(&mesh);
        assert_eq!(surface.triangles.len(), 6);
        // divergence theorem: Σ area·n·x / 3 is the volume if all normals point outwards
        let volume: f64 = surface
            .triangles
            .iter()
            .map(|t| t.nodes.map(|n| surface.points[n as usize]))
            .map(|x| dot(x[0], cross(x[1], x[2])) / 6.0)
            .sum();
        assert!((volume - 0.5).abs() < 1e-14, "{volume}");
    }

    #[test]
    fn a_mirrored_surface_is_closed_and_has_no_seam() {
        let surface = Surface::of(&two_tets()).mirrored(0);
        let volume: f64 = surface
            .triangles
            .iter()
            .map(|t| t.nodes.map(|n| surface.points[n as usize]))
            .map(|x| dot(x[0], cross(x[1], x[2])) / 6.0)
            .sum();
        assert!((volume - 1.0).abs() < 1e-14, "{volume}");
        assert!(
            surface
                .triangles
                .iter()
                .all(|t| !t.nodes.iter().all(|&n| surface.points[n as usize][0] == 0.0))
        );
        // on y = 0 the triangle (0 1 3) and its image meet along the z axis: they are coplanar, so
        // there is no feature
        let kinds = surface.edge_kinds(0.4);
        let mut seam = 0;
        for (t, kind) in surface.triangles.iter().zip(&kinds) {
            for i in 0..3 {
                let edge = [t.nodes[i], t.nodes[(i + 1) % 3]];
                let flat = t.nodes.iter().all(|&n| surface.points[n as usize][1] == 0.0);
                if flat && (edge == [0, 3] || edge == [3, 0]) {
                    assert_eq!(kind[i], EdgeKind::Mesh);
                    seam += 1;
                }
            }
        }
        assert_eq!(seam, 2);
    }
}
