//! Conforming refinement by bisection of longest edges. All tets around an edge are halved
//! together. So there are no hanging nodes, bodies keep their shared faces, and plane faces stay
//! plane.
//!
//! The refinement of a tet walks to ever longer edges until an edge is the longest of all tets
//! around it; that edge is halved. Edges are ordered by length, then by their nodes, so the walk
//! ends.
//!
//! # Source
//! Rivara, New longest-edge algorithms for the refinement and/or improvement of unstructured
//! triangulations, IJNME 40 (1997).

use super::TetMesh;
use super::tet::{EDGES, signed_volume};
use std::collections::HashMap;

/// A refined mesh and the origin of its tets.
#[derive(Clone, Debug, PartialEq)]
pub struct Refined {
    /// The mesh; bodies, names and sharing of nodes are unchanged.
    pub mesh: TetMesh,
    /// The tet of the old mesh that contains each tet of the new mesh.
    pub parent: Vec<u32>,
}

impl Refined {
    /// Number of parts into which each of the `old` tets was split.
    pub fn parts(&self, old: usize) -> Vec<f64> {
        let mut parts = vec![0.0; old];
        self.parent.iter().for_each(|p| parts[*p as usize] += 1.0);
        parts
    }
}

type Edge = [u32; 2];

/// A triangle of a named face.
struct Triangle {
    face: u32,
    nodes: [u32; 3],
}

struct Bisection {
    mesh: TetMesh,
    parent: Vec<u32>,
    triangles: Vec<Triangle>,
    tets_at: HashMap<Edge, Vec<u32>>,
    triangles_at: HashMap<Edge, Vec<u32>>,
}

fn edge(a: u32, b: u32) -> Edge {
    if a < b { [a, b] } else { [b, a] }
}

/// Splits each tet of a mesh whose bodies share nodes into about `wanted` parts. The number is
/// rounded to the nearest power of two, and is larger where conformity requires it. Values below √2
/// leave a tet unchanged: the mesh is never coarsened.
pub fn refine(mesh: &TetMesh, wanted: &[f64]) -> Refined {
    let goals: Vec<f64> = wanted
        .iter()
        .enumerate()
        .map(|(e, n)| mesh.volume(e) / n * std::f64::consts::SQRT_2)
        .collect();
    let mut b = Bisection::new(mesh);
    let mut t = 0;
    // new tets are appended and checked later in the same loop
    while t < b.mesh.tets.len() {
        while signed_volume(&b.mesh.corners(t)) > goals[b.parent[t] as usize] {
            b.halve_for(t as u32);
        }
        t += 1;
    }
    b.finish()
}

impl Bisection {
    fn new(mesh: &TetMesh) -> Self {
        let mut tets_at: HashMap<Edge, Vec<u32>> = HashMap::with_capacity(2 * mesh.tets.len());
        for (e, t) in mesh.tets.iter().enumerate() {
            EDGES
                .iter()
                .for_each(|[a, b]| tets_at.entry(edge(t[*a], t[*b])).or_default().push(e as u32));
        }
        let mut triangles = Vec::new();
        for (face, named) in mesh.faces.iter().enumerate() {
            triangles
                .extend(named.triangles.iter().map(|t| Triangle { face: face as u32, nodes: *t }));
        }
        let mut triangles_at: HashMap<Edge, Vec<u32>> = HashMap::with_capacity(3 * triangles.len());
        for (i, t) in triangles.iter().enumerate() {
            sides(t.nodes)
                .into_iter()
                .for_each(|s| triangles_at.entry(s).or_default().push(i as u32));
        }
        let parent = (0..mesh.tets.len() as u32).collect();
        Self { mesh: mesh.clone(), parent, triangles, tets_at, triangles_at }
    }

    /// Sort key of an edge: squared length, then nodes.
    fn rank(&self, e: Edge) -> (f64, Edge) {
        let [a, b] = e.map(|n| self.mesh.nodes[n as usize]);
        ((0..3).map(|d| (a[d] - b[d]) * (a[d] - b[d])).sum(), e)
    }

