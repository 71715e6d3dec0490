//! Elements that yield, eliminated from the matrix of an iteration: their yield points, their parameters, their inner
//! displacements.
//!
//! With V_j the vector block of `W_j⁻²`, the parameters' own matrix is `H = F + Σ B_jᵀ V_j B_j + ρ`, and what an element leaves
//! on its displacements is `T H⁻¹ Tᵀ`. Rigid-plastic elements have F = 0 and need the proximal term ρ: in rigid zones V goes
//! to zero, and a pressure is held by no point at all.

use super::panel;
use crate::model::batch::{Batch, LANES, Lane, NONE, Rule, Shape, VERTEX_VALUES, YIELD_ROWS};
use crate::model::program::{ConicProgram, SymmetricCsc};
use crate::solve::sparse::{LinearError, Locator};
use pulp::Arch;
use rayon::prelude::*;
use std::sync::Arc;

/// Batches eliminated in parallel before what they leave is added one after the other.
const ROUND: usize = 32;

/// `V_j = α (I + 2 w wᵀ)` of each yield point of a batch: α, then the five of w.
type Weights = Vec<[Lane; YIELD_ROWS]>;

/// All elements that yield, their places in the sparse factor and their own factors.
#[derive(Default)]
pub struct ElementSystem {
    batches: Arc<Vec<Batch>>,
    /// What multiplies displacements of the program.
    scale: Vec<f64>,
    /// Place of each product (a ≥ b, packed by columns b) of each lane.
    places: Vec<Vec<u32>>,
    /// What is kept of each batch's elimination.
    factors: Vec<Vec<Lane>>,
    /// Term added to the parameters' own matrix.
    pub proximal: f64,
}

impl ElementSystem {
    /// The elements of a program.
    pub fn new(program: &ConicProgram) -> Self {
        let batches = program.elements.batches.clone();
        Self { scale: program.elements.scale.clone(), factors: vec![Vec::new(); batches.len()], batches, ..Self::default() }
    }

    /// True when nothing yields.
    pub fn is_empty(&self) -> bool {
        self.batches.is_empty()
    }

    /// Adds the couplings of each element's shared unknowns to the columns of a pattern.
    pub fn couple(&self, columns: &mut [Vec<u32>]) {
        for batch in self.batches.iter() {
            for l in 0..LANES {
                let mut met: Vec<u32> = batch.columns.iter().map(|c| c[l]).filter(|c| *c != NONE).collect();
                met.sort_unstable();
                met.iter().enumerate().for_each(|(j, &c)| columns[c as usize].extend_from_slice(&met[..=j]));
            }
            // elements of one batch are neighbours: drop what repeats before it grows
            batch.columns.iter().flatten().filter(|c| **c != NONE).for_each(|&c| {
                let column = &mut columns[c as usize];
                if column.len() > 512 {
                    column.sort_unstable();
                    column.dedup();
                }
            });
        }
    }

    /// Looks up where every product goes.
    pub fn locate(&mut self, locator: &mut Locator<'_>) {
        for batch in self.batches.iter() {
            let k = batch.shared();
            let mut places = Vec::with_capacity(k * (k + 1) / 2 * LANES);
            for b in 0..k {
                for a in b..k {
                    for l in 0..LANES {
                        let (i, j) = (batch.columns[a][l], batch.columns[b][l]);
                        places.push(if i == NONE || j == NONE { NONE } else { locator.place(i, j) });
                    }
                }
            }
            self.places.push(places);
        }
    }

    /// Memory beside the program's own \[bytes\].
    pub fn bytes(&self) -> usize {
        let places: usize = self.places.iter().map(|p| 4 * p.len()).sum();
        let kept: usize = self.batches.iter().map(|b| 8 * LANES * kept(b)).sum();
        let data: usize = self.batches.iter().map(|b| 8 * LANES * b.data.len()).sum();
        places + kept + data
    }

    /// Floating-point operations of one elimination.
    pub fn flops(&self) -> f64 {
        let one = |b: &Batch| {
            let (d, k) = (b.displacements() as f64, b.shared() as f64);
            let subtets = if let Shape::Flow { subtets, .. } = b.shape { subtets as f64 } else { 0.0 };
            let own = match b.shape {
                Shape::Stress => 80.0 * 930.0 + 9e3 + 900.0 * k + 30.0 * k * k,
                Shape::Flow { .. } => subtets * (2700.0 + 400.0 * d + 20.0 * d * d),
            };
            LANES as f64 * own
        };
        self.batches.iter().map(one).sum()
    }

