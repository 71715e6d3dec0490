//! Inputs and machines that are wrong, through the real program: each ends with the exit code of
//! its kind and one message that names place and cure, and leaves the folder as it was.

#[path = "cli/bench.rs"]
mod bench;
#[path = "common/mod.rs"]
mod common;
#[path = "cli/wrong_machine.rs"]
mod wrong_machine;
#[path = "cli/wrong_models.rs"]
mod wrong_models;
#[path = "cli/wrong_specs.rs"]
mod wrong_specs;
