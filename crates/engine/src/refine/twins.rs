//! Bodies that are mirror images of each other in the plane of a contact: both plates of a splice.
//! Each holds the lower bound down, but the mechanism of the last mesh shows one of them, so a mesh
//! that follows it alone refines the one and is limited by the other. They get equal metrics.

use crate::mesh::TetMesh;
use crate::mesh::nearest::Nearest;
use crate::mesh::polyhedron::Polyhedron;
use crate::refine::metric::{Metric, congruent, meet};
use bracket_base::math::mandel::Mandel;
use bracket_base::math::vec3::{M3, V3, along, dot, norm, sub};
use std::collections::{BTreeMap, BTreeSet};

/// A plane and the bodies that it maps onto a body.
#[derive(Clone, Debug, PartialEq)]
struct Mirror {
    point: V3,
    normal: V3,
    /// For each body whether its mirror image is a body, itself or another.
    maps: Vec<bool>,
}

impl Mirror {
    fn image(&self, x: V3) -> V3 {
        along(x, -2.0 * dot(self.normal, sub(x, self.point)), self.normal)
    }

    fn of_tensor(&self, m: &Mandel) -> Mandel {
        let n = self.normal;
        let flip: M3 = std::array::from_fn(|i| {
            std::array::from_fn(|j| f64::from(u8::from(i == j)) - 2.0 * n[i] * n[j])
        });
        congruent(&flip, m)
    }
}

/// The mirror planes of a body of parts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Twins {
    mirrors: Vec<Mirror>,
}

/// Corners of a body \[mm\].
type Corners = Vec<V3>;

impl Twins {
    /// Finds them in a mesh whose bodies share nodes, with its polyhedron.
    pub fn new(mesh: &TetMesh, p: &Polyhedron) -> Self {
        let corners = corners_of_bodies(mesh, p);
        let near = 1e3 * p.tolerance;
        let mut mirrors: Vec<Mirror> = Vec::new();
        let mut tried: Vec<(V3, V3)> = Vec::new();
        for facet in &p.facets {
            let [Some(a), Some(b)] = facet.sides.map(|s| s.map(|s| p.body[s as usize] as usize))
            else {
                continue;
            };
            let same = |(point, normal): &(V3, V3)| {
                dot(*normal, facet.normal).abs() > 1.0 - 1e-9
                    && dot(*normal, sub(facet.point, *point)).abs() < near
            };
            if a == b || tried.iter().any(same) {
                continue;
            }
            let mut mirror = Mirror { point: facet.point, normal: facet.normal, maps: Vec::new() };
            if !is_image(&mirror, &corners[a], &corners[b], near) {
                continue;
            }
            tried.push((facet.point, facet.normal));
            let maps = |a: &Corners| corners.iter().any(|b| is_image(&mirror, a, b, near));
            mirror.maps = corners.iter().map(maps).collect();
            mirrors.push(mirror);
        }
        Self { mirrors }
    }

    /// The nodes of a mesh of the same bodies with their mirror images.
    pub fn on(&self, mesh: &TetMesh) -> Images {
        let nearest = Nearest::new(mesh.nodes.clone());
        let of = |mirror: &Mirror| {
            let mut maps = vec![false; mesh.nodes.len()];
            for (t, body) in mesh.tets.iter().zip(&mesh.tet_body) {
                if mirror.maps[*body as usize] {
                    t.iter().for_each(|n| maps[*n as usize] = true);
                }
            }
            let image = |n: usize| Some([n, nearest.to(mirror.image(mesh.nodes[n]))?]);
            (0..maps.len()).filter(|n| maps[*n]).filter_map(image).collect()
        };
        Images { of_mirrors: self.mirrors.iter().map(|m| (m.clone(), of(m))).collect() }
    }
}

/// For each mirror the nodes of a mesh that it maps, each with the node nearest to its image.
#[derive(Clone, Debug, PartialEq)]
pub struct Images {
    of_mirrors: Vec<(Mirror, Vec<[usize; 2]>)>,
}

impl Images {
    /// Makes a metric at the nodes of the mesh nowhere coarser than its mirror image.
    pub fn even(&self, metric: &mut Metric) {
        for (mirror, images) in &self.of_mirrors {
            let before = metric.tensors.clone();
            for [n, image] in images {
                metric.tensors[*n] = meet(&before[*n], &mirror.of_tensor(&before[*image]));
            }
        }
    }
}

/// The corners of the polyhedron that belong to each body.
fn corners_of_bodies(mesh: &TetMesh, p: &Polyhedron) -> Vec<Corners> {
    let is_corner: BTreeSet<u32> = p.corners.iter().copied().collect();
    let mut of_body: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    for (t, body) in mesh.tets.iter().zip(&mesh.tet_body) {
        let corners = t.iter().filter(|n| is_corner.contains(n));
        of_body.entry(*body).or_default().extend(corners);
    }
    let at = |body: u32| {
        let corners = of_body.get(&body).into_iter().flatten();
        corners.map(|n| mesh.nodes[*n as usize]).collect()
    };
    (0..mesh.bodies.len() as u32).map(at).collect()
}

/// True if the mirror maps the corners of one body onto those of the other.
fn is_image(mirror: &Mirror, a: &Corners, b: &Corners, near: f64) -> bool {
    if a.len() != b.len() || a.is_empty() {
        return false;
    }
    let nearest = Nearest::new(b.clone());
    a.iter()
        .map(|x| mirror.image(*x))
        .all(|image| nearest.to(image).is_some_and(|n| norm(sub(b[n], image)) < near))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::fixtures::cubes;
    use bracket_base::math::eigen::compose;

    const AXES: [V3; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    /// Two equal plates on each other are twins, a plate and a longer one are not. A fine place in
    /// one plate is as fine in the other, with mirrored directions.
    #[test]
    fn two_plates() {
        let plate = |name: &'static str, k: i32, length: i32| {
            (0..3 * length).map(move |i| ([i % length, i / length, k], name))
        };
        let pair =
            |length: i32| cubes(&plate("A", 0, 4).chain(plate("B", 1, length)).collect::<Vec<_>>());
        let of = |mesh: &TetMesh| Twins::new(mesh, &Polyhedron::new(mesh));
        assert!(of(&pair(5)).mirrors.is_empty());
        let mesh = pair(4);
        let twins = of(&mesh);
        assert_eq!(twins.mirrors.len(), 1);
        assert_eq!(twins.mirrors[0].maps, [true, true]);
        let slanted = [[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [-0.6, 0.0, 0.8]];
        let (fine, even) = (compose([4.0, 1.0, 1.0], &slanted), compose([1.0; 3], &AXES));
        let at = |x: V3| mesh.nodes.iter().position(|n| norm(sub(*n, x)) < 1e-9).expect("a node");
        let mut metric = Metric { tensors: vec![even; mesh.nodes.len()] };
        metric.tensors[at([10.0, 10.0, 0.0])] = fine;
        twins.on(&mesh).even(&mut metric);
        let mirrored = [[0.8, 0.0, -0.6], [0.0, 1.0, 0.0], [0.6, 0.0, 0.8]];
        let want = compose([4.0, 1.0, 1.0], &mirrored);
        let found = metric.tensors[at([10.0, 10.0, 20.0])];
        assert!(found.iter().zip(want).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?}");
        let kept = metric.tensors[at([10.0, 10.0, 0.0])];
        assert!(kept.iter().zip(fine).all(|(a, b)| (a - b).abs() < 1e-9), "{kept:?}");
        assert_eq!(metric.tensors.iter().filter(|m| (m[0] - 1.0).abs() > 1e-9).count(), 2);
    }
}
