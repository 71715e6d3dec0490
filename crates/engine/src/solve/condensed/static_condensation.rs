//! Static condensation of right-hand sides of Newton's system from elements that yield to the
//! shared unknowns, and expansion of solutions back to the elements.
//!
//! An element takes its part of the right-hand side `(r₁, r₂)`, stationarity and slack rows, and
//! completes all steps while its data are in the cache: scaling of the yield points, elimination of
//! the parameters and the inner displacements. The expansion gives its multipliers and the errors
//! of its rows.

use crate::elements::packed_elements::Batch;
use crate::elements::yielding_element::{NONE, YIELD_ROWS};
use crate::solve::condensed::elements::{ElementSystem, ROUND};
use crate::solve::condensed::elimination::{inner_panel, solve_own};
use crate::solve::condensed::panel;
use crate::solve::condensed::yield_points::inverse_square;
use bracket_base::math::wide::{LANES, Lane};
use rayon::prelude::*;
use std::ops::Range;

/// Stationarity and slack rows of one right-hand side.
pub type Side<'a> = (&'a [f64], &'a [f64]);

/// Condensed right-hand side of an element.
struct Carried {
    /// Forces on its displacements, inner ones eliminated.
    force: Vec<Lane>,
    /// Its parameters at zero displacements.
    own: Vec<Lane>,
}

/// An element's part of a solution.
struct Part {
    inner: Vec<Lane>,
    own: Vec<Lane>,
    /// Multipliers of its yield points.
    multipliers: Vec<Lane>,
    /// Minus its forces, and the errors of its parameters' rows; empty unless requested.
    force: Vec<Lane>,
    left: Vec<Lane>,
}

impl ElementSystem {
    /// Rounds of batches: a round is computed in parallel, then its results are added one after the
    /// other while they are in the cache.
    fn rounds(&self) -> impl Iterator<Item = Range<usize>> {
        let count = self.batches.len();
        (0..count).step_by(ROUND).map(move |from| from..(from + ROUND).min(count))
    }

