//! The analysis model and the two programs made from it.

pub mod analysis;
pub mod file;
pub mod program;
pub mod resolve;

pub use analysis::AnalysisModel;
pub use program::ConicProgram;
