//! A model on a mesh twice as fine, with the fields of the coarse one: every tet is cut into eight.

use crate::certify::fields::{DisplacementField, StressField};
use crate::elements::space::Tet10Space;
use crate::elements::super_element::PointStress;
use crate::elements::tet10;
use crate::mesh::TetMesh;
use crate::mesh::tet::{EDGES, FACES};
use crate::model::AnalysisModel;
use crate::model::analysis::{BoundaryFace, FacePair};
use bracket_base::math::mandel::Mandel;
use bracket_base::math::vec3::{self, V3};
use std::sync::Arc;

/// Corners of the four tets at the vertices, as nodes of the 10-node tet.
const AT_VERTICES: [[usize; 4]; 4] = [[0, 4, 6, 7], [4, 1, 5, 8], [6, 5, 2, 9], [7, 8, 9, 3]];

/// The octahedron inside by each of its diagonals: the ends of the diagonal, and the ring of nodes
/// around it.
const DIAGONALS: [([usize; 2], [usize; 4]); 3] =
    [([4, 9], [5, 6, 7, 8]), ([5, 7], [4, 6, 9, 8]), ([6, 8], [4, 5, 9, 7])];

/// A model with the fields of an elastic or elastoplastic analysis.
#[derive(Clone, Debug)]
pub struct Refined {
    /// The model.
    pub model: AnalysisModel,
    /// The displacements of the coarse mesh: the same function.
    pub displacement: DisplacementField,
    /// The stress of the coarse mesh: the same function, except in subtets that a face between two
    /// subtets of the coarse mesh crosses; these have that of the coarse subtet at their middle.
    pub stress: StressField,
}

/// The model and its fields on the mesh with eight tets for each one. The nodes of the finer mesh
/// are those of [`Tet10Space`], in its order.
pub fn refined(
    model: &AnalysisModel,
    displacement: &DisplacementField,
    stress: &StressField,
) -> Refined {
    let coarse = Coarse::new(&model.mesh);
    let mesh = coarse.mesh(&model.mesh);
    let displacement = coarse.displacement(&model.mesh, &mesh, displacement);
    let stress = coarse.stress(&model.mesh, &mesh, stress);
    Refined { model: coarse.model(model, mesh), displacement, stress }
}

/// The coarse mesh with its nodes.
struct Coarse {
    space: Tet10Space,
    /// Diagonal of the octahedron in each tet.
    diagonal: Vec<usize>,
}

/// Number of tets in place of one.
const CHILDREN: usize = 8;

impl Coarse {
    fn new(mesh: &TetMesh) -> Self {
        let space = Tet10Space::new(mesh);
        let diagonal = (0..mesh.tets.len()).map(|e| {
            let x = space.tet(mesh, e).map(|n| space.nodes[n]);
            let length = |d: usize| {
                let [a, b] = DIAGONALS[d].0;
                vec3::norm(vec3::sub(x[b], x[a]))
            };
            // the shortest diagonal gives the best tets
            [1, 2].into_iter().fold(0, |best, d| if length(d) < length(best) { d } else { best })
        });
        let diagonal = diagonal.collect();
        Self { space, diagonal }
    }

    /// The eight tets of a tet by its ten nodes, of positive volume.
    fn children(&self, e: usize) -> [[usize; 4]; CHILDREN] {
        let ([a, b], ring) = DIAGONALS[self.diagonal[e]];
        std::array::from_fn(|i| {
            if i < 4 {
                return AT_VERTICES[i];
            }
            let j = i - 4;
            let [c, d] = [ring[j], ring[(j + 1) % 4]];
            if oriented([a, b, c, d]) { [a, b, c, d] } else { [b, a, c, d] }
        })
    }

    fn mesh(&self, mesh: &TetMesh) -> TetMesh {
        let each = |of: &[u32]| of.iter().flat_map(|x| [*x; CHILDREN]).collect();
        let mut out = TetMesh {
            nodes: self.space.nodes.clone(),
            tets: Vec::with_capacity(CHILDREN * mesh.tets.len()),
            tet_body: each(&mesh.tet_body),
            tet_region: each(&mesh.tet_region),
            bodies: mesh.bodies.clone(),
            faces: Vec::new(),
        };
        for e in 0..mesh.tets.len() {
            let nodes = self.space.tet(mesh, e);
            out.tets.extend(self.children(e).map(|c| c.map(|i| nodes[i] as u32)));
        }
        out
    }

