//! Fields, their certificates, and the brackets they prove.
//!
//! Nothing here knows how a field was found: this room imports neither `solve` nor `programs`.

pub mod bracket;
pub mod certificate;
pub mod contributions;
pub mod dissipation;
pub mod faces;
pub mod factor;
pub mod fields;
pub mod flow;
pub mod free_mechanism;
pub mod limit_certificate;
pub mod measures;
pub mod plastic_certificate;
pub mod plastic_field;
pub mod resultants;
pub mod rigid_fit;
pub mod sampling;
pub mod slip;
pub mod supporting;
pub mod tolerance;
pub mod tractions;
pub mod unlimited;
pub mod welds;

pub use bracket::{Bracket, LowerBound, UpperBound};
pub use factor::{FactorBracket, LowerFactor, UpperFactor};
pub use fields::{DisplacementField, StressField};
pub use flow::VelocityField;
pub use plastic_field::PlasticField;
pub use tolerance::TOLERANCE;
