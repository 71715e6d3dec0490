//! What holds the unknowns of either program: supports, rigid faces, and pins against free rigid motions.

use super::analysis::{AnalysisModel, BoundaryFace, RigidFace};
use super::dofs::DofMap;
use super::loads::Loads;
use crate::math::dense::null_space;
use crate::math::vec3::{self, V3};
use faer::Mat;
use std::collections::BTreeMap;

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
    /// A body that limit analysis cannot let flow.
    #[error("body `{0}` has no yield strength: in limit analysis every body must be able to yield")]
    NeverYields(String),
    /// A force per volume that the load factor multiplies.
    #[error("a body force on `{0}` carries the load factor: limit analysis takes body forces as dead loads only")]
    LiveBodyForce(String),
    /// Nothing is multiplied by the load factor.
    #[error("no load carries the load factor: there is nothing for limit analysis to increase")]
    NoLiveLoad,
}

impl From<ModelError> for crate::diag::Diagnostic {
    fn from(e: ModelError) -> Self {
        let help = match &e {
            ModelError::RigidFacesTouch(..) => "join the two faces into one physical surface, or move only one of them",
            ModelError::NeverYields(_) => "give its material an `fy`",
            ModelError::LiveBodyForce(_) => "write it under `dead`, or load a face instead",
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

/// The motions a rigid face may make, one vector `[ux, uy, uz, rx, ry, rz]` per unknown of the program.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidMotions {
    /// First unknown.
    pub first: usize,
    /// Motion of each unknown at unit value.
    pub basis: Vec<[f64; 6]>,
}

/// Points that carry unknowns: what a support or rigid face finds on its mesh faces.
pub trait FacePoints {
    /// Indices of the points of a boundary face.
    fn points(&self, face: &BoundaryFace) -> Vec<usize>;
    /// Coordinates of a point \[mm\].
    fn position(&self, point: usize) -> V3;
    /// Number of points.
    fn count(&self) -> usize;
    /// Block of a point for orderings.
    fn block(&self, point: usize) -> u32;
}

/// Numbers the unknowns of a program: three per point, less the held ones, plus the motions of rigid faces.
pub fn number_unknowns(
    model: &AnalysisModel,
    points: &impl FacePoints,
) -> Result<(DofMap, Vec<RigidMotions>), ModelError> {
    let mut fixed = vec![[false; 3]; points.count()];
    for s in &model.supports {
        for p in s.faces.iter().flat_map(|f| points.points(f)) {
            (0..3).for_each(|d| fixed[p][d] |= s.fix[d]);
        }
    }
    let mut owner: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for (r, rigid) in model.rigid.iter().enumerate() {
        for p in rigid.faces.iter().flat_map(|f| points.points(f)) {
            for d in (0..3).filter(|&d| rigid.components[d]) {
                match owner.insert((p, d), r) {
                    Some(other) if other != r => {
                        return Err(ModelError::RigidFacesTouch(
                            model.rigid[other].name.clone(),
                            rigid.name.clone(),
                            ["x", "y", "z"][d],
                        ));
                    }
                    _ => {}
                }
            }
        }
    }
    let mut combinations: Vec<Vec<(u32, f64)>> = vec![Vec::new(); 3 * points.count()];
    let mut block = Vec::new();
    for p in 0..points.count() {
        for d in 0..3 {
            if !fixed[p][d] && !owner.contains_key(&(p, d)) {
                combinations[3 * p + d].push((block.len() as u32, 1.0));
                block.push(points.block(p));
            }
        }
    }
    let plain = block.len();
    let rigid_block = (0..points.count()).map(|p| points.block(p) + 1).max().unwrap_or(0);
    let mut rigid_motions = Vec::with_capacity(model.rigid.len());
    for (r, rigid) in model.rigid.iter().enumerate() {
        let mine: Vec<(usize, usize)> = owner.iter().filter(|(_, o)| **o == r).map(|(k, _)| *k).collect();
        let first = block.len();
        let basis = motions(rigid, points, &mine, &fixed);
        for (k, motion) in basis.iter().enumerate() {
            for &(p, d) in &mine {
                let w = rigid_displacement(motion, rigid.at, points.position(p))[d];
                if w != 0.0 {
                    combinations[3 * p + d].push(((first + k) as u32, w));
                }
            }
            block.push(rigid_block + r as u32);
        }
        rigid_motions.push(RigidMotions { first, basis });
    }
    Ok((DofMap::new(combinations, plain, block), rigid_motions))
}

/// A basis of the free motions that move no held component of the face's points. Rotations are scaled to move the face
/// as much as a unit translation does.
fn motions(rigid: &RigidFace, points: &impl FacePoints, mine: &[(usize, usize)], fixed: &[[bool; 3]]) -> Vec<[f64; 6]> {
    let reach =
        mine.iter().map(|&(p, _)| vec3::norm(vec3::sub(points.position(p), rigid.at))).fold(0.0, f64::max).max(1e-12);
    let free: Vec<[f64; 6]> = (0..6)
        .filter(|&m| rigid.free[m])
        .map(|m| {
            let mut v = [0.0; 6];
            v[m] = if m < 3 { 1.0 } else { 1.0 / reach };
            v
        })
        .collect();
    let mut gram = Mat::<f64>::zeros(free.len(), free.len());
    let mut conflicts = false;
    for &(p, d) in mine.iter().filter(|&&(p, d)| fixed[p][d]) {
        conflicts = true;
        let row: Vec<f64> = free.iter().map(|m| rigid_displacement(m, rigid.at, points.position(p))[d]).collect();
        for i in 0..free.len() {
            for j in 0..free.len() {
                gram[(i, j)] += row[i] * row[j];
            }
        }
    }
    if !conflicts {
        return free;
    }
    null_space(&gram, 1e-12)
        .into_iter()
        .map(|c| std::array::from_fn(|i| c.iter().zip(&free).map(|(w, m)| w * m[i]).sum()))
        .collect()
}

/// Forces of rigid faces on the program's unknowns: the work of their actions on unit motions.
pub fn add_rigid_actions(model: &AnalysisModel, motions: &[RigidMotions], loads: Loads, f: &mut [f64]) {
    for (rigid, m) in model.rigid.iter().zip(motions) {
        let action = loads.action(rigid);
        for (k, motion) in m.basis.iter().enumerate() {
            f[m.first + k] += (0..6).map(|i| motion[i] * action[i]).sum::<f64>();
        }
    }
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