    fn displacement(
        &self,
        mesh: &TetMesh,
        fine: &TetMesh,
        field: &DisplacementField,
    ) -> DisplacementField {
        let space = Tet10Space::new(fine);
        let mut u = vec![[0.0; 3]; space.nodes.len()];
        for e in 0..mesh.tets.len() {
            let own = self.space.tet(mesh, e).map(|n| field.u[n]);
            for (i, child) in self.children(e).into_iter().enumerate() {
                let corners = child.map(barycentric);
                for (k, node) in space.tet(fine, CHILDREN * e + i).into_iter().enumerate() {
                    let place = match k.checked_sub(4) {
                        None => corners[k],
                        Some(edge) => mean(&EDGES[edge].map(|v| corners[v])),
                    };
                    let shape = tet10::shape(place);
                    u[node] =
                        (0..10).fold([0.0; 3], |s, j| vec3::add(s, vec3::scale(shape[j], own[j])));
                }
            }
        }
        DisplacementField { u }
    }

    fn stress(&self, mesh: &TetMesh, fine: &TetMesh, field: &StressField) -> StressField {
        let mut points = Vec::with_capacity(fine.tets.len());
        for e in 0..mesh.tets.len() {
            for child in self.children(e) {
                let corners = child.map(barycentric);
                let middle = mean(&corners);
                points.push(std::array::from_fn(|k| {
                    let face = FACES[k].map(|v| corners[v]);
                    let own = [face[0], face[1], face[2], middle];
                    let of = subtet(&mean(&own));
                    own.map(|place| in_subtet(&field.points[e], of, &place))
                }));
            }
        }
        StressField { points }
    }

    fn model(&self, model: &AnalysisModel, mesh: TetMesh) -> AnalysisModel {
        let mut out = model.clone();
        out.tet_part = model.tet_part.iter().flat_map(|p| [*p; CHILDREN]).collect();
        let faces = |of: &[BoundaryFace]| -> Vec<BoundaryFace> {
            of.iter().flat_map(|f| self.face(&model.mesh, &mesh, f)).collect()
        };
        let pairs = |of: &[FacePair]| -> Vec<FacePair> {
            of.iter().flat_map(|f| self.pair(&mesh, f)).collect()
        };
        out.interfaces.iter_mut().for_each(|i| i.faces = pairs(&i.faces));
        out.welds.iter_mut().for_each(|w| w.faces = pairs(&w.faces));
        out.ties.iter_mut().for_each(|t| t.faces = pairs(&t.faces));
        out.preload.iter_mut().for_each(|p| p.faces = pairs(&p.faces));
        out.cuts.iter_mut().for_each(|c| c.faces = pairs(&c.faces));
        out.ground.iter_mut().for_each(|g| g.faces = faces(&g.faces));
        out.supports.iter_mut().for_each(|s| s.faces = faces(&s.faces));
        out.rigid.iter_mut().for_each(|r| r.faces = faces(&r.faces));
        out.surface_loads.iter_mut().for_each(|l| l.faces = faces(&l.faces));
        out.mesh = Arc::new(mesh);
        out
    }

    /// The four triangles of a triangle, by its vertices.
    fn triangles(&self, vertices: [u32; 3]) -> [[u32; 3]; 4] {
        let n = self.space.triangle(vertices).map(|n| n as u32);
        [[n[0], n[3], n[5]], [n[3], n[1], n[4]], [n[5], n[4], n[2]], [n[3], n[4], n[5]]]
    }

    /// The face of one of the children of a tet with these vertices.
    fn on_child(fine: &TetMesh, tet: u32, vertices: [u32; 3]) -> Option<BoundaryFace> {
        let first = CHILDREN * tet as usize;
        (first..first + CHILDREN).find_map(|child| {
            let own = fine.tets[child];
            let local = (0..4).find(|&k| FACES[k].iter().all(|&i| vertices.contains(&own[i])))?;
            Some(BoundaryFace { tet: child as u32, local: local as u8 })
        })
    }

