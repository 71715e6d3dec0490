//! Directions in which elements may be long: the absolute second derivatives of a vector field of
//! 10-node tets. The interpolation error of the field along a direction t is proportional to
//! `h² tᵀ|H|t`; elements whose edges all have the same error are long where |H| is small.
//!
//! # Source
//! Loseille and Alauzet, Continuous mesh framework, SIAM J. Numer. Anal. 49 (2011).

use crate::elements::geometry::gradients;
use crate::elements::space::Tet10Space;
use crate::math::eigen::mapped;
use crate::math::mandel::{Mandel, symmetric_part};
use crate::math::vec3::V3;
use crate::mesh::TetMesh;
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
