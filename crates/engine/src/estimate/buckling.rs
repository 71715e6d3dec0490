//! Linear buckling: the critical factors of the loads of a stress field.
//!
//! `K v + α K_σ v = 0` on the displacements of the kinematic program: K the elastic stiffness, K_σ
//! the geometric stiffness of the given stress, α the factor on the loads that the stress belongs
//! to, preload included. Welds are tied, cuts closed, contacts frozen in the state of the given
//! fields ([`contact_state`]). Loads keep their direction. Motions that nothing resists are held at
//! one point each ([`loose_motions`]).
//!
//! On a given contact state conforming elements make α an upper bound of the exact factor for that
//! stress, up to the softness of closed contacts: it is no safe value by itself. [`conservative`]
//! makes one from two meshes.
//!
//! A model that is part of a symmetric structure finds only the symmetric modes; others may be
//! lower.
//!
//! # Source
//! EN 1993-1-5, section 10; S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, 2nd ed.

pub mod contact_state;
pub mod error;
pub mod extrapolated;
pub mod lanczos;
pub mod loose_motions;
pub mod matrices;

use crate::certify::fields::{DisplacementField, StressField};
use crate::elements::geometric_stiffness::geometric_stiffness;
use crate::elements::tet10::{self, Matrix30};
use crate::model::AnalysisModel;
use crate::programs::assemble::assemble;
use crate::programs::conic::SymmetricCsc;
use crate::programs::elastic_unknowns::ElasticUnknowns;
use crate::solve::sparse::{Patterns, SparseCholesky};
use bracket_base::math::vec3::{self, V3};
use contact_state::ContactState;
pub use error::BucklingError;
pub use extrapolated::conservative;
use lanczos::{Pair, Pencil, Wanted};
use rayon::prelude::*;
use std::convert::Infallible;

/// The structure is checked to be stable at this share of the lowest factor found.
const CHECKED: f64 = 0.999;

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BucklingOptions {
    /// Number of modes, ≥ 1.
    pub modes: usize,
    /// Modes with larger factors do not matter and are left out. EN 1993-1-5 needs none above
    /// 25 α_ult, where even a column has no reduction.
    pub largest: f64,
    /// Relative residual at which a mode has converged, see [`BucklingMode::residual`].
    pub tolerance: f64,
}

impl Default for BucklingOptions {
    /// Four modes with factors up to 1000, to 1e-6.
    fn default() -> Self {
        Self { modes: 4, largest: 1e3, tolerance: 1e-6 }
    }
}

/// A buckling mode.
#[derive(Clone, Debug, PartialEq)]
pub struct BucklingMode {
    /// Critical factor α_cr > 0 of the loads that the stress field belongs to.
    pub factor: f64,
    /// Relative residual in the energy norm: the discrete problem has an exact factor α' with
    /// `|α_cr/α' − 1|` at most this.
    pub residual: f64,
    /// Displacements of vertices and mid-side nodes, in the order of
    /// [`crate::elements::space::Tet10Space`]; the longest has length 1. The sign has no meaning.
    pub shape: Vec<V3>,
    /// Share of each body in the strain energy of the mode; sums to 1.
    pub share_by_body: Vec<f64>,
}

/// The lowest buckling modes of a stress field.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Buckling {
    /// Modes by increasing factor. None: the structure is stable up to the largest factor asked
    /// for, because nothing, or too little, is pressed.
    pub modes: Vec<BucklingMode>,
    /// True when every mode asked for was found or has a larger factor than asked for; false when
    /// higher modes are missing because they did not converge. The first mode is the lowest one in
    /// either case.
    pub complete: bool,
    /// Number of contact faces frozen as closed.
    pub closed_faces: usize,
    /// Number of all contact faces.
    pub contact_faces: usize,
    /// Number of rigid motions, resisted by friction alone or by nothing, that were held at one
    /// point each.
    pub held_motions: usize,
    /// Steps of the iteration.
    pub steps: usize,
}

/// The lowest critical factors of the loads that two fields of an elastic analysis belong to.
///
/// `stress` is multiplied; `displacement` decides together with it which contacts are closed. An
/// empty list of modes means that nothing buckles up to the largest factor of `options`.
pub fn buckling(
    model: &AnalysisModel,
    displacement: &DisplacementField,
    stress: &StressField,
    options: &BucklingOptions,
) -> Result<Buckling, BucklingError> {
    let model = &model.with_welds_tied();
    let unknowns = ElasticUnknowns::new(model)?;
    check(model, &unknowns, displacement, stress)?;
    let state = ContactState::new(model, &unknowns.space, displacement, stress);
    let System { mut stiffness, geometric, held_motions } =
        System::new(model, &unknowns, &state, stress);
    let [closed_faces, contact_faces] = state.count();
    let empty = Buckling { closed_faces, contact_faces, held_motions, ..Buckling::default() };
    if geometric.values.iter().all(|v| *v == 0.0) {
        return Ok(Buckling { complete: true, ..empty });
    }
    let mut factor = SparseCholesky::new(&stiffness, &unknowns.map.block, &Patterns::default())
        .map_err(BucklingError::Stiffness)?;
    let pencil = Pencil { stiffness: &stiffness, geometric: &geometric, factor: &factor };
    let wanted = Wanted {
        count: options.modes.max(1),
        largest: options.largest,
        tolerance: options.tolerance,
    };
    let ended = lanczos::lowest_positive(&pencil, &wanted);
    let lowest = ended.pairs.first().map(|p| p.factor);
    if lowest.is_none() && !ended.complete {
        let (steps, residual) = (ended.steps, ended.residual);
        return Err(BucklingError::NoConvergence { steps, residual });
    }
    // definite at a factor: no mode below it
    let below = lowest.map_or(options.largest, |f| CHECKED * f);
    stiffness = matrices::sum(&stiffness, below, &geometric);
    factor.refactor(&stiffness).map_err(|_| BucklingError::Missed(below))?;
    let modes = ended.pairs.into_iter().map(|p| mode(model, &unknowns, p)).collect();
    Ok(Buckling { modes, complete: ended.complete, steps: ended.steps, ..empty })
}