    /// Eliminates every element; `weight` gives α and w of the cone that starts at a row, `values` is the sparse factor's
    /// storage.
    pub fn eliminate(
        &mut self,
        weight: impl Fn(usize) -> [f64; YIELD_ROWS] + Sync,
        values: &mut [f64],
    ) -> Result<(), LinearError> {
        let Self { batches, scale, places, factors, proximal } = self;
        for (first, round) in batches.chunks(ROUND).enumerate() {
            let from = ROUND * first;
            let products: Option<Vec<Vec<Lane>>> = round
                .par_iter()
                .zip(&mut factors[from..from + round.len()])
                .map(|(batch, factor)| eliminate(batch, &weights(batch, &weight), *proximal, factor))
                .collect();
            for (i, (batch, products)) in round.iter().zip(products.ok_or(LinearError::Singular)?).enumerate() {
                add_products(batch, scale, &places[from + i], &products, values);
            }
        }
        Ok(())
    }

    /// Mean of the diagonal of the parameters' own matrix at the given weights, median over elements and mean.
    pub fn own_stiffness(&self, weight: impl Fn(usize) -> [f64; YIELD_ROWS] + Sync) -> (f64, f64) {
        let mut traces: Vec<f64> = self
            .batches
            .par_iter()
            .flat_map_iter(|batch| {
                let trace = own_trace(batch, &weights(batch, &weight));
                (0..LANES).filter(|&l| batch.own[l] != NONE).map(move |l| trace[l]).collect::<Vec<f64>>()
            })
            .collect();
        if traces.is_empty() {
            return (0.0, 0.0);
        }
        traces.sort_unstable_by(f64::total_cmp);
        (traces[traces.len() / 2], traces.iter().sum::<f64>() / traces.len() as f64)
    }

    /// Carries right-hand sides to the shared unknowns; the vectors are needed to come back.
    pub fn condense<const SIDES: usize>(&self, full: &mut [Vec<f64>; SIDES]) {
        let parts: Vec<[(Vec<Lane>, Vec<Lane>); SIDES]> = self
            .batches
            .par_iter()
            .zip(&self.factors)
            .map(|(batch, factor)| {
                std::array::from_fn(|k| {
                    let mut y = batch.gather_parameters(&full[k]);
                    solve_own(batch, factor, self.proximal, &mut y);
                    let mut force = vec![[0.0; LANES]; batch.displacements()];
                    batch.add_force(&y, &mut force);
                    let inner = batch.shape.inner();
                    if inner > 0 {
                        let own = batch.gather_displacements(&full[k], &self.scale);
                        // what arrives at the inner displacements, in the element's own units
                        for (f, (i, _)) in force.iter_mut().zip(own.iter().enumerate()).take(inner) {
                            let s = self.inner_scale(batch, i);
                            (0..LANES).for_each(|l| if s[l] != 0.0 { f[l] += own[i][l] / (s[l] * s[l]) });
                        }
                        // below the inner block the products come with their sign: what is there already stays apart
                        let mut work = force[..inner].to_vec();
                        work.resize(force.len(), [0.0; LANES]);
                        panel::forward(inner_panel(batch, factor), inner, force.len(), &mut work);
                        force[..inner].copy_from_slice(&work[..inner]);
                        for (f, w) in force[inner..].iter_mut().zip(&work[inner..]) {
                            (0..LANES).for_each(|l| f[l] += w[l]);
                        }
                    }
                    (force, y)
                })
            })
            .collect();
        for (batch, part) in self.batches.iter().zip(&parts) {
            let inner = batch.shape.inner();
            for (full, (force, y)) in full.iter_mut().zip(part) {
                let mut outer = force.clone();
                outer[..inner].fill([0.0; LANES]);
                batch.scatter_displacements(&outer, &self.scale, full);
                set(&batch.own, 0, y, full);
                set(&batch.own, batch.shape.parameters(), &force[..inner], full);
            }
        }
    }

