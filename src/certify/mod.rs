//! Fields, their certificates, and the brackets they prove.
//!
//! Nothing here knows how a field was found: this room imports neither `solve` nor `programs`.

pub mod bracket;
pub mod certificate;
pub mod dissipation;
pub mod error;
pub mod faces;
pub mod factor;
pub mod fields;
pub mod flow;
pub mod limit_certificate;
pub mod plastic_certificate;
pub mod plastic_field;
pub mod resultants;
pub mod sampling;
pub mod slip;
pub mod supporting;
pub mod welds;

pub use bracket::{Bracket, LowerBound, UpperBound};
pub use factor::{FactorBracket, LowerFactor, UpperFactor};
pub use fields::{DisplacementField, StressField};
pub use flow::VelocityField;
pub use plastic_field::PlasticField;
