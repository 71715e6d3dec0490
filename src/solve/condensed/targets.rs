//! What a step aims at: the complementarity product of each cone and the residuals.
//!
//! Mehrotra's rule takes one fraction σ of the mean product, from the length of the affine step:
//! `σ = (1 − α)³`. In limit analysis that step is a tenth or less because of a handful of cones in
//! a hundred thousand (contacts that open or begin to slip), and one σ for all makes every other
//! cone wait for them. There each cone has a σ of its own, from the way it could go for itself; σ
//! of the residuals is their mean. The same way is the part of the cone's second-order term that is
//! trusted.

use super::cones::Cones;

/// Least part of the mean product that a cone with a target of its own aims at: smaller ones fall
/// out of the neighbourhood of the central path before the others arrive (0.1 and 0.01 took as many
/// iterations, with fewer correctors 0.2 took a quarter more).
const LEAST: f64 = 0.03;

/// Targets of a step.
pub struct Targets {
    /// Part of the residuals that is left, and of the mean product that the pair (τ, κ) aims at.
    pub sigma: f64,
    /// That product.
    pub centre: f64,
    /// Product of each cone, at its first row; 0 at the others.
    pub products: Vec<f64>,
    /// Part of its second-order term that each cone is corrected for; empty: all of it.
    pub trusted: Vec<f64>,
}

/// Mehrotra's fraction for a step that may go `step` of the way.
fn fraction(step: f64) -> f64 {
    (1.0 - step).powi(3)
}

impl Targets {
    /// The same for all cones; `step`: part of the affine direction that stays inside, `mu`: mean
    /// product.
    pub fn common(cones: &Cones, step: f64, mu: f64) -> Self {
        let sigma = fraction(step);
        let mut products = cones.identity();
        products.iter_mut().for_each(|p| *p *= sigma * mu);
        Self { sigma, centre: sigma * mu, products, trusted: Vec::new() }
    }

    /// Each cone's own; `steps`: part of the affine direction that stays inside the cone, one value
    /// a cone, at most 1.
    pub fn own(cones: &Cones, steps: Vec<f64>, mu: f64) -> Self {
        let mut products = vec![0.0; cones.rows];
        let mut sum = 0.0;
        for (&(at, _), step) in cones.blocks.iter().zip(&steps) {
            let own = fraction(*step).max(LEAST);
            products[at] = own * mu;
            sum += own;
        }
        let sigma = sum / cones.degree();
        Self { sigma, centre: sigma * mu, products, trusted: steps }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::programs::conic::Cone;

    /// One cone in a hundred that cannot go far keeps its product; the others and the residuals do
    /// not wait for it.
    #[test]
    fn a_cone_that_ends_the_step_holds_back_only_itself() {
        let cones = Cones::new(&[Cone::SecondOrder(3); 100]);
        let mut steps = vec![1.0; 100];
        steps[7] = 0.1;
        let (mu, common) = (2.0, Targets::common(&cones, 0.1, 2.0));
        let own = Targets::own(&cones, steps, mu);
        assert!((common.sigma - 0.729).abs() < 1e-12 && (common.products[3] - 1.458).abs() < 1e-12);
        assert!(
            (own.products[21] - 1.458).abs() < 1e-12
                && (own.products[3] - LEAST * mu).abs() < 1e-12
        );
        assert!(own.products[22] == 0.0 && own.trusted[7] == 0.1);
        assert!((own.sigma - (0.729 + 99.0 * LEAST) / 100.0).abs() < 1e-12);
    }
}