    /// Scale of an element's inner displacement; 0 in empty lanes.
    fn inner_scale(&self, batch: &Batch, i: usize) -> Lane {
        let at = batch.shape.parameters() + i;
        std::array::from_fn(|l| match (batch.own[l], self.scale.is_empty()) {
            (NONE, _) => 0.0,
            (_, true) => 1.0,
            (own, false) => self.scale[own as usize + at],
        })
    }

    /// All unknowns from the shared ones.
    pub fn expand<const SIDES: usize>(&self, full: &mut [Vec<f64>; SIDES]) {
        let parts: Vec<[(Vec<Lane>, Vec<Lane>); SIDES]> = self
            .batches
            .par_iter()
            .zip(&self.factors)
            .map(|(batch, factor)| {
                std::array::from_fn(|k| {
                    let inner = batch.shape.inner();
                    let mut v = batch.gather_displacements(&full[k], &self.scale);
                    if inner > 0 {
                        let parameters = batch.shape.parameters();
                        let first = batch.own.map(|o| if o == NONE { NONE } else { o + parameters as u32 });
                        v[..inner].copy_from_slice(&Batch::gather(&first, inner, &full[k]));
                        let count = v.len();
                        panel::backward(inner_panel(batch, factor), inner, count, &mut v);
                    }
                    let mut sigma = batch.strain(&v);
                    solve_own(batch, factor, self.proximal, &mut sigma);
                    let y = batch.gather_parameters(&full[k]);
                    sigma.iter_mut().zip(&y).for_each(|(s, y)| (0..LANES).for_each(|l| s[l] -= y[l]));
                    v.truncate(inner);
                    for (i, v) in v.iter_mut().enumerate() {
                        let s = self.inner_scale(batch, i);
                        (0..LANES).for_each(|l| if s[l] != 0.0 { v[l] /= s[l] });
                    }
                    (v, sigma)
                })
            })
            .collect();
        for (batch, part) in self.batches.iter().zip(&parts) {
            for (full, (inner, sigma)) in full.iter_mut().zip(part) {
                set(&batch.own, 0, sigma, full);
                set(&batch.own, batch.shape.parameters(), inner, full);
            }
        }
    }
}

/// Writes each lane's values from `offset` behind its first own unknown.
fn set(own: &[u32; LANES], offset: usize, values: &[Lane], full: &mut [f64]) {
    for l in (0..LANES).filter(|&l| own[l] != NONE) {
        let at = own[l] as usize + offset;
        values.iter().zip(&mut full[at..at + values.len()]).for_each(|(v, x)| *x = v[l]);
    }
}

/// Adds what the elements of a batch leave to the sparse factor's storage.
fn add_products(batch: &Batch, scale: &[f64], places: &[u32], products: &[Lane], values: &mut [f64]) {
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

fn weights(batch: &Batch, weight: &(impl Fn(usize) -> [f64; YIELD_ROWS] + Sync)) -> Weights {
    let mut out = vec![[[0.0; LANES]; YIELD_ROWS]; batch.shape.points()];
    for l in 0..LANES {
        for (point, out) in out.iter_mut().enumerate() {
            // an empty lane gets the identity
            let w = match batch.rows[l] {
                NONE => [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                row => weight(row as usize + YIELD_ROWS * point),
            };
            (0..YIELD_ROWS).for_each(|i| out[i][l] = w[i]);
        }
    }
    out
}

/// Mean of the diagonal of H.
fn own_trace(batch: &Batch, weights: &Weights) -> Lane {
    let mut trace = [0.0; LANES];
    let count = batch.shape.parameters() as f64;
    let b = batch.parts()[2];
    for (point, w) in weights.iter().enumerate() {
        for a in 0..5 {
            for l in 0..LANES {
                let v = w[0][l] * (1.0 + 2.0 * w[1 + a][l] * w[1 + a][l]);
                let rows = match batch.shape {
                    Shape::Stress => b[(5 * point + a) * 30..][..30].iter().map(|x| x[l] * x[l]).sum(),
                    Shape::Flow { .. } => 1.0,
                };
                trace[l] += v * rows / count;
            }
        }
    }
    trace
}

/// Entries kept of a batch's elimination.
fn kept(batch: &Batch) -> usize {
    let inner = batch.shape.inner() * batch.displacements();
    let own = match batch.shape {
        Shape::Stress => 30 * 31 / 2,
        Shape::Flow { subtets, rule: Rule::Hencky, .. } => subtets * VERTEX_VALUES * (VERTEX_VALUES + 1) / 2,
        // α + ρ, the fraction taken off along w, w
        Shape::Flow { .. } => 7 * batch.shape.points(),
    };
    own + inner
}

/// The factored inner block of a batch.
fn inner_panel<'a>(batch: &Batch, factor: &'a [Lane]) -> &'a [Lane] {
    &factor[factor.len() - batch.shape.inner() * batch.displacements()..]
}

