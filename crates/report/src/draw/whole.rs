//! A mesh of half or a quarter of a shape, completed by reflection in its planes of symmetry.

use bracket_base::math::vec3::V3;
use bracket_engine::mesh::TetMesh;

/// The completed mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Whole {
    /// Its tets; named faces and regions are left out.
    pub mesh: TetMesh,
    /// The node of the given mesh that each node is, or is an image of.
    origin: Vec<u32>,
    /// Signs of the components of a vector field at each node.
    signs: Vec<V3>,
}

impl Whole {
    /// Reflects a mesh in the planes `x[axis] = 0`, one axis after the other. Nodes in a plane are
    /// common to both halves.
    pub fn of(mesh: &TetMesh, axes: &[usize]) -> Self {
        let n = mesh.nodes.len();
        let mut out = Self {
            mesh: TetMesh { faces: Vec::new(), tet_region: Vec::new(), ..mesh.clone() },
            origin: (0..n as u32).collect(),
            signs: vec![[1.0; 3]; n],
        };
        axes.iter().for_each(|axis| out.reflect(*axis));
        out
    }

    fn reflect(&mut self, axis: usize) {
        let mesh = &mut self.mesh;
        let reach = mesh.nodes.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        let twin: Vec<u32> = (0..mesh.nodes.len())
            .map(|i| {
                let mut x = mesh.nodes[i];
                if x[axis].abs() <= 1e-6 * reach {
                    return i as u32;
                }
                x[axis] = -x[axis];
                let mut sign = self.signs[i];
                sign[axis] = -sign[axis];
                mesh.nodes.push(x);
                self.signs.push(sign);
                self.origin.push(self.origin[i]);
                (mesh.nodes.len() - 1) as u32
            })
            .collect();
        for e in 0..mesh.tets.len() {
            let [a, b, c, d] = mesh.tets[e].map(|n| twin[n as usize]);
            mesh.tets.push([a, b, d, c]);
            mesh.tet_body.push(mesh.tet_body[e]);
        }
    }

    /// A nodal field of the given mesh at the nodes.
    pub fn scalars(&self, field: &[f64]) -> Vec<f64> {
        self.origin.iter().map(|n| field[*n as usize]).collect()
    }

    /// The same for a vector field. It is antisymmetric to the planes with the normals `odd`, and
    /// symmetric to the others.
    pub fn vectors(&self, field: &[V3], odd: &[usize]) -> Vec<V3> {
        let value = |(n, s): (&u32, &V3)| {
            let turned: f64 = odd.iter().map(|axis| s[*axis]).product();
            [0, 1, 2].map(|k| turned * s[k] * field[*n as usize][k])
        };
        self.origin.iter().zip(&self.signs).map(value).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A corner tet becomes an octahedron; a radial field stays radial.
    #[test]
    fn a_corner_tet_becomes_an_octahedron() {
        let mesh = TetMesh {
            nodes: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            tets: vec![[0, 1, 2, 3]],
            tet_body: vec![0],
            bodies: vec!["A".into()],
            ..TetMesh::default()
        };
        let whole = Whole::of(&mesh, &[0, 1, 2]);
        assert_eq!((whole.mesh.nodes.len(), whole.mesh.tets.len()), (7, 8));
        let volume: f64 = (0..8).map(|e| whole.mesh.volume(e)).sum();
        assert!((0..8).all(|e| whole.mesh.volume(e) > 0.0) && (volume - 8.0 / 6.0).abs() < 1e-14);
        assert_eq!(whole.vectors(&mesh.nodes, &[]), whole.mesh.nodes);
        // antisymmetric to x = 0: the component along x is even, the others are odd
        let odd = whole.vectors(&[[1.0, 2.0, 3.0]; 4], &[0]);
        let image = whole.mesh.nodes.iter().position(|x| x[0] < 0.0).expect("an image");
        assert_eq!((odd[1], odd[image]), ([1.0, 2.0, 3.0], [1.0, -2.0, -3.0]));
        assert_eq!(whole.scalars(&[5.0, 1.0, 2.0, 3.0])[1..4], [1.0, 2.0, 3.0]);
    }
}
