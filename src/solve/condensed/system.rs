//! The condensed matrix `P + Gᵀ W⁻² G` of every iteration: one fixed pattern, one ordering, one symbolic factor.

use super::cones::{Cones, Scaling};
use crate::model::program::{ConicProgram, SymmetricCsc};
use crate::solve::forecast::Forecast;
use crate::solve::linear::{LinearError, SparseCholesky};

/// Columns of one cone's rows and where its products go in the matrix.
struct ConeMap {
    /// Distinct columns of the cone's rows.
    columns: Vec<usize>,
    /// Its rows as a dense block, `rows × columns`.
    rows: Vec<f64>,
    /// Position of entry (i ≤ j by column) in the matrix, packed by columns.
    positions: Vec<usize>,
}

/// The matrix, its factor and its fixed data.
pub struct CondensedSystem {
    matrix: SymmetricCsc,
    base: Vec<f64>,
    cones: Vec<ConeMap>,
    factor: SparseCholesky,
}

impl CondensedSystem {
    /// Lays out the pattern, ordering and symbolic factor.
    pub fn new(program: &ConicProgram, cones: &Cones, block: &[u32]) -> Result<Self, LinearError> {
        let columns: Vec<Vec<usize>> = cones
            .blocks
            .iter()
            .map(|&(s, d)| {
                let mut c: Vec<usize> = (s..s + d).flat_map(|r| program.g.row(r).map(|(c, _)| c)).collect();
                c.sort_unstable();
                c.dedup();
                c
            })
            .collect();
        let (matrix, base) = union(&program.p, &columns);
        let maps = columns
            .into_iter()
            .zip(&cones.blocks)
            .map(|(columns, &(s, d))| {
                let m = columns.len();
                let mut rows = vec![0.0; d * m];
                for r in 0..d {
                    for (c, v) in program.g.row(s + r) {
                        if let Ok(k) = columns.binary_search(&c) {
                            rows[r * m + k] += v;
                        }
                    }
                }
                let mut positions = Vec::with_capacity(m * (m + 1) / 2);
                for j in 0..m {
                    let range = matrix.col_ptr[columns[j]]..matrix.col_ptr[columns[j] + 1];
                    for &row in &columns[..=j] {
                        let at = matrix.row_idx[range.clone()].binary_search(&row).unwrap_or_default();
                        positions.push(range.start + at);
                    }
                }
                ConeMap { columns, rows, positions }
            })
            .collect();
        let mut start = matrix;
        start.values.copy_from_slice(&base);
        Ok(Self { factor: SparseCholesky::symbolic(&start, block)?, matrix: start, base, cones: maps })
    }

    /// What a solve with this system costs.
    pub fn forecast(&self) -> Forecast {
        let (entries, flops) = (self.factor.entries(), self.factor.flops());
        let work = self.factor.work_bytes();
        let matrix = self.matrix.row_idx.len() * 24;
        Forecast {
            unknowns: self.matrix.n,
            factor_entries: entries,
            factor_flops: flops,
            bytes: (entries * 8 + matrix + work + self.matrix.n * 8 * 30) as u64,
            seconds: Forecast::seconds(flops, entries),
        }
    }

    /// Factors `P + GᵀG` for the starting point.
    pub fn factor_start(&mut self, cones: &Cones) -> Result<(), LinearError> {
        let unit = |k: usize, w: &mut [[f64; 6]; 6]| (0..cones.blocks[k].1).for_each(|i| w[i][i] = 1.0);
        self.refactor(unit, 0.0)
    }

    /// Factors `P + Gᵀ W⁻² G`, its diagonal raised by the fraction `regularisation`.
    pub fn factor(&mut self, cones: &Cones, scaling: &Scaling, regularisation: f64) -> Result<(), LinearError> {
        self.refactor(|k, w| scaling.inverse_square(cones, k, w), regularisation)
    }

    fn refactor(&mut self, inverse_square: impl Fn(usize, &mut [[f64; 6]; 6]), raise: f64) -> Result<(), LinearError> {
        let values = &mut self.matrix.values;
        values.copy_from_slice(&self.base);
        for (k, cone) in self.cones.iter().enumerate() {
            let mut w = [[0.0; 6]; 6];
            inverse_square(k, &mut w);
            let m = cone.columns.len();
            let d = cone.rows.len() / m.max(1);
            let mut at = 0;
            for j in 0..m {
                let wj: [f64; 6] =
                    std::array::from_fn(
                        |r| {
                            if r < d { (0..d).map(|q| w[r][q] * cone.rows[q * m + j]).sum() } else { 0.0 }
                        },
                    );
                for i in 0..=j {
                    values[cone.positions[at]] += (0..d).map(|r| cone.rows[r * m + i] * wj[r]).sum::<f64>();
                    at += 1;
                }
            }
        }
        if raise > 0.0 {
            for c in 0..self.matrix.n {
                let last = self.matrix.col_ptr[c + 1] - 1;
                self.matrix.values[last] *= 1.0 + raise;
            }
        }
        self.factor.refactor(&self.matrix)
    }

    /// Solves, without refinement.
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        self.factor.solve(b)
    }
}

/// The union of the pattern of P and of all cones' products; P's values in it.
fn union(p: &SymmetricCsc, cones: &[Vec<usize>]) -> (SymmetricCsc, Vec<f64>) {
    let mut extra: Vec<Vec<usize>> = vec![Vec::new(); p.n];
    for columns in cones {
        for (j, &c) in columns.iter().enumerate() {
            extra[c].extend_from_slice(&columns[..=j]);
        }
    }
    let mut out = SymmetricCsc { n: p.n, col_ptr: vec![0], ..SymmetricCsc::default() };
    for c in 0..p.n {
        let own = p.col_ptr[c]..p.col_ptr[c + 1];
        let mut rows = std::mem::take(&mut extra[c]);
        rows.extend_from_slice(&p.row_idx[own.clone()]);
        rows.sort_unstable();
        rows.dedup();
        let start = out.row_idx.len();
        out.row_idx.extend_from_slice(&rows);
        out.values.resize(out.row_idx.len(), 0.0);
        for k in own {
            if let Ok(at) = rows.binary_search(&p.row_idx[k]) {
                out.values[start + at] = p.values[k];
            }
        }
        out.col_ptr.push(out.row_idx.len());
    }
    let base = out.values.clone();
    (out, base)
}
