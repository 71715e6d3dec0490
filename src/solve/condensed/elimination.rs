//! One batch of elements that yield: its parameters and inner displacements eliminated, in dense
//! kernels eight elements wide.
//!
//! With V_j the vector block of `W_j⁻²`, the parameters' own matrix is
//! `H = F + Σ B_jᵀ V_j B_j + ρ`; what is left is `T H⁻¹ Tᵀ`.

use super::panel;
use crate::elements::batch::Batch;
use crate::elements::yielding_element::{Rule, Shape, VERTEX_VALUES, YIELD_ROWS};
use crate::math::lanes::{Place, kernel, solve_packed};
use crate::math::wide::{LANES, Lane, parts, registers, registers_mut};
use pulp::Simd;

/// Values of one yield point's scaling: 1/η, then the six of w. The vector block of `W⁻²` is
/// `η⁻² (I + 2 w₁w₁ᵀ)`.
pub const SCALING: usize = 1 + YIELD_ROWS;
/// The scaling at each yield point of a batch.
pub type Weights = Vec<[Lane; SCALING]>;

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

/// Entries kept of a batch's elimination.
pub fn kept(batch: &Batch) -> usize {
    let inner = batch.shape.inner() * batch.displacements();
    let own = match batch.shape {
        Shape::Stress => 30 * 31 / 2,
        Shape::Flow { subtets, rule: Rule::Hencky, .. } => {
            subtets * VERTEX_VALUES * (VERTEX_VALUES + 1) / 2
        }
        // the scaling of the points is enough
        Shape::Flow { .. } => 0,
    };
    own + inner
}

/// The factored inner block of a batch.
pub fn inner_panel<'a>(batch: &Batch, factor: &'a [Lane]) -> &'a [Lane] {
    &factor[factor.len() - batch.shape.inner() * batch.displacements()..]
}

/// Memory of eliminations, used again from batch to batch.
#[derive(Default)]
pub struct Scratch {
    panel: Buffer,
    product: Buffer,
    own: Vec<Lane>,
}

/// Lanes that begin where a cache line does: a register is loaded from one line instead of two.
#[derive(Default)]
struct Buffer(Vec<f64>);

impl Buffer {
    /// So many lanes with any content.
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
/// columns; its factor is left in `kept`. `None` where a pivot is not positive.
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

kernel! {
    /// The root `√α (I + γ w wᵀ)` of `V = α (I + 2 w wᵀ)` of each point times its rows of B,
    /// `columns` long.
    fn times_roots(simd; weights: &'a [[Lane; SCALING]], b: &'a [Lane], columns: usize, y: &'a mut [Lane]) {
        let (weights, b, y) = (registers::<S>(weights.as_flattened()), registers::<S>(b), registers_mut::<S>(y));
        let (one, two) = (simd.splat_f64s(1.0), simd.splat_f64s(2.0));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            for point in 0..weights.len() / (SCALING * parts::<S>()) {
                let size = weights[at.of(SCALING * point)];
                let mut w = [one; 5];
                let mut n = simd.splat_f64s(0.0);
                for a in 0..5 {
                    w[a] = weights[at.of(SCALING * point + 2 + a)];
                    n = simd.mul_add_e_f64s(w[a], w[a], n);
                }
                // (√(1 + 2n) − 1)/n without cancellation
                let gamma = simd.div_f64s(two, simd.add_f64s(simd.sqrt_f64s(simd.mul_add_e_f64s(two, n, one)), one));
                for c in 0..columns {
                    let mut rows = [one; 5];
                    let mut along = simd.splat_f64s(0.0);
                    for a in 0..5 {
                        rows[a] = b[at.of((5 * point + a) * columns + c)];
                        along = simd.mul_add_e_f64s(w[a], rows[a], along);
                    }
                    let along = simd.mul_f64s(along, gamma);
                    for a in 0..5 {
                        let v = simd.mul_f64s(size, simd.mul_add_e_f64s(along, w[a], rows[a]));
                        y[at.of((5 * point + a) * columns + c)] = v;
                    }
                }
            }
        }
    }
}

/// The super-element: dense in its 30 parameters.
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
    /// The parameters' own matrix on top of the panel, their strains below.
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
        let (weights, flexibility) = (registers::<S>(weights.as_flattened()), registers::<S>(flexibility));
        // V/4 at each vertex
        let quarter = simd.splat_f64s(0.25);
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let [own, others] = [16.0, -4.0].map(|x| simd.mul_f64s(flexibility[offset], simd.splat_f64s(x)));
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
                        panel[at.of(c * height + M + i)] = simd.mul_f64s(quarter, e[at.of(c * all + i)]);
                    }
                }
            }
        }
    }
}

