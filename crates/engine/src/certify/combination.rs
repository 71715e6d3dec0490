//! A lower bound of the load factor on actions, from lower bounds on other actions of the same
//! model.
//!
//! Stresses that are admissible without friction form a convex set, which contains zero where no
//! dead load acts. So do the actions in equilibrium with them. If the set contains `λ_i a_i` of
//! some actions `a_i`, it contains `λ a` with `a = Σ μ_i λ_i a_i`, `μ_i ≥ 0` and `λ = 1/Σ μ_i`: the
//! stresses add up with the weights `λ μ_i`, whose sum is 1.

use bracket_base::math::Sum;

/// Largest difference between the actions and the sum that makes them, relative to the largest
/// force or moment of the parts. It is rounding: stress fields are in equilibrium to a tolerance
/// that is a thousand times larger.
pub const ROUNDING: f64 = 1e-12;

/// Actions that are carried, with their load factor λ_i and their weight μ_i.
#[derive(Clone, Copy, Debug)]
pub struct Part<'a> {
    /// A force and a moment on every rigid face \[N, N mm\].
    pub actions: &'a [[f64; 6]],
    /// Strict lower bound of their load factor.
    pub factor: f64,
    /// Weight, not negative.
    pub weight: f64,
}

/// The lower bound on `actions`, rounded down; `None` where the parts do not add up to them.
pub fn combined(parts: &[Part<'_>], actions: &[[f64; 6]]) -> Option<f64> {
    let sound = |p: &Part<'_>| {
        let numbers = p.weight >= 0.0 && p.factor >= 0.0 && (p.weight * p.factor).is_finite();
        numbers && p.actions.len() == actions.len()
    };
    if parts.is_empty() || !parts.iter().all(sound) {
        return None;
    }
    for (face, wanted) in actions.iter().enumerate() {
        for (k, wanted) in wanted.iter().enumerate() {
            let here = |p: &Part<'_>| p.weight * p.factor * p.actions[face][k];
            let sum = Sum::of(parts.iter().map(here));
            let right = (sum - wanted).abs() <= ROUNDING * size(parts, k);
            if !right {
                return None;
            }
        }
    }
    let total = Sum::of(parts.iter().map(|p| p.weight));
    // the difference that is allowed changes the factor by no more
    let factor = (1.0 - ROUNDING) / total;
    (total > 0.0 && factor.is_finite()).then(|| factor.next_down())
}

/// The largest force (of moments: the largest moment) among the parts.
fn size(parts: &[Part<'_>], component: usize) -> f64 {
    let kind = if component < 3 { 0..3 } else { 3..6 };
    let of = |p: &Part<'_>| {
        let all = p.actions.iter().flat_map(|a| &a[kind.clone()]);
        p.weight * p.factor * all.fold(0.0f64, |m, x| m.max(x.abs()))
    };
    parts.iter().map(of).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(actions: &[[f64; 6]], factor: f64, weight: f64) -> Part<'_> {
        Part { actions, factor, weight }
    }

    fn face(force: f64, moment: f64) -> Vec<[f64; 6]> {
        vec![[force, 0.0, 0.0, 0.0, moment, 0.0]]
    }

    /// On the line between two carried loads, and inside of it.
    #[test]
    fn loads_between_two_that_are_carried() {
        let (m, n) = (face(0.0, 100.0), face(10.0, 0.0));
        // m carried twice, n three times: half of each is carried
        let target = face(15.0, 100.0);
        let parts = [part(&m, 2.0, 0.5), part(&n, 3.0, 0.5)];
        let bound = combined(&parts, &target).expect("they add up");
        assert!(bound < 1.0 && bound > 1.0 - 1e-11, "{bound}");
        // a tenth of it
        let tenth = face(1.5, 10.0);
        let parts = [part(&m, 2.0, 0.05), part(&n, 3.0, 0.05)];
        let bound = combined(&parts, &tenth).expect("they add up");
        assert!((bound - 10.0).abs() < 1e-9, "{bound}");
    }

    #[test]
    fn what_does_not_add_up_proves_nothing() {
        let (m, n) = (face(0.0, 100.0), face(10.0, 0.0));
        let target = face(15.0, 100.0);
        let with = |a: f64, b: f64| [part(&m, 2.0, a), part(&n, 3.0, b)];
        assert!(combined(&with(0.5, 0.5 + 1e-9), &target).is_none(), "too much of one");
        assert!(combined(&with(0.5, f64::NAN), &target).is_none());
        assert!(combined(&[part(&m, 2.0, 0.7), part(&m, 2.0, -0.2)], &face(0.0, 100.0)).is_none());
        assert!(combined(&[part(&m, f64::INFINITY, 0.5)], &face(0.0, 100.0)).is_none());
        assert!(combined(&[], &target).is_none());
        assert!(combined(&with(0.0, 0.0), &face(0.0, 0.0)).is_none(), "no load has no factor");
        assert!(combined(&[part(&m, 2.0, 0.5)], &[[0.0; 6]; 2]).is_none(), "another face");
    }
}
