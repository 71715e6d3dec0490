//! Target element sizes at the nodes of a mesh. They are computed from target subdivisions of its
//! tets, graded, and written as a view for gmsh.

use super::TetMesh;
use super::tet::EDGES;
use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::fmt::Write;

/// Largest change of the target size along an edge, divided by the length of the edge.
pub const GRADING: f64 = 0.4;

/// Number of tetrahedra in a gmsh mesh (HXT) divided by the number of regular tetrahedra of the
/// target size that fill its volume; measured: 0.66 to 0.77.
pub const FILLING: f64 = 0.71;

/// Edge \[mm\] of the regular tetrahedron of volume `v` \[mm³\].
pub fn regular_edge(v: f64) -> f64 {
    (6.0 * std::f64::consts::SQRT_2 * v).cbrt()
}

/// Target sizes at the nodes of a mesh whose bodies share nodes. A size is the edge of a regular
/// tetrahedron \[mm\].
#[derive(Clone, Debug, PartialEq)]
pub struct SizeField {
    /// Size at each node \[mm\].
    pub sizes: Vec<f64>,
}

/// A node in the queue; the smallest size comes first.
#[derive(PartialEq)]
struct Visit(f64, u32);

impl Eq for Visit {}

impl PartialOrd for Visit {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Visit {
    fn cmp(&self, other: &Self) -> Ordering {
        other.0.total_cmp(&self.0).then(other.1.cmp(&self.1))
    }
}

/// The edges of a mesh by node.
#[derive(Clone, Debug)]
pub struct Edges {
    /// Start of the neighbours of each node: node `n` has `neighbours[start[n]..start[n + 1]]`.
    start: Vec<u32>,
    neighbours: Vec<(u32, f64)>,
}

impl Edges {
    /// Collects the edges of a mesh with their lengths \[mm\].
    pub fn new(mesh: &TetMesh) -> Self {
        let mut pairs: Vec<[u32; 2]> = mesh
            .tets
            .iter()
            .flat_map(|t| EDGES.map(|[a, b]| [t[a], t[b]]))
            .flat_map(|[a, b]| [[a, b], [b, a]])
            .collect();
        pairs.sort_unstable();
        pairs.dedup();
        let mut start = vec![0u32; mesh.nodes.len() + 1];
        pairs.iter().for_each(|[a, _]| start[*a as usize + 1] += 1);
        (0..mesh.nodes.len()).for_each(|n| start[n + 1] += start[n]);
        let length = |a: u32, b: u32| {
            let (a, b) = (mesh.nodes[a as usize], mesh.nodes[b as usize]);
            bracket_base::math::vec3::norm(bracket_base::math::vec3::sub(a, b))
        };
        Self { start, neighbours: pairs.into_iter().map(|[a, b]| (b, length(a, b))).collect() }
    }

    fn of(&self, n: u32) -> &[(u32, f64)] {
        &self.neighbours[self.start[n as usize] as usize..self.start[n as usize + 1] as usize]
    }
}

impl SizeField {
    /// Sizes that split each tet into `wanted` parts (fractions allowed). The densities are
    /// averaged at the nodes, which keeps the total count; the sizes are then graded.
    pub fn new(mesh: &TetMesh, edges: &Edges, wanted: &[f64]) -> Self {
        let mut density = vec![(0.0, 0.0); mesh.nodes.len()];
        for (e, (t, n)) in mesh.tets.iter().zip(wanted).enumerate() {
            let v = mesh.volume(e);
            t.iter().for_each(|i| {
                let d = &mut density[*i as usize];
                *d = (d.0 + n, d.1 + v);
            });
        }
        // parts per volume → volume of one part → edge
        let sizes = density
            .iter()
            .map(|(n, v)| if *n > 0.0 { regular_edge(v / n) } else { f64::INFINITY })
            .collect();
        let mut field = Self { sizes };
        field.grade(edges);
        field
    }

