//! Fields, their certificates, and the brackets they prove.
//!
//! Nothing here knows how a field was found: this room imports neither `solve` nor `programs`.

pub mod bracket;
pub mod certificate;
pub mod combination;
pub mod contributions;
pub mod coulomb_shift;
pub mod crushing;
pub mod cut_limits;
pub mod dissipation;
pub mod elastic_ground;
pub mod faces;
pub mod fields;
pub mod free_mechanism;
pub mod half_space;
pub mod limit_certificate;
pub mod load_factor;
pub mod measures;
pub mod plastic_certificate;
pub mod plastic_field;
pub mod resultants;
pub mod rigid_fit;
pub mod sampling;
pub mod slip;
pub mod ties;
pub mod tolerance;
pub mod tractions;
pub mod unlimited;
pub mod velocity_field;
pub mod welds;

pub use bracket::{Bracket, LowerBound, UpperBound};
pub use fields::{DisplacementField, StressField};
pub use load_factor::{FactorBracket, LowerFactor, UpperFactor};
pub use plastic_field::PlasticField;
pub use tolerance::TOLERANCE;
pub use velocity_field::VelocityField;
