//! The 10-node tetrahedron that yields: traceless plastic strain, linear in the element, beside its displacements.
//!
//! Energy of an element with displacements u and plastic strain p (Hencky, perfectly plastic):
//! `½ ∫ (ε − p):C:(ε − p) + ∫ √(2/3) f_y ‖p‖`. The elastic part is exact, strain and plastic strain being linear. The
//! dissipation is convex, so the vertex rule `V/4 Σ_i √(2/3) f_y t_i`, `t_i ≥ ‖p_i‖`, bounds it from above, and is
//! exact where the plastic strain is constant or zero. Since p is traceless only deviators couple: `C p = 2G p`.
//!
//! # Sign
//! The multiplier of vertex i's cone is `(V/4 √(2/3) f_y, −∫ φ_i dev σ)`: the deviatoric part stands against the stress.
//!
//! # Shape
//! A (sub)tet has 24 such unknowns, `6 i` the bound t of vertex i and `6 i + 1 + a` component a of its plastic strain in the
//! basis [`crate::math::mandel::DEVIATORIC`].

use super::element_unknowns::{ElementUnknown, ElementUnknowns, YIELD_ROWS};
use super::tet10::strain_columns;
use crate::math::mandel::deviator;
use crate::math::quadrature::tetrahedron_mass;
use crate::math::vec3::V3;

/// Plastic unknowns of a tet with linear plastic strain.
pub const FLOW_UNKNOWNS: usize = 4 * YIELD_ROWS;

/// Where a displacement of a tet stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// Full unknown that elements share.
    Shared(usize),
    /// Unknown of the element's own.
    Own(usize),
}

/// A tet with linear strain and linear plastic strain.
pub struct FlowingTet<'a> {
    /// Its corners \[mm\].
    pub corners: &'a [V3; 4],
    /// Its volume \[mm³\].
    pub volume: f64,
    /// Twice the shear modulus \[MPa\].
    pub two_mu: f64,
    /// Radius √(2/3) f_y of the yield surface \[MPa\].
    pub radius: f64,
    /// Where its 30 displacements stand.
    pub displacements: [Standing; 30],
}

impl FlowingTet<'_> {
    /// Its plastic unknowns, eliminated at `stage`; the first of them is unknown `first` of the element.
    pub fn unknowns(&self, first: usize, stage: u8) -> Vec<ElementUnknown> {
        let strains = strain_columns(self.corners).map(|vertex| vertex.map(|e| deviator(&e)));
        let weight = |i: usize, j: usize| self.two_mu * self.volume * tetrahedron_mass(i, j);
        let mut out = Vec::with_capacity(FLOW_UNKNOWNS);
        for i in 0..4 {
            out.push(ElementUnknown { stage, q: 0.25 * self.volume * self.radius, ..ElementUnknown::default() });
            for a in 0..5 {
                let mut unknown = ElementUnknown { stage, ..ElementUnknown::default() };
                for (c, standing) in self.displacements.iter().enumerate() {
                    let coupling: f64 = -(0..4).map(|j| weight(i, j) * strains[j][c][a]).sum::<f64>();
                    match standing {
                        _ if coupling == 0.0 => {}
                        Standing::Shared(at) => unknown.shared.push((*at, coupling)),
                        Standing::Own(at) => unknown.own.push((*at, coupling)),
                    }
                }
                unknown.own.sort_unstable_by_key(|term| term.0);
                unknown.own.extend((0..=i).map(|j| (first + YIELD_ROWS * j + 1 + a, weight(i, j))));
                out.push(unknown);
            }
        }
        out
    }
}

/// The plastic unknowns of a plain element, all of one stage; `dofs` are its 30 full unknowns.
pub fn plain(corners: &[V3; 4], volume: f64, two_mu: f64, radius: f64, dofs: [usize; 30]) -> ElementUnknowns {
    let tet = FlowingTet { corners, volume, two_mu, radius, displacements: dofs.map(Standing::Shared) };
    ElementUnknowns { unknowns: tet.unknowns(0, 1), cones: (0..4).map(|i| YIELD_ROWS * i).collect() }
}
