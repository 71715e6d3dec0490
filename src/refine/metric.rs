//! The metric of the next mesh: a tensor M at each node, in which the edges of the mesh should have
//! the length 1. Its determinant follows from the design (how many elements), its directions from
//! the second derivatives of the fields (in which directions they are long):
//! `M = h⁻² |H| / det(|H|)^(1/3)`, h the edge of the regular tet of the wanted volume.

use crate::math::eigen::{compose, eigen};
use crate::math::mandel::{Mandel, to_matrix};
use crate::math::vec3::{area_vector, det, norm};
use crate::mesh::TetMesh;
use crate::mesh::size_field::{Edges, SizeField};
use crate::mesh::topology::FaceTable;
use std::f64::consts::SQRT_2;

/// Largest ratio of the lengths of a wanted element in two directions.
pub const ASPECT: f64 = 4.0;

/// Second derivatives below this part of their mean over the mesh give no direction.
const NOISE: f64 = 0.01;

/// Smallest element size over the thickness of a body.
const PER_THICKNESS: f64 = 0.2;

/// The metric at the nodes of a mesh \[1/mm²\].
#[derive(Clone, Debug, PartialEq)]
pub struct Metric {
    /// One tensor at each node.
    pub tensors: Vec<Mandel>,
}

/// Bounds of the element sizes at each node \[mm\].
#[derive(Clone, Debug, PartialEq)]
pub struct SizeLimits {
    /// Smallest size.
    pub least: Vec<f64>,
    /// Largest size; may be infinite.
    pub most: Vec<f64>,
}

impl Metric {
    /// The metric that divides each tet of `mesh` into `wanted` parts of the given directions,
    /// within the limits of the sizes.
    pub fn new(
        mesh: &TetMesh,
        edges: &Edges,
        wanted: &[f64],
        directions: &[Mandel],
        limits: &SizeLimits,
    ) -> Self {
        let sizes = SizeField::new(mesh, edges, wanted).sizes;
        let shapes = shapes(mesh, directions);
        let tensors = (0..mesh.nodes.len())
            .map(|n| {
                let (values, vectors) = eigen(&shapes[n]);
                let bounded = |v: f64| {
                    let size = sizes[n] / v.sqrt();
                    size.min(limits.most[n]).max(limits.least[n]).powi(-2)
                };
                compose(values.map(bounded), &vectors)
            })
            .collect();
        Self { tensors }
    }

    /// The metric with all sizes multiplied by `factor`.
    pub fn scaled(&self, factor: f64) -> Self {
        let by = factor.powi(-2);
        Self { tensors: self.tensors.iter().map(|m| m.map(|x| by * x)).collect() }
    }

    /// Number of regular unit tets of the metric in each tet.
    pub fn parts(&self, mesh: &TetMesh) -> Vec<f64> {
        let density: Vec<f64> =
            self.tensors.iter().map(|m| det(&to_matrix(m)).max(0.0).sqrt()).collect();
        let one = |e: usize, t: &[u32; 4]| {
            let mean: f64 = t.iter().map(|n| 0.25 * density[*n as usize]).sum();
            6.0 * SQRT_2 * mesh.volume(e) * mean
        };
        mesh.tets.iter().enumerate().map(|(e, t)| one(e, t)).collect()
    }
}

/// The directions at each node as a tensor of determinant 1: those of the tets around it, averaged
/// with their volumes. The unit tensor where there are none, or where they are noise: where a field
/// hardly varies, its second derivatives have the directions of rounding.
fn shapes(mesh: &TetMesh, directions: &[Mandel]) -> Vec<Mandel> {
    let mut sum = vec![([0.0; 6], 0.0); mesh.nodes.len()];
    let (mut trace, mut volume) = (0.0, 0.0);
    for (e, (t, h)) in mesh.tets.iter().zip(directions).enumerate() {
        let v = mesh.volume(e);
        trace += v * (h[0] + h[1] + h[2]);
        volume += v;
        for n in t {
            let (total, weight) = &mut sum[*n as usize];
            total.iter_mut().zip(h).for_each(|(s, h)| *s += v * h);
            *weight += v;
        }
    }
    let noise = if volume > 0.0 { NOISE * trace / (3.0 * volume) } else { 0.0 };
    let at = |(total, weight): &([f64; 6], f64)| {
        let mut mean = total.map(|t| if *weight > 0.0 { t / weight } else { 0.0 });
        mean[..3].iter_mut().for_each(|d| *d += noise);
        shape(&mean)
    };
    sum.iter().map(at).collect()
}

/// The tensor scaled to determinant 1, after its eigenvalues are bounded so that sizes differ by at
/// most [`ASPECT`].
fn shape(h: &Mandel) -> Mandel {
    let (values, vectors) = eigen(h);
    let largest = values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    if !(largest > 0.0 && largest.is_finite()) {
        return [1.0, 1.0, 1.0, 0.0, 0.0, 0.0];
    }
    let bounded = values.map(|v| (v.abs() / largest).max(ASPECT.powi(-2)));
    let mean = bounded.iter().product::<f64>().cbrt();
    compose(bounded.map(|v| v / mean), &vectors)
}

/// Smallest size at each node: a fixed part of the thickness of the thinnest body there. The
/// thickness of a body is twice its volume over its surface.
pub fn least_sizes(mesh: &TetMesh) -> Vec<f64> {
    let mut area = vec![0.0; mesh.bodies.len()];
    let mut volume = vec![0.0; mesh.bodies.len()];
    for rows in FaceTable::new(&mesh.tets).faces() {
        let body = |i: usize| mesh.tet_body[rows[i].tet as usize] as usize;
        if rows.len() == 2 && body(0) == body(1) {
            continue;
        }
        let a = norm(area_vector(&rows[0].key.map(|n| mesh.nodes[n as usize])));
        (0..rows.len()).for_each(|i| area[body(i)] += a);
    }
    for (e, body) in mesh.tet_body.iter().enumerate() {
        volume[*body as usize] += mesh.volume(e);
    }
    let mut least = vec![f64::INFINITY; mesh.nodes.len()];
    for (t, body) in mesh.tets.iter().zip(&mesh.tet_body) {
        let size = PER_THICKNESS * 2.0 * volume[*body as usize] / area[*body as usize];
        t.iter().for_each(|n| least[*n as usize] = least[*n as usize].min(size));
    }
    least
}
