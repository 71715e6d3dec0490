//! Wrong inputs and machines, with the compiled program. Each run ends with the exit code for the
//! kind of error and one message that names place and cure. It leaves the folder unchanged.

mod wrong_machine;
mod wrong_models;
mod wrong_specs;
