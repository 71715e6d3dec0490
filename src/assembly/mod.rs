//! Spec + template + catalogue → parts, interfaces, supports, loads, symmetry.

pub mod actions;
pub mod build;
mod categories;
pub mod end_plate;
pub mod error;
pub mod factors;
pub mod inputs;
pub mod joint;
pub mod origin;
pub mod part;
pub mod scope;
mod seen_bolts;
pub mod symmetry;
pub mod template;

pub use actions::PlaneActions;
pub use build::{BoltLine, Joint, build};
pub use end_plate::{ColumnSide, EndPlate};
pub use error::AssemblyError;
pub use joint::Assembly;

#[cfg(test)]
mod bad_specs;
#[cfg(test)]
mod tests;
