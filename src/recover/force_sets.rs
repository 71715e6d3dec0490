//! Sets that interface forces must stay in.

use crate::programs::conic::ConicProgram;

/// First row and number of rows of each contact cone.
pub(crate) fn cone_ranges(program: &ConicProgram) -> Vec<(usize, usize)> {
    let contacts = program.g.nrows();
    let all = program.cone_starts().into_iter().zip(&program.cones);
    all.take_while(|(start, _)| *start < contacts).map(|(s, c)| (s, c.dim())).collect()
}

/// A set that a force must stay in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Within {
    /// The second-order cone, or the half-line, of `dim` rows from `start` on.
    Cone { start: usize, dim: usize },
    /// The ball of radius `radius`: three rows.
    Ball { start: usize, radius: f64 },
}

impl Within {
    /// First row and number of rows.
    pub fn range(self) -> (usize, usize) {
        match self {
            Within::Cone { start, dim } => (start, dim),
            Within::Ball { start, .. } => (start, 3),
        }
    }

    /// Moves its force to the nearest point of the set. A cone is narrowed, and a ball made
    /// smaller, by the fraction `margin`.
    pub fn project(self, z: &mut [f64], margin: f64) {
        let (start, dim) = self.range();
        let force = &mut z[start..start + dim];
        match self {
            Within::Cone { .. } => into_cone(force, 1.0 - margin),
            Within::Ball { radius, .. } => {
                let (size, room) = (norm(force), (1.0 - margin) * radius);
                if size > room {
                    force.iter_mut().for_each(|x| *x *= room / size);
                }
            }
        }
    }

    /// Derivative of [`Within::project`] at the force `x`: a symmetric matrix, of which a half-line
    /// uses the first entry.
    pub fn slope(self, x: &[f64], margin: f64) -> [[f64; 3]; 3] {
        const ONE: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        match self {
            Within::Cone { dim: 1, .. } if x[0] > 0.0 => ONE,
            Within::Cone { dim: 1, .. } => [[0.0; 3]; 3],
            Within::Cone { .. } => {
                let (n, t, k) = (x[0], norm(&x[1..]), 1.0 - margin);
                if t <= k * n {
                    return ONE;
                }
                if n <= -k * t {
                    return [[0.0; 3]; 3];
                }
                // projected: (p, k p u) with p = (n + k t)/(1 + k²) and u the direction of shear
                let along = 1.0 / (1.0 + k * k);
                let across = k * (n + k * t) * along / t;
                let g = [1.0, k * x[1] / t, k * x[2] / t];
                std::array::from_fn(|i| {
                    std::array::from_fn(|j| {
                        let turn = if i > 0 && j > 0 {
                            across * (ONE[i][j] - x[i] * x[j] / (t * t))
                        } else {
                            0.0
                        };
                        along * g[i] * g[j] + turn
                    })
                })
            }
            Within::Ball { radius, .. } => {
                let (size, room) = (norm(x), (1.0 - margin) * radius);
                if size <= room {
                    return ONE;
                }
                std::array::from_fn(|i| {
                    std::array::from_fn(|j| room / size * (ONE[i][j] - x[i] * x[j] / (size * size)))
                })
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