/// Eliminates one batch: `T H⁻¹ Tᵀ` (the inner displacements eliminated as well), lower triangle by columns; its factor is
/// left in `kept`.
fn eliminate(batch: &Batch, weights: &Weights, proximal: f64, kept: &mut Vec<Lane>) -> Option<Vec<Lane>> {
    kept.clear();
    let [strain, flexibility, volume, inner_part] = batch.parts();
    let all = batch.displacements();
    let Shape::Flow { subtets, rule, inner, .. } = batch.shape else {
        return eliminate_stress(batch, weights, proximal, kept);
    };
    let mut k = vec![[0.0; LANES]; all * (all + 1) / 2];
    let points = rule.points().len();
    for subtet in 0..subtets {
        let e = &strain[subtet * VERTEX_VALUES * all..][..VERTEX_VALUES * all];
        let weights = &weights[subtet * points..][..points];
        if rule == Rule::Hencky {
            let products = eliminate_hencky(e, flexibility[subtet], weights, all, kept)?;
            k.iter_mut().zip(&products).for_each(|(k, p)| (0..LANES).for_each(|l| k[l] += p[l]));
        } else {
            add_rigid_plastic(e, rule, weights, proximal, all, &mut k, kept);
        }
    }
    for row in volume.chunks_exact(all.max(1)) {
        let mut at = 0;
        for c in 0..all {
            for r in c..all {
                (0..LANES).for_each(|l| k[at][l] += row[r][l] * row[c][l] / proximal);
                at += 1;
            }
        }
    }
    if inner == 0 {
        return Some(k);
    }
    let mut panel = inner_part.to_vec();
    let mut at = 0;
    for column in panel.chunks_exact_mut(all).enumerate() {
        let (c, column) = column;
        for p in &mut column[c..] {
            (0..LANES).for_each(|l| p[l] += k[at][l]);
            at += 1;
        }
    }
    let outer = &k[at..];
    let products = panel::eliminate(&mut panel, inner, all)?;
    kept.extend_from_slice(&panel);
    Some(outer.iter().zip(&products).map(|(k, p)| std::array::from_fn(|l| k[l] - p[l])).collect())
}

/// `Y = V^½ B`: `V = α (I + 2 w wᵀ)` has the root `√α (I + γ w wᵀ)`.
#[inline(always)]
fn root(weight: &[Lane; YIELD_ROWS], b: [Lane; 5]) -> [Lane; 5] {
    let mut y = b;
    for l in 0..LANES {
        let w: [f64; 5] = std::array::from_fn(|i| weight[1 + i][l]);
        let n = w.iter().map(|w| w * w).sum::<f64>();
        // (√(1 + 2n) − 1)/n without cancellation
        let gamma = 2.0 / ((1.0 + 2.0 * n).sqrt() + 1.0);
        let along = gamma * (0..5).map(|i| w[i] * b[i][l]).sum::<f64>();
        let root = weight[0][l].sqrt();
        (0..5).for_each(|i| y[i][l] = root * (b[i][l] + along * w[i]));
    }
    y
}

