//! Geometric stiffness of the 10-node tetrahedron: the second-order work of a stress field.
//!
//! `vᵀ K_σ v = ∫ σ_kl v_i,k v_i,l`, that is `∫ ∇N_i · σ · ∇N_j δ_ab` between component a at node i
//! and component b at node j. Negative where the stress presses.
//!
//! # Source
//! O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 2, initial stability.

use crate::elements::geometry::gradients;
use crate::elements::super_element::PointStress;
use crate::elements::tet10::{self, Matrix30};
use crate::mesh::tet::FACES;
use bracket_base::math::mandel::{self, Mandel};
use bracket_base::math::vec3::{self, M3, V3};

/// `∫ λ_v λ_w σ` over a macro tet for its barycentric coordinates λ \[N mm\], exact for stress
/// linear in each of its four subtets.
fn moments(volume: f64, stress: &PointStress) -> [[M3; 4]; 4] {
    let mut sums = [[[0.0; 6]; 4]; 4];
    for (k, s) in stress.iter().enumerate() {
        // value of each λ of the macro tet at the points of the subtet
        let lambda: [[f64; 4]; 4] = std::array::from_fn(|p| match FACES[k].get(p) {
            Some(&v) => tet10::vertex(v),
            None => [0.25; 4],
        });
        let total: Mandel = std::array::from_fn(|c| s.iter().map(|at| at[c]).sum());
        for p in 0..4 {
            for r in 0..4 {
                // ∫ μ_p μ_r σ with ∫ μ_p μ_q μ_r = V/120, V/60, V/20 for no, one, both equal pairs
                let weight = 0.25 * volume / if p == r { 60.0 } else { 120.0 };
                let m: Mandel = std::array::from_fn(|c| weight * (total[c] + s[p][c] + s[r][c]));
                for v in 0..4 {
                    for w in 0..4 {
                        let share = lambda[p][v] * lambda[r][w];
                        (0..6).for_each(|c| sums[v][w][c] += share * m[c]);
                    }
                }
            }
        }
    }
    sums.map(|row| row.map(|m| mandel::to_matrix(&m)))
}

