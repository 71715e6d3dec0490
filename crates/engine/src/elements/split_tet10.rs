//! The 10-node tetrahedron split at its centroid into four (Alfeld split). The trace on its faces
//! is that of the plain element; the five inner nodes avoid locking in isochoric flow.
//!
//! # Shape
//! Nodes 0–3 are the vertices, 4–9 the mid-sides of [`EDGES`], 10 the centroid, 11–14 the middles
//! between the centroid and vertex 0–3. Subtet k holds the face opposite vertex k, its corners
//! [`FACES`] then the centroid.

use crate::elements::geometry::centroid;
use crate::elements::tet10;
use crate::mesh::tet::{EDGES, FACES};
use bracket_base::math::mandel::Isotropic;
use bracket_base::math::vec3::V3;

/// Nodes on the faces, those of the plain element.
pub const OUTER: usize = 10;
/// Nodes of the element.
pub const NODES: usize = 15;
/// Number of displacements of the inner nodes.
pub const INNER_UNKNOWNS: usize = 3 * (NODES - OUTER);
const CENTROID: usize = 10;

/// Element matrix of order 45.
pub type Matrix45 = Box<[[f64; 45]; 45]>;

/// The ten nodes of subtet `k`, in the order of a 10-node tetrahedron.
pub fn subtet_nodes(k: usize) -> [usize; 10] {
    let corner: [usize; 4] = std::array::from_fn(|p| if p < 3 { FACES[k][p] } else { CENTROID });
    std::array::from_fn(|i| {
        if i < 4 {
            return corner[i];
        }
        let [a, b] = EDGES[i - 4].map(|p| corner[p]);
        if b == CENTROID {
            return CENTROID + 1 + a;
        }
        let same = |e: &[usize; 2]| *e == [a, b] || *e == [b, a];
        4 + EDGES
            .iter()
            .position(same)
            .expect("two vertices of a tetrahedron are the ends of one of its edges")
    })
}

/// Corners of subtet `k`.
pub fn subtet_corners(corners: &[V3; 4], k: usize) -> [V3; 4] {
    std::array::from_fn(|p| if p < 3 { corners[FACES[k][p]] } else { centroid(corners) })
}

/// Elastic stiffness, exact for the strains linear in the subtets.
pub fn stiffness(corners: &[V3; 4], volume: f64, material: &Isotropic) -> Matrix45 {
    let mut k = Box::new([[0.0; 45]; 45]);
    for subtet in 0..4 {
        let nodes = subtet_nodes(subtet);
        let ks = tet10::stiffness(&subtet_corners(corners, subtet), 0.25 * volume, material);
        for i in 0..30 {
            for j in 0..30 {
                k[3 * nodes[i / 3] + i % 3][3 * nodes[j / 3] + j % 3] += ks[i][j];
            }
        }
    }
    k
}

/// The part of the stiffness on the outer nodes, the inner ones held.
pub fn outer_stiffness(k: &Matrix45) -> tet10::Matrix30 {
    let mut outer = Box::new([[0.0; 30]; 30]);
    outer.iter_mut().zip(k.iter()).for_each(|(o, row)| o.copy_from_slice(&row[..30]));
    outer
}

/// `∫ N_i` over the element divided by its volume.
pub fn shape_integrals() -> [f64; NODES] {
    let mut w = [0.0; NODES];
    for k in 0..4 {
        for (node, x) in subtet_nodes(k).into_iter().zip(tet10::shape_integrals()) {
            w[node] += 0.25 * x;
        }
    }
    w
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_base::math::vec3;

    const CORNERS: [V3; 4] = [[0.1, 0.0, 0.2], [2.0, 0.3, 0.0], [0.2, 1.7, -0.1], [0.3, 0.4, 2.2]];

    fn position(node: usize) -> V3 {
        let c = centroid(&CORNERS);
        let mid = |a: V3, b: V3| vec3::scale(0.5, vec3::add(a, b));
        match node {
            0..4 => CORNERS[node],
            4..10 => mid(CORNERS[EDGES[node - 4][0]], CORNERS[EDGES[node - 4][1]]),
            10 => c,
            _ => mid(CORNERS[node - 11], c),
        }
    }

    /// Every node of a subtet lies where a 10-node tetrahedron on the subtet's corners has it, and
    /// the energy of a quadratic displacement, which both elements hold, is that of the plain
    /// element.
    #[test]
    fn holds_what_the_plain_element_holds() {
        for k in 0..4 {
            let x = subtet_corners(&CORNERS, k);
            for (i, n) in subtet_nodes(k).into_iter().enumerate() {
                let want = if i < 4 {
                    x[i]
                } else {
                    vec3::scale(0.5, vec3::add(x[EDGES[i - 4][0]], x[EDGES[i - 4][1]]))
                };
                assert!(vec3::norm(vec3::sub(position(n), want)) < 1e-15, "subtet {k} node {i}");
            }
        }
        let material = Isotropic::new(210.0, 0.3);
        let volume = crate::mesh::tet::signed_volume(&CORNERS);
        let u =
            |x: V3| [x[0] * x[1] - x[2], 0.3 * x[2] * x[2] + x[1], x[0] * x[0] - 0.7 * x[1] * x[2]];
        let at: Vec<f64> = (0..NODES).flat_map(|n| u(position(n))).collect();
        let (split, plain) =
            (stiffness(&CORNERS, volume, &material), tet10::stiffness(&CORNERS, volume, &material));
        let energy = |n: usize, k: &dyn Fn(usize, usize) -> f64| -> f64 {
            (0..n).map(|i| (0..n).map(|j| at[i] * k(i, j) * at[j]).sum::<f64>()).sum()
        };
        let (a, b) = (energy(45, &|i, j| split[i][j]), energy(30, &|i, j| plain[i][j]));
        assert!((a - b).abs() < 1e-12 * b, "{a} {b}");
        // the same quadratic field under a constant body force
        let (w, v) = (shape_integrals(), tet10::shape_integrals());
        assert!((w.iter().sum::<f64>() - 1.0).abs() < 1e-15);
        for d in 0..3 {
            let split: f64 = (0..NODES).map(|n| w[n] * at[3 * n + d]).sum();
            let plain: f64 = (0..OUTER).map(|n| v[n] * at[3 * n + d]).sum();
            assert!((split - plain).abs() < 1e-13, "{split} {plain}");
        }
    }
}
