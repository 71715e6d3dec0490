//! From a mesher's file to a mesh whose interfaces match triangle to triangle.

pub mod tet;

pub use tet::{NamedFaces, TetMesh};
pub mod gmsh;
