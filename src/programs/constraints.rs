//! What holds the unknowns of either program: the points on its faces, and pins against free rigid
//! motions.

use crate::math::vec3::V3;
use crate::model::ModelError;
use crate::model::analysis::{BoundaryFace, FacePair};

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

/// Unknowns to hold so that none of the given motions remains: one per motion, by complete
/// pivoting. Unknowns in `held` are held already and use up the motions they stop. Holding them
/// changes no stress, since no load works on the motions and there is one hold per motion, no more.
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
