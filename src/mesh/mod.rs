//! From a mesher's file to a mesh whose interfaces match triangle to triangle.

pub mod bisect;
pub mod error;
#[cfg(test)]
pub(crate) mod fixtures;
pub mod gmsh;
pub mod joint;
pub mod merge;
pub mod msh;
pub mod msh_write;
pub mod naming;
pub mod numbering;
pub mod quality;
pub mod size_field;
pub mod split;
pub mod tet;
pub mod topology;

pub use error::MeshError;
pub use tet::{NamedFaces, TetMesh};