    /// Reduces sizes that grow faster than [`GRADING`] along edges.
    fn grade(&mut self, edges: &Edges) {
        let sizes = &mut self.sizes;
        let mut queue: BinaryHeap<Visit> =
            (0..sizes.len() as u32).map(|n| Visit(sizes[n as usize], n)).collect();
        while let Some(Visit(size, n)) = queue.pop() {
            if size > sizes[n as usize] {
                continue;
            }
            for &(m, length) in edges.of(n) {
                let most = size + GRADING * length;
                if sizes[m as usize] > most {
                    sizes[m as usize] = most;
                    queue.push(Visit(most, m));
                }
            }
        }
    }

    /// Number of parts into which the sizes split each tet.
    pub fn parts(&self, mesh: &TetMesh) -> Vec<f64> {
        let one = |e: usize, t: &[u32; 4]| {
            let mean: f64 = t.iter().map(|n| 0.25 * self.sizes[*n as usize].powi(-3)).sum();
            6.0 * std::f64::consts::SQRT_2 * mesh.volume(e) * mean
        };
        mesh.tets.iter().enumerate().map(|(e, t)| one(e, t)).collect()
    }

    /// The sizes times `scale` as a gmsh view: a scalar field on each tet.
    pub fn view(&self, mesh: &TetMesh, scale: f64) -> String {
        let mut text = String::with_capacity(160 * mesh.tets.len());
        text.push_str("View \"size\" {\n");
        for t in &mesh.tets {
            text.push_str("SS(");
            for (i, n) in t.iter().enumerate() {
                let [x, y, z] = mesh.nodes[*n as usize];
                let comma = if i > 0 { "," } else { "" };
                // writing to a String cannot fail
                let _ = write!(text, "{comma}{x},{y},{z}");
            }
            text.push_str("){");
            for (i, n) in t.iter().enumerate() {
                let comma = if i > 0 { "," } else { "" };
                let _ = write!(text, "{comma}{:.6e}", scale * self.sizes[*n as usize]);
            }
            text.push_str("};\n");
        }
        text.push_str("};\n");
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::fixtures::cubes;

    /// `regular_edge` inverts the volume of a regular tetrahedron, and a uniform number of parts is
    /// reproduced.
    #[test]
    fn counts_are_kept() {
        let v = 1.0 / (6.0 * std::f64::consts::SQRT_2);
        assert!((regular_edge(v) - 1.0).abs() < 1e-15);
        let cells: Vec<_> = (0..64).map(|i| ([i % 4, i / 4 % 4, i / 16], "B")).collect();
        let mesh = cubes(&cells);
        let edges = Edges::new(&mesh);
        let field = SizeField::new(&mesh, &edges, &vec![3.0; mesh.tets.len()]);
        for p in field.parts(&mesh) {
            assert!((p - 3.0).abs() < 1e-12, "{p}");
        }
        assert_eq!(field.view(&mesh, 1.0).matches("SS(").count(), mesh.tets.len());
    }

    /// With one tet to be split into very many parts, the sizes grow from it no faster than allowed
    /// and nowhere exceed the target.
    #[test]
    fn sizes_are_graded() {
        let cells: Vec<_> = (0..216).map(|i| ([i % 6, i / 6 % 6, i / 36], "B")).collect();
        let mesh = cubes(&cells);
        let edges = Edges::new(&mesh);
        let mut wanted = vec![1.0; mesh.tets.len()];
        wanted[0] = 1e6;
        let field = SizeField::new(&mesh, &edges, &wanted);
        let mut steep = 0;
        for n in 0..mesh.nodes.len() as u32 {
            for &(m, length) in edges.of(n) {
                let rise = field.sizes[m as usize] - field.sizes[n as usize];
                assert!(rise <= GRADING * length * (1.0 + 1e-12));
                steep += usize::from(rise > 0.9 * GRADING * length);
            }
        }
        assert!(steep > 0);
        let plain = SizeField::new(&mesh, &edges, &vec![1.0; mesh.tets.len()]);
        assert!(field.sizes.iter().zip(&plain.sizes).all(|(a, b)| a <= &(b * (1.0 + 1e-12))));
        assert!(field.parts(&mesh).iter().sum::<f64>() > mesh.tets.len() as f64);
    }
}
