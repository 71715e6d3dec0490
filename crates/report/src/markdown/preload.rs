//! The sentences on preloaded bolts.

use crate::figures::{Rounding, significant};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::analysis::preloaded_bolt::PreloadedBolt;

/// Preload, closure and tension of a preloaded bolt.
pub(crate) fn preload_words(bolt: &PreloadedBolt) -> Text {
    let kilonewtons = |f: f64| format!("{} kN", significant(f / 1e3, 4, Rounding::Nearest));
    let loaded = bolt.tension.map_or_else(Text::default, |t| {
        say!(
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
    say!(
        "Bolt {}: the preload of {}{} closes the cut {} by {} mm, the same for both programs{}.",
        &bolt.body,
        kilonewtons(bolt.force),
        halved,
        &bolt.cut,
        significant(bolt.closure, 6, Rounding::Nearest),
        loaded
    )
}
