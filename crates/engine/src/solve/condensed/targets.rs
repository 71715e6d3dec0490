//! Targets of a step: the complementarity product of each cone, and the residuals.
//!
//! Mehrotra's rule uses one fraction σ of the mean product, from the length α of the affine step:
//! `σ = (1 − α)³`. In limit analysis a few cones in a hundred thousand (contacts that open or begin
//! to slip) limit that step to a tenth or less, and one σ for all delays every other cone. There
//! each cone has its own σ, from the affine step that the cone alone allows; σ of the residuals is
//! their mean. The same step is the fraction of the second-order term that is used in the cone.

use super::cones::Cones;

/// Smallest target of a single cone, as a fraction of the mean product: a cone with a smaller one
/// leaves the neighbourhood of the central path before the others arrive (0.1 and 0.01 took as many
/// iterations; with fewer correctors 0.2 took a quarter more).
const LEAST: f64 = 0.03;

/// Targets of a step.
pub struct Targets {
    /// Fraction of the residuals that remains, and of the mean product that is the target of the
    /// pair (τ, κ).
    pub sigma: f64,
    /// Target product of the pair (τ, κ).
    pub centre: f64,
    /// Target product of each cone, at its first row; 0 at the others.
    pub products: Vec<f64>,
    /// Fraction of the second-order term that is used in each cone; empty: 1 in all cones.
    pub trusted: Vec<f64>,
}

/// Mehrotra's fraction for an affine step of length `step`.
fn fraction(step: f64) -> f64 {
    (1.0 - step).powi(3)
}

impl Targets {
    /// One target for all cones; `step`: fraction of the affine direction that stays inside, `mu`:
    /// mean product.
    pub fn common(cones: &Cones, step: f64, mu: f64) -> Self {
        let sigma = fraction(step);
        let mut products = cones.identity();
        products.iter_mut().for_each(|p| *p *= sigma * mu);
        Self { sigma, centre: sigma * mu, products, trusted: Vec::new() }
    }

    /// A target for each cone; `steps`: fraction of the affine direction that stays inside the
    /// cone, one value per cone, at most 1.
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

    /// One cone in a hundred that allows only a short step keeps its product; it does not delay the
    /// others and the residuals.
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
