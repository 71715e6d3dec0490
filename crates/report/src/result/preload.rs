//! Preloaded bolts of a result.

use crate::result::forces::ON_PLANE;
use bracket_engine::analysis::preloaded_bolt::PreloadedBolt;
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::analysis::Preload;

/// The entry of a result for a preloaded cut of the model.
pub fn of_cut<'a>(found: &'a [PreloadedBolt], cut: &Preload) -> Option<&'a PreloadedBolt> {
    found.iter().find(|bolt| bolt.body == cut.body && bolt.cut == cut.cut)
}

/// Gives the cuts of a model the closures that an analysis has found; a cut without an entry is
/// not tightened.
pub fn close_cuts(model: &mut AnalysisModel, found: &[PreloadedBolt]) {
    for cut in &mut model.preload {
        cut.closure = of_cut(found, cut).map(|bolt| bolt.closure);
    }
}

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
