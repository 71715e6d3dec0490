//! Scales that make a program's numbers dimensionless before a solver sees them.

use crate::model::program::ConicProgram;

/// Scales of a program: `x_i = size·columns_i·x̂_i`, `z = size·rows·ẑ`.
pub struct Scales {
    /// Scale of each unknown.
    columns: Vec<f64>,
    /// Size of the answer.
    size: f64,
    /// Scale of each row.
    rows: Vec<f64>,
}

impl Scales {
    /// Chooses the scales.
    pub fn new(program: &ConicProgram) -> Self {
        // every unknown is measured in the give of its own stiffness: soft parts on hard ones are no trouble
        let diagonal = program.p.diagonal();
        let mean = (diagonal.iter().sum::<f64>() / diagonal.len().max(1) as f64).max(f64::MIN_POSITIVE);
        let columns: Vec<f64> = diagonal.iter().map(|d| d.max(1e-14 * mean).sqrt().recip()).collect();
        let load = program.q.iter().zip(&columns).fold(0.0f64, |m, (q, c)| m.max((q * c).abs()));
        let mut rows = vec![1.0; program.h.len()];
        for (start, cone) in program.cone_starts().into_iter().zip(&program.cones) {
            let range = start..start + cone.dim();
            let largest = range
                .clone()
                .flat_map(|r| program.g.row(r))
                .map(|(c, v)| (v * columns[c]).abs())
                .fold(0.0f64, f64::max);
            rows[range].fill(if largest > 0.0 { 1.0 / largest } else { 1.0 });
        }
        let offset = program.h.iter().zip(&rows).map(|(h, s)| (h * s).abs()).fold(0.0f64, f64::max);
        // the scaled loads are 1, or the largest gap is when nothing is loaded
        let size = if load > 0.0 {
            load
        } else if offset > 0.0 {
            offset
        } else {
            1.0
        };
        Self { columns, size, rows }
    }

    /// The scaled program: unit stiffness of every unknown, unit largest load, unit largest entry in the rows of each cone.
    pub fn apply(&self, program: &ConicProgram) -> ConicProgram {
        let mut p = program.p.clone();
        for c in 0..p.n {
            for k in p.col_ptr[c]..p.col_ptr[c + 1] {
                p.values[k] *= self.columns[c] * self.columns[p.row_idx[k] as usize];
            }
        }
        let mut g = program.g.clone();
        for r in 0..program.h.len() {
            for k in g.row_ptr[r]..g.row_ptr[r + 1] {
                g.values[k] *= self.rows[r] * self.columns[g.col_idx[k]];
            }
        }
        ConicProgram {
            p,
            q: program.q.iter().zip(&self.columns).map(|(v, c)| v * c / self.size).collect(),
            c: 0.0,
            g,
            h: program.h.iter().zip(&self.rows).map(|(h, r)| h * r / self.size).collect(),
            cones: program.cones.clone(),
            stage: program.stage.clone(),
            maximised: program.maximised.clone(),
        }
    }

    /// Unknowns in the program's units.
    pub fn unscale_x(&self, x: &[f64]) -> Vec<f64> {
        x.iter().zip(&self.columns).map(|(x, c)| x * c * self.size).collect()
    }

    /// Multipliers in the program's units.
    pub fn unscale_z(&self, z: &[f64]) -> Vec<f64> {
        z.iter().zip(&self.rows).map(|(z, r)| z * r * self.size).collect()
    }
}
