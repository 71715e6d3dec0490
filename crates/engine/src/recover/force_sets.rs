//! Sets that interface forces must stay in, and the balance of forces inside them.

use crate::programs::conic::{ConicProgram, cone_margin};
use bracket_base::math::Sum;
use bracket_base::math::dense::{Mat, pseudo_solve};

/// Fraction of a strength that is kept free for rounding.
const ROOM: f64 = 1e-11;

/// First row and number of rows of each contact cone.
pub(crate) fn cone_ranges(program: &ConicProgram) -> Vec<(usize, usize)> {
    let contacts = program.g.nrows();
    let all = program.cone_starts().into_iter().zip(&program.cones);
    all.take_while(|(start, _)| *start < contacts).map(|(s, c)| (s, c.dim())).collect()
}

/// A set that a force must stay in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Within {
    /// The second-order cone, or the half-line, of `dim` rows from `start` on; the pressure, its
    /// first row, is at most `most`.
    Cone { start: usize, dim: usize, most: f64 },
    /// The ball of radius `radius`: three rows.
    Ball { start: usize, radius: f64 },
}

impl Within {
    /// First row and number of rows.
    pub fn range(self) -> (usize, usize) {
        match self {
            Within::Cone { start, dim, .. } => (start, dim),
            Within::Ball { start, .. } => (start, 3),
        }
    }

    /// Shortens a force to at most `1 − margin` of the radius of a ball or of the largest pressure.
    pub fn draw_in(self, z: &mut [f64], margin: f64) {
        let (start, dim) = self.range();
        let force = &mut z[start..start + dim];
        let (size, room) = match self {
            Within::Cone { most, .. } => (force[0], (1.0 - margin) * most),
            Within::Ball { radius, .. } => (norm(force), (1.0 - margin) * radius),
        };
        if size > room {
            force.iter_mut().for_each(|x| *x *= room / size);
        }
    }

    /// Moves a force to the nearest one in the set with a margin relative to the pressure in a cone
    /// and to the strength in a ball.
    pub fn move_in(self, z: &mut [f64], margin: f64) {
        if let Within::Cone { start, dim, .. } = self {
            into_cone(&mut z[start..start + dim], 1.0 - margin);
        }
        self.draw_in(z, margin);
    }

    /// Distance to the surface, with the room for rounding subtracted; negative outside.
    fn margin(self, z: &[f64]) -> f64 {
        let (start, dim) = self.range();
        let force = &z[start..start + dim];
        match self {
            Within::Cone { most, .. } => cone_margin(force).min((1.0 - ROOM) * most - force[0]),
            Within::Ball { radius, .. } => (1.0 - ROOM) * radius - norm(force),
        }
    }

    /// The inverse Hessian of the set's barrier at `z` times `r`: `z zᵀ − ½ det(z) J` of a cone (z²
    /// of the half-line), smaller towards a largest pressure; `½ d (I − 2 z zᵀ/(d + 2 ‖z‖²))` with
    /// `d = radius² − ‖z‖²` of a ball.
    fn metric(self, z: &[f64], r: &[f64], out: &mut [f64]) {
        let along: f64 = z.iter().zip(r).map(|(a, b)| a * b).sum();
        match self {
            Within::Cone { dim, most, .. } => {
                let half_det = if dim == 1 {
                    0.0
                } else {
                    0.5 * cone_margin(z).max(0.0) * (2.0 * z[0] - cone_margin(z))
                };
                for i in 0..dim {
                    let j = if i == 0 { 1.0 } else { -1.0 };
                    out[i] = z[i] * along - half_det * j * r[i];
                }
                if most.is_finite() {
                    // the barrier has one more term, −log(most − z₀)
                    let (first, room) = (z[0] * z[0] - half_det, most - z[0]);
                    let taken = out[0] / (room * room + first).max(f64::MIN_POSITIVE);
                    out[0] -= taken * first;
                    (1..dim).for_each(|i| out[i] -= taken * z[i] * z[0]);
                }
            }
            Within::Ball { radius, .. } => {
                let size = norm(z);
                let d = ((radius - size) * (radius + size)).max(0.0);
                let taken = 2.0 * along / (d + 2.0 * size * size).max(f64::MIN_POSITIVE);
                (0..3).for_each(|i| out[i] = 0.5 * d * (r[i] - taken * z[i]));
            }
        }
    }
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Moves `s` to the nearest point of the cone `‖s₁…‖ ≤ slope s₀`.
pub(crate) fn into_cone(s: &mut [f64], slope: f64) {
    let (n, t) = (s[0], s[1..].iter().map(|x| x * x).sum::<f64>().sqrt());
    if n <= -slope * t {
        s.fill(0.0);
    } else if t > slope * n {
        s[0] = (n + slope * t) / (1.0 + slope * slope);
        // slightly below the slope, because the root above is rounded
        let shorter = slope * (1.0 - 1e-15) * s[0] / t;
        s[1..].iter_mut().for_each(|x| *x *= shorter);
    }
}

/// Corrects `z` by the smallest change in the Dikin metric of each set that makes
/// `rows · z = needed`; true when every force is still in its set.
///
/// In the inverse Hessian of a cone's barrier, a force near the surface of the cone grows or
/// shrinks easily along itself and hardly moves out of the cone; a change of length below 1 stays
/// inside.
pub(crate) fn balance(sets: &[Within], rows: &[Vec<f64>], needed: &[f64], z: &mut [f64]) -> bool {
    let n = rows.len();
    for _ in 0..3 {
        let weighted: Vec<Vec<f64>> = rows
            .iter()
            .map(|row| {
                let mut w = vec![0.0; z.len()];
                for set in sets {
                    let (s, d) = set.range();
                    set.metric(&z[s..s + d], &row[s..s + d], &mut w[s..s + d]);
                }
                w
            })
            .collect();
        let dot = |a: &[f64], b: &[f64]| Sum::of(a.iter().zip(b).map(|(a, b)| a * b));
        let gram = Mat::from_fn(n, n, |i, j| dot(&rows[i], &weighted[j]));
        let missing = Mat::from_fn(n, 1, |i, _| needed[i] - dot(&rows[i], z));
        // a mode without contacts has a zero row here; the pseudo-inverse does not change it
        let multipliers = pseudo_solve(&gram, &missing);
        for r in 0..z.len() {
            z[r] += (0..n).map(|i| weighted[i][r] * multipliers[(i, 0)]).sum::<f64>();
        }
    }
    sets.iter().all(|set| set.margin(z) >= 0.0)
}
