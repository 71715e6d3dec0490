//! The rate q at which the contribution of each tet falls with its size: `η ~ h^(2q)`.
//!
//! Where the solution is smooth, q is 2: strains and stresses are linear in an element, and the gap
//! is the square of their error. Next to an edge where stresses grow without limit, refinement
//! helps far less. Such tets are recognised by their contributions alone: the error per volume,
//! scaled to be independent of the size of the tets (`η / V h⁴`, for smooth solutions the square of
//! a second derivative of the strain), is there a multiple of its value one ring of tets farther
//! away.

use crate::analysis::dispatch::AnalysisPass;
use crate::certify::contributions::Contributions;
use crate::mesh::TetMesh;
use crate::mesh::size_field::regular_edge;
use crate::model::AnalysisKind;
use crate::model::AnalysisModel;
use crate::model::file::Bounds;
use crate::refine::directions::{recovered_second_derivatives, second_derivatives};
use crate::refine::mechanism_error;
use crate::refine::near_yield;
use crate::refine::optimum::{Estimate, PARTS};
use rayon::prelude::*;

/// Rate of the energy's gap where the solution is smooth.
pub const SMOOTH: f64 = 2.0;

/// Rate next to a re-entrant right-angled edge; other notches and rigid corners lie between 0.5 and
/// 1.
pub const SINGULAR: f64 = 0.55;

/// Rate in limit analysis: the error of the dissipation is proportional to that of the strain.
pub const PLASTIC: f64 = 0.5;

/// Fewest parts of a tet on a mesh for one bound: the next mechanism may be where the last mesh was
/// refined.
const LEAST_PARTS: f64 = 0.5;

/// Ratios of the scaled contribution per volume around a node to that of the ring beyond: up to the
/// first the node lies in a smooth region, from the second on at a singular edge. In between the
/// rate is interpolated.
const STEEP: [f64; 2] = [1.2, 2.5];

/// The tets around each node.
struct Stars {
    start: Vec<u32>,
    tets: Vec<u32>,
}

impl Stars {
    fn new(mesh: &TetMesh) -> Self {
        let mut start = vec![0u32; mesh.nodes.len() + 1];
        mesh.tets.iter().flatten().for_each(|n| start[*n as usize + 1] += 1);
        (0..mesh.nodes.len()).for_each(|n| start[n + 1] += start[n]);
        let mut place = start.clone();
        let mut tets = vec![0u32; 4 * mesh.tets.len()];
        for (e, t) in mesh.tets.iter().enumerate() {
            for n in t {
                tets[place[*n as usize] as usize] = e as u32;
                place[*n as usize] += 1;
            }
        }
        Self { start, tets }
    }

    fn at(&self, n: u32) -> &[u32] {
        &self.tets[self.start[n as usize] as usize..self.start[n as usize + 1] as usize]
    }
}

/// The rate q of each tet from the contributions of an elastic analysis: the smallest of its nodes.
pub fn elastic(mesh: &TetMesh, contributions: &[f64]) -> Vec<f64> {
    let stars = Stars::new(mesh);
    let volumes: Vec<f64> = (0..mesh.tets.len()).map(|e| mesh.volume(e)).collect();
    let scaled: Vec<f64> = contributions
        .iter()
        .zip(&volumes)
        .map(|(c, v)| c.max(0.0) / regular_edge(*v).powi(4))
        .collect();
    let nodes: Vec<f64> = (0..mesh.nodes.len() as u32)
        .into_par_iter()
        .map(|node| {
            let inner = stars.at(node);
            let mut rim: Vec<u32> = inner.iter().flat_map(|t| mesh.tets[*t as usize]).collect();
            rim.sort_unstable();
            rim.dedup();
            let mut outer: Vec<u32> = rim.iter().flat_map(|n| stars.at(*n)).copied().collect();
            outer.sort_unstable();
            outer.dedup();
            outer.retain(|t| !inner.contains(t));
            let density = |tets: &[u32]| {
                let sum = |x: &[f64]| tets.iter().map(|t| x[*t as usize]).sum::<f64>();
                sum(&scaled) / sum(&volumes)
            };
            let ratio = density(inner) / density(&outer);
            // without a ring beyond or a contribution the node counts as smooth
            let steep = if ratio.is_finite() {
                (ratio / STEEP[0]).ln() / (STEEP[1] / STEEP[0]).ln()
            } else {
                0.0
            };
            SMOOTH * (SINGULAR / SMOOTH).powf(steep.clamp(0.0, 1.0))
        })
        .collect();
    mesh.tets.iter().map(|t| t.iter().map(|n| nodes[*n as usize]).fold(SMOOTH, f64::min)).collect()
}

/// Rounds of averaging over the tets around a node before two distributions are compared: tets that
/// close count as one place.
const BLUR: usize = 2;

