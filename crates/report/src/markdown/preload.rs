//! The sentences on preloaded bolts.

use crate::figures::{Rounding, significant};
use crate::markdown::markup::inline;
use bracket_engine::analysis::preloaded_bolt::PreloadedBolt;

/// Preload, closure and tension of a preloaded bolt.
pub(crate) fn preload_words(bolt: &PreloadedBolt) -> String {
    let kilonewtons = |f: f64| format!("{} kN", significant(f / 1e3, 4, Rounding::Nearest));
    let loaded = bolt.tension.map_or(String::new(), |t| {
        format!(
            "; under the loads the stress of the lower bound gives a tension of {} there (an \
             estimate)",
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
