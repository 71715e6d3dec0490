//! The fixed point `s = G(s)` of many unknowns by plain or accelerated (Anderson) steps.
//!
//! # Source
//! D. G. Anderson, Iterative procedures for nonlinear integral equations, J. ACM 12 (1965); in the
//! form of H. F. Walker and P. Ni, SIAM J. Numer. Anal. 49 (2011).

use std::collections::VecDeque;

/// Number of earlier steps that the acceleration uses.
const DEPTH: usize = 3;
/// Contraction of the plain steps above which steps are accelerated.
const SLOW: f64 = 0.5;
/// Growth of the change in an accelerated step above which the earlier steps are dropped.
const WORSE: f64 = 2.0;
/// Columns of the least-squares problem are dropped as dependent where the part orthogonal to the
/// others is smaller than this fraction of the column.
const DEPENDENT: f64 = 1e-8;

/// The iteration of a point `s ≥ 0`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FixedPoint {
    point: Vec<f64>,
    /// Points and their changes `G(s) − s`, oldest first.
    past: VecDeque<(Vec<f64>, Vec<f64>)>,
    /// `max |G(s) − s|` of each step, over the entries that count.
    changes: Vec<f64>,
    accelerated: bool,
    contraction: Option<f64>,
}

impl FixedPoint {
    /// Starts from zero.
    pub fn new(unknowns: usize) -> Self {
        Self { point: vec![0.0; unknowns], ..Self::default() }
    }

    /// Starts from a point.
    pub fn starting_at(point: Vec<f64>) -> Self {
        Self { point, ..Self::default() }
    }

    /// The present point.
    pub fn point(&self) -> &[f64] {
        &self.point
    }

    /// `max |G(s) − s|` at every point so far.
    pub fn changes(&self) -> &[f64] {
        &self.changes
    }

    /// Ratio of the changes of the last two plain steps; `None` before the second.
    pub fn contraction(&self) -> Option<f64> {
        self.contraction
    }

    /// Takes the image `G(s)` of the point and returns the change. Entries that do not count enter
    /// neither the change nor the weights of the acceleration. The point stays until
    /// [`Self::step`].
    pub fn image(&mut self, image: &[f64], counts: &[bool]) -> f64 {
        let change: Vec<f64> = image.iter().zip(&self.point).map(|(g, s)| g - s).collect();
        let size = counted(&change, counts).fold(0.0, |m: f64, x| m.max(x.abs()));
        if self.accelerated && self.changes.last().is_some_and(|last| size > WORSE * last) {
            self.past.clear();
        }
        self.changes.push(size);
        if let ([.., a, b], false) = (&self.changes[..], self.accelerated)
            && *a > 0.0
        {
            self.contraction = Some(b / a);
            self.accelerated = b / a > SLOW;
        }
        self.past.push_back((self.point.clone(), change));
        if self.past.len() > DEPTH + 1 {
            self.past.pop_front();
        }
        size
    }

    /// Goes to the next point.
    pub fn step(&mut self, counts: &[bool]) {
        let Some((point, change)) = self.past.back() else { return };
        let mut next: Vec<f64> = point.iter().zip(change).map(|(s, f)| s + f).collect();
        if self.accelerated {
            let pairs: Vec<_> = self.past.iter().zip(self.past.iter().skip(1)).collect();
            let differences: Vec<Vec<f64>> = pairs
                .iter()
                .map(|(a, b)| b.1.iter().zip(&a.1).map(|(b, a)| b - a).collect())
                .collect();
            for (k, weight) in least_squares(&differences, change, counts) {
                let (a, b) = pairs[k];
                for i in 0..next.len() {
                    next[i] -= weight * (b.0[i] - a.0[i] + differences[k][i]);
                }
            }
        }
        // a shift is the norm of a slip
        next.iter_mut().for_each(|s| *s = s.max(0.0));
        self.point = next;
    }
}

fn counted<'a>(v: &'a [f64], counts: &'a [bool]) -> impl Iterator<Item = f64> + 'a {
    v.iter().zip(counts).filter(|(_, c)| **c).map(|(x, _)| *x)
}