    fn longest(&self, t: u32) -> Edge {
        let nodes = self.mesh.tets[t as usize];
        let first = edge(nodes[0], nodes[1]);
        EDGES
            .iter()
            .map(|[a, b]| edge(nodes[*a], nodes[*b]))
            .fold(first, |m, e| if self.longer(e, m) { e } else { m })
    }

    fn longer(&self, a: Edge, b: Edge) -> bool {
        let (a, b) = (self.rank(a), self.rank(b));
        a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).is_gt()
    }

    /// Halves the last edge of the walk from tet `t` to ever longer edges. Repeated calls end with
    /// the longest edge of `t` itself.
    fn halve_for(&mut self, t: u32) {
        let mut e = self.longest(t);
        loop {
            let around = self.tets_at.get(&e).map_or(&[][..], |a| a);
            match around.iter().map(|t| self.longest(*t)).find(|other| self.longer(*other, e)) {
                Some(longer) => e = longer,
                None => return self.halve(e),
            }
        }
    }

    fn halve(&mut self, e: Edge) {
        let [a, b] = e;
        let m = self.mesh.nodes.len() as u32;
        let (x, y) = (self.mesh.nodes[a as usize], self.mesh.nodes[b as usize]);
        // equal coordinates stay equal: nodes in a coordinate plane stay there exactly
        self.mesh.nodes.push(std::array::from_fn(|d| 0.5 * (x[d] + y[d])));
        for t in self.tets_at.remove(&e).unwrap_or_default() {
            let nodes = self.mesh.tets[t as usize];
            let new = self.mesh.tets.len() as u32;
            let with = |old: u32| nodes.map(|n| if n == old { m } else { n });
            self.mesh.tets[t as usize] = with(b);
            self.mesh.tets.push(with(a));
            self.mesh.tet_body.push(self.mesh.tet_body[t as usize]);
            if let Some(region) = self.mesh.tet_region.get(t as usize).copied() {
                self.mesh.tet_region.push(region);
            }
            self.parent.push(self.parent[t as usize]);
            let others: Vec<u32> = nodes.into_iter().filter(|n| *n != a && *n != b).collect();
            for &c in &others {
                rename(&mut self.tets_at, edge(b, c), t, new);
                self.tets_at.entry(edge(m, c)).or_default().extend([t, new]);
            }
            if let [c, d] = others[..] {
                self.tets_at.entry(edge(c, d)).or_default().push(new);
            }
            self.tets_at.entry(edge(m, a)).or_default().push(t);
            self.tets_at.entry(edge(m, b)).or_default().push(new);
        }
        for t in self.triangles_at.remove(&e).unwrap_or_default() {
            let Triangle { face, nodes } = self.triangles[t as usize];
            let new = self.triangles.len() as u32;
            let with = |old: u32| nodes.map(|n| if n == old { m } else { n });
            self.triangles[t as usize].nodes = with(b);
            self.triangles.push(Triangle { face, nodes: with(a) });
            for c in nodes.into_iter().filter(|n| *n != a && *n != b) {
                rename(&mut self.triangles_at, edge(b, c), t, new);
                self.triangles_at.entry(edge(m, c)).or_default().extend([t, new]);
            }
            self.triangles_at.entry(edge(m, a)).or_default().push(t);
            self.triangles_at.entry(edge(m, b)).or_default().push(new);
        }
    }

    fn finish(self) -> Refined {
        let mut mesh = self.mesh;
        mesh.faces.iter_mut().for_each(|f| f.triangles.clear());
        for t in &self.triangles {
            mesh.faces[t.face as usize].triangles.push(t.nodes);
        }
        Refined { mesh, parent: self.parent }
    }
}

fn sides([a, b, c]: [u32; 3]) -> [Edge; 3] {
    [edge(a, b), edge(b, c), edge(c, a)]
}

