//! A sequence of meshes: the one for both bounds, or the one for the lower or the upper bound.
//!
//! In limit analysis each bound has meshes of its own, because the mechanism of the static
//! program's multipliers and that of the kinematic program lie in different places. Both bounds are
//! strict on any mesh of the same body. The gap between them is divided: each bound has its error.
//! The error is estimated from the last gain. If the design promised that the fraction f of the
//! error remains and the bound gained Δ, the remaining error is `Δ f / (1 − f)`.

use crate::model::file::Bounds;
use crate::refine::plan::Step;

/// Least share of the gap that is assigned to a bound: a bound that gained nothing on its last mesh
/// is not exact.
const LEAST_SHARE: f64 = 0.15;

/// A sequence of meshes.
#[derive(Clone, Debug)]
pub struct Track {
    /// The bounds computed on its meshes.
    pub bounds: Bounds,
    /// Its passes that gave a bound. The gap of a step is that of the bracket; for one bound alone
    /// it is twice its error over the lower bound, so that the mean over both tracks is the gap of
    /// the bracket.
    pub steps: Vec<Step>,
    /// The bound of each step, relative to the first lower bound.
    values: Vec<f64>,
}

impl Track {
    /// A track that has made no mesh yet.
    pub fn new(bounds: Bounds) -> Self {
        Self { bounds, steps: Vec::new(), values: Vec::new() }
    }

    /// Adds a pass; `value`: its bound.
    pub fn push(&mut self, step: Step, value: f64) {
        self.steps.push(step);
        self.values.push(value);
    }

    /// Error of the last bound, estimated from its last gain; `None` with fewer than two meshes.
    fn error(&self) -> Option<f64> {
        let ([.., before, last], [.., a, b]) = (&self.values[..], &self.steps[..]) else {
            return None;
        };
        let left = (b.predicted?.ideal_gap / a.gap).clamp(0.05, 0.95);
        Some((last - before).abs() * left / (1.0 - left))
    }
}

/// Divides the gap of the bracket, `upper − lower`, between the tracks of its two bounds: sets the
/// gap of the last step of each. `lower` is the lower bound.
pub fn divide(tracks: [&mut Track; 2], gap: f64, lower: f64) {
    let errors = [tracks[0].error(), tracks[1].error()];
    let share = match errors {
        [Some(a), Some(b)] if a + b > 0.0 => a / (a + b),
        [Some(a), None] => a / gap,
        [None, Some(b)] => 1.0 - b / gap,
        _ => 0.5,
    };
    let share = share.clamp(LEAST_SHARE, 1.0 - LEAST_SHARE);
    for (track, share) in tracks.into_iter().zip([share, 1.0 - share]) {
        if let Some(step) = track.steps.last_mut() {
            step.gap = 2.0 * share * gap / lower.abs();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::refine::plan::Prediction;

    fn step(gap: f64, promised: Option<f64>) -> Step {
        let predicted = promised.map(|p| Prediction {
            tets: 2.0,
            gap: p,
            ideal_gap: p,
            seconds: 1.0,
            first_of_two: false,
        });
        Step { tets: 1, gap, seconds: 1.0, bytes: 0, predicted }
    }

    fn tracks() -> [Track; 2] {
        let mut both = [Track::new(Bounds::Static), Track::new(Bounds::Kinematic)];
        both[0].push(step(0.4, None), 1.0);
        both[1].push(step(0.4, None), 1.4);
        both
    }

    fn split(both: &mut [Track; 2], gap: f64, lower: f64) {
        let [a, b] = both;
        divide([a, b], gap, lower);
    }

    /// Bounds `1.2 − e` and `1.2 + 3 e` that halve their errors: the gap is divided 1 : 3, and the
    /// mean of both gaps is that of the bracket.
    #[test]
    fn gains_divide_the_gap() {
        let mut both = tracks();
        split(&mut both, 0.4, 1.0);
        assert_eq!(both.each_ref().map(|t| t.steps[0].gap), [0.4, 0.4]);
        let error = [0.1, 0.3];
        for (i, sign) in [-1.0, 1.0].into_iter().enumerate() {
            both[i].values[0] = 1.2 + sign * error[i];
            both[i].push(step(0.4, Some(0.2)), 1.2 + sign * 0.5 * error[i]);
        }
        let (lower, upper) = (1.15, 1.35);
        split(&mut both, upper - lower, lower);
        let gaps = both.each_ref().map(|t| t.steps[1].gap);
        assert!((gaps[1] / gaps[0] - 3.0).abs() < 1e-12, "{gaps:?}");
        assert!((0.5 * (gaps[0] + gaps[1]) - 0.2 / 1.15).abs() < 1e-12, "{gaps:?}");
    }

    /// A bound that gains nothing keeps the least share; the other one the rest.
    #[test]
    fn a_bound_that_gains_nothing() {
        let mut both = tracks();
        both[0].push(step(0.4, Some(0.2)), 1.0);
        split(&mut both, 0.4, 1.0);
        let gaps = [both[0].steps[1].gap, both[1].steps[0].gap];
        assert!((gaps[0] - 2.0 * LEAST_SHARE * 0.4).abs() < 1e-12, "{gaps:?}");
        assert!((gaps[1] - 2.0 * (1.0 - LEAST_SHARE) * 0.4).abs() < 1e-12, "{gaps:?}");
    }
}