    /// Condenses right-hand sides to the shared unknowns. `full` holds r₁; afterwards the places of
    /// the elements' own unknowns hold data that [`Self::expand`] needs.
    pub fn condense<const SIDES: usize>(
        &self,
        rhs: [Side<'_>; SIDES],
        full: &mut [Vec<f64>; SIDES],
    ) {
        for round in self.rounds() {
            let parts: Vec<[Carried; SIDES]> = round
                .clone()
                .into_par_iter()
                .map(|i| rhs.map(|side| self.carried(i, side)))
                .collect();
            for (batch, part) in self.batches[round].iter().zip(&parts) {
                let inner = batch.shape.inner();
                for (full, part) in full.iter_mut().zip(part) {
                    batch.scatter_displacements(&part.force, &self.scale, full);
                    set(&batch.own, &part.own, full);
                    set(&batch.inner_own(), &part.force[..inner], full);
                }
            }
        }
    }

    fn carried(&self, i: usize, (r1, r2): Side<'_>) -> Carried {
        let (batch, factor, weights) = (&self.batches[i], &self.factors[i], &self.weights[i]);
        let mut own = batch.gather_parameters(r1);
        let mut scaled = Batch::gather(&batch.rows, YIELD_ROWS * batch.shape.points(), r2);
        inverse_square(weights, &mut scaled);
        batch.add_deviators(&deviators(&scaled), &mut own);
        solve_own(batch, weights, factor, self.proximal, &mut own);
        let mut force = vec![[0.0; LANES]; batch.displacements()];
        batch.add_force(&own, &mut force);
        let inner = batch.shape.inner();
        if inner > 0 {
            let given = Batch::gather(&batch.inner_own(), inner, r1);
            for (i, (f, r)) in force.iter_mut().zip(&given).enumerate() {
                let s = self.inner_scale(batch, i);
                (0..LANES).for_each(|l| f[l] += r[l] / s[l]);
            }
            let count = force.len();
            panel::forward(inner_panel(batch, factor), inner, count, &mut force);
        }
        Carried { force, own }
    }

    /// Scale of an element's inner displacement.
    fn inner_scale(&self, batch: &Batch, i: usize) -> Lane {
        batch.inner_own().map(|first| match (first, self.scale.is_empty()) {
            (NONE, _) | (_, true) => 1.0,
            (first, false) => self.scale[first as usize + i],
        })
    }

    /// Computes the elements' own unknowns and multipliers from the shared unknowns in `full`. With
    /// CHECK the errors of their rows and their forces go into `errors`, which holds r₁ in the
    /// places of their own unknowns.
    pub fn expand<const SIDES: usize, const CHECK: bool>(
        &self,
        rhs: [Side<'_>; SIDES],
        full: &mut [Vec<f64>; SIDES],
        multipliers: &mut [Vec<f64>; SIDES],
        errors: &mut [Vec<f64>; SIDES],
    ) {
        for round in self.rounds() {
            let parts: Vec<[Part; SIDES]> = round
                .clone()
                .into_par_iter()
                .map(|i| std::array::from_fn(|k| self.part::<CHECK>(i, rhs[k], &full[k])))
                .collect();
            for (batch, parts) in self.batches[round].iter().zip(&parts) {
                for (k, part) in parts.iter().enumerate() {
                    set(&batch.own, &part.own, &mut full[k]);
                    set(&batch.inner_own(), &part.inner, &mut full[k]);
                    set(&batch.rows, &part.multipliers, &mut multipliers[k]);
                    if CHECK {
                        batch.scatter_displacements(&part.force, &self.scale, &mut errors[k]);
                        set(&batch.own, &part.left, &mut errors[k]);
                    }
                }
            }
        }
    }

    fn part<const CHECK: bool>(&self, i: usize, (r1, r2): Side<'_>, full: &[f64]) -> Part {
        let (batch, factor, weights) = (&self.batches[i], &self.factors[i], &self.weights[i]);
        let inner = batch.shape.inner();
        let mut v = batch.gather_displacements(full, &self.scale);
        if inner > 0 {
            v[..inner].copy_from_slice(&Batch::gather(&batch.inner_own(), inner, full));
            let count = v.len();
            panel::backward(inner_panel(batch, factor), inner, count, &mut v);
        }
        let mut strain = vec![[0.0; LANES]; batch.shape.parameters()];
        batch.strain(&v, &mut strain);
        let mut own = strain.clone();
        solve_own(batch, weights, factor, self.proximal, &mut own);
        let carried = batch.gather_parameters(full);
        own.iter_mut().zip(&carried).for_each(|(s, y)| (0..LANES).for_each(|l| s[l] -= y[l]));
        // z = −W⁻² (G x + r₂)
        let mut multipliers = Batch::gather(&batch.rows, YIELD_ROWS * batch.shape.points(), r2);
        let deviator = batch.deviators(&own);
        for (row, d) in
            multipliers.chunks_exact_mut(YIELD_ROWS).zip(deviator.chunks_exact(YIELD_ROWS - 1))
        {
            row[0].iter_mut().for_each(|r| *r = -*r);
            row[1..]
                .iter_mut()
                .zip(d)
                .for_each(|(r, d)| (0..LANES).for_each(|l| r[l] = -r[l] - d[l]));
        }
        inverse_square(weights, &mut multipliers);
        let (mut force, mut left) = (Vec::new(), Vec::new());
        if CHECK {
            // r₁ − (Tᵀv − F σ − ρ σ) − Bᵀz
            batch.subtract_flexibility(&own, &mut strain);
            batch.add_deviators(&deviators(&multipliers), &mut strain);
            left = batch.gather_parameters(r1);
            for ((e, s), own) in left.iter_mut().zip(&strain).zip(&own) {
                (0..LANES).for_each(|l| e[l] += self.proximal * own[l] - s[l]);
            }
            force = vec![[0.0; LANES]; v.len()];
            batch.add_force(&own, &mut force);
            batch.add_inner(&v, &mut force);
            force.iter_mut().flatten().for_each(|f| *f = -*f);
        }
        v.truncate(inner);
        for (i, v) in v.iter_mut().enumerate() {
            let s = self.inner_scale(batch, i);
            (0..LANES).for_each(|l| v[l] /= s[l]);
        }
        Part { inner: v, own, multipliers, force, left }
    }
}

/// The vector parts of yield points.
fn deviators(rows: &[Lane]) -> Vec<Lane> {
    rows.chunks_exact(YIELD_ROWS).flat_map(|c| &c[1..]).copied().collect()
}

/// Writes the values of each lane from its place `first` on.
fn set(first: &[u32; LANES], values: &[Lane], full: &mut [f64]) {
    for l in (0..LANES).filter(|&l| first[l] != NONE) {
        let at = first[l] as usize;
        values.iter().zip(&mut full[at..at + values.len()]).for_each(|(v, x)| *x = v[l]);
    }
}
