//! Category of the bolts and limit states of the load cases: what of a spec must agree.

use super::error::AssemblyError;
use crate::spec::connection::{BoltCategory, ConnectionSpec, PreloadSpec};

/// Categories that are preloaded without a preload; load cases of two limit states.
pub(super) fn check(spec: &ConnectionSpec, faults: &mut Vec<AssemblyError>) {
    if let Some(b) = &spec.bolts {
        let preloaded = b.preload.is_some_and(|p| p != PreloadSpec::None);
        let asks = matches!(b.category, Some(BoltCategory::B | BoltCategory::C | BoltCategory::E));
        if asks && !preloaded {
            faults.push(AssemblyError::Value {
                path: "bolts.category".into(),
                problem: "bolts of categories B, C and E are preloaded (EN 1993-1-8:2005 Table \
                          3.2), these have no `preload`"
                    .into(),
                help: "add `preload: 0.7` to `bolts`, or take category A or D".into(),
            });
        }
    }
    for (i, load) in spec.loads.iter().enumerate() {
        let Some(first) = spec.loads[..i].iter().find(|o| o.name == load.name) else { continue };
        if first.state != load.state {
            faults.push(AssemblyError::Value {
                path: format!("{}.state", load.path(i)),
                problem: format!("the loads of load case `{}` are of two limit states", load.name),
                help: "give all of them the same `state`, or this one another name".into(),
            });
        }
    }
}
