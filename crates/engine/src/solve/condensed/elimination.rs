//! Elimination of the parameters and inner displacements of one batch of elements that yield, in
//! dense kernels eight elements wide.
//!
//! With V_j the vector block of `W_j⁻²`, the matrix of the parameters is
//! `H = F + Σ B_jᵀ V_j B_j + ρ`; the elimination leaves `T H⁻¹ Tᵀ`.

use super::panel;
use super::yield_points::{SCALING, Weights, point_inverse, solve_points, times_roots};
use crate::elements::packed_elements::Batch;
use crate::elements::yielding_element::Rule;
use crate::elements::yielding_element::Shape;
use crate::elements::yielding_element::VERTEX_VALUES;
use bracket_base::math::lanes::{Place, kernel, solve_packed};
use bracket_base::math::wide::{LANES, Lane, parts, registers, registers_mut};

/// Mean of the diagonal of H.
pub fn own_trace(batch: &Batch, weights: &Weights) -> Lane {
    let mut trace = [0.0; LANES];
    let count = batch.shape.parameters() as f64;
    let b = batch.parts()[2];
    for (point, w) in weights.iter().enumerate() {
        for a in 0..5 {
            for l in 0..LANES {
                let v = w[0][l] * w[0][l] * (1.0 + 2.0 * w[2 + a][l] * w[2 + a][l]);
                let rows = match batch.shape {
                    Shape::Stress => {
                        b[(5 * point + a) * 30..][..30].iter().map(|x| x[l] * x[l]).sum()
                    }
                    Shape::Flow { .. } => 1.0,
                };
                trace[l] += v * rows / count;
            }
        }
    }
    trace
}

/// Number of stored entries of the elimination of a batch.
pub fn kept(batch: &Batch) -> usize {
    let inner = batch.shape.inner() * batch.displacements();
    let own = match batch.shape {
        Shape::Stress => 30 * 31 / 2,
        Shape::Flow { subtets, rule: Rule::Hencky, .. } => {
            subtets * VERTEX_VALUES * (VERTEX_VALUES + 1) / 2
        }
        // the scaling of the points determines it
        Shape::Flow { .. } => 0,
    };
    own + inner
}

/// The factored inner block of a batch.
pub fn inner_panel<'a>(batch: &Batch, factor: &'a [Lane]) -> &'a [Lane] {
    &factor[factor.len() - batch.shape.inner() * batch.displacements()..]
}

/// Work memory of eliminations, used again from batch to batch.
#[derive(Default)]
pub struct Scratch {
    panel: Buffer,
    product: Buffer,
    own: Vec<Lane>,
}

/// Lanes aligned to cache lines, so that a register is loaded from one line instead of two.
#[derive(Default)]
struct Buffer(Vec<f64>);

impl Buffer {
    /// `count` lanes with any content.
    fn lanes(&mut self, count: usize) -> &mut [Lane] {
        const LINE: usize = 64;
        if self.0.len() < LANES * (count + 1) {
            self.0.resize(LANES * (count + 1), 0.0);
        }
        let skip = self.0.as_ptr().align_offset(LINE).min(LANES);
        &mut self.0[skip..].as_chunks_mut().0[..count]
    }
}

