//! Where the lower bound is held down, or will be after the next mesh.
//!
//! The yield multipliers show the mechanism that limits the lower bound now. A joint has others of
//! almost the same load factor: two equal plates, for instance. A mesh that follows one alone lifts
//! it, and the next one limits the bound. The multipliers of an interior-point solve at an earlier
//! stage of its path, where slack s and multiplier z have the product μ, show them all: `z = μ / s`.
//! So tets near yield get the weight `δ / (s + δ)` per volume and yield strength, s the slack of the
//! utilisation at a point of a tet.

use crate::certify::fields::StressField;
use crate::certify::plastic_field::length;
use crate::elements::super_element::PointStress;
use crate::math::mandel::deviator;
use crate::model::AnalysisModel;

/// The slack δ of the utilisation at which a tet has half of the weight of a yielding one.
const SLACK: f64 = 0.03;

/// Part of the estimate that goes to tets near yield; the rest follows the multipliers.
const PART: f64 = 0.4;

/// The shares of the tets in what holds the lower bound down, with the sum 1: their `multipliers`,
/// and their nearness to yield under `stress`.
pub fn shares(
    model: &AnalysisModel,
    multipliers: &[f64],
    stress: Option<&StressField>,
) -> Vec<f64> {
    let multipliers = normal(multipliers.iter().map(|m| m.max(0.0)).collect());
    let Some(stress) = stress else { return multipliers };
    let near = normal(weights(model, stress));
    multipliers.iter().zip(near).map(|(m, n)| (1.0 - PART) * m + PART * n).collect()
}

fn normal(mut x: Vec<f64>) -> Vec<f64> {
    let sum: f64 = x.iter().sum();
    if sum > 0.0 {
        x.iter_mut().for_each(|x| *x /= sum);
    }
    x
}

/// Volume times yield strength times `δ / (s + δ)`; zero in rigid bodies.
fn weights(model: &AnalysisModel, stress: &StressField) -> Vec<f64> {
    let radii = model.yield_radii();
    let one = |(e, points): (usize, &PointStress)| {
        let Some(radius) = radii[model.mesh.tet_body[e] as usize] else { return 0.0 };
        let points = points.iter().flatten().map(|s| {
            let slack = (1.0 - length(&deviator(s)) / radius).max(0.0);
            SLACK / (slack + SLACK)
        });
        model.mesh.volume(e) * radius * points.sum::<f64>() / 16.0
    };
    stress.points.iter().enumerate().map(one).collect()
}
