//! Certificates of the elastic, perfectly plastic energy (Hencky), computed from the fields and the
//! model alone.
//!
//! Upper bound: `½ ∫ (ε − p):C:(ε − p) + ∫ π(p) − work` of any displacement with any traceless
//! plastic strain p, with the upper bound of the dissipation `π(p) = √(2/3) f_y ‖p‖` of
//! [`crate::certify::dissipation`]. Lower bound: −Π_c of a stress in equilibrium and inside the
//! yield surface, with an allowance for the residuals of its equilibrium.

use crate::certify::certificate::{
    KinematicCertificate, StaticCertificate, certify_motion, certify_stress,
};
use crate::certify::dissipation::mean_norm;
use crate::certify::fields::StressField;
use crate::certify::limit_certificate::{hidden_utilisation, utilisation};
use crate::certify::measures::largest;
use crate::certify::plastic_field::{
    PlasticField, PlasticPiece, at_points, length, mean_equivalent, tensor,
};
use crate::elements::geometry::centroid;
use crate::elements::space::Tet10Space;
use crate::elements::super_element::PointStress;
use crate::elements::tet10;
use crate::model::AnalysisModel;
use crate::model::loads::Loads;
use bracket_base::math::Sum;
use bracket_base::math::mandel::{self, Isotropic, Mandel, deviator};
use bracket_base::math::quadrature::TETRAHEDRON_2;
use bracket_base::math::vec3::{self, V3};

/// Number of times the tets are subdivided for the dissipation.
const SUBDIVISIONS: u32 = 1;

/// `∫ π(p)` over the pieces of a tet, an upper bound \[N mm\]; infinite for plastic strain in a
/// body without a yield strength.
pub fn dissipated(pieces: &[PlasticPiece], radius: Option<f64>) -> f64 {
    let of = |p: &PlasticPiece| {
        if p.plastic == [[0.0; 5]; 4] {
            return 0.0;
        }
        p.volume
            * radius.unwrap_or(f64::INFINITY)
            * mean_norm(&p.plastic.map(|d| tensor(&d)), SUBDIVISIONS)
    };
    pieces.iter().map(of).sum()
}

/// `∫ π(p)` over the tets that `counts` selects, an upper bound \[N mm\].
pub fn dissipation(
    model: &AnalysisModel,
    field: &PlasticField,
    counts: impl Fn(usize) -> bool,
) -> f64 {
    let space = Tet10Space::new(&model.mesh);
    let radii = model.yield_radii();
    let of = |e: usize| {
        dissipated(&field.pieces(model, &space, e), radii[model.mesh.tet_body[e] as usize])
    };
    Sum::of((0..model.mesh.tets.len()).filter(|&e| counts(e)).map(of))
}

/// Elastic strain ε − p at the vertices of a piece.
fn elastic_strains(piece: &PlasticPiece) -> [Mandel; 4] {
    let strains = tet10::vertex_strains(&piece.corners, &piece.displacements);
    std::array::from_fn(|v| {
        let p = tensor(&piece.plastic[v]);
        std::array::from_fn(|i| strains[v][i] - p[i])
    })
}

/// Stress `C (ε − p)` at the points of tet `e` \[MPa\].
pub fn stress_at_points(
    model: &AnalysisModel,
    space: &Tet10Space,
    field: &PlasticField,
    material: &Isotropic,
    e: usize,
) -> PointStress {
    let of = |piece: &PlasticPiece| elastic_strains(piece).map(|s| material.stress(&s));
    match &field.pieces(model, space, e)[..] {
        [plain] => at_points(&of(plain)),
        pieces => std::array::from_fn(|k| of(&pieces[k])),
    }
}

/// Certifies a displacement with plastic strain.
pub fn certify_plastic_motion(model: &AnalysisModel, field: &PlasticField) -> KinematicCertificate {
    let space = Tet10Space::new(&model.mesh);
    let (materials, radii) = (model.stiffnesses(), model.yield_radii());
    let forces = model.body_forces(Loads::ALL);
    let body = |e: usize| model.mesh.tet_body[e] as usize;
    let inside = |e: usize, energy: &mut Sum, work: &mut Sum| {
        let pieces = field.pieces(model, &space, e);
        for piece in &pieces {
            let strains = elastic_strains(piece);
            for (l, w) in TETRAHEDRON_2 {
                let eps: Mandel =
                    std::array::from_fn(|i| (0..4).map(|v| l[v] * strains[v][i]).sum());
                energy.add(
                    0.5 * w * piece.volume * mandel::dot(&eps, &materials[body(e)].stress(&eps)),
                );
                let shape = tet10::shape(l);
                let at: V3 = (0..10).fold([0.0; 3], |s, i| {
                    vec3::add(s, vec3::scale(shape[i], piece.displacements[i]))
                });
                work.add(w * piece.volume * vec3::dot(forces[body(e)], at));
            }
        }
        energy.add(dissipated(&pieces, radii[body(e)]));
    };
    let stress = |e: usize, face: usize| {
        let s = stress_at_points(model, &space, field, &materials[body(e)], e)[face];
        [s[0], s[1], s[2]]
    };
    certify_motion(model, &space, &field.nodes.u, &inside, &stress)
}