/// Eliminates one batch: `T H⁻¹ Tᵀ` (the inner displacements eliminated as well), lower triangle by
/// columns; its factor is stored in `kept`. `None` where a pivot is not positive.
pub fn eliminate(
    batch: &Batch,
    weights: &Weights,
    proximal: f64,
    kept: &mut Vec<Lane>,
    scratch: &mut Scratch,
) -> Option<Vec<Lane>> {
    kept.clear();
    let [strain, flexibility, volume, inner_part] = batch.parts();
    let all = batch.displacements();
    let Shape::Flow { subtets, rule, inner, .. } = batch.shape else {
        return eliminate_stress(batch, weights, proximal, kept, scratch);
    };
    let mut k = vec![[0.0; LANES]; all * (all + 1) / 2];
    let points = rule.points().len();
    for subtet in 0..subtets {
        let e = &strain[subtet * VERTEX_VALUES * all..][..VERTEX_VALUES * all];
        let weights = &weights[subtet * points..][..points];
        if rule == Rule::Hencky {
            eliminate_hencky(e, &flexibility[subtet], weights, all, kept, scratch, &mut k)?;
        } else {
            let y = scratch.product.lanes(VERTEX_VALUES * all);
            rigid_plastic(e, rule, weights, proximal, all, y);
            panel::add_products(e, y, all, VERTEX_VALUES, 0, &mut k);
        }
    }
    if !volume.is_empty() {
        let scaled = scratch.product.lanes(volume.len());
        scaled.iter_mut().zip(volume).for_each(|(s, v)| *s = v.map(|v| v / proximal));
        panel::add_products(volume, scaled, all, volume.len() / all, 0, &mut k);
    }
    if inner == 0 {
        return Some(k);
    }
    let own = scratch.panel.lanes(inner * all);
    own.copy_from_slice(inner_part);
    let mut at = 0;
    for (c, column) in own.chunks_exact_mut(all).enumerate() {
        for p in &mut column[c..] {
            (0..LANES).for_each(|l| p[l] += k[at][l]);
            at += 1;
        }
    }
    if !panel::factor(own, inner, all) {
        return None;
    }
    kept.extend_from_slice(own);
    k.drain(..at);
    panel::subtract_products(own, inner, all, &mut k);
    Some(k)
}

/// Eliminates a super-element, which is dense in its 30 parameters.
fn eliminate_stress(
    batch: &Batch,
    weights: &Weights,
    proximal: f64,
    kept: &mut Vec<Lane>,
    scratch: &mut Scratch,
) -> Option<Vec<Lane>> {
    const M: usize = 30;
    let [tt, flexibility, b, _] = batch.parts();
    let k = batch.shared();
    let height = M + k;
    let Scratch { panel, product, own } = scratch;
    let (panel, y) = (panel.lanes(M * height), product.lanes(80 * M));
    own.clear();
    own.extend_from_slice(flexibility);
    times_roots(weights, b, M, y);
    panel::add_products(y, y, M, 80, 0, own);
    for c in 0..M {
        let column = &mut panel[c * height..(c + 1) * height];
        let start = panel::packed(M, c);
        column[c..M].copy_from_slice(&own[start..start + M - c]);
        column[c].iter_mut().for_each(|d| *d += proximal);
        column[M..].copy_from_slice(&tt[c * k..(c + 1) * k]);
    }
    if !panel::factor(panel, M, height) {
        return None;
    }
    let mut products = vec![[0.0; LANES]; k * (k + 1) / 2];
    panel::add_products(&panel[..], &panel[..], height, M, M, &mut products);
    (0..M).for_each(|c| kept.extend_from_slice(&panel[c * height + c..c * height + M]));
    Some(products)
}

kernel! {
    /// Fills the panel: the matrix of the parameters on top, their strains below.
    fn fill_hencky(
        simd;
        e: &'a [Lane],
        flexibility: &'a [Lane],
        weights: &'a [[Lane; SCALING]],
        all: usize,
        panel: &'a mut [Lane],
    ) {
        const M: usize = VERTEX_VALUES;
        let height = M + all;
        let (e, panel) = (registers::<S>(e), registers_mut::<S>(panel));
        let weights = registers::<S>(weights.as_flattened());
        let flexibility = registers::<S>(flexibility);
        // V/4 at each vertex
        let quarter = simd.splat_f64s(0.25);
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let [own, others] =
                [16.0, -4.0].map(|x| simd.mul_f64s(flexibility[offset], simd.splat_f64s(x)));
            for v in 0..4 {
                let size = weights[at.of(SCALING * v)];
                let alpha = simd.mul_f64s(size, size);
                let twice = simd.add_f64s(alpha, alpha);
                for a in 0..5 {
                    let c = 5 * v + a;
                    for r in c..M {
                        panel[at.of(c * height + r)] = simd.splat_f64s(0.0);
                    }
                    for w in v + 1..4 {
                        panel[at.of(c * height + 5 * w + a)] = others;
                    }
                    let along = simd.mul_f64s(twice, weights[at.of(SCALING * v + 2 + a)]);
                    for i in a..5 {
                        let w = weights[at.of(SCALING * v + 2 + i)];
                        panel[at.of(c * height + 5 * v + i)] = simd.mul_f64s(along, w);
                    }
                    let diagonal = &mut panel[at.of(c * height + c)];
                    *diagonal = simd.add_f64s(*diagonal, simd.add_f64s(alpha, own));
                    for i in 0..all {
                        panel[at.of(c * height + M + i)] =
                            simd.mul_f64s(quarter, e[at.of(c * all + i)]);
                    }
                }
            }
        }
    }
}

