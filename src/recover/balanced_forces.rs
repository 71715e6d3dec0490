//! Interface forces nearest to given ones that stay in their sets and have given resultants.
//!
//! `min ½‖z − z₀‖²` with `A z = b` and z in a product K of convex sets. A row of A is a rigid
//! motion that only contact resists, so A has many columns and few rows. The dual problem has one
//! unknown per row: z = Π_K(z₀ + Aᵀ y), where y makes `A z = b`. A semismooth Newton method finds
//! y; with half-lines alone it is an active-set method and ends after finitely many steps. Every
//! iterate is in K.

use crate::math::Sum;
use crate::math::dense::{self, Mat, symmetric_eigen};
use crate::recover::force_sets::Within;

/// Largest number of Newton steps.
const STEPS: usize = 200;
/// Directions of the rows whose Gram value is below this, over the largest, are rounding: motions
/// that no contact resists.
const RANK: f64 = 1e-14;
/// Resultants left open at which the steps end, over the size of the forces.
const EXACT: f64 = 1e-15;
/// Resultants left open that count as rounding.
const ROUNDING: f64 = 1e-13;
/// Largest resultants left open, if none of the attempts ends at rounding: a tenth of the residual
/// of a strict bound. The certificate judges the result.
const SMALL: f64 = 1e-10;
/// Forces below this part of the largest are made zero, the first part with which a balance is
/// found. Where cones admit no other force than zero, the steps approach it slowly.
const NOTHING: [f64; 5] = [0.0, 1e-9, 1e-8, 1e-7, 1e-6];
/// Parts of the margin, the first with which a balance is found. Where only forces on the surface
/// of a cone balance the loads (a block that is pushed with exactly its friction), the whole margin
/// leaves a resultant of its size open.
const MARGINS: [f64; 2] = [1.0, 1e-3];

/// The rows in an orthonormal basis, stored force by force.
struct Rows {
    /// Number of rows.
    count: usize,
    /// Entry of force i in row r at `i · count + r`.
    of_force: Vec<f64>,
    /// Resultants needed in the basis.
    needed: Vec<f64>,
    /// Each row of the basis in terms of the given rows.
    from_given: Vec<Vec<f64>>,
}

impl Rows {
    fn new(rows: &[Vec<f64>], needed: &[f64]) -> Self {
        let n = rows.len();
        let forces = rows.first().map_or(0, Vec::len);
        let dot = |a: &[f64], b: &[f64]| Sum::of(a.iter().zip(b).map(|(a, b)| a * b));
        let gram = Mat::from_fn(n, n, |i, j| dot(&rows[i], &rows[j]));
        let (values, vectors) = symmetric_eigen(&gram);
        let largest = values.iter().fold(0.0f64, |m, v| m.max(*v));
        let from_given: Vec<Vec<f64>> = (0..n)
            .filter(|&k| values[k] > RANK * largest)
            .map(|k| vectors[k].iter().map(|v| v / values[k].sqrt()).collect())
            .collect();
        let count = from_given.len();
        let mut of_force = vec![0.0; forces * count];
        for (r, c) in from_given.iter().enumerate() {
            for (row, c) in rows.iter().zip(c) {
                (0..forces).for_each(|i| of_force[i * count + r] += c * row[i]);
            }
        }
        let needed = from_given.iter().map(|c| dot(c, needed)).collect();
        Self { count, of_force, needed, from_given }
    }

    fn force(&self, i: usize) -> &[f64] {
        &self.of_force[i * self.count..][..self.count]
    }
}

/// A point of the dual problem.
struct Point {
    /// Forces before their projection into the sets.
    free: Vec<f64>,
    /// Forces inside the sets.
    z: Vec<f64>,
    /// Resultants that the forces have beyond the needed ones.
    excess: Vec<f64>,
    /// Dual function, which the solution makes smallest.
    value: f64,
}

impl Point {
    fn at(y: &[f64], sets: &Sets, rows: &Rows, start: &[f64]) -> Self {
        let free: Vec<f64> = (0..start.len())
            .map(|i| start[i] + Sum::of(rows.force(i).iter().zip(y).map(|(a, y)| a * y)))
            .collect();
        let mut z = free.clone();
        sets.kept.iter().for_each(|set| set.project(&mut z, sets.margin));
        for (first, dim) in sets.dropped.iter().map(|set| set.range()) {
            z[first..first + dim].fill(0.0);
        }
        let mut sums: Vec<Sum> = vec![Sum::default(); rows.count];
        for (i, z) in z.iter().enumerate().filter(|(_, z)| **z != 0.0) {
            rows.force(i).iter().zip(&mut sums).for_each(|(a, sum)| sum.add(a * z));
        }
        for (sum, needed) in sums.iter_mut().zip(&rows.needed) {
            sum.add(-needed);
        }
        let excess: Vec<f64> = sums.into_iter().map(Sum::value).collect();
        // ½‖x‖² − ½‖x − Πx‖² has the gradient Πx
        let value = Sum::of(free.iter().zip(&z).map(|(x, z)| z * (x - 0.5 * z)))
            - Sum::of(rows.needed.iter().zip(y).map(|(b, y)| b * y));
        Self { free, z, excess, value }
    }