/// Certifies a stress field under all loads, yield condition included.
pub fn certify_yielding_stress(model: &AnalysisModel, field: &StressField) -> StaticCertificate {
    let base = certify_stress(model, field, Loads::ALL);
    let residual = largest([base.equilibrium, base.traction_jump, base.contact.unwrap_or(0.0)]);
    let yields = utilisation(model, field).0 + hidden_utilisation(model, field, residual) - 1.0;
    StaticCertificate { yields: Some(yields), ..base }
}

/// Largest utilisation `‖dev σ‖/(√(2/3) f_y)` in each tet; 0 where nothing yields.
pub fn utilisations(model: &AnalysisModel, field: &StressField) -> Vec<f64> {
    let radii = model.yield_radii();
    let of = |(stress, body): (&PointStress, &u32)| match radii[*body as usize] {
        Some(radius) => largest(stress.iter().flatten().map(|s| length(&deviator(s)) / radius)),
        None => 0.0,
    };
    field.points.iter().zip(&model.mesh.tet_body).map(of).collect()
}

/// Largest utilisation in each tet of the elastic trial stress of a displacement, measured by the
/// vertex rule of the plastic strain: below 1 the best plastic strain is zero. 0 where nothing
/// yields.
pub fn trial_utilisations(model: &AnalysisModel, field: &PlasticField) -> Vec<f64> {
    let space = Tet10Space::new(&model.mesh);
    let (materials, radii) = (model.stiffnesses(), model.yield_radii());
    (0..model.mesh.tets.len())
        .map(|e| {
            let body = model.mesh.tet_body[e] as usize;
            let Some(radius) = radii[body] else { return 0.0 };
            let of = |piece: &PlasticPiece| {
                let s = tet10::vertex_strains(&piece.corners, &piece.displacements)
                    .map(|s| deviator(&s));
                let sum: [f64; 5] = std::array::from_fn(|a| s.iter().map(|s| s[a]).sum());
                let at = |i: usize| length(&std::array::from_fn(|a| (s[i][a] + sum[a]) / 5.0));
                materials[body].two_mu * largest((0..4).map(at)) / radius
            };
            largest(field.pieces(model, &space, e).iter().map(of))
        })
        .collect()
}

/// State of a body that may yield.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyState {
    /// Fraction of its volume with plastic strain above [`FLOWS`] times the strain at yield, an
    /// estimate from the field of the upper bound.
    pub flowing: f64,
    /// Upper bound of the dissipation in the field of the upper bound \[N mm\].
    pub dissipation: f64,
    /// Largest utilisation by the stress of the lower bound.
    pub utilisation: f64,
    /// Largest equivalent plastic strain, as the mean of a tet, in the field of the upper bound, a
    /// fraction; an estimate.
    pub strain: f64,
    /// Centroid of that tet \[mm\].
    pub strain_at: V3,
}

/// Plastic strain, relative to the elastic strain at yield, above which a point counts as yielded.
pub const FLOWS: f64 = 0.01;

/// State of each body, computed from the fields given; `None` for bodies that never yield.
pub fn body_states(
    model: &AnalysisModel,
    motion: Option<&PlasticField>,
    stress: Option<&StressField>,
) -> Vec<Option<BodyState>> {
    let radii = model.yield_radii();
    let materials = model.stiffnesses();
    let mut out: Vec<Option<BodyState>> =
        radii.iter().map(|r| r.map(|_| BodyState::default())).collect();
    let mut volumes = vec![0.0; out.len()];
    let space = Tet10Space::new(&model.mesh);
    let used = stress.map(|s| utilisations(model, s));
    for (e, &body) in model.mesh.tet_body.iter().enumerate() {
        let body = body as usize;
        volumes[body] += model.mesh.volume(e);
        let (Some(state), Some(radius)) = (&mut out[body], radii[body]) else { continue };
        if let Some(used) = &used {
            state.utilisation = state.utilisation.max(used[e]);
        }
        let Some(motion) = motion else { continue };
        let pieces = motion.pieces(model, &space, e);
        state.dissipation += dissipated(&pieces, Some(radius));
        let strain = mean_equivalent(&pieces);
        if strain > state.strain {
            (state.strain, state.strain_at) = (strain, centroid(&model.mesh.corners(e)));
        }
        let least = FLOWS * radius / materials[body].two_mu;
        for p in &pieces {
            let beyond = p.plastic.iter().filter(|d| length(d) > least).count();
            state.flowing += p.volume * beyond as f64 / 4.0;
        }
    }
    for (state, volume) in out.iter_mut().zip(volumes) {
        state.iter_mut().for_each(|s| s.flowing /= volume);
    }
    out
}