    fn face(&self, mesh: &TetMesh, fine: &TetMesh, f: &BoundaryFace) -> Vec<BoundaryFace> {
        let vertices = FACES[f.local as usize].map(|i| mesh.tets[f.tet as usize][i]);
        let each = self.triangles(vertices).into_iter();
        each.filter_map(|t| Self::on_child(fine, f.tet, t)).collect()
    }

    fn pair(&self, fine: &TetMesh, f: &FacePair) -> Vec<FacePair> {
        let sides = self.triangles(f.nodes_a).into_iter().zip(self.triangles(f.nodes_b));
        let pair = |(nodes_a, nodes_b)| {
            let a = Self::on_child(fine, f.a.tet, nodes_a)?;
            let b = Self::on_child(fine, f.b.tet, nodes_b)?;
            Some(FacePair { a, b, nodes_a, nodes_b })
        };
        sides.filter_map(pair).collect()
    }
}

/// Barycentric coordinates of a node of the 10-node tet.
fn barycentric(node: usize) -> [f64; 4] {
    match node.checked_sub(4) {
        None => tet10::vertex(node),
        Some(edge) => mean(&EDGES[edge].map(tet10::vertex)),
    }
}

fn mean<const N: usize>(of: &[[f64; 4]; N]) -> [f64; 4] {
    std::array::from_fn(|k| of.iter().map(|x| x[k]).sum::<f64>() / N as f64)
}

/// Whether four nodes of the 10-node tet make a tet of positive volume.
fn oriented(nodes: [usize; 4]) -> bool {
    // the first coordinate is one less the others
    let x: [V3; 4] = nodes.map(|n| {
        let l = barycentric(n);
        [l[1], l[2], l[3]]
    });
    crate::mesh::tet::signed_volume(&x) > 0.0
}

/// The subtet of a super-element that holds a point: that of the face nearest to it.
fn subtet(l: &[f64; 4]) -> usize {
    (1..4).fold(0, |best, k| if l[k] < l[best] { k } else { best })
}

