//! The finite elements, one in each file, with their geometry and data layout beside them.
//!
//! The kinematic program uses 10-node tetrahedra, the static program super-elements of four subtets
//! with linear stress. Each has an elastic form and a form with von Mises cones.

pub mod columns;
#[cfg(test)]
pub(crate) mod fixtures;
pub mod flow_maps;
pub mod geometric_stiffness;
pub mod geometry;
pub mod hencky_kinematic;
pub mod hencky_static;
pub mod packed_elements;
pub mod space;
pub mod split_flow;
pub mod split_tet10;
pub mod stress_basis;
pub mod stress_maps;
pub mod super_element;
pub mod tet10;
pub mod yielding_element;
