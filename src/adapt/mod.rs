//! Passes of dual analysis over meshes.

pub mod limit;
pub mod memory;
pub mod pass;
pub mod problem;
pub mod words;
