//! What the report says of preloaded bolts and of the fixed point for Coulomb's law.

use super::figures::{Rounding, percent_up, significant};
use super::text::inline;
use crate::adapt::coulomb::FixedPointRun;
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

/// How near the problem of the bracket is to Coulomb's law.
pub(super) fn fixed_point_words(run: &FixedPointRun) -> String {
    let problems = if run.solves == 1 { "one problem".into() } else { format!("{} problems", run.solves) };
    let contraction = match run.contraction {
        Some(c) => format!("; a plain step leaves {} of the error", percent_up(c)),
        None => String::new(),
    };
    format!(
        "Coulomb's law was reached through {problems}; the last changed the slips by at most {} of the largest{contraction}. The \
         bracket is strict for that last problem.",
        percent_up(run.change)
    )
}
