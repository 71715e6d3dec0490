//! How fast the contribution of each tet falls with its size: `η ~ h^(2q)`.
//!
//! Where the solution is smooth q is 2: strains and stresses are linear in an element, the gap is
//! the square of their error. Next to an edge where stresses grow without limit refinement helps
//! far less. Such tets are told by their contributions alone: the error per volume, freed of the
//! size of the tets (`η / V h⁴`, for smooth solutions the square of a second derivative of the
//! strain), is there a multiple of what it is one ring of tets farther on.

use crate::certify::contributions::Contributions;
use crate::mesh::TetMesh;
use crate::mesh::size_field::regular_edge;
use crate::model::AnalysisModel;
use crate::refine::optimum::Estimate;
use crate::spec::analysis::AnalysisKind;
use rayon::prelude::*;

/// Rate of the energy's gap where the solution is smooth.
pub const SMOOTH: f64 = 2.0;

/// Rate next to a re-entrant right-angled edge; other notches and rigid corners lie between 0.5 and
/// 1.
pub const SINGULAR: f64 = 0.55;

/// Rate of limit analysis: the dissipation is as wrong as the strain.
pub const PLASTIC: f64 = 0.5;

/// Ratios of the freed contribution per volume around a node to that of the ring beyond at which a
/// node counts as one of a smooth region, and as one of a singular edge; between them rates go from
/// one to the other.
const STEEP: [f64; 2] = [1.2, 2.5];

/// Tets at each node.
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

/// The rate q of each tet from the contributions of an elastic analysis: the least of its nodes.
pub fn elastic(mesh: &TetMesh, contributions: &[f64]) -> Vec<f64> {
    let stars = Stars::new(mesh);
    let volumes: Vec<f64> = (0..mesh.tets.len()).map(|e| mesh.volume(e)).collect();
    let freed: Vec<f64> = contributions
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
                sum(&freed) / sum(&volumes)
            };
            let ratio = density(inner) / density(&outer);
            // no ring beyond, or no contribution: nothing to tell
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

/// Rounds of averaging over the tets around a node before two mechanisms are compared: what lies
/// that near is one place.
const BLUR: usize = 2;

/// What the next mesh is designed by: contributions of a pass on `model`, those of contacts shared
/// out to the tets beside them, and of limit analysis what holds the lower bound down in each tet.
///
/// Contributions follow the mechanism: a tet at rest has none, whatever its stress. But the
/// mechanism of the static program's multipliers may be another one (the paper's joint: its
/// supports, plate and bolts, against the beam's end), and the lower bound rises only where that
/// one is. The farther [`apart`] the two are, the more of the gap stands where the lower bound is
/// held.
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
        // squared: two mechanisms in one place (C1: 0.2 to 0.4) are hardly told apart, two in
        // different ones (the joint: 0.7) are
        let part = apart(&model.mesh, &contributions, held).powi(2);
        for (c, held) in contributions.iter_mut().zip(held) {
            *c = (1.0 - part) * c.max(0.0) + part * gap / all * held.max(0.0);
        }
    }
    Estimate { contributions, rates }
}

/// How much of two distributions over the tets lies in different places: 0 the same, 1 nothing in
/// common.
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

    /// The same in other amounts is nowhere apart; neighbours are not far apart, the two ends of a
    /// bar have nothing in common.
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
