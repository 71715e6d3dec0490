//! Steel joints as data: a spec, catalogues and a template become parts, solids, a mesh with named
//! faces, and the model that the engine analyses.
//!
//! Units everywhere: mm, N, MPa, N mm, rad.

pub mod assembly;
pub mod catalog;
pub mod forces;
pub mod geometry;
pub mod meshing;
pub mod model_file;
pub mod spec;
pub mod strength;