/// Eliminates a tet with linear strain that is elastic before it yields; the mass matrix couples
/// its four points.
fn eliminate_hencky(
    e: &[Lane],
    flexibility: &Lane,
    weights: &[[Lane; SCALING]],
    all: usize,
    kept: &mut Vec<Lane>,
    scratch: &mut Scratch,
    k: &mut [Lane],
) -> Option<()> {
    const M: usize = VERTEX_VALUES;
    let height = M + all;
    let panel = scratch.panel.lanes(M * height);
    fill_hencky(e, std::slice::from_ref(flexibility), weights, all, panel);
    if !panel::factor(panel, M, height) {
        return None;
    }
    panel::add_products(panel, panel, height, M, M, k);
    (0..M).for_each(|c| kept.extend_from_slice(&panel[c * height + c..c * height + M]));
    Some(())
}

kernel! {
    /// `y = (Σ_j c_j c_jᵀ ⊗ H_j⁻¹) E` of a tet with linear strain that is rigid before it yields;
    /// the points are independent.
    fn rigid_plastic(
        simd;
        e: &'a [Lane],
        rule: Rule,
        weights: &'a [[Lane; SCALING]],
        proximal: f64,
        all: usize,
        y: &'a mut [Lane],
    ) {
        const M: usize = VERTEX_VALUES;
        let zero = simd.splat_f64s(0.0);
        let (e, y) = (registers::<S>(e), registers_mut::<S>(y));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let mut m = [zero; M * M];
            for (combination, weight) in rule.points().iter().zip(weights) {
                let weight = registers::<S>(weight);
                let (inverse, fraction, w) = point_inverse(simd, weight, at, proximal);
                // one block of a point serves all pairs of its vertices
                let mut block = [[zero; 5]; 5];
                let taken = simd.mul_f64s(inverse, fraction);
                for a in 0..5 {
                    let along = simd.mul_f64s(taken, w[a]);
                    for b in 0..5 {
                        let same = if a == b { inverse } else { zero };
                        block[a][b] = simd.negate_mul_add_e_f64s(along, w[b], same);
                    }
                }
                for v in 0..4 {
                    for u in 0..4 {
                        let factor = combination[v] * combination[u];
                        if factor == 0.0 {
                            continue;
                        }
                        let factor = simd.splat_f64s(factor);
                        for a in 0..5 {
                            for b in 0..5 {
                                let entry = &mut m[(5 * v + a) * M + 5 * u + b];
                                *entry = simd.mul_add_e_f64s(factor, block[a][b], *entry);
                            }
                        }
                    }
                }
            }
            for rows in (0..M).step_by(5) {
                for c in 0..all {
                    let mut sums = [zero; 5];
                    for j in 0..M {
                        let right = e[at.of(j * all + c)];
                        for q in 0..5 {
                            sums[q] = simd.mul_add_e_f64s(m[(rows + q) * M + j], right, sums[q]);
                        }
                    }
                    for q in 0..5 {
                        y[at.of((rows + q) * all + c)] = sums[q];
                    }
                }
            }
        }
    }
}

/// `y ← H⁻¹ y`.
pub fn solve_own(batch: &Batch, weights: &Weights, factor: &[Lane], proximal: f64, y: &mut [Lane]) {
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
            let (yielding, pressures) = y.split_at_mut(5 * points);
            solve_points(weights, proximal, yielding);
            pressures.as_flattened_mut().iter_mut().for_each(|y| *y /= proximal);
        }
    }
}

#[cfg(test)]
mod tests;