/// The super-element: dense in its 30 parameters.
fn eliminate_stress(batch: &Batch, weights: &Weights, proximal: f64, kept: &mut Vec<Lane>) -> Option<Vec<Lane>> {
    const M: usize = 30;
    let [tt, flexibility, b, _] = batch.parts();
    let k = batch.shared();
    let height = M + k;
    let mut panel = vec![[0.0; LANES]; M * height];
    let mut y = vec![[0.0; LANES]; 80 * M];
    Arch::new().dispatch(
        #[inline(always)]
        || {
            for (point, weight) in weights.iter().enumerate() {
                for c in 0..M {
                    let rows = std::array::from_fn(|i| b[(5 * point + i) * M + c]);
                    for (i, v) in root(weight, rows).into_iter().enumerate() {
                        y[(5 * point + i) * M + c] = v;
                    }
                }
            }
            let mut at = 0;
            for c in 0..M {
                let column = &mut panel[c * height..(c + 1) * height];
                let mut r = c;
                while r < M {
                    let rows = (M - r).min(4);
                    let mut sums = [[0.0; LANES]; 4];
                    for row in y.chunks_exact(M) {
                        let factor = row[c];
                        for (q, sum) in sums.iter_mut().enumerate().take(rows) {
                            for l in 0..LANES {
                                sum[l] += row[r + q][l] * factor[l];
                            }
                        }
                    }
                    for (q, sum) in sums.iter().enumerate().take(rows) {
                        for l in 0..LANES {
                            column[r + q][l] = sum[l] + flexibility[at][l];
                        }
                        at += 1;
                    }
                    r += rows;
                }
                for l in 0..LANES {
                    column[c][l] += proximal;
                }
                column[M..].copy_from_slice(&tt[c * k..(c + 1) * k]);
            }
        },
    );
    let products = panel::eliminate(&mut panel, M, height)?;
    (0..M).for_each(|c| kept.extend_from_slice(&panel[c * height + c..c * height + M]));
    Some(products)
}

/// A tet with linear strain that is elastic before it yields: its four points are coupled by the mass matrix.
fn eliminate_hencky(
    e: &[Lane],
    flexibility: Lane,
    weights: &[[Lane; YIELD_ROWS]],
    all: usize,
    kept: &mut Vec<Lane>,
) -> Option<Vec<Lane>> {
    const M: usize = VERTEX_VALUES;
    let height = M + all;
    let mut panel = vec![[0.0; LANES]; M * height];
    for (v, weight) in weights.iter().enumerate() {
        for a in 0..5 {
            let c = 5 * v + a;
            let column = &mut panel[c * height..(c + 1) * height];
            for w in v..4 {
                let mass = if w == v { 16.0 } else { -4.0 };
                (0..LANES).for_each(|l| column[5 * w + a][l] = mass * flexibility[l]);
            }
            for i in a..5 {
                for l in 0..LANES {
                    let same = if i == a { 1.0 } else { 0.0 };
                    column[5 * v + i][l] += weight[0][l] * (same + 2.0 * weight[1 + a][l] * weight[1 + i][l]);
                }
            }
            // V/4 at each vertex
            for (below, e) in column[M..].iter_mut().zip(&e[c * all..(c + 1) * all]) {
                *below = e.map(|e| 0.25 * e);
            }
        }
    }
    let products = panel::eliminate(&mut panel, M, height)?;
    (0..M).for_each(|c| kept.extend_from_slice(&panel[c * height + c..c * height + M]));
    Some(products)
}

