//! Solids → a CAD script for the mesher, exact volumes and contact areas, and checks of clashes and
//! clearances.

mod boxes;
pub mod error;
pub mod exact;
#[cfg(test)]
pub(crate) mod fixtures;
pub mod flat;
pub mod footprint;
pub mod geo_script;
pub mod hinges;
pub mod line;
pub mod proximity;
mod pulled;
pub mod scene;
mod shank;
pub mod size;
pub mod validate;

pub use flat::{FlatPrism, FlatSolid};
pub use scene::Scene;
