//! Random points inside elements and on faces: the fields must be admissible there too, with no exception.

use super::certificate::contact_tractions;
use super::faces::{contact_faces, roles};
use super::fields::{DisplacementField, StressField};
use crate::math::mandel;
use crate::math::quadrature::triangle_p2;
use crate::math::vec3::{self, V3};
use crate::mesh::numbering::FaceNumbering;
use crate::mesh::tet::FACES;
use crate::model::AnalysisModel;
use crate::model::kinematic::Tet10Space;
use crate::model::loads::Loads;

/// Largest relative violations found at random points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sampled {
    /// Traction jump across faces of the mesh / largest stress of the field.
    pub traction_jump: f64,
    /// Violation of a friction cone by the stress / largest traction of the field.
    pub traction_cone: f64,
    /// Violation of the contact law by the displacement / largest displacement of the field.
    pub gap_cone: f64,
}

/// A small deterministic generator (xorshift64*): the same points on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / (1u64 << 53) as f64
    }
    fn index(&mut self, n: usize) -> usize {
        ((self.next() * n as f64) as usize).min(n - 1)
    }
    /// Uniform barycentric coordinates of a triangle.
    fn barycentric(&mut self) -> [f64; 3] {
        let (a, b) = (self.next().sqrt(), self.next());
        [1.0 - a, a * (1.0 - b), a * b]
    }
}

fn relative(a: f64, scale: f64) -> f64 {
    if scale > 0.0 { a / scale } else { a }
}

fn at(v: &[V3; 3], l: [f64; 3]) -> V3 {
    std::array::from_fn(|d| (0..3).map(|i| l[i] * v[i][d]).sum())
}

/// Tries `points` random points of each kind.
pub fn sample(
    model: &AnalysisModel,
    displacement: Option<&DisplacementField>,
    stress: Option<&StressField>,
    points: usize,
) -> Sampled {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut out = Sampled::default();
    let contacts = contact_faces(model);
    if let Some(s) = stress {
        let stress = s.points.iter().flatten().flatten().map(mandel::norm).fold(0.0, f64::max);
        out.traction_jump = relative(jumps(model, s, points, &mut random), stress);
        let roles = roles(model, Loads::ALL);
        let mut worst = 0.0f64;
        for _ in 0..points * usize::from(!contacts.is_empty()) {
            let f = &contacts[random.index(contacts.len())];
            let r = contact_tractions(model, s, f, roles.get(&(f.a.tet, f.a.local)));
            let (n, _) = f.normal(model);
            let r = at(&r, random.barycentric());
            let rn = vec3::dot(r, n);
            let rt = vec3::norm(vec3::sub(r, vec3::scale(rn, n)));
            worst = worst.max(rt - f.law.mu * rn).max(-rn);
        }
        out.traction_cone = relative(worst, stress);
    }
    if let Some(u) = displacement {
        let space = Tet10Space::new(&model.mesh);
        let mut worst = 0.0f64;
        let largest = u.u.iter().map(|x| vec3::norm(*x)).fold(0.0, f64::max);
        for _ in 0..points * usize::from(!contacts.is_empty()) {
            let f = &contacts[random.index(contacts.len())];
            let l = random.barycentric();
            let shape = triangle_p2(l);
            let a = space.triangle(f.nodes_a).map(|n| u.u[n]);
            let b = f.b.map_or([[0.0; 3]; 6], |(_, nodes)| space.triangle(nodes).map(|n| u.u[n]));
            let g = (0..6).fold([0.0; 3], |s, i| vec3::add(s, vec3::scale(shape[i], vec3::sub(b[i], a[i]))));
            let (n, _) = f.normal(model);
            let gn = vec3::dot(g, n);
            let gt = vec3::norm(vec3::sub(g, vec3::scale(gn, n)));
            worst = worst.max(f.law.mu * gt - gn - f.law.gap.at(at(&f.corners(model), l)));
        }
        out.gap_cone = relative(worst, largest);
    }
    out
}

fn jumps(model: &AnalysisModel, s: &StressField, points: usize, random: &mut Random) -> f64 {
    let mesh = &model.mesh;
    let faces = FaceNumbering::new(mesh);
    let mut worst = 0.0f64;
    for _ in 0..points {
        let f = random.index(faces.nodes.len());
        let (a, Some(b)) = faces.tets[f] else { continue };
        let nodes = faces.nodes[f];
        let corners = nodes.map(|n| mesh.nodes[n as usize]);
        let area = vec3::area_vector(&corners);
        let n = vec3::scale(1.0 / vec3::norm(area), area);
        let l = random.barycentric();
        let side = |e: u32| {
            let e = e as usize;
            let k = (0..4).find(|&k| faces.of_tet[e][k] as usize == f).expect("the tet owns the face");
            let t = nodes.map(|m| {
                let p = FACES[k].iter().position(|&i| mesh.tets[e][i] == m).expect("the node is on the face");
                mandel::traction(&s.points[e][k][p], n)
            });
            at(&t, l)
        };
        let (ta, tb) = (side(a), side(b));
        worst = worst.max(vec3::norm(vec3::sub(ta, tb)));
    }
    worst
}
