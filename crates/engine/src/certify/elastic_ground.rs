//! Elastic ground (Winkler): its energy under a displacement, and its complementary energy under a
//! pressure.
//!
//! The ground presses back with k times its closing c. A displacement with the jump g needs
//! `c = max(0, μ‖g_T‖ − g_N − g₀)`, and the ground stores `½ k ∫ c²`. The complementary energy of a
//! pressure p is `∫ p² / 2k`.

use crate::certify::faces::ContactFace;
use crate::certify::welds::{coefficients, jumps, quarters};
use crate::elements::space::{FACE_EDGES, Tet10Space};
use crate::model::AnalysisModel;
use crate::model::opening::bernstein_at;
use bracket_base::math::quadrature::{bernstein_mass, triangle_mass};
use bracket_base::math::vec3::{self, V3};

/// Number of times a face is subdivided where the edge of the pressed region crosses it.
const SUBDIVISIONS: u32 = 3;

/// Energy of elastic ground under a face, an upper bound; zero on other faces \[N mm\].
pub fn energy_of(
    model: &AnalysisModel,
    space: &Tet10Space,
    face: &ContactFace<'_>,
    u: &[V3],
) -> f64 {
    let Some(stiffness) = model.ground_stiffness(face.of) else { return 0.0 };
    let (n, area) = face.normal(model);
    let opening = face.opening(model);
    let mut g = jumps(space, face, u);
    for (i, g) in g.iter_mut().enumerate() {
        let [p, q] = if i < 3 { [i, i] } else { FACE_EDGES[i - 3] };
        let mut at = [0.0; 3];
        at[p] += 0.5;
        at[q] += 0.5;
        *g = vec3::along(*g, bernstein_at(&opening, at), n);
    }
    let pressed = |g: V3| {
        let across = vec3::dot(g, n);
        face.law.mu * vec3::norm(vec3::along(g, -across, n)) - across
    };
    let linear = face.law.mu == 0.0;
    0.5 * stiffness * area * mean_square(&g, &pressed, linear, SUBDIVISIONS)
}

/// An upper bound of the mean of `max(0, f)²` over a triangle, f a convex function of a quadratic g
/// with the given values at vertices and mid-sides. `linear`: f is linear.
///
/// The quadratic polynomial of the positive values of f at the Bernstein coefficients lies nowhere
/// below `max(0, f)`. Where f is linear and has one sign, the mean is exact.
fn mean_square(g: &[V3; 6], f: &impl Fn(V3) -> f64, linear: bool, subdivisions: u32) -> f64 {
    let mut values = [0.0; 6];
    values.iter_mut().zip(coefficients(g)).for_each(|(v, g)| *v = f(g));
    if values.iter().all(|v| *v <= 0.0) {
        return 0.0;
    }
    if subdivisions == 0 || (linear && values.iter().all(|v| *v >= 0.0)) {
        let c = values.map(|v| v.max(0.0));
        let row = |i: usize| (0..6).map(|j| bernstein_mass(i, j) * c[j]).sum::<f64>();
        return (0..6).map(|i| c[i] * row(i)).sum();
    }
    0.25 * quarters(g).iter().map(|g| mean_square(g, f, linear, subdivisions - 1)).sum::<f64>()
}

/// Complementary energy of elastic ground under a face with the given tractions at its vertices,
/// zero on other faces \[N mm\].
pub fn complementary_energy_of(model: &AnalysisModel, face: &ContactFace<'_>, r: &[V3; 3]) -> f64 {
    let Some(stiffness) = model.ground_stiffness(face.of) else { return 0.0 };
    let (n, area) = face.normal(model);
    let p = r.map(|r| vec3::dot(r, n));
    let row = |i: usize| (0..3).map(|j| triangle_mass(i, j) * p[j]).sum::<f64>();
    0.5 * area / stiffness * (0..3).map(|i| p[i] * row(i)).sum::<f64>()
}
