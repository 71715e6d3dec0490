//! The condensed matrix `P + Gᵀ W⁻² G` of every iteration: one fixed pattern, one ordering, one symbolic factor.
//!
//! Unknowns of a stage above 0 are eliminated element by element ([`super::local`]); the others reach the sparse factor.
//! Every entry has its place in the factor's own storage, so no matrix is assembled beside it.

use super::cones::{Cones, Scaling};
use super::local::Local;
use crate::model::program::{Csr, SymmetricCsc};
use crate::solve::forecast::Forecast;
use crate::solve::sparse::{LinearError, SparseCholesky};

/// Columns of one cone's rows and where its products go.
struct ConeMap {
    /// Distinct columns of the cone's rows.
    columns: Vec<u32>,
    /// Its rows as a dense block, `rows × columns`.
    rows: Vec<f64>,
    /// Place of entry (i ≤ j by column), packed by columns.
    places: Vec<u32>,
}

/// The matrix, its factor and its fixed data.
pub struct CondensedSystem {
    /// P in its own pattern.
    p: SymmetricCsc,
    /// Place of each entry of P.
    place: Vec<u32>,
    cones: Vec<ConeMap>,
    local: Local,
    factor: SparseCholesky,
}

impl CondensedSystem {
    /// Lays out the pattern, the elimination and the symbolic factor.
    ///
    /// `stage` as in [`crate::model::ConicProgram::stage`], `maximised` likewise; `block` gives the block of each unknown.
    pub fn new(
        p: SymmetricCsc,
        g: &Csr,
        cones: &Cones,
        stage: &[u8],
        maximised: &[bool],
        block: &[u32],
    ) -> Result<Self, LinearError> {
        let columns: Vec<Vec<u32>> = cones
            .blocks
            .iter()
            .map(|&(s, d)| {
                let mut c: Vec<u32> = (s..s + d).flat_map(|r| g.row(r).map(|(c, _)| c as u32)).collect();
                c.sort_unstable();
                c.dedup();
                c
            })
            .collect();
        let pattern = union(&p, &columns);
        let (local, reduced, reduced_block) = Local::new(pattern, stage, maximised, block)?;
        let factor = SparseCholesky::symbolic(&reduced, &reduced_block)?;
        let mut system = Self { place: Vec::new(), cones: Vec::new(), local, factor, p };
        system.local.locate(&system.factor);
        let mut locator = system.factor.locator();
        let mut place = |r: u32, c: u32| system.local.place(&mut locator, r, c);
        let mut places = Vec::with_capacity(system.p.row_idx.len());
        for c in 0..system.p.n {
            let rows = &system.p.row_idx[system.p.col_ptr[c]..system.p.col_ptr[c + 1]];
            places.extend(rows.iter().map(|&r| place(r, c as u32)));
        }
        let cones = columns.into_iter().zip(&cones.blocks).map(|(columns, &(s, d))| {
            let m = columns.len();
            let mut rows = vec![0.0; d * m];
            for r in 0..d {
                for (c, v) in g.row(s + r) {
                    if let Ok(k) = columns.binary_search(&(c as u32)) {
                        rows[r * m + k] += v;
                    }
                }
            }
            let places = (0..m).flat_map(|j| (0..=j).map(move |i| (i, j))).map(|(i, j)| place(columns[i], columns[j]));
            let places = places.collect();
            ConeMap { columns, rows, places }
        });
        let cones: Vec<ConeMap> = cones.collect();
        (system.place, system.cones) = (places, cones);
        Ok(system)
    }

    /// What a solve with this system costs.
    pub fn forecast(&self) -> Forecast {
        let (entries, flops) = (self.factor.nonzeros(), self.factor.flops() + self.local.flops());
        let cones: usize = self.cones.iter().map(|c| 4 * c.columns.len() + 8 * c.rows.len() + 4 * c.places.len()).sum();
        // the iterates, directions and right-hand sides of the method
        let vectors = 8 * 30 * self.p.n;
        let bytes = self.factor.bytes() + self.local.bytes() + 16 * self.place.len() + cones + vectors;
        Forecast {
            unknowns: self.factor.unknowns(),
            factor_entries: entries,
            factor_flops: flops,
            bytes: bytes as u64,
            seconds: Forecast::all_iterations(flops, entries),
        }
    }

