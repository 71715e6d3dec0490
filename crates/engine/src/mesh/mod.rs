//! Tetrahedral meshes: the mesher gmsh, the remesher Mmg, their files, and meshes whose interfaces
//! match triangle by triangle.

pub mod bisect;
pub mod error;
#[cfg(test)]
pub(crate) mod fixtures;
pub mod gmsh;
pub mod medit;
pub mod mend;
pub mod merge;
pub mod mesher_command;
pub mod mesher_error;
pub mod mmg;
pub mod msh;
pub mod msh_write;
pub mod nearest;
pub mod numbering;
pub mod orient;
pub mod polyhedron;
mod process;
pub mod quality;
pub mod restore;
pub mod shape;
pub mod size_field;
pub mod split;
pub mod tet;
pub mod topology;

pub use error::MeshError;
pub use tet::{NamedFaces, TetMesh};
