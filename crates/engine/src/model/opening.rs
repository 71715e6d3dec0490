//! Opening of contact faces at rest: the initial gap, and the shift of the contact cones under
//! Coulomb's law.
//!
//! Both are quadratic on a face and given by their six Bernstein coefficients, so that the two
//! programs and their certificates use the same field: the kinematic program takes the coefficients
//! themselves, the static program integrates the polynomial.

use super::file::Gap;
use crate::elements::space::FACE_EDGES;
use bracket_base::math::vec3::{self, V3};

/// Bernstein coefficients of a quadratic polynomial on a triangle: at the vertices, then at the
/// edges [`FACE_EDGES`].
pub type Bernstein = [f64; 6];

/// The polynomial at a point given by its barycentric coordinates.
pub fn bernstein_at(c: &Bernstein, l: [f64; 3]) -> f64 {
    let vertices: f64 = (0..3).map(|i| c[i] * l[i] * l[i]).sum();
    let edges: f64 =
        FACE_EDGES.iter().zip(&c[3..]).map(|([i, j], c)| 2.0 * c * l[*i] * l[*j]).sum();
    vertices + edges
}

/// Shift s of the contact cones \[mm\]: `g_N + g₀ + s ≥ μ‖g_T‖`.
///
/// With `s = μ‖g_T‖` of the solution itself, slip causes no dilation: Coulomb's law.
///
/// # Source
/// V. Acary, F. Cadoux, C. Lemaréchal, J. Malick, A formulation of the linear discrete Coulomb
/// friction problem via convex optimization, ZAMM 91 (2011), 155–175.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ConeShift {
    /// Coefficients of each contact face, interfaces first, vertices in outward order of side A;
    /// empty: no shift.
    pub faces: Vec<Bernstein>,
}

impl Gap {
    /// Bernstein coefficients of the gap on a face \[mm\]; exact, since the gap is quadratic.
    pub fn bernstein(&self, corners: &[V3; 3]) -> Bernstein {
        let at = corners.map(|x| self.at(x));
        std::array::from_fn(|i| {
            if i < 3 {
                return at[i];
            }
            let [p, q] = FACE_EDGES[i - 3];
            2.0 * self.at(vec3::scale(0.5, vec3::add(corners[p], corners[q])))
                - 0.5 * (at[p] + at[q])
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The coefficients reproduce the gap at every point, not only at nodes.
    #[test]
    fn a_quadratic_gap_is_its_coefficients() {
        let gap =
            Gap::Quadratic { quadratic: [0.3, -0.2, 0.5, 0.1, 0.7, -0.4, 0.2, 0.6, -0.1, 0.9] };
        let corners = [[0.1, 0.2, -0.3], [2.0, 0.4, 0.6], [-0.5, 1.7, 0.8]];
        let c = gap.bernstein(&corners);
        for l in [[0.2, 0.3, 0.5], [0.9, 0.05, 0.05], [0.0, 0.4, 0.6], [1.0, 0.0, 0.0]] {
            let x = std::array::from_fn(|d| (0..3).map(|i| l[i] * corners[i][d]).sum());
            let (found, exact) = (bernstein_at(&c, l), gap.at(x));
            assert!((found - exact).abs() < 1e-13, "{found} against {exact}");
        }
    }
}
