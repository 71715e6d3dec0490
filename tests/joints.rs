//! Joints from their specs: invariance of the bounds, verdicts of a bolted joint, T-stubs from
//! their template.
#![allow(clippy::unwrap_used)]

#[path = "cli/bench.rs"]
mod bench;
#[path = "joints/bolt_forces.rs"]
mod bolt_forces;
#[path = "joints/built.rs"]
mod built;
#[path = "joints/invariance.rs"]
mod invariance;
#[path = "joints/preload.rs"]
mod preload;
#[path = "joints/stiffness.rs"]
mod stiffness;
#[path = "joints/suggested_values.rs"]
mod suggested_values;
#[path = "joints/t_stubs_by_template.rs"]
mod t_stubs_by_template;
#[path = "joints/verdicts.rs"]
mod verdicts;
#[path = "joints/welds.rs"]
mod welds;
