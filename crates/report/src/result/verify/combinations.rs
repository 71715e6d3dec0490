//! Recomputation of the bounds of load cases without an analysis of their own, from the analyses
//! whose fields are stored.

use super::derived::{Proved, Reference, same_bound};
use super::differences::derived_differences;
use crate::result::case_result::CaseResult;
use crate::result::derived_bounds::{Run, derived_case};
use bracket_engine::certify::half_space::{HalfSpace, live_actions};

/// What the proved cases prove of other load cases.
pub fn runs(proved: &[Proved]) -> Vec<Run> {
    let run = |p: &Proved| {
        let mechanism = p.mechanism.as_ref();
        Run {
            entry: p.entry.clone(),
            actions: live_actions(&p.model),
            half_space: mechanism.and_then(|(v, bound)| HalfSpace::new(&p.model, v, bound)),
        }
    };
    proved.iter().map(run).collect()
}

/// The first difference of a load case whose bounds come from `runs`. Without the input nothing is
/// known of its actions.
pub fn proof_difference(
    claimed: &CaseResult,
    runs: &[Run],
    reference: Option<&Reference>,
) -> Option<String> {
    let Reference { actions, .. } = reference?;
    let name = &claimed.name;
    let Some((_, actions)) = actions.iter().find(|(case, _)| case == name) else {
        return Some(format!("{name}: the input gives no actions of this load case"));
    };
    let proved_by = claimed.proved_by.clone()?;
    let Some(found) = derived_case(name, actions, proved_by, runs) else {
        return Some(format!("{name}: the analyses that `proved_by` names prove no such bounds"));
    };
    let upper = |c: &CaseResult| c.upper.and_then(|u| u.finite());
    if !same_bound(claimed.lower, found.lower) || !same_bound(upper(claimed), upper(&found)) {
        return Some(format!("{name}: its bounds are not those that `proved_by` proves"));
    }
    derived_differences(claimed, &found).into_iter().next()
}
