//! Elimination of elements that yield from the matrix of an iteration: their yield points,
//! parameters and inner displacements.
//!
//! With V_j the vector block of `W_j⁻²`, the matrix of the parameters is
//! `H = F + Σ B_jᵀ V_j B_j + ρ`, and the stiffness of an element on its displacements is
//! `T H⁻¹ Tᵀ`. Rigid-plastic elements have F = 0 and need the proximal term ρ: in rigid zones V
//! approaches zero, and no yield point constrains a pressure.

use super::elimination::{Scratch, eliminate, kept, own_trace};
use super::yield_points::{SCALING, Weights};
use crate::elements::packed_elements::Batch;
use crate::elements::yielding_element::NONE;
use crate::elements::yielding_element::Shape;
use crate::elements::yielding_element::YIELD_ROWS;
use crate::programs::conic::{ConicProgram, SymmetricCsc};
use crate::solve::sparse::{LinearError, Locator};
use bracket_base::math::wide::{LANES, Lane};
use rayon::prelude::*;
use std::sync::Arc;

/// Number of batches eliminated in parallel before their products are added one after the other.
pub(super) const ROUND: usize = 32;

/// A point with W = I.
pub const UNSCALED: [f64; SCALING] = [1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];

/// All elements that yield, their places in the sparse factor and their own factors.
#[derive(Default)]
pub struct ElementSystem {
    pub(super) batches: Arc<Vec<Batch>>,
    /// Scale of the displacements of the program.
    pub(super) scale: Vec<f64>,
    /// Place of each product (a ≥ b, packed by columns b) in each lane.
    places: Vec<Vec<u32>>,
    /// Stored elimination of each batch.
    pub(super) factors: Vec<Vec<Lane>>,
    /// The scaling at the yield points of each batch.
    pub(super) weights: Vec<Weights>,
    /// Term ρ added to the matrix of the parameters.
    pub proximal: f64,
}

impl ElementSystem {
    /// The elements of a program.
    pub fn new(program: &ConicProgram) -> Self {
        let batches = program.elements.batches.clone();
        Self {
            scale: program.elements.scale.clone(),
            factors: vec![Vec::new(); batches.len()],
            weights: vec![Vec::new(); batches.len()],
            batches,
            ..Self::default()
        }
    }

    /// Adds the couplings of each element's shared unknowns to the columns of a pattern.
    pub fn couple(&self, columns: &mut [Vec<u32>]) {
        for batch in self.batches.iter() {
            for l in 0..LANES {
                let mut met: Vec<u32> =
                    batch.columns.iter().map(|c| c[l]).filter(|c| *c != NONE).collect();
                met.sort_unstable();
                met.iter()
                    .enumerate()
                    .for_each(|(j, &c)| columns[c as usize].extend_from_slice(&met[..=j]));
            }
            // elements of one batch are neighbours: repeated entries are removed early
            batch.columns.iter().flatten().filter(|c| **c != NONE).for_each(|&c| {
                let column = &mut columns[c as usize];
                if column.len() > 512 {
                    column.sort_unstable();
                    column.dedup();
                }
            });
        }
    }

    /// Finds the place of every product.
    pub fn locate(&mut self, locator: &mut Locator<'_>) {
        for batch in self.batches.iter() {
            let k = batch.shared();
            let mut places = Vec::with_capacity(k * (k + 1) / 2 * LANES);
            for b in 0..k {
                for a in b..k {
                    for l in 0..LANES {
                        let (i, j) = (batch.columns[a][l], batch.columns[b][l]);
                        places.push(if i == NONE || j == NONE {
                            NONE
                        } else {
                            locator.place(i, j)
                        });
                    }
                }
            }
            self.places.push(places);
        }
    }

    /// True for the kinematic program of limit analysis.
    pub fn have_pressures(&self) -> bool {
        let pressures = |b: &Batch| matches!(b.shape, Shape::Flow { pressures: 1.., .. });
        self.batches.iter().any(pressures)
    }

    /// Memory in addition to that of the program \[bytes\].
    pub fn bytes(&self) -> usize {
        let places: usize = self.places.iter().map(|p| 4 * p.len()).sum();
        let kept: usize =
            self.batches.iter().map(|b| 8 * LANES * (kept(b) + SCALING * b.shape.points())).sum();
        let data: usize = self.batches.iter().map(|b| 8 * LANES * b.data.len()).sum();
        places + kept + data
    }