/// Weights of the columns whose sum is closest to `target`. Columns are added newest first,
/// dependent ones are left out.
fn least_squares(columns: &[Vec<f64>], target: &[f64], counts: &[bool]) -> Vec<(usize, f64)> {
    let dot = |a: &[f64], b: &[f64]| {
        bracket_base::math::Sum::of(
            a.iter().zip(b).zip(counts).filter(|(_, c)| **c).map(|((x, y), _)| x * y),
        )
    };
    // Gram–Schmidt: orthonormal columns, each with its weights of the original columns
    let mut basis: Vec<(Vec<f64>, Vec<f64>)> = Vec::new();
    for k in (0..columns.len()).rev() {
        let mut v = columns[k].clone();
        let mut made = vec![0.0; columns.len()];
        made[k] = 1.0;
        let before = dot(&v, &v).sqrt();
        for (q, of) in &basis {
            let along = dot(q, &v);
            v.iter_mut().zip(q).for_each(|(v, q)| *v -= along * q);
            made.iter_mut().zip(of).for_each(|(m, o)| *m -= along * o);
        }
        let left = dot(&v, &v).sqrt();
        if left > DEPENDENT * before {
            v.iter_mut().chain(&mut made).for_each(|x| *x /= left);
            basis.push((v, made));
        }
    }
    let mut weights = vec![0.0; columns.len()];
    for (q, of) in &basis {
        let along = dot(q, target);
        weights.iter_mut().zip(of).for_each(|(w, o)| *w += along * o);
    }
    weights.into_iter().enumerate().filter(|(_, w)| *w != 0.0).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps until the change is below `tolerance`.
    fn run(map: impl Fn(&[f64]) -> Vec<f64>, n: usize, tolerance: f64) -> FixedPoint {
        let mut f = FixedPoint::new(n);
        let counts = vec![true; n];
        for _ in 0..100 {
            let image = map(f.point());
            if f.image(&image, &counts) <= tolerance {
                break;
            }
            f.step(&counts);
        }
        f
    }

    /// `s ← 1 + c s` contracts by c: plain steps below a half, one accelerated step above it.
    #[test]
    fn one_unknown_contracts_as_it_must() {
        let slow = run(|s| vec![1.0 + 0.3 * s[0]], 1, 1e-9);
        assert!((slow.contraction().expect("two steps") - 0.3).abs() < 1e-6, "{slow:?}");
        assert!(
            (slow.point()[0] - 1.0 / 0.7).abs() < 2e-9 && slow.changes().len() > 10,
            "{slow:?}"
        );
        let fast = run(|s| vec![1.0 + 0.9 * s[0]], 1, 1e-9);
        assert!((fast.point()[0] - 10.0).abs() < 1e-7 && fast.changes().len() <= 4, "{fast:?}");
    }

    /// Three slow modes, a curved map and a diverging unknown that does not count.
    #[test]
    fn slow_modes_need_few_steps() {
        let map = |s: &[f64]| {
            let first: Vec<f64> =
                [0.95, 0.8, 0.6].iter().zip(s).map(|(c, s)| 0.2 + c * s - 1e-3 * s * s).collect();
            let wanders = 1.0 + 2.0 * s[3];
            vec![first[0], first[1], first[2], wanders.min(1e6)]
        };
        let mut f = FixedPoint::new(4);
        let counts = [true, true, true, false];
        let mut steps = 0;
        loop {
            let image = map(f.point());
            if f.image(&image, &counts) < 1e-9 || steps > 40 {
                break;
            }
            f.step(&counts);
            steps += 1;
        }
        assert!(steps <= 20, "{steps} steps");
        for (c, s) in [0.95, 0.8, 0.6].iter().zip(f.point()) {
            // s = 0.2 + c s − 0.001 s²
            let exact: f64 = 500.0 * ((c - 1.0) + f64::sqrt((1.0 - c) * (1.0 - c) + 8e-4));
            assert!((s - exact).abs() < 1e-6 * exact, "{s} against {exact}");
        }
    }
}
