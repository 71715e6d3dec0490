//! How far contact faces are open before anything moves: initial gap, and the shift of the cones
//! under Coulomb's law.
//!
//! Both are quadratic on a face and given by their six Bernstein coefficients, so that the two
//! programs and their certificates read one and the same field: the kinematic program takes the
//! coefficients as they are, the static one integrates the polynomial.

use super::analysis::{AnalysisModel, ContactLaw};
use super::file::Gap;
use crate::elements::space::FACE_EDGES;
use crate::math::vec3::{self, V3};
use crate::spec::friction::FrictionLaw;

/// Bernstein coefficients of a quadratic polynomial on a triangle: of the vertices, then of the
/// edges [`FACE_EDGES`].
pub type Bernstein = [f64; 6];

/// The polynomial at a point given by its barycentric coordinates.
pub fn bernstein_at(c: &Bernstein, l: [f64; 3]) -> f64 {
    let vertices: f64 = (0..3).map(|i| c[i] * l[i] * l[i]).sum();
    let edges: f64 =
        FACE_EDGES.iter().zip(&c[3..]).map(|([i, j], c)| 2.0 * c * l[*i] * l[*j]).sum();
    vertices + edges
}

/// By how much the cones of contact faces are opened \[mm\]: `g_N + g₀ + s ≥ μ‖g_T‖`.
///
/// With `s = μ‖g_T‖` of the solution itself slip does not dilate: Coulomb's law.
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
    /// Its coefficients on a face \[mm\]; exact, since it is quadratic.
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

impl AnalysisModel {
    /// Coefficients of initial gap and shift of contact face `face` (interfaces first) \[mm\].
    pub fn opening(&self, face: usize, law: &ContactLaw, corners: &[V3; 3]) -> Bernstein {
        let gap = law.gap.bernstein(corners);
        let shift = self.shift.faces.get(face).copied().unwrap_or_default();
        std::array::from_fn(|i| gap[i] + shift[i])
    }

    /// The law of a contact, interfaces first, then contacts with the ground.
    pub fn contact_law(&self, contact: usize) -> &ContactLaw {
        match self.interfaces.get(contact) {
            Some(i) => &i.law,
            None => &self.ground[contact - self.interfaces.len()].law,
        }
    }

    /// True when some contact has Coulomb's friction.
    pub fn has_coulomb_friction(&self) -> bool {
        let mut laws =
            self.interfaces.iter().map(|i| &i.law).chain(self.ground.iter().map(|g| &g.law));
        laws.any(ContactLaw::is_coulomb)
    }
}

impl ContactLaw {
    /// FrictionLaw without dilation.
    pub fn is_coulomb(&self) -> bool {
        self.mu > 0.0 && self.friction == FrictionLaw::Coulomb
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The coefficients of a gap give the gap at every point, not only at nodes.
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
