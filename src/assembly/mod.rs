//! Spec + template + catalogue → parts, interfaces, supports, loads, symmetry.

pub mod actions;
#[allow(clippy::module_inception)] // a file is named for its noun, and this one holds `Assembly`
pub mod assembly;
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
pub use assembly::Assembly;
pub use end_plate::{ColumnSide, EndPlate};
pub use error::AssemblyError;
pub use joint::{BoltLine, Joint, build};

#[cfg(test)]
mod bad_specs;
#[cfg(test)]
mod tests;
