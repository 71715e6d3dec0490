//! The two conic programs of an analysis model, as plain data.

pub mod assemble;
pub mod conic;
pub mod constraints;
pub mod contact_modes;
pub mod cuts;
pub mod dofs;
pub mod explicit;
pub mod kinematic;
pub mod rigid_motions;
pub mod static_form;
pub mod weld_face;
pub mod yielding_elements;

pub use conic::ConicProgram;
pub use kinematic::Kinematic;
pub use static_form::Static;
