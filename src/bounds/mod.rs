//! Fields, their certificates, and the bracket they prove.

pub mod fields;
pub mod recover;

pub use fields::{DisplacementField, StressField};
