//! What holds the unknowns of either program: the points on its faces, and pins against free rigid motions.

use super::analysis::{BoundaryFace, FacePair};
use crate::math::vec3::{self, V3};

/// Why a program cannot be set up.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ModelError {
    /// Two rigid faces share nodes in a component both of them move.
    #[error("rigid faces `{0}` and `{1}` share an edge and both move it in {2}")]
    RigidFacesTouch(String, String, &'static str),
    /// An element too flat for its stress parameters.
    #[error("tet {tet} (near {x:.1}, {y:.1}, {z:.1} mm) is too flat for the static program")]
    FlatTet {
        /// Index of the tet, from 0.
        tet: usize,
        /// Centroid \[mm\].
        x: f64,
        /// Centroid \[mm\].
        y: f64,
        /// Centroid \[mm\].
        z: f64,
    },
    /// Nothing that could give way.
    #[error("no body has a yield strength and no contact can slip or open: there is nothing that could collapse")]
    NothingYields,
    /// Something holds the halves of a bolt apart where its preload draws them together.
    #[error("{holder} at the rim of the cut `{cut}` lets its halves move neither together nor apart")]
    CutHeld {
        /// What holds it.
        holder: &'static str,
        /// Name of the cut.
        cut: String,
    },
    /// A force per volume that the load factor multiplies.
    #[error("a body force on `{0}` carries the load factor: limit analysis takes body forces as dead loads only")]
    LiveBodyForce(String),
    /// What the load factor multiplies can do no work.
    #[error("every load that carries the load factor acts on what supports hold: it can grow without limit")]
    LiveLoadsHeld,
    /// Nothing is multiplied by the load factor.
    #[error("no load carries the load factor: there is nothing for limit analysis to increase")]
    NoLiveLoad,
}

impl From<ModelError> for crate::diag::Diagnostic {
    fn from(e: ModelError) -> Self {
        let help = match &e {
            ModelError::RigidFacesTouch(..) => "join the two faces into one physical surface, or move only one of them",
            ModelError::NothingYields => "give the material of the bodies that can yield an `fy`",
            ModelError::CutHeld { .. } => "cut the shank away from supports, rigid faces, welds and other cuts",
            ModelError::LiveBodyForce(_) => "write it under `dead`, or load a face instead",
            ModelError::LiveLoadsHeld => "load a face that can move, or free what the load is to move",
            ModelError::NoLiveLoad => "write the load to be increased under `loads`",
            ModelError::FlatTet { .. } => "improve the mesh there (a coarser size, an optimised mesh), then try again",
        };
        crate::diag::Diagnostic::input("model/program", e.to_string()).help(help)
    }
}

/// The motion of a point of a rigid body: `U + θ × (x − at)`.
pub fn rigid_displacement(motion: &[f64; 6], at: V3, x: V3) -> V3 {
    let theta = [motion[3], motion[4], motion[5]];
    vec3::add([motion[0], motion[1], motion[2]], vec3::cross(theta, vec3::sub(x, at)))
}

/// Points that carry unknowns: what a support or rigid face finds on its mesh faces.
pub trait FacePoints {
    /// Indices of the points of a boundary face.
    fn points(&self, face: &BoundaryFace) -> Vec<usize>;
    /// Indices of the points of a tet.
    fn tet_points(&self, tet: usize) -> Vec<usize>;
    /// Points of the two sides of an opened face that lie on each other, side A first.
    fn pairs(&self, face: &FacePair) -> Vec<[usize; 2]>;
    /// Coordinates of a point \[mm\].
    fn position(&self, point: usize) -> V3;
    /// Number of points.
    fn count(&self) -> usize;
    /// Block of a point for orderings.
    fn block(&self, point: usize) -> u32;
}

/// The live loads on the unknowns of a program, if any of them can do work.
pub fn that_work(live: Vec<f64>) -> Result<Vec<f64>, ModelError> {
    if live.iter().all(|f| *f == 0.0) { Err(ModelError::LiveLoadsHeld) } else { Ok(live) }
}

/// Unknowns to hold so that none of the given motions remains: one per motion, by complete pivoting. Unknowns in `held`
/// are held already and use up the motions they stop. Holding them changes no stress, since no load works on the motions
/// and there is one hold per motion, no more.
pub fn pins(mut motions: Vec<Vec<f64>>, held: &[usize]) -> Vec<usize> {
    let mut first = 0;
    for &pivot in held {
        let candidates = first..motions.len();
        let best = candidates.max_by(|&a, &b| motions[a][pivot].abs().total_cmp(&motions[b][pivot].abs()));
        let Some(m) = best.filter(|&m| motions[m][pivot] != 0.0) else { continue };
        eliminate(&mut motions, first, m, pivot);
        first += 1;
    }
    let mut chosen = Vec::new();
    for step in first..motions.len() {
        let mut best = (0.0, step, 0);
        for (m, motion) in motions.iter().enumerate().skip(step) {
            for (i, x) in motion.iter().enumerate() {
                if x.abs() > best.0 * (1.0 + 1e-9) {
                    best = (x.abs(), m, i);
                }
            }
        }
        let (size, m, pivot) = best;
        if size == 0.0 {
            break;
        }
        eliminate(&mut motions, step, m, pivot);
        chosen.push(pivot);
    }
    chosen
}

/// Puts motion `m` at `step` and removes unknown `pivot` from the motions after it.
fn eliminate(motions: &mut [Vec<f64>], step: usize, m: usize, pivot: usize) {
    motions.swap(step, m);
    let row = motions[step].clone();
    for other in motions.iter_mut().skip(step + 1) {
        let k = other[pivot] / row[pivot];
        other.iter_mut().zip(&row).for_each(|(a, b)| *a -= k * b);
        other[pivot] = 0.0;
    }
}
