//! Directions in which elements may be long: the absolute second derivatives of a vector field of
//! 10-node tets. The interpolation error of the field along a direction t is proportional to
//! `h² tᵀ|H|t`; elements whose edges all have the same error are long where |H| is small.
//!
//! # Source
//! Loseille and Alauzet, Continuous mesh framework, SIAM J. Numer. Anal. 49 (2011).

use crate::elements::geometry::gradients;
use crate::elements::space::Tet10Space;
use crate::mesh::TetMesh;
use bracket_base::math::eigen::mapped;
use bracket_base::math::mandel::{Mandel, symmetric_part};
use bracket_base::math::vec3::V3;
use rayon::prelude::*;

/// `Σ |H_k|` of each tet \[1/mm, for a field in mm\]: the absolute values of the second derivatives
/// of the three components, which are constant in a tet. `u`: the field at vertices and mid-side
/// nodes. In split elements the outer nodes count.
pub fn second_derivatives(mesh: &TetMesh, u: &[V3]) -> Vec<Mandel> {
    let space = Tet10Space::new(mesh);
    (0..mesh.tets.len())
        .into_par_iter()
        .map(|e| {
            let nodes = space.tet(mesh, e).map(|n| u[n]);
            let mut sum = [0.0; 6];
            for component in 0..3 {
                let h = hessian(&mesh.corners(e), &nodes.map(|u| u[component]));
                sum.iter_mut().zip(mapped(&h, f64::abs)).for_each(|(s, h)| *s += h);
            }
            sum
        })
        .collect()
}

/// The same from a field given at the vertices only. Its gradients in the tets, averaged to the
/// vertices with the volumes, are differentiated once more.
pub fn recovered_second_derivatives(mesh: &TetMesh, u: &[V3]) -> Vec<Mandel> {
    let derivative = |e: usize, values: [f64; 4]| -> V3 {
        let g = gradients(&mesh.corners(e));
        std::array::from_fn(|d| (0..4).map(|i| values[i] * g[i][d]).sum())
    };
    let mut sum = vec![[[0.0; 3]; 3]; mesh.nodes.len()];
    let mut volume = vec![0.0; mesh.nodes.len()];
    for (e, t) in mesh.tets.iter().enumerate() {
        let v = mesh.volume(e);
        let of: [V3; 3] = std::array::from_fn(|c| derivative(e, t.map(|n| u[n as usize][c])));
        for n in t.map(|n| n as usize) {
            volume[n] += v;
            (0..3).for_each(|c| (0..3).for_each(|d| sum[n][c][d] += v * of[c][d]));
        }
    }
    let one = |(e, t): (usize, &[u32; 4])| {
        let mut total = [0.0; 6];
        for c in 0..3 {
            let at = |d: usize| t.map(|n| sum[n as usize][c][d] / volume[n as usize]);
            let h = symmetric_part(&std::array::from_fn(|d| derivative(e, at(d))));
            total.iter_mut().zip(mapped(&h, f64::abs)).for_each(|(s, h)| *s += h);
        }
        total
    };
    mesh.tets.iter().enumerate().map(one).collect()
}

/// The second derivatives of a quadratic function given at the ten nodes of a tet.
fn hessian(corners: &[V3; 4], values: &[f64; 10]) -> Mandel {
    let g = gradients(corners);
    let product = |a: V3, b: V3| symmetric_part(&a.map(|x| b.map(|y| x * y)));
    let mut h = [0.0; 6];
    let mut add = |weight: f64, p: Mandel| h.iter_mut().zip(p).for_each(|(h, p)| *h += weight * p);
    for i in 0..4 {
        add(4.0 * values[i], product(g[i], g[i]));
    }
    for (value, [i, j]) in values[4..].iter().zip(crate::mesh::tet::EDGES) {
        add(8.0 * value, product(g[i], g[j]));
    }
    h
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::fixtures::cubes;
    use bracket_base::math::eigen::eigen;
    use bracket_base::math::vec3::dot;

    /// `u = ½ (xᵀAx) a`, slanted to all axes; the second derivatives are A times the components.
    fn field(x: V3) -> V3 {
        let n = SLANT;
        let s = dot(n, x);
        [8.0 * s * s, -2.0 * s * s + x[0] * x[1], 3.0 * x[2]]
    }

    const SLANT: V3 = [0.6, 0.0, 0.8];

    fn block() -> TetMesh {
        let cells: Vec<_> = (0..64).map(|i| ([i % 4, i / 4 % 4, i / 16], "B")).collect();
        cubes(&cells)
    }

    /// The second derivatives of a quadratic field are exact in every tet:
    /// `|H₁| = 16 nnᵀ`, `|H₂| = |−4 nnᵀ + sym(xy)|`, `H₃ = 0`.
    #[test]
    fn exact_for_quadratic_fields() {
        let mesh = block();
        let u: Vec<V3> = Tet10Space::new(&mesh).nodes.iter().map(|x| field(*x)).collect();
        let nn = symmetric_part(&SLANT.map(|a| SLANT.map(|b| a * b)));
        let xy = symmetric_part(&[[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0; 3]]);
        let second: Mandel = std::array::from_fn(|c| -4.0 * nn[c] + xy[c]);
        let second = mapped(&second, f64::abs);
        for h in second_derivatives(&mesh, &u) {
            for c in 0..6 {
                let want = 16.0 * nn[c] + second[c];
                assert!((h[c] - want).abs() < 1e-9, "{h:?}");
            }
        }
    }

    /// From the vertices alone: away from the surface, where gradients are averaged from all
    /// sides, the strongest direction is found to 10°.
    #[test]
    fn recovered_inside() {
        let mesh = block();
        let u: Vec<V3> = mesh.nodes.iter().map(|x| field(*x)).collect();
        let all = recovered_second_derivatives(&mesh, &u);
        let inner = (0..mesh.tets.len())
            .filter(|e| mesh.corners(*e).iter().flatten().all(|x| *x > 5.0 && *x < 35.0));
        let mut count = 0;
        for e in inner {
            let (values, vectors) = eigen(&all[e]);
            let i = (0..3).max_by(|i, j| values[*i].total_cmp(&values[*j])).unwrap_or(0);
            let cos = dot(vectors[i], SLANT).abs();
            assert!(cos > 10f64.to_radians().cos(), "{cos}");
            assert!(values[i] > 14.0 && values[i] < 25.0, "{values:?}");
            count += 1;
        }
        assert_eq!(count, 48);
    }
}