/// The stress of subtet k, continued linearly, at a point of the element.
fn in_subtet(points: &PointStress, k: usize, l: &[f64; 4]) -> Mandel {
    let own = &points[k];
    let mut out = own[3].map(|x| 4.0 * l[k] * x);
    for (p, &vertex) in FACES[k].iter().enumerate() {
        (0..6).for_each(|i| out[i] += (l[vertex] - l[k]) * own[p][i]);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::section_forces::SectionPlane;
    use crate::mesh::fixtures::{cubes, name};
    use crate::model::file::ModelFile;
    use crate::model::resolve::resolve;
    use bracket_base::yaml;
    use std::path::Path;

    const TWO: &str = "mesh: m.msh
analysis: elastic
materials: {steel: {E: 210000, nu: 0.3}}
bodies: {A: steel, B: steel}
interfaces:
  - {between: [B, A], law: contact, mu: 0, friction: associated}
supports:
  - {face: LEFT, fix: [x, y, z]}
  - {face: SIDE, fix: [y]}
  - {face: FLOOR, fix: [z]}
loads:
  - {face: RIGHT, traction: [-3, 0, 0]}
";

    fn two() -> AnalysisModel {
        let mut mesh = cubes(&[([0, 0, 0], "A"), ([1, 0, 0], "A"), ([2, 0, 0], "B")]);
        for (face, axis, at) in
            [("LEFT", 0, 0.0), ("RIGHT", 0, 30.0), ("SIDE", 1, 0.0), ("FLOOR", 2, 0.0)]
        {
            name(&mut mesh, face, |x| x[axis] == at);
        }
        let parsed = yaml::parse::<ModelFile>(TWO, Path::new("m.yaml")).expect("sound");
        resolve(&parsed.value, mesh, &|p| parsed.index.place(p)).expect("sound")
    }

    fn area(mesh: &TetMesh, faces: &[BoundaryFace]) -> f64 {
        let corners =
            |f: &BoundaryFace| FACES[f.local as usize].map(|i| mesh.corners(f.tet as usize)[i]);
        faces.iter().map(|f| vec3::norm(vec3::area_vector(&corners(f)))).sum()
    }

    /// Eight tets of positive volume for each, the same volume and faces, pairs that coincide.
    #[test]
    fn the_finer_mesh_is_the_same_body() {
        let model = two();
        let space = Tet10Space::new(&model.mesh);
        let u = DisplacementField { u: vec![[0.0; 3]; space.nodes.len()] };
        let fine = refined(&model, &u, &StressField::none(model.mesh.tets.len())).model;
        assert_eq!(fine.mesh.tets.len(), 8 * model.mesh.tets.len());
        let volume = |m: &TetMesh| (0..m.tets.len()).map(|e| m.volume(e)).sum::<f64>();
        assert!((0..fine.mesh.tets.len()).all(|e| fine.mesh.volume(e) > 0.0));
        assert!((volume(&fine.mesh) - volume(&model.mesh)).abs() < 1e-9 * volume(&model.mesh));
        for (a, b) in model.supports.iter().zip(&fine.supports) {
            assert_eq!(b.faces.len(), 4 * a.faces.len());
            assert!((area(&fine.mesh, &b.faces) - area(&model.mesh, &a.faces)).abs() < 1e-9);
        }
        let pairs = &fine.interfaces[0].faces;
        assert_eq!(pairs.len(), 4 * model.interfaces[0].faces.len());
        for p in pairs {
            let x = |nodes: [u32; 3]| nodes.map(|n| fine.mesh.nodes[n as usize]);
            assert_eq!(x(p.nodes_a), x(p.nodes_b));
            let own = |f: BoundaryFace| {
                FACES[f.local as usize].map(|i| fine.mesh.tets[f.tet as usize][i])
            };
            assert!(own(p.a).iter().all(|n| p.nodes_a.contains(n)));
            assert!(own(p.b).iter().all(|n| p.nodes_b.contains(n)));
            // the normal still points out of side A
            let out = vec3::area_vector(&x(p.nodes_a));
            assert!(vec3::dot(out, vec3::area_vector(&x(own(p.a)))) > 0.0);
        }
    }

    /// A quadratic displacement and a stress that is linear over each tet stay what they are.
    #[test]
    fn the_fields_are_the_same_functions() {
        let model = two();
        let space = Tet10Space::new(&model.mesh);
        let at = |x: V3| [x[0] * x[1], x[2] * x[2] - x[0], x[1] + 0.5 * x[0] * x[2]];
        let u = DisplacementField { u: space.nodes.iter().map(|x| at(*x)).collect() };
        let stress_at = |x: V3| [x[0], x[1] - x[2], 2.0, x[2], 0.3 * x[0], -x[1]];
        let points = |e: usize, mesh: &TetMesh| -> PointStress {
            let x = mesh.corners(e);
            let middle: V3 = std::array::from_fn(|d| x.iter().map(|x| x[d]).sum::<f64>() / 4.0);
            std::array::from_fn(|k| {
                std::array::from_fn(|p| stress_at(if p < 3 { x[FACES[k][p]] } else { middle }))
            })
        };
        let stress = StressField {
            points: (0..model.mesh.tets.len()).map(|e| points(e, &model.mesh)).collect(),
        };
        let fine = refined(&model, &u, &stress);
        let finer = Tet10Space::new(&fine.model.mesh);
        for (x, u) in finer.nodes.iter().zip(&fine.displacement.u) {
            assert!(vec3::norm(vec3::sub(at(*x), *u)) < 1e-9, "{x:?}");
        }
        for (e, found) in fine.stress.points.iter().enumerate() {
            let want = points(e, &fine.model.mesh);
            let near = |a: &Mandel, b: &Mandel| (0..6).all(|i| (a[i] - b[i]).abs() < 1e-9);
            assert!((0..4).all(|k| (0..4).all(|p| near(&found[k][p], &want[k][p]))), "{e}");
        }
        // its traction through a section is that of the coarse one
        let section = SectionPlane { body: 0, axis: 0, at: 10.0 };
        let [a, b] = [
            section.of_stress(&model, &stress).expect("faces"),
            section.of_stress(&fine.model, &fine.stress).expect("faces"),
        ];
        assert!(vec3::norm(vec3::sub(a, b)) < 1e-6, "{a:?} {b:?}");
    }
}
