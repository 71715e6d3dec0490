//! Fields, their certificates, and the bracket they prove.

pub mod bracket;
pub mod certificate;
pub mod error;
pub mod faces;
pub mod fields;
pub mod recover;
pub mod sampling;

pub use bracket::{Bracket, LowerBound, UpperBound};
pub use fields::{DisplacementField, StressField};