    fn open(&self) -> f64 {
        norm(&self.excess)
    }
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Resultants that no forces inside their sets have.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Open {
    /// The combination of the given rows whose resultant stays open.
    pub direction: Vec<f64>,
    /// Size of what stays open, over the size of all forces.
    pub part: f64,
}

/// The forces inside `sets` that are nearest to `start` and have the resultants `rows · z =
/// needed`; a cone is narrowed and a ball made smaller by `margin`, or by a thousandth of it where
/// the margin makes a balance impossible.
pub(crate) fn balanced_forces(
    sets: &[Within],
    rows: &[Vec<f64>],
    needed: &[f64],
    start: &[f64],
    margin: f64,
) -> Result<Vec<f64>, Open> {
    let rows = Rows::new(rows, needed);
    let size = norm(start).max(norm(&rows.needed));
    let mut best: Option<Point> = None;
    let attempts = MARGINS.iter().flat_map(|part| NOTHING.map(|least| (part * margin, least)));
    for (margin, least) in attempts {
        let forces = best.as_ref().map_or(start, |p| &p.z);
        let least = least * forces.iter().fold(0.0f64, |m, z| m.max(z.abs()));
        let force = |set: &Within| norm(&forces[set.range().0..][..set.range().1]);
        let (kept, dropped) = sets.iter().partition(|set| force(set) >= least);
        let found = nearest(&Sets { kept, dropped, margin }, &rows, start, size);
        if best.as_ref().is_none_or(|p| found.open() < p.open()) {
            best = Some(found);
        }
        if best.as_ref().is_some_and(|p| p.open() <= ROUNDING * size) {
            break;
        }
    }
    let Some(point) = best else { return Ok(start.to_vec()) };
    if point.open() <= SMALL * size {
        return Ok(point.z);
    }
    let mut direction = vec![0.0; needed.len()];
    for (f, c) in point.excess.iter().zip(&rows.from_given) {
        direction.iter_mut().zip(c).for_each(|(d, c)| *d += f * c);
    }
    Err(Open { direction, part: point.open() / size })
}

/// The sets of the forces; those of dropped sets are zero.
struct Sets {
    kept: Vec<Within>,
    dropped: Vec<Within>,
    margin: f64,
}

/// The end of the Newton steps.
fn nearest(sets: &Sets, rows: &Rows, start: &[f64], size: f64) -> Point {
    let mut y = vec![0.0; rows.count];
    let mut point = Point::at(&y, sets, rows, start);
    for _ in 0..STEPS {
        if point.open() <= EXACT * size {
            break;
        }
        let step = newton_step(&point, sets, rows, size);
        let slope: f64 = step.iter().zip(&point.excess).map(|(d, f)| d * f).sum();
        let mut length = 1.0;
        let mut next = None;
        for _ in 0..40 {
            let trial: Vec<f64> = y.iter().zip(&step).map(|(y, d)| y + length * d).collect();
            let there = Point::at(&trial, sets, rows, start);
            // near the solution the dual function is flat to rounding
            if there.open() <= (1.0 - 0.1 * length) * point.open()
                || there.value < point.value + 1e-4 * length * slope
            {
                next = Some((trial, there));
                break;
            }
            length *= 0.5;
        }
        let Some((trial, there)) = next else { break };
        (y, point) = (trial, there);
    }
    point
}

/// The step to the zero of the linearised excess, damped as long as the excess is large.
fn newton_step(p: &Point, sets: &Sets, rows: &Rows, size: f64) -> Vec<f64> {
    let n = rows.count;
    let mut h = Mat::<f64>::zeros(n, n);
    for set in &sets.kept {
        let (first, dim) = set.range();
        let slope = set.slope(&p.free[first..first + dim], sets.margin);
        for (a, row) in slope.iter().enumerate().take(dim) {
            for (b, &d) in row.iter().enumerate().take(dim).filter(|(_, d)| **d != 0.0) {
                let (fa, fb) = (rows.force(first + a), rows.force(first + b));
                for (i, x) in fa.iter().enumerate().filter(|(_, x)| **x != 0.0) {
                    (0..n).for_each(|j| h[(i, j)] += x * d * fb[j]);
                }
            }
        }
    }
    // the rows are orthonormal, so that no entry exceeds 1
    let damping = 1e-3 * (p.open() / size.max(f64::MIN_POSITIVE)).min(1.0) + 1e-13;
    (0..n).for_each(|i| h[(i, i)] += damping);
    let rhs = Mat::from_fn(n, 1, |i, _| -p.excess[i]);
    let step = dense::solve(&h, &rhs);
    (0..n).map(|i| step[(i, 0)]).collect()
}

#[cfg(test)]
mod tests;
