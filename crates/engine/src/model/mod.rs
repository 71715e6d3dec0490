//! The analysis model: the common form of a connection spec and a MODEL.yaml.

pub mod analysis;
pub mod analysis_kind;
pub mod contact;
pub mod error;
pub mod file;
pub mod friction_law;
pub mod limit_motions;
pub mod loads;
pub mod opening;
pub mod resolve;
pub mod resultant_limit;
pub mod welded;

pub use analysis::AnalysisModel;
pub use analysis_kind::AnalysisKind;
pub use error::ModelError;
pub use friction_law::FrictionLaw;
