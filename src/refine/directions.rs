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
