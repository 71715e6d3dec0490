//! The analysis model and the two programs made from it.

pub mod analysis;
pub mod assemble;
pub mod batch;
pub mod contact_modes;
pub mod cuts;
pub mod dofs;
pub mod explicit;
pub mod file;
pub mod flowing_tet10;
pub mod from_joint;
pub mod holds;
pub mod kinematic;
pub mod loads;
pub mod opening;
pub mod program;
pub mod resolve;
pub mod rigid_motions;
pub mod split_flow;
pub mod split_tet10;
pub mod static_form;
pub mod stress_basis;
pub mod super_element;
pub mod tet10;
pub mod weld_face;
pub mod yielding_elements;
pub mod yielding_super_element;

pub use analysis::AnalysisModel;
pub use kinematic::{Flow, Kinematic};
pub use program::ConicProgram;
pub use static_form::Static;