/// A tet with linear strain that is rigid before it flows: every point for itself, `k += Eᵀ (Σ_j c_j c_jᵀ ⊗ H_j⁻¹) E`.
fn add_rigid_plastic(
    e: &[Lane],
    rule: Rule,
    weights: &[[Lane; YIELD_ROWS]],
    proximal: f64,
    all: usize,
    k: &mut [Lane],
    kept: &mut Vec<Lane>,
) {
    const M: usize = VERTEX_VALUES;
    let mut m = [[0.0; LANES]; M * M];
    for (combination, weight) in rule.points().iter().zip(weights) {
        // H⁻¹ = (I − g w wᵀ)/(α + ρ)
        let (mut inverse, mut fraction) = ([0.0; LANES], [0.0; LANES]);
        for l in 0..LANES {
            let n: f64 = (1..YIELD_ROWS).map(|i| weight[i][l] * weight[i][l]).sum();
            let (a, beta) = (weight[0][l] + proximal, 2.0 * weight[0][l]);
            inverse[l] = 1.0 / a;
            fraction[l] = beta / (a + beta * n);
        }
        kept.push(inverse);
        kept.push(fraction);
        kept.extend_from_slice(&weight[1..]);
        for (v, &cv) in combination.iter().enumerate().filter(|c| *c.1 != 0.0) {
            for (w, &cw) in combination.iter().enumerate().filter(|c| *c.1 != 0.0) {
                for a in 0..5 {
                    for b in 0..5 {
                        let same = if a == b { 1.0 } else { 0.0 };
                        for l in 0..LANES {
                            m[(5 * v + a) * M + 5 * w + b][l] += cv
                                * cw
                                * inverse[l]
                                * (same - fraction[l] * weight[1 + a][l] * weight[1 + b][l]);
                        }
                    }
                }
            }
        }
    }
    let mut y = vec![[0.0; LANES]; M * all];
    Arch::new().dispatch(
        #[inline(always)]
        || {
            for (row, y) in m.chunks_exact(M).zip(y.chunks_exact_mut(all)) {
                for (m, e) in row.iter().zip(e.chunks_exact(all)) {
                    for (y, e) in y.iter_mut().zip(e) {
                        for l in 0..LANES {
                            y[l] += m[l] * e[l];
                        }
                    }
                }
            }
            let mut at = 0;
            for c in 0..all {
                let mut r = c;
                while r < all {
                    let rows = (all - r).min(4);
                    let mut sums = [[0.0; LANES]; 4];
                    for s in 0..M {
                        let factor = y[s * all + c];
                        let row = &e[s * all + r..s * all + r + rows];
                        for (sum, e) in sums.iter_mut().zip(row) {
                            for l in 0..LANES {
                                sum[l] += e[l] * factor[l];
                            }
                        }
                    }
                    for sum in &sums[..rows] {
                        for l in 0..LANES {
                            k[at][l] += sum[l];
                        }
                        at += 1;
                    }
                    r += rows;
                }
            }
        },
    );
}

/// `y ← H⁻¹ y`.
fn solve_own(batch: &Batch, factor: &[Lane], proximal: f64, y: &mut [Lane]) {
    match batch.shape {
        Shape::Stress => solve_packed(factor, y),
        Shape::Flow { subtets, rule: Rule::Hencky, .. } => {
            let len = VERTEX_VALUES * (VERTEX_VALUES + 1) / 2;
            for subtet in 0..subtets {
                let own = &mut y[subtet * VERTEX_VALUES..(subtet + 1) * VERTEX_VALUES];
                solve_packed(&factor[subtet * len..(subtet + 1) * len], own);
            }
        }
        Shape::Flow { .. } => {
            let points = batch.shape.points();
            for (point, y) in factor.chunks_exact(7).zip(y.chunks_exact_mut(5)).take(points) {
                for l in 0..LANES {
                    let along: f64 = (0..5).map(|a| point[2 + a][l] * y[a][l]).sum::<f64>() * point[1][l];
                    (0..5).for_each(|a| y[a][l] = point[0][l] * (y[a][l] - along * point[2 + a][l]));
                }
            }
            y[5 * points..].iter_mut().for_each(|y| (0..LANES).for_each(|l| y[l] /= proximal));
        }
    }
}

/// Solves with a Cholesky factor, lower triangle by columns.
fn solve_packed(factor: &[Lane], y: &mut [Lane]) {
    let n = y.len();
    Arch::new().dispatch(
        #[inline(always)]
        || {
            let mut at = 0;
            for c in 0..n {
                let column = &factor[at..at + n - c];
                let mut x = y[c];
                (0..LANES).for_each(|l| x[l] /= column[0][l]);
                y[c] = x;
                for (y, f) in y[c + 1..].iter_mut().zip(&column[1..]) {
                    for l in 0..LANES {
                        y[l] -= f[l] * x[l];
                    }
                }
                at += n - c;
            }
            for c in (0..n).rev() {
                at -= n - c;
                let column = &factor[at..at + n - c];
                let mut x = y[c];
                for (y, f) in y[c + 1..].iter().zip(&column[1..]) {
                    for l in 0..LANES {
                        x[l] -= f[l] * y[l];
                    }
                }
                (0..LANES).for_each(|l| x[l] /= column[0][l]);
                y[c] = x;
            }
        },
    );
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
