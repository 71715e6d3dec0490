//! The shape of the bodies and faces of a mesh, whatever its elements: two meshes of one polyhedron
//! have the same.

use super::TetMesh;
use super::topology::FaceTable;
use bracket_base::math::vec3::{V3, area_vector, norm, sub};
use std::collections::BTreeMap;

/// Allowed relative difference; meshes of one polyhedron agree to rounding.
const SAME: f64 = 1e-6;

/// Integrals over bodies and faces, by their names.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// A corner of the box around the nodes \[mm\].
    corner: V3,
    /// Diagonal of the box \[mm\]; the integrals are those of the mesh in a box of diagonal 1.
    diagonal: f64,
    /// Volume, surface and moments of every body.
    bodies: BTreeMap<String, Vec<f64>>,
    /// Area and moments of every named face.
    faces: BTreeMap<String, Vec<f64>>,
}

impl Shape {
    /// The shape of a mesh.
    pub fn of(mesh: &TetMesh) -> Self {
        let (lo, hi) = box_around(&mesh.nodes);
        let unit = norm(sub(hi, lo)).max(f64::MIN_POSITIVE);
        // the moments are those about a corner of the box, over its diagonal
        let at = |n: u32| sub(mesh.nodes[n as usize], lo).map(|x| x / unit);
        let mut bodies: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        for (e, tet) in mesh.tets.iter().enumerate() {
            let size = mesh.volume(e).abs() / unit.powi(3);
            add(&mut bodies, body_of(mesh, e as u32), &moments(size, &tet.map(at)));
        }
        for rows in FaceTable::new(&mesh.tets).faces() {
            for row in rows {
                let other = rows.iter().any(|r| {
                    r.tet != row.tet
                        && mesh.tet_body[r.tet as usize] == mesh.tet_body[row.tet as usize]
                });
                if !other && let Some(sum) = bodies.get_mut(body_of(mesh, row.tet)) {
                    sum[SURFACE] += norm(area_vector(&row.key.map(at)));
                }
            }
        }
        let mut faces = BTreeMap::new();
        for face in &mesh.faces {
            for triangle in &face.triangles {
                let corners = triangle.map(at);
                add(&mut faces, &face.name, &moments(norm(area_vector(&corners)), &corners));
            }
        }
        Self { corner: lo, diagonal: unit, bodies, faces }
    }

    /// The body, or the face that both have, whose shape differs.
    pub fn difference(&self, other: &Self) -> Option<String> {
        let moved = norm(sub(self.corner, other.corner));
        let larger = (self.diagonal - other.diagonal).abs();
        let allowed = SAME * self.diagonal;
        // NaN never agrees
        let agree = moved <= allowed && larger <= allowed;
        if !agree {
            return Some("the box around the nodes".into());
        }
        if !self.bodies.keys().eq(other.bodies.keys()) {
            return Some("the set of bodies".into());
        }
        let kinds =
            [("the body", &self.bodies, &other.bodies), ("the face", &self.faces, &other.faces)];
        kinds.into_iter().find_map(|(kind, a, b)| {
            let differs = |name: &&String| b.get(*name).is_some_and(|b| !same(&a[*name], b));
            a.keys().find(differs).map(|name| format!("{kind} {name}"))
        })
    }
}

/// Place of the surface of a body in its integrals; faces have zero there.
const SURFACE: usize = 10;

/// Size, first and second moments of a simplex, and a place for its surface.
fn moments<const N: usize>(size: f64, corners: &[V3; N]) -> Vec<f64> {
    let sum: V3 = std::array::from_fn(|d| corners.iter().map(|x| x[d]).sum());
    let n = N as f64;
    let mut out = vec![size];
    out.extend(sum.map(|s| size * s / n));
    for (i, j) in [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)] {
        let squares: f64 = corners.iter().map(|x| x[i] * x[j]).sum();
        out.push(size * (squares + sum[i] * sum[j]) / (n * (n + 1.0)));
    }
    out.push(0.0);
    out
}

fn add(into: &mut BTreeMap<String, Vec<f64>>, name: &str, more: &[f64]) {
    match into.get_mut(name) {
        Some(sum) => sum.iter_mut().zip(more).for_each(|(s, m)| *s += m),
        None => _ = into.insert(name.into(), more.to_vec()),
    }
}

/// Integrals that agree, relative to the size of the body or face; NaN never agrees.
fn same(a: &[f64], b: &[f64]) -> bool {
    let size = a[0].max(a[SURFACE]);
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME * size)
}

fn body_of(mesh: &TetMesh, tet: u32) -> &str {
    &mesh.bodies[mesh.tet_body[tet as usize] as usize]
}

fn box_around(nodes: &[V3]) -> (V3, V3) {
    nodes.iter().fold(([f64::MAX; 3], [f64::MIN; 3]), |(lo, hi), x| {
        (std::array::from_fn(|d| lo[d].min(x[d])), std::array::from_fn(|d| hi[d].max(x[d])))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::bisect;

    fn mesh() -> TetMesh {
        let path =
            concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data/paper_quarter_9k/mesh.msh");
        crate::mesh::msh::read(std::path::Path::new(path)).expect("reads")
    }

    /// Bisection keeps the shape; a node moved by a thousandth of the joint does not, nor does a
    /// face that is called otherwise.
    #[test]
    fn only_meshes_of_one_polyhedron_have_one_shape() {
        let given = mesh();
        let shape = Shape::of(&given);
        let finer = bisect::refine(&given, &vec![2.0; given.tets.len()]).mesh;
        assert!(finer.tets.len() > given.tets.len());
        assert_eq!(shape.difference(&Shape::of(&finer)), None);

        let mut moved = given.clone();
        let (lo, hi) = box_around(&given.nodes);
        let corner =
            moved.nodes.iter_mut().find(|x| x[2] == hi[2]).expect("there is a highest node");
        corner[2] -= 1e-3 * norm(sub(hi, lo));
        let found = shape.difference(&Shape::of(&moved)).expect("differs");
        assert!(found.starts_with("the body "), "{found}");

        for (factor, step) in [(2.0, 0.0), (1.0, 5.0)] {
            let mut other = given.clone();
            other.nodes.iter_mut().flatten().for_each(|x| *x = factor * *x + step);
            let found = shape.difference(&Shape::of(&other)).expect("differs");
            assert_eq!(found, "the box around the nodes");
        }

        let mut renamed = given.clone();
        let names: Vec<String> = given.faces.iter().map(|f| f.name.clone()).collect();
        renamed.faces[0].name = names[1].clone();
        renamed.faces[1].name = names[0].clone();
        let found = shape.difference(&Shape::of(&renamed)).expect("differs");
        assert!(found.starts_with("the face "), "{found}");
    }

    /// Volume, centroid and second moments of a box about a corner.
    #[test]
    fn moments_of_a_tetrahedron_are_exact() {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let m = moments(1.0 / 6.0, &corners);
        let exact = [1.0 / 6.0, 1.0 / 24.0, 1.0 / 24.0, 1.0 / 24.0, 1.0 / 60.0];
        exact.iter().zip(&m).for_each(|(e, m)| assert!((e - m).abs() < 1e-15));
        assert!((m[7] - 1.0 / 120.0).abs() < 1e-15);
    }
}
