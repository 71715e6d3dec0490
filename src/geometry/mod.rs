//! Solids → a CAD script for the mesher, exact volumes and contact areas, clash and clearance checks.

pub mod exact;
pub mod flat;
pub mod line;
pub mod scene;

pub use flat::{FlatPrism, FlatSolid};
pub use scene::Scene;
