//! The analysis model and the two programs made from it.

pub mod analysis;
pub mod file;
pub mod from_joint;
pub mod program;

pub use analysis::AnalysisModel;
pub use program::ConicProgram;
