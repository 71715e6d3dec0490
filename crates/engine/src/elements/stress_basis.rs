//! The stress basis of the static super-element, on the reference tetrahedron.
//!
//! Self-equilibrated, traction-continuous stress fields of a split tetrahedron: 96 stress values
//! minus 66 equilibrium rows leave 30 parameters. Points and tractions are numbered as in
//! [`crate::elements::super_element`].

use crate::elements::geometry::{centroid, gradients};
use crate::mesh::tet::FACES;
use bracket_base::math::dense::{Mat, orthogonal_factor};
use bracket_base::math::mandel::{self, Mandel};
use bracket_base::math::quadrature::{tetrahedron_mass, triangle_mass};
use bracket_base::math::vec3::{self, V3};
use std::sync::OnceLock;

/// Free stress parameters of an element.
pub const PARAMETERS: usize = 30;
/// Traction values of an element: 4 faces × 3 vertices × 3 components.
pub const TRACTIONS: usize = 36;
/// Constant data of the reference tetrahedron (0, e₁, e₂, e₃).
pub(crate) struct Reference {
    /// Stress basis: `basis[k][p][parameter]`.
    pub(crate) basis: [[[Mandel; PARAMETERS]; 4]; 4],
    /// The same, point by point and component by component: row `24 k + 6 p + c`.
    pub(crate) stress: Box<[[f64; PARAMETERS]; 96]>,
    /// Area- and mass-weighted tractions of each parameter, `[traction][parameter]`, before `J`
    /// rotates them.
    pub(crate) traction: Box<[[f64; PARAMETERS]; TRACTIONS]>,
    /// `flexibility[c]`: 30 × 30 matrix that multiplies entry c of the upper triangle of the
    /// transformed compliance.
    pub(crate) flexibility: Vec<Box<[[f64; PARAMETERS]; PARAMETERS]>>,
}

/// Corners of the reference tetrahedron.
const CORNERS: [V3; 4] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The 66 rows (12 equilibrium, 54 traction continuity) on the 96 stress values of a split
/// tetrahedron.
///
/// Rows are scaled to unit length. Rank 66 on any non-degenerate tetrahedron.
///
/// # Shape
/// Column `24 k + 6 p + c`: component c of the stress at point p of subtet k.
pub fn equilibrium_rows(corners: &[V3; 4]) -> Vec<[f64; 96]> {
    let centroid = centroid(corners);
    let mut rows: Vec<[f64; 96]> = Vec::with_capacity(66);
    for k in 0..4 {
        let x = [corners[FACES[k][0]], corners[FACES[k][1]], corners[FACES[k][2]], centroid];
        let grad = gradients(&x);
        let operators = grad.map(mandel::normal_operator);
        for d in 0..3 {
            let mut row = [0.0; 96];
            for p in 0..4 {
                row[24 * k + 6 * p..][..6].copy_from_slice(&operators[p][d]);
            }
            rows.push(row);
        }
    }
    for k in 0..4 {
        for l in k + 1..4 {
            let shared: Vec<usize> = (0..4).filter(|&m| m != k && m != l).collect();
            let face = [corners[shared[0]], corners[shared[1]], centroid];
            let a = vec3::area_vector(&face);
            let operator = mandel::normal_operator(vec3::scale(1.0 / vec3::norm(a), a));
            for vertex in [Some(shared[0]), Some(shared[1]), None] {
                let (pk, pl) = (point_of(k, vertex), point_of(l, vertex));
                for d in 0..3 {
                    let mut row = [0.0; 96];
                    row[24 * k + 6 * pk..][..6].copy_from_slice(&operator[d]);
                    row[24 * l + 6 * pl..][..6].copy_from_slice(&operator[d].map(|x| -x));
                    rows.push(row);
                }
            }
        }
    }
    for row in &mut rows {
        let n = row.iter().map(|x| x * x).sum::<f64>().sqrt();
        row.iter_mut().for_each(|x| *x /= n);
    }
    rows
}

/// Point of subtet `k` that is macro vertex `vertex` (`None`: the centroid).
fn point_of(k: usize, vertex: Option<usize>) -> usize {
    vertex.map_or(3, |v| FACES[k].iter().position(|&f| f == v).unwrap_or(3))
}

/// The data of the reference tetrahedron, computed once.
pub(crate) fn reference() -> &'static Reference {
    static REFERENCE: OnceLock<Reference> = OnceLock::new();
    REFERENCE.get_or_init(|| {
        let rows = equilibrium_rows(&CORNERS);
        // the last 30 columns of Q in Rᵀ = Q [U; 0] span the null space of R
        let rt = Mat::from_fn(96, 66, |i, j| rows[j][i]);
        let q = orthogonal_factor(&rt);
        let basis: [[[Mandel; PARAMETERS]; 4]; 4] = std::array::from_fn(|k| {
            std::array::from_fn(|p| {
                std::array::from_fn(|a| std::array::from_fn(|c| q[(24 * k + 6 * p + c, 66 + a)]))
            })
        });
        let mut traction = Box::new([[0.0; PARAMETERS]; TRACTIONS]);
        for k in 0..4 {
            let area = vec3::area_vector(&FACES[k].map(|i| CORNERS[i]));
            for a in 0..PARAMETERS {
                let t: [V3; 3] = std::array::from_fn(|p| mandel::traction(&basis[k][p][a], area));
                for p in 0..3 {
                    for d in 0..3 {
                        traction[9 * k + 3 * p + d][a] =
                            (0..3).map(|b| triangle_mass(p, b) * t[b][d]).sum();
                    }
                }
            }
        }
        let mut flexibility = Vec::with_capacity(21);
        for i in 0..6 {
            for j in i..6 {
                let mut h = Box::new([[0.0; PARAMETERS]; PARAMETERS]);
                for subtet in &basis {
                    for (p, at_p) in subtet.iter().enumerate() {
                        for (r, at_r) in subtet.iter().enumerate() {
                            let m = tetrahedron_mass(p, r);
                            for a in 0..PARAMETERS {
                                for b in 0..PARAMETERS {
                                    h[a][b] += m * at_p[a][i] * at_r[b][j];
                                    if i != j {
                                        h[a][b] += m * at_p[a][j] * at_r[b][i];
                                    }
                                }
                            }
                        }
                    }
                }
                flexibility.push(h);
            }
        }
        let mut stress = Box::new([[0.0; PARAMETERS]; 96]);
        for (r, row) in stress.iter_mut().enumerate() {
            *row = std::array::from_fn(|a| basis[r / 24][r / 6 % 4][a][r % 6]);
        }
        Reference { basis, stress, traction, flexibility }
    })
}
