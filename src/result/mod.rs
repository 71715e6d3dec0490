//! The typed result of a run and the files that hold it.

pub mod case;
pub mod combine;
pub mod data;
pub mod demand;
pub mod derived;
pub mod fields;
pub mod file_names;
pub mod folder;
pub mod forces;
pub mod history;
pub mod limit_case;
pub mod polygon;
pub mod stiffness;
pub mod verify;
