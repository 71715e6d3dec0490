//! The metric of the next mesh: a tensor M at each node, in which the edges of the mesh should have
//! the length 1. Its determinant follows from the design (how many elements), its directions from
//! the second derivatives of the fields (in which directions they are long):
//! `M = h⁻² |H| / det(|H|)^(1/3)`, h the edge of the regular tet of the wanted volume.

use crate::mesh::TetMesh;
use crate::mesh::size_field::{Edges, SizeField};
use crate::mesh::tet::EDGES;
use crate::mesh::topology::FaceTable;
use bracket_base::math::eigen::{compose, eigen, mapped};
use bracket_base::math::mandel::{Mandel, symmetric_part, to_matrix};
use bracket_base::math::vec3::{M3, area_vector, det, norm, sub};
use rayon::prelude::*;
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

/// Bounds of the elements at each node.
#[derive(Clone, Debug, PartialEq)]
pub struct SizeLimits {
    /// Smallest size \[mm\].
    pub least: Vec<f64>,
    /// The coarsest elements.
    pub coarsest: Coarsest,
}

/// The coarsest elements at each node, as a metric with its square roots: no element is longer in
/// any direction than a unit of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Coarsest {
    roots: Vec<M3>,
    inverse_roots: Vec<M3>,
}

impl Coarsest {
    /// From the tensors at the nodes \[1/mm²\].
    pub fn new(tensors: &[Mandel]) -> Self {
        let power = |p: f64| tensors.iter().map(|m| to_matrix(&mapped(m, |v| v.powf(p)))).collect();
        Self { roots: power(0.5), inverse_roots: power(-0.5) }
    }

    /// The coarsest tensor at node `n` that is nowhere coarser than `m` or the limit:
    /// `C^½ max(1, C^−½ M C^−½) C^½`.
    fn meet(&self, n: usize, m: &Mandel) -> Mandel {
        let relative = congruent(&self.inverse_roots[n], m);
        congruent(&self.roots[n], &mapped(&relative, |v| v.max(1.0)))
    }
}

/// The coarsest tensor that is nowhere coarser than one of two.
pub fn meet(a: &Mandel, b: &Mandel) -> Mandel {
    Coarsest::new(&[*a]).meet(0, b)
}

/// `A M A` of a symmetric matrix A.
pub fn congruent(a: &M3, m: &Mandel) -> Mandel {
    let product = |x: &M3, y: &M3| -> M3 {
        std::array::from_fn(|i| {
            std::array::from_fn(|j| (0..3).map(|k| x[i][k] * y[k][j]).sum::<f64>())
        })
    };
    symmetric_part(&product(a, &product(&to_matrix(m), a)))
}

