//! Passes of dual analysis over meshes.

pub mod coulomb;
pub mod fixed_point;
pub mod limit;
pub mod memory;
pub mod pass;
pub mod problem;
pub mod words;
