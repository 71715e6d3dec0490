//! Where the mesh resolves the mechanism of a kinematic program badly.
//!
//! Dissipation alone is no measure: a bolt that stretches evenly dissipates much and is exact on
//! any mesh. What a finer mesh changes is the strain rate, so the measure is the difference between
//! the strain rate of a tet and its average over the tets around each vertex, in units of
//! dissipation: `√2 k V ¼ Σ_v ‖dev(ε_v − ε̄_v)‖`.
//!
//! # Source
//! Recovery of gradients after Zienkiewicz and Zhu (1987), in the norm of the dissipation.

use crate::certify::velocity_field::VelocityField;
use crate::elements::space::Tet10Space;
use crate::elements::tet10;
use crate::model::AnalysisModel;
use bracket_base::math::mandel::{self, Mandel};

/// The deviator of a tensor.
fn deviator(mut t: Mandel) -> Mandel {
    let mean = (t[0] + t[1] + t[2]) / 3.0;
    t[..3].iter_mut().for_each(|x| *x -= mean);
    t
}

/// The measure of each tet \[N mm per unit of time\]; zero in rigid bodies.
pub fn of_tets(model: &AnalysisModel, field: &VelocityField) -> Vec<f64> {
    let mesh = &model.mesh;
    let space = Tet10Space::new(mesh);
    let radii = model.yield_radii();
    let strains: Vec<[Mandel; 4]> = (0..mesh.tets.len())
        .map(|e| {
            let nodes = space.tet(mesh, e).map(|n| field.nodes.u[n]);
            tet10::vertex_strains(&mesh.corners(e), &nodes).map(deviator)
        })
        .collect();
    // rigid bodies do not count where they share nodes with others
    let flows = |e: usize| radii[mesh.tet_body[e] as usize].is_some();
    let mut mean = vec![[0.0; 6]; mesh.nodes.len()];
    let mut weight = vec![0.0; mesh.nodes.len()];
    for e in (0..mesh.tets.len()).filter(|&e| flows(e)) {
        let volume = mesh.volume(e);
        for (n, strain) in mesh.tets[e].iter().zip(&strains[e]) {
            (0..6).for_each(|c| mean[*n as usize][c] += volume * strain[c]);
            weight[*n as usize] += volume;
        }
    }
    (0..mesh.tets.len())
        .map(|e| {
            let Some(radius) = radii[mesh.tet_body[e] as usize] else { return 0.0 };
            let sum: f64 = mesh.tets[e]
                .iter()
                .zip(&strains[e])
                .map(|(n, strain)| {
                    let n = *n as usize;
                    let difference: Mandel =
                        std::array::from_fn(|c| strain[c] - mean[n][c] / weight[n]);
                    mandel::norm(&difference)
                })
                .sum();
            0.25 * radius * mesh.volume(e) * sum
        })
        .collect()
}
