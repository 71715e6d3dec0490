//! Passes of dual analysis over meshes.

pub mod pass;
