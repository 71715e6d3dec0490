//! The two conic programs of an analysis model, as plain data.
//!
//! [`kinematic`] and [`static_form`] build them. The other files are their parts: unknowns
//! ([`dofs`], [`rigid_motions`], [`cuts`], [`free_modes`]), [`loads`], [`contact`] cones, welds
//! ([`weld_face`]), slip on held faces ([`slip_face`]) and elements that yield
//! ([`yielding_elements`]). [`elastic_unknowns`] has the unknowns of the kinematic program
//! without its cones.

pub mod assemble;
pub mod conic;
pub mod constraints;
pub mod contact;
pub mod contact_modes;
pub mod cuts;
pub mod dofs;
pub mod elastic_unknowns;
pub mod explicit;
pub mod free_modes;
pub mod kinematic;
pub mod loads;
pub mod rigid_motions;
pub mod slip_face;
pub mod static_form;
mod static_mechanism;
pub mod super_elements;
pub mod symmetric_sum;
pub mod tied_points;
pub mod weld_face;
pub mod yielding_elements;

pub use conic::ConicProgram;
pub use kinematic::Kinematic;
pub use static_form::Static;
