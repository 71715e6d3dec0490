//! The half space of actions that a mechanism bounds. It is stronger than the load factor of the
//! mechanism, which is one point of its edge.
//!
//! Let the actions `a` (a force and a moment on every rigid face) be carried by some admissible
//! stress. For every mechanism, virtual work with its velocities gives `P(a) ≤ D`: P is the power
//! of the actions, D the dissipation. The certificate of the mechanism that was found under the
//! actions a₀ has D and `P(a₀)`; divided by `P(a₀)`, the half space is `p · a ≤ λ_up` with
//! `p · a₀ = 1`. So no factor on other actions can exceed `λ_up / (p · a)`, where that is positive.

use crate::certify::load_factor::UpperFactor;
use crate::certify::rigid_fit::rigid_motions;
use crate::certify::tolerance::TOLERANCE;
use crate::certify::velocity_field::VelocityField;
use crate::model::AnalysisModel;
use bracket_base::math::Sum;
use bracket_base::math::convex::HalfPlane;

/// A force and a moment about its reference point on every rigid face of a model \[N, N mm\].
pub type Actions = Vec<[f64; 6]>;

/// Two unit actions.
pub type Axes = [Actions; 2];

/// Relative difference allowed between the power of the actions and the power of the certificate.
const SAME: f64 = 1e-9;

/// Actions `a` with `p · a ≤ offset`; the others cannot be carried.
#[derive(Clone, Debug, PartialEq)]
pub struct HalfSpace {
    /// p: motions of the rigid faces for unit power of the actions of the model \[mm, rad; per N
    /// mm\].
    motions: Vec<[f64; 6]>,
    /// λ_up, with the allowance for the residuals, rounded up.
    offset: f64,
}

/// The live actions of a model on its rigid faces.
pub fn live_actions(model: &AnalysisModel) -> Actions {
    model.rigid.iter().map(|r| r.action).collect()
}

impl HalfSpace {
    /// What the velocities certified for the live actions of `model` prove; `None` where the bound
    /// is not strict, or where loads other than actions on rigid faces do work.
    pub fn new(
        model: &AnalysisModel,
        velocity: &VelocityField,
        bound: &UpperFactor,
    ) -> Option<Self> {
        let power = bound.certificate().live_power;
        if !bound.is_strict() || model.has_dead_loads() || power <= 0.0 {
            return None;
        }
        let motions = rigid_motions(model, &velocity.nodes.u);
        let own = live_actions(model);
        let together = Sum::of(terms(&motions, &own));
        let size: f64 = terms(&motions, &own).map(f64::abs).sum();
        if (together - power).abs() > SAME * size {
            return None;
        }
        let motions = motions.into_iter().map(|m| m.map(|x| x / power)).collect();
        // rounding of the powers rotates the half space by less than this
        let offset = bound.value() * (1.0 + 1e-12);
        Some(Self { motions, offset })
    }

    /// p · a, and the sum of the sizes of its terms; `None` for actions on another number of faces.
    fn power(&self, actions: &[[f64; 6]]) -> Option<[f64; 2]> {
        if actions.len() != self.motions.len() {
            return None;
        }
        let size: f64 = terms(&self.motions, actions).map(f64::abs).sum();
        Some([Sum::of(terms(&self.motions, actions)), size])
    }

    /// The largest factor on these actions that the half space allows, rounded up; `None` where it
    /// bounds none.
    pub fn factor(&self, actions: &[[f64; 6]]) -> Option<f64> {
        let [power, size] = self.power(actions)?;
        // the residuals of the mechanism and rounding change the power by no more
        let least = power - TOLERANCE * size;
        let factor = (self.offset / least).next_up();
        (least > 0.0 && factor.is_finite()).then_some(factor)
    }

    /// The half plane of the factors on two unit actions; `None` unless `direction` of them is what
    /// the mechanism was found for.
    pub fn half_plane(&self, axes: &Axes, direction: [f64; 2]) -> Option<HalfPlane> {
        let [first, second] = [self.power(&axes[0])?, self.power(&axes[1])?];
        let size = (direction[0] * first[1]).abs() + (direction[1] * second[1]).abs();
        let together = direction[0] * first[0] + direction[1] * second[0];
        let same = (together - 1.0).abs() <= SAME * size;
        same.then_some(HalfPlane { normal: [first[0], second[0]], offset: self.offset })
    }
}

fn terms<'a>(motions: &'a [[f64; 6]], actions: &'a [[f64; 6]]) -> impl Iterator<Item = f64> {
    motions.iter().zip(actions).flat_map(|(m, a)| (0..6).map(move |i| m[i] * a[i]))
}
