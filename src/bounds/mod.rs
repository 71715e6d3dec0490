//! Fields, their certificates, and the brackets they prove.

pub mod bracket;
pub mod certificate;
pub mod dissipation;
pub mod error;
pub mod faces;
pub mod factor;
pub mod fields;
pub mod flow;
pub mod free_mechanism;
pub mod limit_certificate;
pub mod limit_lower;
pub mod limit_upper;
pub mod plastic_certificate;
pub mod plastic_field;
pub mod plastic_recover;
pub mod recover;
pub mod resultants;
pub mod sampling;
mod settle;
pub mod slip;
pub mod supporting;
pub mod unlimited;
pub mod welds;

pub use bracket::{Bracket, LowerBound, UpperBound};
pub use factor::{FactorBracket, LowerFactor, UpperFactor};
pub use fields::{DisplacementField, StressField};
pub use flow::VelocityField;
pub use plastic_field::PlasticField;
