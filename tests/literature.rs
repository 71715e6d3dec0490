//! Cases with known answers, named after their source.
#![allow(clippy::unwrap_used)]

mod common;
#[path = "literature/paper_reference_meshes.rs"]
mod paper_reference_meshes;
