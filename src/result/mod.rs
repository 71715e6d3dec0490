//! The typed result of a run and the files that hold it.

pub mod bounds;
pub mod case;
pub mod certificate;
pub mod combine;
pub mod data;
pub mod demand;
pub mod entry;
pub mod fields;
pub mod file_names;
#[cfg(test)]
pub(crate) mod fixtures;
pub mod folder;
pub mod forces;
pub mod history;
pub mod limit_case;
pub mod polygon;
pub mod preload;
pub mod quantity;
pub mod refusal;
pub mod stiffness;
pub mod study;
pub mod verify;