/// Checks that the fields belong to the mesh.
fn check(
    model: &AnalysisModel,
    unknowns: &ElasticUnknowns,
    displacement: &DisplacementField,
    stress: &StressField,
) -> Result<(), BucklingError> {
    let size = |field, found, needed| {
        if found == needed { Ok(()) } else { Err(BucklingError::Size { field, found, needed }) }
    };
    size("displacement", displacement.u.len(), unknowns.space.nodes.len())?;
    size("stress", stress.points.len(), model.mesh.tets.len())?;
    if !displacement.u.as_flattened().iter().all(|x| x.is_finite()) {
        return Err(BucklingError::NotFinite("displacement"));
    }
    if !stress.points.iter().flatten().flatten().flatten().all(|x| x.is_finite()) {
        return Err(BucklingError::NotFinite("stress"));
    }
    Ok(())
}

/// The matrices on the unknowns of the model.
struct System {
    stiffness: SymmetricCsc,
    geometric: SymmetricCsc,
    held_motions: usize,
}

impl System {
    fn new(
        model: &AnalysisModel,
        unknowns: &ElasticUnknowns,
        state: &ContactState,
        stress: &StressField,
    ) -> Self {
        let mesh = &model.mesh;
        let materials = model.stiffnesses();
        let elastic = assembled(model, unknowns, |e| {
            let material = &materials[mesh.tet_body[e] as usize];
            tet10::stiffness(&mesh.corners(e), mesh.volume(e), material)
        });
        let mut geometric = assembled(model, unknowns, |e| {
            geometric_stiffness(&mesh.corners(e), mesh.volume(e), &stress.points[e])
        });
        let contact = state.stiffness(&unknowns.map);
        let loose = loose_motions::pins(model, unknowns, &contact);
        let held: Vec<usize> =
            unknowns.pins.iter().copied().chain(unknowns.closures()).chain(loose.clone()).collect();
        let mut stiffness = matrices::sum(&elastic, 1.0, &contact);
        let diagonal = matrices::mean_diagonal(&elastic);
        matrices::hold(&mut stiffness, &held, diagonal);
        matrices::hold(&mut geometric, &held, 0.0);
        Self { stiffness, geometric, held_motions: unknowns.pins.len() + loose.len() }
    }
}

/// Assembles matrices of the tets on the unknowns.
fn assembled(
    model: &AnalysisModel,
    unknowns: &ElasticUnknowns,
    matrix: impl Fn(usize) -> Matrix30 + Sync,
) -> SymmetricCsc {
    let dofs = |e: usize| {
        let nodes = unknowns.space.tet(&model.mesh, e);
        std::array::from_fn(|i| 3 * nodes[i / 3] + i % 3)
    };
    let of = |e: usize| Ok::<_, Infallible>(matrix(e));
    let Ok(a) = assemble::<30, Infallible>(model.mesh.tets.len(), &unknowns.map, dofs, of);
    a
}

/// The mode of a pair.
fn mode(model: &AnalysisModel, unknowns: &ElasticUnknowns, pair: Pair) -> BucklingMode {
    let full = unknowns.map.expand(&pair.vector);
    let mut shape: Vec<V3> = full.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
    let longest = shape.iter().fold(0.0f64, |m, u| m.max(vec3::norm(*u)));
    shape.iter_mut().for_each(|u| *u = vec3::scale(1.0 / longest, *u));
    let share_by_body = shares(model, unknowns, &shape);
    BucklingMode { factor: pair.factor, residual: pair.residual, shape, share_by_body }
}

/// Share of each body in the strain energy of nodal displacements.
fn shares(model: &AnalysisModel, unknowns: &ElasticUnknowns, u: &[V3]) -> Vec<f64> {
    let mesh = &model.mesh;
    let materials = model.stiffnesses();
    let energy = |e: usize| {
        let nodal = unknowns.space.tet(mesh, e).map(|n| u[n]);
        let v = nodal.as_flattened();
        let material = &materials[mesh.tet_body[e] as usize];
        let k = tet10::stiffness(&mesh.corners(e), mesh.volume(e), material);
        let force = |row: &[f64; 30]| row.iter().zip(v).map(|(k, v)| k * v).sum::<f64>();
        k.iter().zip(v).map(|(row, v)| v * force(row)).sum::<f64>()
    };
    let energies: Vec<f64> = (0..mesh.tets.len()).into_par_iter().map(energy).collect();
    let total: f64 = energies.iter().sum();
    let mut shares = vec![0.0; mesh.bodies.len()];
    for (energy, body) in energies.iter().zip(&mesh.tet_body) {
        shares[*body as usize] += energy / total;
    }
    shares
}