/// Geometric stiffness of a stress field \[N/mm\], unknowns as in [`tet10`].
pub fn geometric_stiffness(corners: &[V3; 4], volume: f64, stress: &PointStress) -> Matrix30 {
    let g = gradients(corners);
    let slopes: [[V3; 10]; 4] =
        std::array::from_fn(|v| tet10::shape_gradients(&g, tet10::vertex(v)));
    let moments = moments(volume, stress);
    let mut k = Box::new([[0.0; 30]; 30]);
    for j in 0..10 {
        // ∫ λ_v σ · ∇N_j
        let pulled: [V3; 4] = std::array::from_fn(|v| {
            (0..4).fold([0.0; 3], |s, w| vec3::add(s, vec3::mul(&moments[v][w], slopes[w][j])))
        });
        for i in 0..10 {
            let work: f64 = (0..4).map(|v| vec3::dot(slopes[v][i], pulled[v])).sum();
            (0..3).for_each(|d| k[3 * i + d][3 * j + d] = work);
        }
    }
    k
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::super_element::SuperElement;

    const CORNERS: [V3; 4] = [[0.1, 0.2, 0.0], [2.0, 0.3, 0.1], [0.2, 1.7, -0.1], [0.4, 0.5, 1.3]];

    fn volume() -> f64 {
        let g = gradients(&CORNERS);
        // ∇λ_3 is the reciprocal of the height over the opposite face
        let area = vec3::norm(vec3::area_vector(&[CORNERS[0], CORNERS[1], CORNERS[2]]));
        area / (3.0 * vec3::norm(g[3]))
    }

    /// Stress linear over the whole element: components `c + s·x`.
    fn linear(x: V3) -> Mandel {
        std::array::from_fn(|c| 3.0 - c as f64 + x[0] * 0.7 - x[1] * c as f64 + 0.3 * x[2])
    }

    fn quadratic(x: V3) -> V3 {
        [
            x[0] * x[1] - x[2] * x[2],
            0.5 * x[0] + x[1] * x[2],
            x[0] * x[0] + 2.0 * x[1] * x[1] - x[0] * x[2],
        ]
    }

    fn gradient(x: V3) -> M3 {
        [[x[1], x[0], -2.0 * x[2]], [0.5, x[2], x[1]], [2.0 * x[0] - x[2], 4.0 * x[1], -x[0]]]
    }

    /// Mean over the tet of a polynomial of degree 3 by a rule of Keast (degree 3, 5 points).
    fn mean(f: impl Fn(V3) -> f64) -> f64 {
        let at =
            |l: [f64; 4]| f(std::array::from_fn(|d| (0..4).map(|v| l[v] * CORNERS[v][d]).sum()));
        let outer: f64 = (0..4)
            .map(|v| {
                let mut l = [1.0 / 6.0; 4];
                l[v] = 0.5;
                at(l)
            })
            .sum();
        0.45 * outer - 0.8 * at([0.25; 4])
    }

    #[test]
    fn the_work_of_a_quadratic_displacement_is_exact() {
        let stress = SuperElement::points(&CORNERS).map(|t| t.map(linear));
        let k = geometric_stiffness(&CORNERS, volume(), &stress);
        let v: Vec<f64> = (0..10)
            .flat_map(|i| {
                let x = match i {
                    0..4 => CORNERS[i],
                    _ => {
                        let [a, b] = crate::mesh::tet::EDGES[i - 4];
                        vec3::scale(0.5, vec3::add(CORNERS[a], CORNERS[b]))
                    }
                };
                quadratic(x)
            })
            .collect();
        let found: f64 = (0..30).map(|i| (0..30).map(|j| v[i] * k[i][j] * v[j]).sum::<f64>()).sum();
        let exact = volume()
            * mean(|x| {
                let (s, g) = (mandel::to_matrix(&linear(x)), gradient(x));
                g.iter().map(|row| vec3::dot(*row, vec3::mul(&s, *row))).sum()
            });
        assert!((found / exact - 1.0).abs() < 1e-12, "{found} {exact}");
        for i in 0..30 {
            assert!((0..30).all(|j| (k[i][j] - k[j][i]).abs() < 1e-12));
            // a translation does no work
            let d = i % 3;
            let shifted: f64 = (0..10).map(|j| k[i][3 * j + d]).sum();
            assert!(shifted.abs() < 1e-12, "{shifted}");
        }
    }

    /// A stress in one subtet alone does as much work as the mean of its values there.
    #[test]
    fn each_subtet_counts_with_its_own_stress() {
        let slope = [0.3, -0.2, 0.5];
        let v: Vec<f64> = (0..10)
            .flat_map(|i| {
                let x = match i {
                    0..4 => CORNERS[i],
                    _ => {
                        let [a, b] = crate::mesh::tet::EDGES[i - 4];
                        vec3::scale(0.5, vec3::add(CORNERS[a], CORNERS[b]))
                    }
                };
                [vec3::dot(slope, x), 0.0, 0.0]
            })
            .collect();
        for k in 0..4 {
            let mut stress = [[[0.0; 6]; 4]; 4];
            stress[k] = std::array::from_fn(|p| [p as f64, 1.0, -2.0, 0.5, 0.0, 1.0]);
            let m = geometric_stiffness(&CORNERS, volume(), &stress);
            let found: f64 =
                (0..30).map(|i| (0..30).map(|j| v[i] * m[i][j] * v[j]).sum::<f64>()).sum();
            let s = mandel::to_matrix(&[1.5, 1.0, -2.0, 0.5, 0.0, 1.0]);
            let exact = 0.25 * volume() * vec3::dot(slope, vec3::mul(&s, slope));
            assert!((found / exact - 1.0).abs() < 1e-12, "{k}: {found} {exact}");
        }
    }
}
