//! What `run`, `analyse` and `check` share: context, cases, and how a run ends.

pub mod adaptive;
pub mod analysis_pass;
pub mod aside;
pub mod case;
pub mod conclude;
pub mod interrupt;
pub mod memory_limit;
pub mod polygon;
pub mod remesh;
