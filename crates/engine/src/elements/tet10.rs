//! The 10-node tetrahedron with straight edges: quadratic displacement, linear strain.
//!
//! Nodes: four vertices, then the mid-side nodes of [`EDGES`]. Unknown `3 i + d` is component d at
//! node i.

use crate::elements::geometry::gradients;
use crate::mesh::tet::EDGES;
use bracket_base::math::mandel::{self, Isotropic, Mandel};
use bracket_base::math::quadrature::tetrahedron_mass;
use bracket_base::math::vec3::V3;

/// Element matrix of order 30.
pub type Matrix30 = Box<[[f64; 30]; 30]>;

/// Quadratic shape functions at barycentric `l`.
pub fn shape(l: [f64; 4]) -> [f64; 10] {
    std::array::from_fn(|i| {
        if i < 4 {
            l[i] * (2.0 * l[i] - 1.0)
        } else {
            let [a, b] = EDGES[i - 4];
            4.0 * l[a] * l[b]
        }
    })
}

/// Gradients of the shape functions at barycentric `l`, from the gradients `g` of the barycentric
/// coordinates.
pub fn shape_gradients(g: &[V3; 4], l: [f64; 4]) -> [V3; 10] {
    std::array::from_fn(|i| {
        if i < 4 {
            g[i].map(|x| (4.0 * l[i] - 1.0) * x)
        } else {
            let [a, b] = EDGES[i - 4];
            std::array::from_fn(|d| 4.0 * (l[a] * g[b][d] + l[b] * g[a][d]))
        }
    })
}

/// Barycentric coordinates of vertex `v`.
pub fn vertex(v: usize) -> [f64; 4] {
    let mut l = [0.0; 4];
    l[v] = 1.0;
    l
}

/// Strain at barycentric `l` of nodal displacements `u`.
pub fn strain(g: &[V3; 4], l: [f64; 4], u: &[V3; 10]) -> Mandel {
    let n = shape_gradients(g, l);
    let mut grad = [[0.0; 3]; 3];
    for i in 0..10 {
        for r in 0..3 {
            for c in 0..3 {
                grad[r][c] += u[i][r] * n[i][c];
            }
        }
    }
    mandel::symmetric_part(&grad)
}

/// Strain at the four vertices; strain is linear between them.
pub fn vertex_strains(corners: &[V3; 4], u: &[V3; 10]) -> [Mandel; 4] {
    let g = gradients(corners);
    std::array::from_fn(|v| strain(&g, vertex(v), u))
}

/// Strain at the four vertices of each unknown at unit value: `[vertex][unknown]`.
pub fn strain_columns(corners: &[V3; 4]) -> [[Mandel; 30]; 4] {
    let g = gradients(corners);
    std::array::from_fn(|v| {
        let n = shape_gradients(&g, vertex(v));
        std::array::from_fn(|c| {
            let mut grad = [[0.0; 3]; 3];
            grad[c % 3] = n[c / 3];
            mandel::symmetric_part(&grad)
        })
    })
}

/// Diagonal of the elastic stiffness \[N/mm\].
pub fn diagonal(corners: &[V3; 4], volume: f64, material: &Isotropic) -> [f64; 30] {
    let k = stiffness(corners, volume, material);
    std::array::from_fn(|i| k[i][i])
}

/// Elastic stiffness, exact for the linear strain.
pub fn stiffness(corners: &[V3; 4], volume: f64, material: &Isotropic) -> Matrix30 {
    let b = strain_columns(corners);
    // Σ_vw m_vw B_vᵀ C B_w = Σ_w (Σ_v m_vw B_v)ᵀ C B_w
    let mut k = Box::new([[0.0; 30]; 30]);
    for w in 0..4 {
        let weighted: [Mandel; 30] = std::array::from_fn(|c| {
            std::array::from_fn(|i| {
                (0..4).map(|v| volume * tetrahedron_mass(v, w) * b[v][c][i]).sum()
            })
        });
        let stress: [Mandel; 30] = std::array::from_fn(|c| material.stress(&b[w][c]));
        for i in 0..30 {
            for j in 0..30 {
                k[i][j] += mandel::dot(&weighted[i], &stress[j]);
            }
        }
    }
    for i in 0..30 {
        for j in 0..i {
            let mean = 0.5 * (k[i][j] + k[j][i]);
            k[i][j] = mean;
            k[j][i] = mean;
        }
    }
    k
}

/// `∫ N_i` over the element divided by its volume: −1/20 at vertices, 1/5 at mid-sides.
pub fn shape_integrals() -> [f64; 10] {
    std::array::from_fn(|i| if i < 4 { -0.05 } else { 0.2 })
}
