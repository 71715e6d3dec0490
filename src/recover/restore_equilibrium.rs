//! Slivers: a stress that has lost its equilibrium to rounding gets it back.

use crate::elements::geometry::{centroid, gradients};
use crate::elements::stress_basis::equilibrium_rows;
use crate::elements::super_element::{PointStress, SuperElement};
use crate::math::mandel;
use crate::math::vec3::{self, V3};
use crate::model::AnalysisModel;
use faer::Mat;
use rayon::prelude::*;

/// A tet with `|div σ + b| h` above this times the largest stress is settled: a hundredth of what a
/// strict bound may have.
const SETTLED: f64 = 1e-11;

/// Under the body forces `body` \[N/mm³\], brings the stress of every sliver into equilibrium with
/// itself again, by the smallest change; leaves other tets as they are.
///
/// The Piola map of a tet with dihedral angle θ cancels numbers 1/θ² times its stress, and the
/// divergence divides what is left by the height: 1e-16/θ³ of the stress, too much for a strict
/// bound below about half a degree. The tractions on outer faces change by what the map had left in
/// them, 1e-16/θ².
pub(crate) fn settle(model: &AnalysisModel, body: &[V3], points: &mut [PointStress]) {
    let largest = points.iter().flatten().flatten().map(mandel::norm).fold(0.0, f64::max);
    points.par_iter_mut().enumerate().for_each(|(e, s)| {
        let corners = model.mesh.corners(e);
        let b = body[model.mesh.tet_body[e] as usize];
        if imbalance(&corners, b, s) * model.mesh.volume(e).cbrt() > SETTLED * largest {
            correct(&corners, b, s);
        }
    });
}

/// Largest `|div σ + b|` \[N/mm³\] of the four subtets.
fn imbalance(corners: &[V3; 4], body: V3, s: &PointStress) -> f64 {
    let divergence = |(x, s): (&[V3; 4], &[mandel::Mandel; 4])| {
        let g = gradients(x);
        vec3::norm((0..4).fold(body, |d, p| vec3::add(d, mandel::traction(&s[p], g[p]))))
    };
    SuperElement::points(corners).iter().zip(s).map(divergence).fold(0.0, f64::max)
}

/// Least-squares correction of the rows `div σ = 0` and `[t] = 0`, on the stress less
/// `−diag(b_i (x_i − c_i))`, which carries the body force.
fn correct(corners: &[V3; 4], body: V3, s: &mut PointStress) {
    let centre = centroid(corners);
    let points = SuperElement::points(corners);
    let carried = |i: usize| {
        let (x, c) = (points[i / 24][i / 6 % 4], i % 6);
        if c < 3 { -body[c] * (x[c] - centre[c]) } else { 0.0 }
    };
    let rows = equilibrium_rows(corners);
    let qr = Mat::from_fn(96, rows.len(), |i, j| rows[j][i]).qr();
    let (q, r) = (qr.compute_thin_Q(), qr.thin_R());
    // the second round takes out the rounding of the first
    for _ in 0..2 {
        let rest: [f64; 96] = std::array::from_fn(|i| s[i / 24][i / 6 % 4][i % 6] - carried(i));
        let mut y =
            Mat::from_fn(rows.len(), 1, |j, _| -(0..96).map(|i| rows[j][i] * rest[i]).sum::<f64>());
        faer::linalg::triangular_solve::solve_lower_triangular_in_place(
            r.transpose(),
            y.as_mut(),
            faer::Par::Seq,
        );
        let change = q.as_ref() * &y;
        (0..96).for_each(|i| s[i / 24][i / 6 % 4][i % 6] += change[(i, 0)]);
    }
}
