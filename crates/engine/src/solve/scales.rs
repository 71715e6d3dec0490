//! Scales that make the numbers of a program dimensionless before a solve.

use crate::programs::conic::{ConicProgram, Elements};

/// Scales of a program: `x_i = size·columns_i·x̂_i`, `z = size·rows·ẑ`.
///
/// Displacements, gaps and multipliers of yield points have one size; forces, stresses and
/// multipliers of contacts have another. Without elasticity the two sizes are independent.
pub struct Scales {
    /// Scale of each unknown.
    columns: Vec<f64>,
    /// Scale of each row.
    rows: Vec<f64>,
    /// Size of the motion.
    motion: f64,
    /// Size of the forces.
    force: f64,
    maximised: Vec<bool>,
    /// First row of the yield points.
    points: usize,
}

impl Scales {
    /// Chooses the scales.
    pub fn new(program: &ConicProgram) -> Self {
        // every unknown is scaled by its own stiffness, so that soft parts on stiff ones cause no
        // difficulty
        let stiffness = if program.stiffness.is_empty() {
            program.p.diagonal()
        } else {
            program.stiffness.clone()
        };
        let shared = &stiffness[..program.shared()];
        let least = 1e-14
            * (shared.iter().sum::<f64>() / shared.len().max(1) as f64).max(f64::MIN_POSITIVE);
        let mut columns: Vec<f64> = stiffness.iter().map(|d| d.max(least).sqrt().recip()).collect();
        let largest = |values: &[f64]| {
            values.iter().zip(&columns).fold(0.0f64, |m, (q, c)| m.max((q * c).abs()))
        };
        let load = largest(&program.q[..program.shared()]);
        let live = largest(&program.live);
        let mut rows = vec![1.0; program.h.len()];
        for (start, cone) in program.cone_starts().into_iter().zip(&program.cones) {
            if start >= program.g.nrows() {
                break;
            }
            let range = start..start + cone.dim();
            let largest = range
                .clone()
                .flat_map(|r| program.g.row(r))
                .map(|(c, v)| (v * columns[c]).abs())
                .fold(0.0f64, f64::max);
            rows[range].fill(if largest > 0.0 { 1.0 / largest } else { 1.0 });
        }
        let points = program.g.nrows();
        let offset = program.h[..points]
            .iter()
            .zip(&rows)
            .map(|(h, s)| (h * s).abs())
            .fold(0.0f64, f64::max);
        // the largest scaled load is 1, or the largest gap in a program without loads
        let size = match (load > 0.0, offset > 0.0) {
            (true, _) => load,
            (false, true) => offset,
            _ => 1.0,
        };
        let (mut motion, mut force) = (size, size);
        if live > 0.0 {
            // rigid-plastic: stresses are relative to the yield strength already, so that the
            // dissipation of a point is of the order of the load factor; a factor of ten either way
            // changes the count by one or two iterations
            columns.push(live.recip());
            let points = program.cones.len() as f64;
            (motion, force) = (live.recip() / points, 1.0);
        }
        Self { columns, rows, motion, force, maximised: program.maximised(), points }
    }

    /// The scaled program: unit stiffness of every unknown, unit largest load, unit largest entry
    /// in the rows of each cone.
    pub fn apply(&self, program: &ConicProgram) -> ConicProgram {
        let mut p = program.p.clone();
        for c in 0..p.n {
            for k in p.col_ptr[c]..p.col_ptr[c + 1] {
                p.values[k] *= self.columns[c]
                    * self.columns[p.row_idx[k] as usize]
                    * (self.motion / self.force);
            }
        }
        let mut g = program.g.clone();
        for r in 0..g.nrows() {
            for k in g.row_ptr[r]..g.row_ptr[r + 1] {
                g.values[k] *= self.rows[r] * self.columns[g.col_idx[k]];
            }
        }
        let factor = self.columns.last().copied().unwrap_or(1.0);
        let conjugate = |i: usize| if self.maximised[i] { self.motion } else { self.force };
        let scaled = |(i, (q, c)): (usize, (&f64, &f64))| q * c / conjugate(i);
        let yields = !program.elements.batches.is_empty();
        ConicProgram {
            p,
            q: program.q.iter().zip(&self.columns).enumerate().map(scaled).collect(),
            c: 0.0,
            g,
            h: self.scale_offsets(&program.h),
            cones: program.cones.clone(),
            elements: Elements {
                batches: program.elements.batches.clone(),
                scale: if yields { self.columns.clone() } else { Vec::new() },
            },
            live: program.live.iter().zip(&self.columns).map(|(f, c)| f * c * factor).collect(),
            stiffness: Vec::new(),
        }
    }

    /// Offsets of the rows, scaled.
    pub fn scale_offsets(&self, h: &[f64]) -> Vec<f64> {
        let offset = |r: usize| if r < self.points { self.motion } else { self.force };
        h.iter().zip(&self.rows).enumerate().map(|(i, (h, r))| h * r / offset(i)).collect()
    }

    /// Unknowns in the program's units.
    pub fn unscale_x(&self, x: &[f64]) -> Vec<f64> {
        let size = |i: usize| if self.maximised[i] { self.force } else { self.motion };
        x.iter().zip(&self.columns).enumerate().map(|(i, (x, c))| x * c * size(i)).collect()
    }

    /// Multipliers in the program's units.
    pub fn unscale_z(&self, z: &[f64]) -> Vec<f64> {
        let size = |r: usize| if r < self.points { self.force } else { self.motion };
        z.iter().zip(&self.rows).enumerate().map(|(r, (z, s))| z * s * size(r)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::programs::conic::SymmetricCsc;

    fn diagonal(values: &[f64]) -> SymmetricCsc {
        let n = values.len();
        SymmetricCsc {
            n,
            col_ptr: (0..=n).collect(),
            row_idx: (0..n as u32).collect(),
            values: values.to_vec(),
        }
    }

    /// Programs without yield points are scaled by their diagonal, at least 1e-14 of its mean.
    #[test]
    fn plain_programs_are_measured_by_their_diagonal() {
        let values = [4.0, 1e6, 0.0, 25.0];
        let program =
            ConicProgram { p: diagonal(&values), q: vec![1.0; 4], ..ConicProgram::default() };
        let mean = (4.0 + 1e6 + 0.0 + 25.0) / 4.0;
        let want = values.map(|d| 1.0 / f64::sqrt(d.max(1e-14 * mean)));
        assert_eq!(Scales::new(&program).columns, want);
    }
}