/// A tet with linear strain that is elastic before it yields: its four points are coupled by the
/// mass matrix.
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

/// `H⁻¹ = a (I − g w wᵀ)` of a point that is rigid before it flows: a, g, w.
#[inline(always)]
fn point_inverse<S: Simd>(
    simd: S,
    weight: &[S::f64s],
    at: Place,
    proximal: f64,
) -> (S::f64s, S::f64s, [S::f64s; 5]) {
    let mut w = [simd.splat_f64s(0.0); 5];
    let mut n = simd.splat_f64s(0.0);
    for a in 0..5 {
        w[a] = weight[at.of(2 + a)];
        n = simd.mul_add_e_f64s(w[a], w[a], n);
    }
    let size = weight[at.of(0)];
    let alpha = simd.mul_f64s(size, size);
    let (a, beta) = (simd.add_f64s(alpha, simd.splat_f64s(proximal)), simd.add_f64s(alpha, alpha));
    let fraction = simd.div_f64s(beta, simd.mul_add_e_f64s(beta, n, a));
    (simd.div_f64s(simd.splat_f64s(1.0), a), fraction, w)
}

kernel! {
    /// `y = (Σ_j c_j c_jᵀ ⊗ H_j⁻¹) E` of a tet with linear strain that is rigid before it flows:
    /// each point for itself.
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
                let (inverse, fraction, w) = point_inverse(simd, registers::<S>(weight), at, proximal);
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

kernel! {
    /// `y ← H⁻¹ y` at points that are rigid before they flow.
    fn solve_points(simd; weights: &'a [[Lane; SCALING]], proximal: f64, y: &'a mut [Lane]) {
        let y = registers_mut::<S>(y);
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            for (point, weight) in weights.iter().enumerate() {
                let (inverse, fraction, w) = point_inverse(simd, registers::<S>(weight), at, proximal);
                let mut along = simd.splat_f64s(0.0);
                for a in 0..5 {
                    along = simd.mul_add_e_f64s(w[a], y[at.of(5 * point + a)], along);
                }
                let along = simd.mul_f64s(along, fraction);
                for a in 0..5 {
                    let y = &mut y[at.of(5 * point + a)];
                    *y = simd.mul_f64s(inverse, simd.negate_mul_add_e_f64s(along, w[a], *y));
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

kernel! {
    /// `W⁻²` of each yield point of a batch times its six values, in place.
    pub fn inverse_square(simd; weights: &'a [[Lane; SCALING]], values: &'a mut [Lane]) {
        let values = registers_mut::<S>(values);
        let one = simd.splat_f64s(1.0);
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            for (point, weight) in weights.iter().enumerate() {
                let weight = registers::<S>(weight);
                let (e, w0) = (weight[at.of(0)], weight[at.of(1)]);
                let (mut w, mut v) = ([one; 5], [one; 5]);
                let mut v0 = values[at.of(YIELD_ROWS * point)];
                for a in 0..5 {
                    w[a] = weight[at.of(2 + a)];
                    v[a] = values[at.of(YIELD_ROWS * point + 1 + a)];
                }
                let share = simd.div_f64s(one, simd.add_f64s(one, w0));
                for _ in 0..2 {
                    let mut t = simd.splat_f64s(0.0);
                    for a in 0..5 {
                        t = simd.mul_add_e_f64s(w[a], v[a], t);
                    }
                    let f = simd.sub_f64s(simd.mul_f64s(t, share), v0);
                    v0 = simd.mul_f64s(e, simd.sub_f64s(simd.mul_f64s(w0, v0), t));
                    for a in 0..5 {
                        v[a] = simd.mul_f64s(e, simd.mul_add_e_f64s(w[a], f, v[a]));
                    }
                }
                values[at.of(YIELD_ROWS * point)] = v0;
                for a in 0..5 {
                    values[at.of(YIELD_ROWS * point + 1 + a)] = v[a];
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::batch::Placed;
    use crate::elements::yielding_element::YieldingElement;

    /// An element with any numbers, its flexibility and inner stiffness definite.
    fn element(shape: Shape, k: usize) -> YieldingElement {
        let mut data: Vec<f64> =
            (0..shape.len(k)).map(|i| ((i * 7919) % 1009) as f64 / 1009.0 - 0.5).collect();
        match shape {
            Shape::Stress => {
                (0..30).for_each(|c| data[30 * k + panel::packed(30, c)] = 50.0);
            }
            Shape::Flow { subtets, inner, .. } => {
                let (all, length) = (inner + k, data.len());
                data[subtets * VERTEX_VALUES * all..][..subtets].fill(0.05);
                for c in 0..inner {
                    let column = &mut data[length - (inner - c) * all..][..inner];
                    column.fill(0.1);
                    column[c] = 50.0;
                }
            }
        }
        YieldingElement {
            shape,
            columns: (0..k as u32).collect(),
            data,
            q: vec![],
            h: vec![],
            inner_stiffness: vec![],
        }
    }

    /// What is left of an element times displacements is the force that the element's own equations
    /// give, for every kind.
    #[test]
    fn what_is_left_gives_the_forces_of_the_element() {
        let flow =
            |subtets, rule, inner, pressures| Shape::Flow { subtets, rule, inner, pressures };
        let shapes = [
            (flow(1, Rule::Hencky, 0, 0), 29, 0.0),
            (flow(4, Rule::Hencky, 15, 0), 30, 0.0),
            (flow(1, Rule::TenPoints, 0, 4), 30, 1e-2),
            (flow(4, Rule::TenPoints, 0, 1), 30, 1e-2),
            (Shape::Stress, 36, 1e-3),
        ];
        for (shape, k, proximal) in shapes {
            let lanes: Vec<Placed> =
                (0..LANES as u32).map(|l| (element(shape, k), 1000 * l, 1000 * l)).collect();
            let batch = Batch::new(&lanes);
            let weights: Weights = (0..shape.points())
                .map(|point| {
                    let w: [f64; 5] = std::array::from_fn(|a| 0.1 * ((a + 3 * point) % 7) as f64);
                    let w0 = (1.0 + w.iter().map(|x| x * x).sum::<f64>()).sqrt();
                    [1.3, w0, w[0], w[1], w[2], w[3], w[4]].map(|x| [x; LANES])
                })
                .collect();
            let (mut kept, mut scratch) = (Vec::new(), Scratch::default());
            let left =
                eliminate(&batch, &weights, proximal, &mut kept, &mut scratch).expect("definite");
            let (all, inner) = (batch.displacements(), shape.inner());
            let mut v: Vec<Lane> =
                (0..all).map(|i| [((31 * i) % 17) as f64 / 17.0 - 0.5; LANES]).collect();
            v[..inner].fill([0.0; LANES]);
            if inner > 0 {
                panel::backward(inner_panel(&batch, &kept), inner, all, &mut v);
            }
            let mut strain = vec![[0.0; LANES]; shape.parameters()];
            batch.strain(&v, &mut strain);
            let mut sigma = strain.clone();
            solve_own(&batch, &weights, &kept, proximal, &mut sigma);
            // the parameters' own rows: Tᵀv = F σ + ρ σ + Bᵀ V B σ
            let mut rows: Vec<Lane> = Vec::new();
            for d in batch.deviators(&sigma).chunks_exact(5) {
                rows.push([0.0; LANES]);
                rows.extend_from_slice(d);
            }
            inverse_square(&weights, &mut rows);
            let scaled: Vec<Lane> = rows
                .chunks_exact(YIELD_ROWS)
                .flat_map(|r| &r[1..])
                .map(|r| r.map(|x| -x))
                .collect();
            batch.subtract_flexibility(&sigma, &mut strain);
            batch.add_deviators(&scaled, &mut strain);
            for (s, x) in strain.iter().zip(&sigma) {
                assert!(
                    (s[5] - proximal * x[5]).abs() < 1e-12,
                    "{shape:?}: {}",
                    s[5] - proximal * x[5]
                );
            }
            let mut force = vec![[0.0; LANES]; all];
            batch.add_force(&sigma, &mut force);
            batch.add_inner(&v, &mut force);
            assert!(
                force[..inner].iter().all(|f| f[0].abs() < 1e-12),
                "{shape:?}: inner forces vanish"
            );
            let entry =
                |r: usize, c: usize| left[panel::packed(k, r.min(c)) + r.max(c) - r.min(c)][6];
            for r in 0..k {
                let product: f64 = (0..k).map(|c| entry(r, c) * v[inner + c][6]).sum();
                let size = 1.0 + product.abs();
                assert!(
                    (product - force[inner + r][6]).abs() < 1e-10 * size,
                    "{shape:?} row {r}: {product}"
                );
            }
        }
    }
}
