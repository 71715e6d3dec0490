//! The half plane of two actions that a mechanism bounds. It is stronger than the load factor of
//! the mechanism, which is one point of its edge.
//!
//! Let actions `x₁ A₁ + x₂ A₂` act. For every pair x that some admissible stress carries, virtual
//! work with admissible velocities gives `x₁ P₁ + x₂ P₂ ≤ D`: P_k is the power of the unit action
//! A_k, D the dissipation. The certificate of the mechanism found for one direction d of x has D
//! and `P = d₁ P₁ + d₂ P₂`; divided by P, the half plane is `n · x ≤ λ_up` with `n · d = 1`.

use crate::certify::load_factor::UpperFactor;
use crate::certify::rigid_fit::rigid_motions;
use crate::certify::velocity_field::VelocityField;
use crate::model::AnalysisModel;
use bracket_base::math::Sum;
use bracket_base::math::convex::HalfPlane;

/// Two unit actions, each a force and a moment about its reference point on every rigid face of a
/// model \[N, N mm\].
pub type Axes = [Vec<[f64; 6]>; 2];

/// Relative difference allowed between the powers of the actions and the power of the certificate.
const SAME: f64 = 1e-9;

/// The half plane, in multiples of the two actions, proved by the velocities certified for the
/// direction `direction`; `None` where the bound is not strict, or where loads other than these
/// actions do work.
///
/// `model` carries `direction[0] · axes[0] + direction[1] · axes[1]` and no other load. The offset
/// includes the allowance for the residuals, as the load factor does.
pub fn half_plane(
    model: &AnalysisModel,
    velocity: &VelocityField,
    bound: &UpperFactor,
    axes: &Axes,
    direction: [f64; 2],
) -> Option<HalfPlane> {
    let certificate = bound.certificate();
    let motions = rigid_motions(model, &velocity.nodes.u);
    let fits = axes.iter().all(|a| a.len() == motions.len());
    if !(bound.is_strict() && fits) || model.has_dead_loads() || certificate.live_power <= 0.0 {
        return None;
    }
    let terms =
        |k: usize| motions.iter().zip(&axes[k]).flat_map(|(m, a)| (0..6).map(move |i| m[i] * a[i]));
    let power = [0, 1].map(|k| Sum::of(terms(k)));
    let size: f64 = (0..2).map(|k| direction[k].abs() * terms(k).map(f64::abs).sum::<f64>()).sum();
    let together = direction[0] * power[0] + direction[1] * power[1];
    if (together - certificate.live_power).abs() > SAME * size {
        return None;
    }
    let normal = power.map(|p| p / certificate.live_power);
    // rounding of the powers rotates the normal by less than this
    let offset = bound.value() * (1.0 + 1e-12);
    Some(HalfPlane { normal, offset })
}
