use super::*;
use crate::elements::packed_elements::Placed;
use crate::elements::yielding_element::YIELD_ROWS;
use crate::elements::yielding_element::YieldingElement;
use crate::solve::condensed::yield_points::inverse_square;

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
        maps: vec![],
        q: vec![],
        h: vec![],
        inner_stiffness: vec![],
    }
}

/// The condensed matrix of an element times displacements equals the force of the element's own
/// equations, for every kind of element.
#[test]
fn condensed_matrix_gives_the_forces_of_the_element() {
    let flow = |subtets, rule, inner, pressures| Shape::Flow { subtets, rule, inner, pressures };
    let shapes = [
        (flow(1, Rule::Hencky, 0, 0), 29, 0.0),
        (flow(4, Rule::Hencky, 15, 0), 30, 0.0),
        (flow(1, Rule::TenPoints, 0, 4), 30, 1e-2),
        (flow(4, Rule::TenPoints, 0, 1), 30, 1e-2),
        (flow(4, Rule::Gauss, 0, 1), 30, 1e-2),
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
        let scaled: Vec<Lane> =
            rows.chunks_exact(YIELD_ROWS).flat_map(|r| &r[1..]).map(|r| r.map(|x| -x)).collect();
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
        let entry = |r: usize, c: usize| left[panel::packed(k, r.min(c)) + r.max(c) - r.min(c)][6];
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
