//! The mesh of a joint: gmsh meshes its solids, and the faces that the model needs get names.

pub mod joint;
pub mod naming;

#[cfg(test)]
mod remeshed_tests;
