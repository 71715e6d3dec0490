//! What the report says of preloaded bolts.

use super::figures::{Rounding, significant};
use super::text::inline;
use crate::adapt::preload::Tightened;

/// What a preloaded bolt carries.
pub(super) fn preload_words(bolt: &Tightened) -> String {
    let kilonewtons = |f: f64| format!("{} kN", significant(f / 1e3, 4, Rounding::Nearest));
    let loaded = bolt.tension.map_or(String::new(), |t| {
        format!("; under the loads the stress of the lower bound carries {} there (an estimate)", kilonewtons(t))
    });
    format!(
        "Bolt {}: the preload of {} closes the cut {} by {} mm, the same for both programs{loaded}.",
        inline(&bolt.body),
        kilonewtons(bolt.force),
        inline(&bolt.cut),
        significant(bolt.closure, 6, Rounding::Nearest)
    )
}
