//! Where the lower bound is held down, or will be after the next mesh.
//!
//! The multipliers of the static program are a mechanism, and a finer mesh gains where the present
//! one resolves it badly ([`super::mechanism_error`]). A joint has other mechanisms of almost the
//! same load factor: two equal plates, for instance. A mesh that follows one alone lifts it, and
//! the next one limits the bound. At an earlier stage of an interior-point solve slack s and
//! multiplier z have the product μ: then `z = μ / s` shows them all. So tets near yield get the
//! weight `δ / (s + δ)` per volume and yield strength, s the slack of the utilisation at a point of
//! a tet.

use crate::certify::fields::StressField;
use crate::certify::plastic_field::length;
use crate::elements::super_element::PointStress;
use crate::mesh::TetMesh;
use crate::model::AnalysisModel;
use bracket_base::math::mandel::deviator;

/// The slack δ of the utilisation at which a tet has half of the weight of a yielding one.
const SLACK: f64 = 0.03;

/// Part of the estimate that goes to tets near yield; the rest follows the mechanism.
const PART: f64 = 0.05;

/// The shares of the tets in what holds the lower bound down, with the sum 1: the `errors` of the
/// mechanism, and their nearness to yield under `stress`.
pub fn shares(model: &AnalysisModel, errors: Vec<f64>, stress: Option<&StressField>) -> Vec<f64> {
    let near = stress.map(|s| weights(&model.mesh, &model.yield_radii(), s));
    mixed(errors, near)
}

fn mixed(errors: Vec<f64>, near: Option<Vec<f64>>) -> Vec<f64> {
    let errors = normal(errors);
    let Some(near) = near.map(normal) else { return errors };
    errors.iter().zip(near).map(|(e, n)| (1.0 - PART) * e + PART * n).collect()
}

fn normal(mut x: Vec<f64>) -> Vec<f64> {
    let sum: f64 = x.iter().sum();
    if sum > 0.0 {
        x.iter_mut().for_each(|x| *x /= sum);
    }
    x
}

/// Volume times yield strength times `δ / (s + δ)`; zero in rigid bodies.
fn weights(mesh: &TetMesh, radii: &[Option<f64>], stress: &StressField) -> Vec<f64> {
    let one = |(e, points): (usize, &PointStress)| {
        let Some(radius) = radii[mesh.tet_body[e] as usize] else { return 0.0 };
        let points = points.iter().flatten().map(|s| {
            let slack = (1.0 - length(&deviator(s)) / radius).max(0.0);
            SLACK / (slack + SLACK)
        });
        mesh.volume(e) * radius * points.sum::<f64>() / 16.0
    };
    stress.points.iter().enumerate().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::fixtures::cubes;
    use bracket_base::math::mandel::yield_radius;

    /// A tet at yield outweighs one of the same volume at half of it as 1 to δ / (½ + δ);
    /// errors keep their part, also of a tet without stress. All shares sum to 1.
    #[test]
    fn tets_at_yield_outweigh_others() {
        let mesh = cubes(&[([0, 0, 0], "B")]);
        let n = mesh.tets.len();
        let mut stress = StressField::none(n);
        for (e, s) in [(0, 100.0), (1, 50.0)] {
            stress.points[e] = [[[s, 0.0, 0.0, 0.0, 0.0, 0.0]; 4]; 4];
        }
        let mut errors = vec![0.0; n];
        errors[2] = 3.0;
        let near = weights(&mesh, &[Some(yield_radius(100.0))], &stress);
        let shares = mixed(errors, Some(near));
        assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        assert!((shares[1] / shares[0] - SLACK / (0.5 + SLACK)).abs() < 1e-12, "{shares:?}");
        assert!(shares[2] > 1.0 - PART && shares[3] < 0.1 * PART, "{shares:?}");
    }
}
