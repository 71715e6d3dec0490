//! How fast the contribution of each tet falls with its size: `η ~ h^(2q)`.
//!
//! Where the solution is smooth q is 2: strains and stresses are linear in an element, the gap is the square of their error. Next to
//! an edge where stresses grow without limit refinement helps far less. Such tets are told by their contributions alone: the
//! error per volume, freed of the size of the tets (`η / V h⁴`, for smooth solutions the square of a second derivative of the
//! strain), is there a multiple of what it is one ring of tets farther on.

use super::optimum::Estimate;
use crate::bounds::error::Contributions;
use crate::mesh::TetMesh;
use crate::mesh::size_field::regular_edge;
use crate::model::AnalysisModel;
use crate::model::file::AnalysisKind;
use rayon::prelude::*;

/// Rate of the energy's gap where the solution is smooth.
pub const SMOOTH: f64 = 2.0;

/// Rate next to a re-entrant right-angled edge; other notches and rigid corners lie between 0.5 and 1.
pub const SINGULAR: f64 = 0.55;

/// Rate of limit analysis: the dissipation is as wrong as the strain.
pub const PLASTIC: f64 = 0.5;

/// Ratios of the freed contribution per volume around a node to that of the ring beyond at which a node counts as one of a smooth
/// region, and as one of a singular edge; between them rates go from one to the other.
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
    let freed: Vec<f64> =
        contributions.iter().zip(&volumes).map(|(c, v)| c.max(0.0) / regular_edge(*v).powi(4)).collect();
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
            let steep = if ratio.is_finite() { (ratio / STEEP[0]).ln() / (STEEP[1] / STEEP[0]).ln() } else { 0.0 };
            SMOOTH * (SINGULAR / SMOOTH).powf(steep.clamp(0.0, 1.0))
        })
        .collect();
    mesh.tets.iter().map(|t| t.iter().map(|n| nodes[*n as usize]).fold(SMOOTH, f64::min)).collect()
}

/// Part of the gap that the design gives to the places that hold the lower bound of a load factor down; the rest stays where the
/// contributions are.
///
/// Contributions follow the mechanism: a tet at rest has none, whatever its stress. But the mechanism of the static program's multipliers may
/// be another one (the paper's joint: its supports, plate and bolts, against the beam's end), and the lower bound rises only where that one is.
const HELD: f64 = 0.5;

/// What the next mesh is designed by: contributions of a pass on `model`, those of contacts shared out to the tets beside them, and of
/// limit analysis what holds the lower bound down in each tet.
pub fn estimate(model: &AnalysisModel, contributions: &Contributions, held: Option<&[f64]>) -> Estimate {
    let mut contributions = contributions.by_tet(model);
    let rates = match model.analysis {
        AnalysisKind::Limit => vec![PLASTIC; contributions.len()],
        _ => elastic(&model.mesh, &contributions),
    };
    if let Some(held) = held {
        let total = |x: &[f64]| x.iter().map(|c| c.max(0.0)).sum::<f64>();
        let (gap, all) = (total(&contributions), total(held));
        if all > 0.0 {
            for (c, held) in contributions.iter_mut().zip(held) {
                *c = (1.0 - HELD) * c.max(0.0) + HELD * gap / all * held.max(0.0);
            }
        }
    }
    Estimate { contributions, rates }
}
