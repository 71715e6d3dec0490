//! The typed result of a run and its files.

pub mod bounds;
pub mod buckled;
pub mod case_result;
pub mod certificate;
pub mod combine;
pub mod demand;
pub mod derived_bounds;
pub mod digests;
pub mod energy_case;
pub mod evidence;
pub mod face_motion;
pub mod fields;
pub mod file_names;
#[cfg(test)]
pub(crate) mod fixtures;
pub mod folder;
pub mod folder_error;
pub mod forces;
pub mod history;
pub mod interface_use;
pub mod judged_case;
pub mod limit_case;
pub mod load_step;
pub mod polygon;
pub mod preload;
pub mod proved_by;
pub mod quantity;
pub mod refusal;
pub mod result_file;
pub mod step_bounds;
pub mod stiffness;
pub mod study;
pub mod verify;
mod weld_bands;