/// Replaces `old` by `new` in the list of an edge.
fn rename(at: &mut HashMap<Edge, Vec<u32>>, e: Edge, old: u32, new: u32) {
    for t in at.get_mut(&e).into_iter().flatten().filter(|t| **t == old) {
        *t = new;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::fixtures::{cubes, name};
    use crate::mesh::quality;
    use crate::mesh::topology::FaceTable;

    /// Two adjacent blocks, one body each, with named faces; strongly refined at one corner.
    fn refined() -> (TetMesh, Refined) {
        let cells: Vec<_> = (0..54)
            .map(|i| ([i % 6, i / 6 % 3, i / 18], if i % 6 < 3 { "A" } else { "B" }))
            .collect();
        let mut mesh = cubes(&cells);
        name(&mut mesh, "BASE", |x| x[2] == 0.0);
        name(&mut mesh, "BETWEEN", |x| x[0] == 30.0);
        let corner = |e: usize| mesh.corners(e).contains(&[30.0, 0.0, 0.0]);
        let wanted: Vec<f64> =
            (0..mesh.tets.len()).map(|e| if corner(e) { 300.0 } else { 1.0 }).collect();
        let refined = refine(&mesh, &wanted);
        (mesh, refined)
    }

    /// There is no hanging node: every face has one or two owners, and faces with one owner lie on
    /// the hull. Volumes of bodies and areas of named faces are unchanged, and every named triangle
    /// is a face of the mesh.
    #[test]
    fn stays_conformal() {
        let (old, Refined { mesh, parent }) = refined();
        assert!(mesh.tets.len() > old.tets.len() + 500, "{}", mesh.tets.len());
        let table = FaceTable::new(&mesh.tets);
        let size = [60.0, 30.0, 30.0];
        for owners in table.faces() {
            let x = owners[0].key.map(|n| mesh.nodes[n as usize]);
            let on_hull =
                (0..3).any(|d| [0.0, size[d]].iter().any(|c| x.iter().all(|x| x[d] == *c)));
            assert_eq!(owners.len(), if on_hull { 1 } else { 2 }, "{x:?}");
        }
        let volume = |m: &TetMesh, body: u32| -> f64 {
            (0..m.tets.len()).filter(|e| m.tet_body[*e] == body).map(|e| m.volume(e)).sum()
        };
        for body in 0..2 {
            assert!((volume(&mesh, body) / 27_000.0 - 1.0).abs() < 1e-12);
        }
        for (e, p) in parent.iter().enumerate() {
            assert!(mesh.volume(e) > 0.0 && mesh.tet_body[e] == old.tet_body[*p as usize]);
        }
        for (face, area) in mesh.faces.iter().zip([1800.0, 900.0]) {
            let sum: f64 = face
                .triangles
                .iter()
                .map(|t| {
                    assert!(!table.owners(*t).is_empty());
                    bracket_base::math::vec3::norm(bracket_base::math::vec3::area_vector(
                        &t.map(|n| mesh.nodes[n as usize]),
                    ))
                })
                .sum();
            assert!((sum / area - 1.0).abs() < 1e-12, "{} {sum}", face.name);
        }
    }

    /// The wanted number of parts is reached, tets far away are unchanged, and the smallest angle
    /// stays above half of its old value.
    #[test]
    fn refines_where_wanted() {
        let (old, refined) = refined();
        let parts = refined.parts(old.tets.len());
        let corner = |e: usize| old.corners(e).contains(&[30.0, 0.0, 0.0]);
        for (e, n) in parts.iter().enumerate().filter(|(e, _)| corner(*e)) {
            assert!(*n >= 300.0 / std::f64::consts::SQRT_2, "tet {e}: {n}");
        }
        assert!(parts.iter().filter(|n| **n == 1.0).count() > old.tets.len() / 4);
        let worst = |m: &TetMesh| {
            quality::table(m).iter().map(|q| q.worst_dihedral).fold(f64::INFINITY, f64::min)
        };
        assert!(
            worst(&refined.mesh) > 0.5 * worst(&old),
            "{} {}",
            worst(&refined.mesh),
            worst(&old)
        );
        // targets below √2 change nothing
        assert_eq!(refine(&old, &vec![1.4; old.tets.len()]).mesh, old);
    }
}
