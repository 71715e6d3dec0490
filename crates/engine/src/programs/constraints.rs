//! Constraints on the unknowns of either program: the points of faces that supports and rigid faces
//! constrain, and pins against free rigid motions.

use crate::model::ModelError;
use crate::model::analysis::{BoundaryFace, FacePair};
use crate::programs::conic::SymmetricCsc;
use bracket_base::math::vec3::V3;

/// Points of a program that carry unknowns, found by the mesh faces they lie on.
pub trait FacePoints {
    /// Indices of the points of a boundary face.
    fn points(&self, face: &BoundaryFace) -> Vec<usize>;
    /// Indices of the points of a tet.
    fn tet_points(&self, tet: usize) -> Vec<usize>;
    /// Coincident points of the two sides of an opened face, side A first.
    fn pairs(&self, face: &FacePair) -> Vec<[usize; 2]>;
    /// Coordinates of a point \[mm\].
    fn position(&self, point: usize) -> V3;
    /// Number of points.
    fn count(&self) -> usize;
    /// Block of a point (node or face) for fill-reducing orderings.
    fn block(&self, point: usize) -> u32;
}

/// Returns the live loads on the unknowns of a program; an error when none of them can do work.
pub fn working_live_loads(live: Vec<f64>) -> Result<Vec<f64>, ModelError> {
    if live.iter().all(|f| *f == 0.0) { Err(ModelError::LiveLoadsHeld) } else { Ok(live) }
}

/// Unknowns to hold so that none of the given motions remains: one per motion, by complete
/// pivoting. Unknowns in `held` are held already; each removes a motion that it stops.
///
/// The pins change no stress: no load works on the motions, and there is exactly one pin per
/// motion.
pub fn pins(mut motions: Vec<Vec<f64>>, held: &[usize]) -> Vec<usize> {
    let mut first = 0;
    for &pivot in held {
        let candidates = first..motions.len();
        let best =
            candidates.max_by(|&a, &b| motions[a][pivot].abs().total_cmp(&motions[b][pivot].abs()));
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

/// Holds unknowns at zero: adds the mean of `stiffness` (empty: the diagonal of P) to their
/// diagonal entries. No force acts on them, so their value becomes zero.
pub fn hold(p: &mut SymmetricCsc, unknowns: &[usize], stiffness: &[f64]) {
    let diagonal = if stiffness.is_empty() { p.diagonal() } else { stiffness.to_vec() };
    let mean = diagonal.iter().sum::<f64>() / diagonal.len().max(1) as f64;
    unknowns.iter().for_each(|&k| p.add_diagonal(k, mean));
}
