//! Isochoric flow in the split 10-node tetrahedron: the inner velocities as a constant linear map
//! of the outer ones.
//!
//! `tr ε = 0` at the 4 vertices of the 4 subtets is 16 rows. Their block on the 15 inner velocities
//! has rank 15; the only combination without inner velocities is the sum of all rows, `∫ div u`.
//! Therefore the 15 inner velocities follow from the 30 outer ones, and one row per element
//! remains. The map is the least-squares solution of the 16 rows: its residual is the same at all
//! 16 points, so `div u` is constant in the element for any outer velocities, and zero when the
//! volume row is zero.
//!
//! The Piola map `u = J û` keeps divergences (`div u = div û`), so one map on the reference
//! tetrahedron, for û, serves every element.
//!
//! # Shape
//! Nodes as in [`crate::elements::split_tet10`]; velocity `3 i + d` is component d at node i.

use crate::elements::geometry::{gradients, jacobian};
use crate::elements::split_tet10::{
    self, INNER_UNKNOWNS, NODES, OUTER, subtet_corners, subtet_nodes,
};
use crate::elements::tet10;
use crate::mesh::tet::{EDGES, FACES};
use bracket_base::math::dense::{Mat, least_squares};
use bracket_base::math::vec3::{self, V3};
use std::sync::OnceLock;

/// Velocities of the outer nodes.
pub const OUTER_UNKNOWNS: usize = 3 * OUTER;

/// Corners of the reference tetrahedron.
const REFERENCE: [V3; 4] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// `tr ε` at vertex v of subtet k as a linear form of the 45 velocities: row `4 k + v`.
///
/// # Units
/// 1/mm.
pub fn divergence_rows(corners: &[V3; 4]) -> [[f64; 3 * NODES]; 16] {
    let mut rows = [[0.0; 3 * NODES]; 16];
    for k in 0..4 {
        let nodes = subtet_nodes(k);
        let g = gradients(&subtet_corners(corners, k));
        for v in 0..4 {
            let slopes = tet10::shape_gradients(&g, tet10::vertex(v));
            for (node, slope) in nodes.into_iter().zip(slopes) {
                (0..3).for_each(|d| rows[4 * k + v][3 * node + d] += slope[d]);
            }
        }
    }
    rows
}

/// Inner velocities from the outer ones, both in the components û of the reference tetrahedron,
/// `u = J û`.
pub fn inner_map() -> &'static [[f64; OUTER_UNKNOWNS]; INNER_UNKNOWNS] {
    static MAP: OnceLock<Box<[[f64; OUTER_UNKNOWNS]; INNER_UNKNOWNS]>> = OnceLock::new();
    MAP.get_or_init(|| {
        let rows = divergence_rows(&REFERENCE);
        let inner = Mat::from_fn(16, INNER_UNKNOWNS, |r, c| rows[r][OUTER_UNKNOWNS + c]);
        let outer = Mat::from_fn(16, OUTER_UNKNOWNS, |r, c| -rows[r][c]);
        // refined: the entries are small fractions, and rounding is all the divergence there may be
        let x = least_squares(&inner, &outer);
        let mut map = Box::new([[0.0; OUTER_UNKNOWNS]; INNER_UNKNOWNS]);
        for (r, row) in map.iter_mut().enumerate() {
            row.iter_mut().enumerate().for_each(|(c, m)| *m = x[(r, c)]);
        }
        map
    })
}

/// The 45 velocities of an element from those of its outer nodes, with constant divergence inside.
pub fn velocities(corners: &[V3; 4], outer: &[f64; OUTER_UNKNOWNS]) -> [f64; 3 * NODES] {
    let (j, inverse, _) = jacobian(corners);
    let mut hat = [0.0; OUTER_UNKNOWNS];
    for i in 0..OUTER {
        let u = [outer[3 * i], outer[3 * i + 1], outer[3 * i + 2]];
        hat[3 * i..3 * i + 3].copy_from_slice(&vec3::mul(&inverse, u));
    }
    let mut all = [0.0; 3 * NODES];
    all[..OUTER_UNKNOWNS].copy_from_slice(outer);
    for (i, rows) in inner_map().chunks_exact(3).enumerate() {
        let inside: V3 =
            std::array::from_fn(|d| rows[d].iter().zip(&hat).map(|(m, u)| m * u).sum());
        all[OUTER_UNKNOWNS + 3 * i..][..3].copy_from_slice(&vec3::mul(&j, inside));
    }
    all
}

