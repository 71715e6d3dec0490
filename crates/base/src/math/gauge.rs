//! The gauge of a polytope: with which weights, of the smallest sum, do given points add up to
//! another one?
//!
//! Only this file and the component method use microlp.

use crate::math::dense::{Mat, least_squares};
use microlp::{ComparisonOp, OptimizationDirection, Problem};

/// Coordinates up to this size are rounding; coordinates are near 1.
const ZERO: f64 = 1e-13;
/// Weights up to this size may be noise of the linear program; the largest is about 1.
const NOISE: f64 = 1e-9;

/// Weights μ ≥ 0 of the smallest sum with `Σ μ_i points_i = target`, to rounding; `None` where no
/// weights give the target. The convex hull of the points and zero contains `target / Σ μ_i`.
///
/// Points and target have the same number of coordinates, scaled so that they are near 1.
pub fn gauge(points: &[Vec<f64>], target: &[f64]) -> Option<Vec<f64>> {
    let rows: Vec<(usize, f64)> =
        (0..target.len()).filter_map(|k| row(points, target, k)).collect();
    let mut program = Problem::new(OptimizationDirection::Minimize);
    let weights: Vec<_> =
        points.iter().map(|_| program.add_var(1.0, (0.0, f64::INFINITY))).collect();
    for &(k, size) in &rows {
        let terms: Vec<_> = weights.iter().zip(points).map(|(w, p)| (*w, p[k] / size)).collect();
        program.add_constraint(&terms[..], ComparisonOp::Eq, target[k] / size);
    }
    let solution = program.solve().ok()?.into_solution().ok()?;
    let found: Vec<f64> = weights.iter().map(|w| solution[*w]).collect();
    let largest = found.iter().fold(0.0f64, |m, w| m.max(*w));
    let used: Vec<usize> = (0..points.len()).filter(|&i| found[i] > NOISE * largest).collect();
    // the program leaves an error of 1e-9 or so; its points in use give the target exactly
    let matrix =
        Mat::from_fn(rows.len(), used.len(), |r, c| points[used[c]][rows[r].0] / rows[r].1);
    let wanted = Mat::from_fn(rows.len(), 1, |r, _| target[rows[r].0] / rows[r].1);
    if used.is_empty() || rows.len() < used.len() {
        return None;
    }
    let exact = least_squares(&matrix, &wanted);
    let mut out = vec![0.0; points.len()];
    for (c, &i) in used.iter().enumerate() {
        out[i] = exact[(c, 0)];
    }
    let sum = |k: usize| points.iter().zip(&out).map(|(p, w)| w * p[k]).sum::<f64>();
    let error = ZERO * (1.0 + out.iter().sum::<f64>());
    let right = (0..target.len()).all(|k| (sum(k) - target[k]).abs() <= error);
    (right && out.iter().all(|w| *w >= 0.0)).then_some(out)
}

/// A coordinate and the size of its largest value; `None` where it is zero everywhere.
fn row(points: &[Vec<f64>], target: &[f64], k: usize) -> Option<(usize, f64)> {
    let size = points.iter().fold(target[k].abs(), |m, p| m.max(p[k].abs()));
    (size > ZERO).then_some((k, size))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sum(weights: &[f64]) -> f64 {
        weights.iter().sum()
    }

    #[test]
    fn a_square_and_points_in_and_outside_of_it() {
        let square = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]].map(Vec::from);
        for (target, want) in [([0.25, 0.5], 0.75), ([-1.0, 1.0], 2.0), ([0.0, -0.1], 0.1)] {
            let found = gauge(&square, &target).expect("all directions are spanned");
            assert!((sum(&found) - want).abs() < 1e-14, "{target:?}: {found:?}");
        }
        assert_eq!(gauge(&square[..2], &[-0.1, 0.1]), None);
        assert_eq!(gauge(&[], &[1.0]), None);
    }

    /// Points on a line, and coordinates that are noise of rounding or that are small but real.
    #[test]
    fn proportional_points_and_small_coordinates() {
        let line = vec![vec![0.5, 1.0, 1e-16], vec![0.25, 0.5, 0.0]];
        let found = gauge(&line, &[0.125, 0.25, 2e-17]).expect("on the line");
        assert!((sum(&found) - 0.25).abs() < 1e-13, "{found:?}");
        let tilted = vec![vec![1.0, 1e-5], vec![1.0, -1e-5]];
        let found = gauge(&tilted, &[0.5, 2.5e-6]).expect("between both");
        assert!((found[0] - 0.375).abs() < 1e-12 && (found[1] - 0.125).abs() < 1e-12, "{found:?}");
        assert_eq!(gauge(&tilted, &[0.5, 6e-6]), None, "beyond the first");
    }

    proptest! {
        /// The weights give the target, and no hyperplane of a brute-force search separates less.
        #[test]
        fn weights_are_right_and_least(
            points in prop::collection::vec(prop::collection::vec(-1.0..1.0f64, 2), 3..9),
            target in prop::collection::vec(-1.0..1.0f64, 2),
        ) {
            // in the plane two points suffice: try every pair
            let mut best = f64::INFINITY;
            for (i, a) in points.iter().enumerate() {
                for b in &points[..i] {
                    let det = a[0] * b[1] - a[1] * b[0];
                    let s = (target[0] * b[1] - target[1] * b[0]) / det;
                    let t = (a[0] * target[1] - a[1] * target[0]) / det;
                    if det.abs() > 1e-3 && s >= 0.0 && t >= 0.0 {
                        best = best.min(s + t);
                    }
                }
            }
            match gauge(&points, &target) {
                Some(found) => {
                    for k in 0..2 {
                        let sum: f64 = points.iter().zip(&found).map(|(p, w)| p[k] * w).sum();
                        prop_assert!((sum - target[k]).abs() < 1e-12);
                    }
                    prop_assert!(sum(&found) <= best * (1.0 + 1e-9));
                }
                None => prop_assert!(best == f64::INFINITY || best > 50.0, "{best}"),
            }
        }
    }
}
