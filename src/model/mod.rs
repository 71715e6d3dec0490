//! The analysis model: the common form of a connection spec and a MODEL.yaml.

pub mod analysis;
pub mod contact;
pub mod error;
pub mod file;
pub mod from_joint;
pub mod loads;
pub mod opening;
pub mod resolve;

pub use analysis::AnalysisModel;
pub use error::ModelError;
