//! One batch of elements that yield: its parameters and inner displacements eliminated, in dense kernels eight elements wide.
//!
//! With V_j the vector block of `W_j⁻²`, the parameters' own matrix is `H = F + Σ B_jᵀ V_j B_j + ρ`; what is left is `T H⁻¹ Tᵀ`.

use super::panel;
use crate::model::batch::{Batch, LANES, Lane, Rule, Shape, VERTEX_VALUES, YIELD_ROWS};
use pulp::Arch;

/// `V_j = α (I + 2 w wᵀ)` of each yield point of a batch: α, then the five of w.
pub type Weights = Vec<[Lane; YIELD_ROWS]>;

/// Mean of the diagonal of H.
pub fn own_trace(batch: &Batch, weights: &Weights) -> Lane {
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
pub fn kept(batch: &Batch) -> usize {
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
pub fn inner_panel<'a>(batch: &Batch, factor: &'a [Lane]) -> &'a [Lane] {
    &factor[factor.len() - batch.shape.inner() * batch.displacements()..]
}

/// Eliminates one batch: `T H⁻¹ Tᵀ` (the inner displacements eliminated as well), lower triangle by columns; its factor is
/// left in `kept`.
pub fn eliminate(batch: &Batch, weights: &Weights, proximal: f64, kept: &mut Vec<Lane>) -> Option<Vec<Lane>> {
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

/// The root `√α (I + γ w wᵀ)` of `V = α (I + 2 w wᵀ)`.
struct Root {
    /// √α.
    size: Lane,
    /// γ w.
    along: [Lane; 5],
    w: [Lane; 5],
}

impl Root {
    #[inline(always)]
    fn new(weight: &[Lane; YIELD_ROWS]) -> Self {
        let [alpha, w @ ..] = *weight;
        let (mut size, mut along) = ([0.0; LANES], w);
        for l in 0..LANES {
            let n = (0..5).map(|i| w[i][l] * w[i][l]).sum::<f64>();
            // (√(1 + 2n) − 1)/n without cancellation
            let gamma = 2.0 / ((1.0 + 2.0 * n).sqrt() + 1.0);
            size[l] = alpha[l].sqrt();
            (0..5).for_each(|i| along[i][l] *= gamma);
        }
        Self { size, along, w }
    }

    /// The root times a vector.
    #[inline(always)]
    fn times(&self, b: [Lane; 5]) -> [Lane; 5] {
        let mut y = b;
        let mut part = [0.0; LANES];
        for i in 0..5 {
            for l in 0..LANES {
                part[l] += self.along[i][l] * b[i][l];
            }
        }
        for i in 0..5 {
            for l in 0..LANES {
                y[i][l] = self.size[l] * (b[i][l] + part[l] * self.w[i][l]);
            }
        }
        y
    }
}

/// The super-element: dense in its 30 parameters.
fn eliminate_stress(batch: &Batch, weights: &Weights, proximal: f64, kept: &mut Vec<Lane>) -> Option<Vec<Lane>> {
    const M: usize = 30;
    let [tt, flexibility, b, _] = batch.parts();
    let k = batch.shared();
    let height = M + k;
    let mut panel = vec![[0.0; LANES]; M * height];
    let mut y = vec![[0.0; LANES]; 80 * M];
    let mut own = flexibility.to_vec();
    Arch::new().dispatch(
        #[inline(always)]
        || {
            for (point, weight) in weights.iter().enumerate() {
                let root = Root::new(weight);
                for c in 0..M {
                    let rows = std::array::from_fn(|i| b[(5 * point + i) * M + c]);
                    for (i, v) in root.times(rows).into_iter().enumerate() {
                        y[(5 * point + i) * M + c] = v;
                    }
                }
            }
            panel::add_products(&y, &y, M, 80, 0, &mut own);
            for c in 0..M {
                let column = &mut panel[c * height..(c + 1) * height];
                let start = panel::packed(M, c);
                column[c..M].copy_from_slice(&own[start..start + M - c]);
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
                            m[(5 * v + a) * M + 5 * w + b][l] +=
                                cv * cw * inverse[l] * (same - fraction[l] * weight[1 + a][l] * weight[1 + b][l]);
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
            panel::add_products(e, &y, all, M, 0, k);
        },
    );
}

/// `y ← H⁻¹ y`.
pub fn solve_own(batch: &Batch, factor: &[Lane], proximal: f64, y: &mut [Lane]) {
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