/// The metric of a mesh itself \[1/mm²\]: in it, its tets are about regular with edges of length 1.
/// The mean of the logarithms of `(½ Σ e eᵀ)⁻¹` over the tets of a node, e the edges of a tet.
pub fn own(mesh: &TetMesh) -> Vec<Mandel> {
    let mut sum = vec![([0.0; 6], 0.0); mesh.nodes.len()];
    for (e, t) in mesh.tets.iter().enumerate() {
        let x = mesh.corners(e);
        let mut edges = [0.0; 6];
        for [a, b] in EDGES {
            let d = sub(x[b], x[a]);
            let square = symmetric_part(&d.map(|i| d.map(|j| 0.5 * i * j)));
            edges.iter_mut().zip(square).for_each(|(s, x)| *s += x);
        }
        let logarithm = mapped(&edges, |v| -v.ln());
        for n in t {
            let (total, count) = &mut sum[*n as usize];
            total.iter_mut().zip(logarithm).for_each(|(s, x)| *s += x);
            *count += 1.0;
        }
    }
    sum.iter().map(|(total, count)| mapped(&total.map(|x| x / count), f64::exp)).collect()
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
            .into_par_iter()
            .map(|n| {
                let (values, vectors) = eigen(&shapes[n]);
                let bounded = |v: f64| (sizes[n] / v.sqrt()).max(limits.least[n]).powi(-2);
                limits.coarsest.meet(n, &compose(values.map(bounded), &vectors))
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
    sum.par_iter().map(at).collect()
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::fixtures::cubes;
    use bracket_base::math::vec3::V3;

    const AXES: [V3; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    fn block() -> TetMesh {
        let cells: Vec<_> = (0..64).map(|i| ([i % 4, i / 4 % 4, i / 16], "B")).collect();
        cubes(&cells)
    }

    /// Limits of the same size everywhere.
    fn even(mesh: &TetMesh, least: f64, most: f64) -> SizeLimits {
        let tensor = compose([most.powi(-2); 3], &AXES);
        let n = mesh.nodes.len();
        SizeLimits { least: vec![least; n], coarsest: Coarsest::new(&vec![tensor; n]) }
    }

    fn none(mesh: &TetMesh) -> SizeLimits {
        even(mesh, 0.0, 1e6)
    }

    /// The metric that divides every tet into `parts` with the second derivatives `h`.
    fn metric(mesh: &TetMesh, parts: f64, h: Mandel, limits: &SizeLimits) -> Metric {
        let n = mesh.tets.len();
        Metric::new(mesh, &Edges::new(mesh), &vec![parts; n], &vec![h; n], limits)
    }

    /// Sizes in the three axes of a tensor.
    fn sizes(m: &Mandel) -> [f64; 3] {
        std::array::from_fn(|d| m[d].powf(-0.5))
    }

    /// Second derivatives 16 : 4 : 1 give sizes 1 : 2 : 4, but for the noise, of the volume that is
    /// wanted, and as many unit tets as are wanted.
    #[test]
    fn sizes_of_a_quadratic_field() {
        let mesh = block();
        let metric = metric(&mesh, 3.0, [16.0, 4.0, 1.0, 0.0, 0.0, 0.0], &none(&mesh));
        let h = crate::mesh::size_field::regular_edge(mesh.volume(0) / 3.0);
        let noise = NOISE * 7.0;
        for m in &metric.tensors {
            let s = sizes(m);
            let ratio = |i: usize, a: f64| (s[i] / s[0]).powi(2) * (a + noise) / (16.0 + noise);
            assert!((ratio(1, 4.0) - 1.0).abs() < 1e-9 && (ratio(2, 1.0) - 1.0).abs() < 1e-9);
            assert!((s.iter().product::<f64>().cbrt() / h - 1.0).abs() < 1e-9, "{s:?} {h}");
        }
        assert!(metric.parts(&mesh).iter().all(|p| (p - 3.0).abs() < 1e-9));
        let coarser = metric.scaled(2.0);
        assert!(coarser.parts(&mesh).iter().all(|p| (p - 0.375).abs() < 1e-9));
    }

    /// The aspect ratio is bounded; without derivatives all sizes are equal.
    #[test]
    fn bounded_aspect() {
        let mesh = block();
        for (h, ratio) in [([1e6, 1.0, 1.0], ASPECT), ([0.0; 3], 1.0), ([2.0, 2.0, 1e-9], ASPECT)] {
            let metric = metric(&mesh, 1.0, compose(h, &AXES), &none(&mesh));
            let s = sizes(&metric.tensors[0]);
            assert!((s[2] / s[0] - ratio).abs() < 1e-9, "{h:?} {s:?}");
            assert!(metric.parts(&mesh).iter().all(|p| (p - 1.0).abs() < 1e-9));
        }
    }

    /// Sizes stay between their limits in every direction, whatever number of parts is wanted, and
    /// the number of parts counts the limits.
    #[test]
    fn limited_sizes() {
        let mesh = block();
        let limits = even(&mesh, 4.0, 15.0);
        for parts in [1e-3, 1.0, 1e3] {
            let metric = metric(&mesh, parts, [16.0, 4.0, 1.0, 0.0, 0.0, 0.0], &limits);
            for m in &metric.tensors {
                assert!(sizes(m).iter().all(|s| *s > 3.999_999 && *s < 15.000_001), "{m:?}");
            }
            let [few, many] = [15.0f64, 4.0].map(|h| 6.0 * SQRT_2 * mesh.volume(0) / h.powi(3));
            let made = metric.parts(&mesh)[0];
            assert!(made > 0.999 * few && made < 1.001 * many, "{few} {made} {many}");
        }
    }

    /// A metric within a long one is the finer of both in each direction of either.
    #[test]
    fn the_finer_in_each_direction() {
        let slanted = [[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [-0.6, 0.0, 0.8]];
        let (a, b) = (compose([9.0, 1.0, 4.0], &slanted), compose([2.0, 5.0, 2.0], &AXES));
        let met = meet(&a, &b);
        let along = |m: &Mandel, t: V3| {
            let m = to_matrix(m);
            (0..3)
                .flat_map(|i| (0..3).map(move |j| (i, j)))
                .map(|(i, j)| t[i] * m[i][j] * t[j])
                .sum::<f64>()
        };
        for t in slanted.into_iter().chain(AXES) {
            assert!(along(&met, t) >= along(&a, t).max(along(&b, t)) - 1e-9);
        }
        assert!((along(&met, slanted[0]) - 9.0).abs() < 1e-9);
        assert!((along(&met, AXES[1]) - 5.0).abs() < 1e-9);
        let again = meet(&b, &a);
        assert!(met.iter().zip(again).all(|(x, y)| (x - y).abs() < 1e-9), "{met:?} {again:?}");
    }

    /// In its own metric a mesh has one regular tet in each of its tets, whatever its shape.
    #[test]
    fn the_metric_of_a_mesh_itself() {
        let mut mesh = block();
        mesh.nodes.iter_mut().for_each(|x| x[2] *= 0.3);
        let parts = Metric { tensors: own(&mesh) }.parts(&mesh);
        let mean = parts.iter().sum::<f64>() / parts.len() as f64;
        assert!(mean > 0.7 && mean < 1.4, "{mean}");
    }

    /// Twice the volume over the surface: 6.67 for a plate of 40 × 40 × 10 mm, 13.3 for a cube of
    /// 40 mm; where both meet the smaller counts.
    #[test]
    fn thickness_of_bodies() {
        let plate = (0..16).map(|i| ([i % 4, i / 4, 0], "PLATE"));
        let block = (0..64).map(|i| ([i % 4, i / 4 % 4, 1 + i / 16], "BLOCK"));
        let mesh = cubes(&plate.chain(block).collect::<Vec<_>>());
        let least = least_sizes(&mesh);
        for (x, least) in mesh.nodes.iter().zip(least) {
            let area = 2.0 * 1600.0 + 4.0 * 400.0;
            let want = if x[2] <= 10.0 { 2.0 * 16_000.0 / area } else { 2.0 * 64_000.0 / 9600.0 };
            assert!((least - PER_THICKNESS * want).abs() < 1e-9, "{x:?} {least}");
        }
    }
}
