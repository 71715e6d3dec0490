//! Preloaded bolts of a result.

use crate::result::forces::ON_PLANE;
use bracket_engine::analysis::preloaded_bolt::PreloadedBolt;
use bracket_engine::model::AnalysisModel;

/// Marks the bolts that a plane of symmetry halves. `mirror` contains the normals of these planes,
/// which pass through the origin.
pub fn mark_halved(bolts: &mut [PreloadedBolt], model: &AnalysisModel, mirror: &[usize]) {
    for bolt in bolts {
        let cut = model
            .preload
            .iter()
            .filter(|p| p.body == bolt.body && p.cut == bolt.cut)
            .flat_map(|p| &p.faces);
        let mut rim = cut.flat_map(|f| f.nodes_a).map(|n| model.mesh.nodes[n as usize]);
        bolt.halved = rim.any(|x| mirror.iter().any(|&k| x[k].abs() < ON_PLANE));
    }
}
