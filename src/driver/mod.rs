//! The parts that `run`, `analyse`, `check` and `study` share: context, cases, and the end of a
//! run.

pub mod adaptive;
pub mod analyse_model;
pub mod by_metric;
pub mod case;
pub mod case_files;
pub mod check_spec;
pub mod collapse_pictures;
pub mod context;
pub mod demands;
pub mod finish;
pub mod input_hash;
pub mod interrupt;
pub mod limits;
pub mod memory_limit;
pub mod meshing;
pub mod pass_entry;
pub mod pass_run;
pub mod passes;
pub mod pictures;
pub mod polygon;
pub mod queue;
pub mod remesh;
pub mod run_cases;
pub mod run_spec;
pub mod scene;
pub mod sequence;
pub mod spec_cases;
pub mod spec_checks;
pub mod spec_context;
pub mod spec_file;
pub mod study;
mod verify_cases;
pub mod verify_folder;
mod verify_mesh;
mod verify_model;
mod verify_spec;
