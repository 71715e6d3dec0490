//! The parts that `run`, `analyse`, `check` and `study` share. A run has three steps with one
//! struct between them: `solve` gives [`solved::Solved`], [`judge`] makes [`judge::Judged`] of it,
//! and `present` writes the folder.

pub mod adaptive;
pub mod analyse_model;
pub mod by_metric;
pub mod case;
pub mod case_files;
pub mod check_spec;
pub mod collapse_pictures;
pub mod context;
pub mod demands;
pub mod input_hash;
pub mod interrupt;
pub mod judge;
pub mod limits;
pub mod load_steps;
pub mod memory_limit;
pub mod meshing;
pub mod overrides;
pub mod pass_entry;
pub mod pass_run;
pub mod passes;
pub mod pictures;
pub mod polygon;
pub mod present;
pub mod printing;
pub mod queue;
pub mod remesh;
pub mod run_files;
pub mod run_spec;
pub mod scene;
pub mod sequence;
pub mod setup;
pub mod solve;
pub mod solved;
pub mod spec_cases;
pub mod spec_checks;
pub mod spec_context;
pub mod spec_file;
pub mod spec_input;
pub mod spec_run;
pub mod study;
mod verify_cases;
pub mod verify_folder;
mod verify_mesh;
mod verify_model;
mod verify_spec;
