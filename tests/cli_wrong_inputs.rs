//! Wrong inputs and machines, with the compiled program. Each run ends with the exit code for the
//! kind of error and one message that names place and cure. It leaves the folder unchanged.

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
