//! The contacts of a loaded structure, frozen: closed faces keep their normal gap, open ones do
//! nothing.
//!
//! A face is closed if the static field presses on it and the displacements do not open it. Where
//! the two fields disagree, at the rim of a contact zone, it counts as open. A closed face holds
//! the normal jump by a penalty and leaves the tangential one free, also under friction. Each of
//! these choices makes the structure softer and its critical factor lower, never higher.

use crate::certify::faces::{ContactFace, contact_faces, roles};
use crate::certify::fields::{DisplacementField, StressField};
use crate::certify::tractions::contact_tractions;
use crate::certify::welds::{coefficients, jumps};
use crate::elements::space::Tet10Space;
use crate::model::AnalysisModel;
use crate::model::loads::Loads;
use crate::programs::assemble::assemble;
use crate::programs::conic::SymmetricCsc;
use crate::programs::dofs::DofMap;
use bracket_base::math::quadrature::{TRIANGLE_4, triangle_p2};
use bracket_base::math::vec3::{self, V3};
use std::convert::Infallible;

/// A face is pressed if its mean pressure exceeds this times the largest one of its contact.
const PRESSED: f64 = 1e-3;
/// Pressures below this times the largest stress are rounding of the solver.
const ROUNDING: f64 = 1e-6;
/// A face is open if its mean gap exceeds this times the largest displacement.
const OPENED: f64 = 1e-4;
/// Stiffness of a closed face against its normal jump over E/h, h the size of the face: the jump is
/// that of a layer of the thickness h/1000.
const PENALTY: f64 = 1e3;

/// A closed face: its nodes on both sides and its stiffness.
struct ClosedFace {
    a: [usize; 6],
    /// `None`: rigid ground.
    b: Option<[usize; 6]>,
    normal: V3,
    area: f64,
    /// Pressure for a unit of normal jump \[MPa/mm\].
    stiffness: f64,
}

/// The frozen contacts of a model.
pub struct ContactState {
    closed: Vec<ClosedFace>,
    faces: usize,
}

/// Mean pressure on a face of a contact \[MPa\].
fn mean_pressures(
    model: &AnalysisModel,
    faces: &[ContactFace<'_>],
    stress: &StressField,
) -> Vec<f64> {
    let roles = roles(model, Loads::ALL);
    let mean = |face: &ContactFace<'_>| {
        let (n, _) = face.normal(model);
        let role = roles.get(&(face.a.tet, face.a.local));
        let at = contact_tractions(model, stress, face, role);
        at.iter().map(|t| vec3::dot(*t, n)).sum::<f64>() / 3.0
    };
    faces.iter().map(mean).collect()
}

/// Mean gap of a face \[mm\], without the opening that slip of a rough face causes by itself under
/// associated friction.
fn mean_gap(
    model: &AnalysisModel,
    space: &Tet10Space,
    face: &ContactFace<'_>,
    displacement: &DisplacementField,
) -> f64 {
    let (n, _) = face.normal(model);
    let jumps = jumps(space, face, &displacement.u);
    let gaps = coefficients(&jumps).zip(face.opening(model)).map(|(jump, opening)| {
        let normal = vec3::dot(jump, n);
        let slip = vec3::norm(vec3::along(jump, -normal, n));
        normal + opening - face.law.mu * slip
    });
    // each Bernstein polynomial has the mean 1/6
    gaps.sum::<f64>() / 6.0
}

impl ContactState {
    /// The state of the contacts under the loads that the two fields belong to.
    pub fn new(
        model: &AnalysisModel,
        space: &Tet10Space,
        displacement: &DisplacementField,
        stress: &StressField,
    ) -> Self {
        let faces = contact_faces(model);
        let pressures = mean_pressures(model, &faces, stress);
        let mut least = vec![0.0f64; faces.last().map_or(0, |f| f.of + 1)];
        for (face, p) in faces.iter().zip(&pressures) {
            least[face.of] = least[face.of].max(PRESSED * p);
        }
        let values = stress.points.iter().flatten().flatten().flatten();
        let rounding = ROUNDING * values.fold(0.0f64, |m, s| m.max(s.abs()));
        let moved = displacement.u.iter().fold(0.0f64, |m, u| m.max(vec3::norm(*u)));
        let is_closed = |(face, pressure): (&ContactFace<'_>, &f64)| {
            *pressure > least[face.of].max(rounding)
                && mean_gap(model, space, face, displacement) <= OPENED * moved
        };
        let closed = faces.iter().zip(&pressures).filter(|f| is_closed(*f));
        let closed = closed.map(|(face, _)| ClosedFace::new(model, space, face)).collect();
        Self { closed, faces: faces.len() }
    }

    /// Number of closed faces and of all faces.
    pub fn count(&self) -> [usize; 2] {
        [self.closed.len(), self.faces]
    }

    /// Stiffness of the closed faces on the unknowns \[N/mm\].
    pub fn stiffness(&self, map: &DofMap) -> SymmetricCsc {
        let dofs = |e: usize| self.closed[e].dofs();
        let matrix = |e: usize| Ok::<_, Infallible>(self.closed[e].matrix());
        let Ok(k) = assemble::<36, Infallible>(self.closed.len(), map, dofs, matrix);
        k
    }
}

impl ClosedFace {
    fn new(model: &AnalysisModel, space: &Tet10Space, face: &ContactFace<'_>) -> Self {
        let (normal, area) = face.normal(model);
        let modulus = |tet: u32| {
            let body = model.mesh.tet_body[tet as usize] as usize;
            model.materials[model.body_material[body] as usize].e
        };
        // that of the softer body
        let of_a = modulus(face.a.tet);
        let e = face.b.map_or(of_a, |(b, _)| of_a.min(modulus(b.tet)));
        Self {
            a: space.triangle(face.nodes_a),
            b: face.b.map(|(_, nodes)| space.triangle(nodes)),
            normal,
            area,
            stiffness: PENALTY * e / (2.0 * area).sqrt(),
        }
    }

    /// Full unknowns: side A, then side B; side A again in place of the ground.
    fn dofs(&self) -> [usize; 36] {
        let b = self.b.unwrap_or(self.a);
        std::array::from_fn(|i| {
            let node = if i < 18 { self.a[i / 3] } else { b[i / 3 - 6] };
            3 * node + i % 3
        })
    }

    /// `stiffness ∫ (n·(u_B − u_A))²` as a matrix.
    fn matrix(&self) -> Box<[[f64; 36]; 36]> {
        let mut mass = [[0.0; 6]; 6];
        for (l, w) in TRIANGLE_4 {
            let shape = triangle_p2(l);
            for i in 0..6 {
                (0..6).for_each(|j| mass[i][j] += w * self.area * shape[i] * shape[j]);
            }
        }
        let side = |i: usize| if i < 18 { -1.0 } else { f64::from(u8::from(self.b.is_some())) };
        let row = |i: usize| side(i) * self.normal[i % 3];
        let mut k = Box::new([[0.0; 36]; 36]);
        for i in 0..36 {
            for j in 0..36 {
                k[i][j] = self.stiffness * row(i) * row(j) * mass[i / 3 % 6][j / 3 % 6];
            }
        }
        k
    }
}