/// The 15 inner velocities as linear forms of the 30 outer ones.
pub fn inner_rows(corners: &[V3; 4]) -> Box<[[f64; OUTER_UNKNOWNS]; INNER_UNKNOWNS]> {
    let mut rows = Box::new([[0.0; OUTER_UNKNOWNS]; INNER_UNKNOWNS]);
    for c in 0..OUTER_UNKNOWNS {
        let all = velocities(corners, &std::array::from_fn(|i| if i == c { 1.0 } else { 0.0 }));
        rows.iter_mut().zip(&all[OUTER_UNKNOWNS..]).for_each(|(row, u)| row[c] = *u);
    }
    rows
}

/// `∫ b·u` over the element of volume `volume` \[mm³\] as a linear form of the outer velocities,
/// for a constant force b per volume \[N/mm³\]: the inner nodes carry their part too.
pub fn body_forces(corners: &[V3; 4], volume: f64, b: V3) -> [f64; OUTER_UNKNOWNS] {
    let (j, inverse, _) = jacobian(corners);
    let weights = split_tet10::shape_integrals();
    let local = vec3::mul_t(&j, b);
    let mut hat: [f64; OUTER_UNKNOWNS] = std::array::from_fn(|i| weights[i / 3] * local[i % 3]);
    for (i, row) in inner_map().iter().enumerate() {
        let w = weights[OUTER + i / 3] * local[i % 3];
        hat.iter_mut().zip(row).for_each(|(h, m)| *h += w * m);
    }
    let mut f = [0.0; OUTER_UNKNOWNS];
    for (f, h) in f.chunks_exact_mut(3).zip(hat.chunks_exact(3)) {
        f.copy_from_slice(&vec3::scale(volume, vec3::mul_t(&inverse, [h[0], h[1], h[2]])));
    }
    f
}

