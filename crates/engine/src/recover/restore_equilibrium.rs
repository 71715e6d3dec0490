//! Equilibrium of the stress in slivers, restored after its loss to rounding.

use crate::elements::geometry::centroid;
use crate::elements::geometry::gradients;
use crate::elements::stress_basis::equilibrium_rows;
use crate::elements::super_element::PointStress;
use crate::elements::super_element::SuperElement;
use crate::model::AnalysisModel;
use bracket_base::math::dense::{Mat, ThinQr};
use bracket_base::math::mandel;
use bracket_base::math::vec3::{self, V3};
use rayon::prelude::*;

/// A tet with `|div σ + b| h` above this times the largest stress is corrected: a hundredth of the
/// tolerance of a strict bound.
const ROUNDING: f64 = 1e-11;

/// Restores the equilibrium of the stress inside every sliver by the smallest change, under the
/// body forces `body` \[N/mm³\]; leaves other tets as they are.
///
/// The Piola map of a tet with dihedral angle θ cancels numbers 1/θ² times its stress, and the
/// divergence divides the rounding by the height: 1e-16/θ³ of the stress, too much for a strict
/// bound below about half a degree. The tractions on outer faces change by the rounding of the map,
/// 1e-16/θ².
pub(crate) fn restore_equilibrium(model: &AnalysisModel, body: &[V3], points: &mut [PointStress]) {
    let largest = points.iter().flatten().flatten().map(mandel::norm).fold(0.0, f64::max);
    points.par_iter_mut().enumerate().for_each(|(e, s)| {
        let corners = model.mesh.corners(e);
        let b = body[model.mesh.tet_body[e] as usize];
        if imbalance(&corners, b, s) * model.mesh.volume(e).cbrt() > ROUNDING * largest {
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
    let factor = ThinQr::new(&Mat::from_fn(96, rows.len(), |i, j| rows[j][i]));
    // the second round removes the rounding of the first
    for _ in 0..2 {
        let rest: [f64; 96] = std::array::from_fn(|i| s[i / 24][i / 6 % 4][i % 6] - carried(i));
        let y =
            Mat::from_fn(rows.len(), 1, |j, _| -(0..96).map(|i| rows[j][i] * rest[i]).sum::<f64>());
        let change = factor.least_norm(y);
        (0..96).for_each(|i| s[i / 24][i / 6 % 4][i % 6] += change[(i, 0)]);
    }
}
