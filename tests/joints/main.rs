//! Joints from their specs: invariance of the bounds, verdicts of a bolted joint, T-stubs from
//! their template.
#![allow(clippy::unwrap_used)]

#[path = "../common/bench.rs"]
mod bench;
mod bolt_forces;
mod bolted_families;
mod built;
mod column_base;
mod component_method;
mod files;
mod haunched_eaves;
mod invariance;
mod load_steps;
#[path = "../common/numbers.rs"]
mod numbers;
mod preload;
mod profiles;
mod public_cases;
mod route_pictures;
mod stiffness;
mod suggested_values;
mod t_stubs_by_template;
mod turned_solids;
mod verdict_by_code;
mod verdicts;
mod welds;
