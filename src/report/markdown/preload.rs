//! What the report says of preloaded bolts.

use crate::analysis::preloaded_bolt::PreloadedBolt;
use crate::model::AnalysisModel;
use crate::report::figures::{Rounding, significant};
use crate::report::markdown::text::inline;
use crate::result::forces::ON_PLANE;

/// Marks the bolts that a plane of symmetry halves; `mirror`: axes of these planes, through the
/// origin.
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

/// What a preloaded bolt carries.
pub(crate) fn preload_words(bolt: &PreloadedBolt) -> String {
    let kilonewtons = |f: f64| format!("{} kN", significant(f / 1e3, 4, Rounding::Nearest));
    let loaded = bolt.tension.map_or(String::new(), |t| {
        format!(
            "; under the loads the stress of the lower bound carries {} there (an estimate)",
            kilonewtons(t)
        )
    });
    let halved = if bolt.halved {
        " in the half that is meshed (a plane of symmetry halves the bolt)"
    } else {
        ""
    };
    format!(
        "Bolt {}: the preload of {}{halved} closes the cut {} by {} mm, the same for both \
         programs{loaded}.",
        inline(&bolt.body),
        kilonewtons(bolt.force),
        inline(&bolt.cut),
        significant(bolt.closure, 6, Rounding::Nearest)
    )
}