/// The estimates from which the next mesh is designed. They combine the contributions of a pass on
/// `model`, those of contacts distributed to the adjacent tets, with the shares of the yield
/// multipliers in limit analysis.
///
/// Contributions follow the mechanism: a tet at rest has none, whatever its stress. The mechanism
/// of the static program's multipliers may be another one (in the paper's joint: supports, plate
/// and bolts, against the end of the beam), and the lower bound rises only with refinement there.
/// The farther `apart` the two distributions are, the more of the gap is assigned to the yield
/// multipliers.
pub fn estimate(
    model: &AnalysisModel,
    contributions: &Contributions,
    yield_multiplier_share: Option<&[f64]>,
) -> Estimate {
    let mut contributions = contributions.by_tet(model);
    let rates = match model.analysis {
        AnalysisKind::Limit => vec![PLASTIC; contributions.len()],
        _ => elastic(&model.mesh, &contributions),
    };
    let total = |x: &[f64]| x.iter().map(|c| c.max(0.0)).sum::<f64>();
    let gap = total(&contributions);
    if let Some((held, all)) =
        yield_multiplier_share.map(|h| (h, total(h))).filter(|(_, all)| *all > 0.0 && gap > 0.0)
    {
        // squared to separate two mechanisms in one place (case C1: 0.2 to 0.4) from two in
        // different places (the joint: 0.7)
        let part = apart(&model.mesh, &contributions, held).powi(2);
        for (c, held) in contributions.iter_mut().zip(held) {
            *c = (1.0 - part) * c.max(0.0) + part * gap / all * held.max(0.0);
        }
    }
    Estimate { contributions, rates, directions: Vec::new(), least_parts: PARTS[0] }
}

/// The estimate for the meshes of the bounds asked for, from a pass on `model`; `None` if it lacks
/// the fields.
///
/// The mesh of each bound follows the error of its mechanism, for the lower bound that of the
/// static program's multipliers with the places near yield; one mesh for both follows the
/// contributions to the gap.
pub fn for_bounds(bounds: Bounds, model: &AnalysisModel, pass: &AnalysisPass) -> Option<Estimate> {
    let directions = match bounds {
        Bounds::Static => {
            pass.static_velocities().map(|u| recovered_second_derivatives(&model.mesh, u))
        }
        _ => pass.kinematic_field().map(|u| second_derivatives(&model.mesh, u)),
    };
    let directions = directions.unwrap_or_default();
    let contributions = match bounds {
        Bounds::Both => {
            let share = pass.yield_multiplier_share();
            return Some(Estimate { directions, ..estimate(model, pass.contributions()?, share) });
        }
        Bounds::Static => {
            let errors = mechanism_error::of_vertices(model, pass.static_velocities()?);
            near_yield::shares(model, errors, pass.stress(model.has_coulomb_friction()))
        }
        Bounds::Kinematic => mechanism_error::of_tets(model, pass.velocity()?),
    };
    let rates = vec![PLASTIC; model.mesh.tets.len()];
    Some(Estimate { contributions, rates, directions, least_parts: LEAST_PARTS })
}

/// Fraction of two distributions over the tets that lies in different places: 0 where they are
/// equal, 1 where they have no place in common.
fn apart(mesh: &TetMesh, a: &[f64], b: &[f64]) -> f64 {
    let stars = Stars::new(mesh);
    let blurred = |x: &[f64]| {
        let mut x: Vec<f64> = x.iter().map(|c| c.max(0.0)).collect();
        for _ in 0..BLUR {
            let mean = |n: u32| {
                0.25 * stars.at(n).iter().map(|t| x[*t as usize]).sum::<f64>()
                    / stars.at(n).len() as f64
            };
            let nodes: Vec<f64> = (0..mesh.nodes.len() as u32).map(mean).collect();
            x = mesh.tets.iter().map(|t| t.iter().map(|n| nodes[*n as usize]).sum()).collect();
        }
        let all: f64 = x.iter().sum();
        x.iter_mut().for_each(|c| *c /= all);
        x
    };
    0.5 * blurred(a).iter().zip(blurred(b)).map(|(a, b)| (a - b).abs()).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::fixtures::cubes;

    /// Proportional distributions have distance 0, neighbours a small one, the two ends of a bar 1.
    #[test]
    fn distance_of_distributions() {
        let bar: Vec<_> = (0..40).map(|i| ([i, 0, 0], "A")).collect();
        let mesh = cubes(&bar);
        let n = mesh.tets.len();
        let at = |tets: std::ops::Range<usize>| {
            (0..n).map(|e| if tets.contains(&e) { 2.0 } else { 0.0 }).collect::<Vec<f64>>()
        };
        let first = at(0..6);
        let scaled: Vec<f64> = first.iter().map(|x| 3.0 * x).collect();
        assert!(apart(&mesh, &first, &scaled) < 1e-12);
        assert!((apart(&mesh, &first, &at(n - 6..n)) - 1.0).abs() < 1e-12);
        let near = apart(&mesh, &first, &at(3..9));
        assert!(near > 0.05 && near < 0.5, "{near}");
    }
}