    /// Floating-point operations of one elimination.
    pub fn flops(&self) -> f64 {
        let one = |b: &Batch| {
            let (d, k) = (b.displacements() as f64, b.shared() as f64);
            let subtets =
                if let Shape::Flow { subtets, .. } = b.shape { subtets as f64 } else { 0.0 };
            let own = match b.shape {
                Shape::Stress => 80.0 * 930.0 + 9e3 + 900.0 * k + 30.0 * k * k,
                Shape::Flow { .. } => subtets * (2700.0 + 400.0 * d + 20.0 * d * d),
            };
            LANES as f64 * own
        };
        self.batches.iter().map(one).sum()
    }

    /// Eliminates every element; `weight` gives the scaling of the cone that starts at a row,
    /// `values` is the sparse factor's storage.
    pub fn eliminate(
        &mut self,
        weight: impl Fn(usize) -> [f64; SCALING] + Sync,
        values: &mut [f64],
    ) -> Result<(), LinearError> {
        let Self { batches, scale, places, factors, weights, proximal } = self;
        for (first, round) in batches.chunks(ROUND).enumerate() {
            let from = ROUND * first;
            let products: Option<Vec<Vec<Lane>>> = round
                .par_iter()
                .zip(&mut factors[from..from + round.len()])
                .zip(&mut weights[from..from + round.len()])
                .map_init(Scratch::default, |scratch, ((batch, factor), weights)| {
                    gather_weights(batch, &weight, weights);
                    eliminate(batch, weights, *proximal, factor, scratch)
                })
                .collect();
            for (i, (batch, products)) in
                round.iter().zip(products.ok_or(LinearError::Singular)?).enumerate()
            {
                add_products(batch, scale, &places[from + i], &products, values);
            }
        }
        Ok(())
    }

    /// Mean of the diagonal of the parameters' matrix at the given weights: its median and its mean
    /// over the elements.
    pub fn own_stiffness(&self, weight: impl Fn(usize) -> [f64; SCALING] + Sync) -> (f64, f64) {
        let mut traces: Vec<f64> = self
            .batches
            .par_iter()
            .flat_map_iter(|batch| {
                let mut weights = Weights::new();
                gather_weights(batch, &weight, &mut weights);
                let trace = own_trace(batch, &weights);
                (0..LANES)
                    .filter(|&l| batch.own[l] != NONE)
                    .map(move |l| trace[l])
                    .collect::<Vec<f64>>()
            })
            .collect();
        if traces.is_empty() {
            return (0.0, 0.0);
        }
        traces.sort_unstable_by(f64::total_cmp);
        (traces[traces.len() / 2], traces.iter().sum::<f64>() / traces.len() as f64)
    }
}

/// Adds the products of a batch to the storage of the sparse factor.
fn add_products(
    batch: &Batch,
    scale: &[f64],
    places: &[u32],
    products: &[Lane],
    values: &mut [f64],
) {
    let k = batch.shared();
    let of = |c: &[u32; LANES]| -> Lane {
        c.map(|c| match (c, scale.is_empty()) {
            (NONE, _) => 0.0,
            (_, true) => 1.0,
            (c, false) => scale[c as usize],
        })
    };
    let scales: Vec<Lane> = batch.columns.iter().map(of).collect();
    let mut at = 0;
    for b in 0..k {
        for a in b..k {
            for l in 0..LANES {
                let place = places[at * LANES + l];
                if place != NONE {
                    values[place as usize] += products[at][l] * scales[a][l] * scales[b][l];
                }
            }
            at += 1;
        }
    }
}

fn gather_weights(
    batch: &Batch,
    weight: &(impl Fn(usize) -> [f64; SCALING] + Sync),
    out: &mut Weights,
) {
    out.resize(batch.shape.points(), [[0.0; LANES]; SCALING]);
    for l in 0..LANES {
        for (point, out) in out.iter_mut().enumerate() {
            // an empty lane gets the identity
            let w = match batch.rows[l] {
                NONE => UNSCALED,
                row => weight(row as usize + YIELD_ROWS * point),
            };
            (0..SCALING).for_each(|i| out[i][l] = w[i]);
        }
    }
}

/// The pattern of P with the couplings of cones and elements added.
pub fn union(p: &SymmetricCsc, cones: &[Vec<u32>], elements: &ElementSystem) -> SymmetricCsc {
    let mut extra: Vec<Vec<u32>> = vec![Vec::new(); p.n];
    for columns in cones {
        for (j, &c) in columns.iter().enumerate() {
            extra[c as usize].extend_from_slice(&columns[..=j]);
        }
    }
    elements.couple(&mut extra);
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