/// `∫ div u` over the element as a linear form of the outer velocities: the flux through its faces.
/// A quadratic function integrates on a face to the area times the mean of its mid-side values. The
/// form is the same in a plain element.
///
/// # Units
/// mm²: velocities in mm per unit of time give mm³ per unit of time.
pub fn volume_row(corners: &[V3; 4]) -> [f64; OUTER_UNKNOWNS] {
    let areas = FACES.map(|f| vec3::area_vector(&f.map(|i| corners[i])));
    let mut row = [0.0; OUTER_UNKNOWNS];
    for (e, [a, b]) in EDGES.into_iter().enumerate() {
        // face k is opposite vertex k: an edge lies on the two faces opposite the other two
        // vertices
        for k in (0..4).filter(|&k| k != a && k != b) {
            (0..3).for_each(|d| row[3 * (4 + e) + d] += areas[k][d] / 3.0);
        }
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    fn random(seed: &mut u64) -> f64 {
        *seed ^= *seed << 13;
        *seed ^= *seed >> 7;
        *seed ^= *seed << 17;
        (*seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    }

    fn random_tet(seed: &mut u64) -> [V3; 4] {
        loop {
            let mut x: [V3; 4] =
                std::array::from_fn(|_| std::array::from_fn(|_| 10.0 * random(seed)));
            let d = jacobian(&x).2;
            if d < 0.0 {
                x.swap(1, 2);
            }
            if d.abs() > 20.0 {
                return x;
            }
        }
    }

    /// Divergence at the 16 points from the velocities alone, by the strains of the subtets.
    fn divergences(corners: &[V3; 4], all: &[f64; 45]) -> [f64; 16] {
        let mut out = [0.0; 16];
        for k in 0..4 {
            let u = subtet_nodes(k).map(|n| [all[3 * n], all[3 * n + 1], all[3 * n + 2]]);
            for (v, e) in tet10::vertex_strains(&subtet_corners(corners, k), &u).iter().enumerate()
            {
                out[4 * k + v] = e[0] + e[1] + e[2];
            }
        }
        out
    }

    /// On random tets and random outer velocities the divergence is the volume row over the volume
    /// at every point; with the row made zero it vanishes. The element's own 16 rows have rank 15
    /// on the inner velocities, 16 on all.
    #[test]
    fn divergence_is_constant_and_the_volume_row() {
        let mut seed = 0x9e37_79b9_7f4a_7c15;
        for _ in 0..100 {
            let x = random_tet(&mut seed);
            let row = volume_row(&x);
            let volume = jacobian(&x).2 / 6.0;
            let mut outer: [f64; 30] = std::array::from_fn(|_| random(&mut seed));
            let flux = |u: &[f64; 30]| row.iter().zip(u).map(|(a, b)| a * b).sum::<f64>();
            let height = volume
                / FACES
                    .map(|f| vec3::norm(vec3::area_vector(&f.map(|i| x[i]))))
                    .into_iter()
                    .fold(0.0, f64::max);
            let mean = flux(&outer) / volume;
            for d in divergences(&x, &velocities(&x, &outer)) {
                assert!((d - mean).abs() < 1e-12 / height, "{d} {mean}");
            }
            assert!(mean.abs() > 1e-6 / height);
            let square: f64 = row.iter().map(|a| a * a).sum();
            let excess = flux(&outer);
            outer.iter_mut().zip(&row).for_each(|(u, a)| *u -= excess / square * a);
            for d in divergences(&x, &velocities(&x, &outer)) {
                assert!(d.abs() < 1e-12 / height, "{d}");
            }
            let rows = divergence_rows(&x);
            let rank = |first: usize, count: usize| {
                let s = Mat::from_fn(16, count, |r, c| rows[r][first + c])
                    .singular_values()
                    .expect("a small matrix");
                s.iter().filter(|s| **s > 1e-9 / height).count()
            };
            assert_eq!((rank(30, 15), rank(0, 45)), (15, 16));
        }
    }

    /// The power of a body force on the outer velocities is its integral over the subtets.
    #[test]
    fn body_force_works_inside() {
        let mut seed = 11;
        for _ in 0..20 {
            let x = random_tet(&mut seed);
            let volume = jacobian(&x).2 / 6.0;
            let b: V3 = std::array::from_fn(|_| random(&mut seed));
            let outer: [f64; 30] = std::array::from_fn(|_| random(&mut seed));
            let all = velocities(&x, &outer);
            let mut power = 0.0;
            for k in 0..4 {
                for (l, w) in bracket_base::math::quadrature::TETRAHEDRON_2 {
                    for (n, s) in subtet_nodes(k).into_iter().zip(tet10::shape(l)) {
                        power += 0.25
                            * volume
                            * w
                            * s
                            * vec3::dot(b, [all[3 * n], all[3 * n + 1], all[3 * n + 2]]);
                    }
                }
            }
            let row: f64 = body_forces(&x, volume, b).iter().zip(&outer).map(|(f, u)| f * u).sum();
            assert!((row - power).abs() < 1e-12 * volume, "{row} {power}");
        }
    }

    /// A quadratic velocity without divergence, a rotation and a translation are kept as they are.
    #[test]
    fn holds_quadratic_flow() {
        let mut seed = 3;
        for _ in 0..20 {
            let x = random_tet(&mut seed);
            let c = crate::elements::geometry::centroid(&x);
            let mid = |a: V3, b: V3| vec3::scale(0.5, vec3::add(a, b));
            let at = |n: usize| match n {
                0..4 => x[n],
                4..10 => mid(x[EDGES[n - 4][0]], x[EDGES[n - 4][1]]),
                10 => c,
                _ => mid(x[n - 11], c),
            };
            let flow = |p: V3| {
                [
                    p[0] * p[1] + p[2] * p[2] - 1.0,
                    -0.5 * p[1] * p[1] + 0.3 * p[0] * p[0],
                    2.0 * p[0] * p[1] - p[1] + 0.2,
                ]
            };
            let exact: [f64; 45] = std::array::from_fn(|i| flow(at(i / 3))[i % 3]);
            let outer: [f64; 30] = std::array::from_fn(|i| exact[i]);
            for (a, b) in velocities(&x, &outer).iter().zip(&exact) {
                assert!((a - b).abs() < 1e-11, "{a} {b}");
            }
        }
    }
}
