//! The load cases that are demands on the joint.

use bracket_joint::spec::loads::{Action, LoadSpec};
use bracket_report::markdown::report_data::GivenActions;
use bracket_report::result::demand::{ActionValue, EndAction};

/// The demands among the loads of a spec, in the order of the loads. Each has at least one force or
/// moment at a member end; the directions of a polygon are not demands.
pub fn demands(loads: &[LoadSpec]) -> Vec<GivenActions> {
    let mut out: Vec<GivenActions> = Vec::new();
    for load in loads.iter().filter(|l| !l.of_polygon) {
        let actions = end_actions(load);
        match out.iter_mut().find(|d| d.case == load.name) {
            _ if actions.is_empty() => {}
            Some(demand) => demand.actions.extend(actions),
            None => out.push(GivenActions { case: load.name.clone(), actions }),
        }
    }
    out
}

/// The forces and moments of a load at a member end.
fn end_actions(load: &LoadSpec) -> Vec<EndAction> {
    let (Some(end), Some(at)) = (&load.end, load.at) else { return Vec::new() };
    let of = |(action, value): (Action, f64)| EndAction {
        end: end.clone(),
        at: at.word().into(),
        action: action.word().into(),
        value: ActionValue::of(action, value),
        factored: load.multiplies(action),
    };
    load.actions().into_iter().map(of).collect()
}