    /// Operations of a factorisation for each nonzero of the factor.
    pub fn flops_per_entry(&self) -> f64 {
        self.factor.flops() / self.factor.nonzeros().max(1) as f64
    }

    /// `P X` for a few vectors.
    pub fn multiply<const SIDES: usize>(&self, x: [&[f64]; SIDES]) -> [Vec<f64>; SIDES] {
        self.p.mul_all(x)
    }

    /// Factors `P + GᵀG` for the starting point.
    pub fn factor_start(&mut self, cones: &Cones) -> Result<(), LinearError> {
        let unit = |k: usize, w: &mut [[f64; 6]; 6]| (0..cones.blocks[k].1).for_each(|i| w[i][i] = 1.0);
        self.refactor(unit, 0.0)
    }

    /// Factors `P + Gᵀ W⁻² G`, the diagonal of P raised by the fraction `regularisation`.
    pub fn factor(&mut self, cones: &Cones, scaling: &Scaling, regularisation: f64) -> Result<(), LinearError> {
        self.refactor(|k, w| scaling.inverse_square(cones, k, w), regularisation)
    }

    fn refactor(&mut self, inverse_square: impl Fn(usize, &mut [[f64; 6]; 6]), raise: f64) -> Result<(), LinearError> {
        let Self { p, place, cones, local, factor } = self;
        let values = factor.clear()?;
        let mut store = local.store(values);
        place.iter().zip(&p.values).for_each(|(&at, &v)| store.add(at, v));
        if raise > 0.0 {
            for c in 0..p.n {
                let last = p.col_ptr[c + 1] - 1;
                store.add(place[last], raise * p.values[last]);
            }
        }
        for (k, cone) in cones.iter().enumerate() {
            let mut w = [[0.0; 6]; 6];
            inverse_square(k, &mut w);
            let m = cone.columns.len();
            let d = cone.rows.len() / m.max(1);
            let mut at = 0;
            for j in 0..m {
                let mut wj = [0.0; 6];
                for r in 0..d {
                    wj[r] = (0..d).map(|q| w[r][q] * cone.rows[q * m + j]).sum();
                }
                for i in 0..=j {
                    store.add(cone.places[at], (0..d).map(|r| cone.rows[r * m + i] * wj[r]).sum::<f64>());
                    at += 1;
                }
            }
        }
        local.eliminate(factor.values_mut())?;
        factor.factor()
    }

    /// Solves for a few right-hand sides, without refinement.
    pub fn solve<const SIDES: usize>(&self, b: [&[f64]; SIDES]) -> [Vec<f64>; SIDES] {
        if self.local.is_empty() {
            return self.factor.solve_all(b);
        }
        let (condensed, kept) = self.local.condense(b);
        let sides: [&[f64]; SIDES] = std::array::from_fn(|k| condensed[k].as_slice());
        self.local.expand(self.factor.solve_all(sides), kept)
    }
}

/// The union of the pattern of P and of all cones' products.
fn union(p: &SymmetricCsc, cones: &[Vec<u32>]) -> SymmetricCsc {
    let mut extra: Vec<Vec<u32>> = vec![Vec::new(); p.n];
    for columns in cones {
        for (j, &c) in columns.iter().enumerate() {
            extra[c as usize].extend_from_slice(&columns[..=j]);
        }
    }
    let mut out = SymmetricCsc { n: p.n, col_ptr: vec![0], ..SymmetricCsc::default() };
    for c in 0..p.n {
        let mut rows = std::mem::take(&mut extra[c]);
        rows.extend_from_slice(&p.row_idx[p.col_ptr[c]..p.col_ptr[c + 1]]);
        rows.sort_unstable();
        rows.dedup();
        out.row_idx.extend_from_slice(&rows);
        out.col_ptr.push(out.row_idx.len());
    }
    out
}
