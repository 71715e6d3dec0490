//! Solvers of conic programs and of linear systems.

pub mod allocator;
pub mod clarabel;
pub mod condensed;
pub mod feasibility;
pub mod forecast;
pub mod prepare;
pub mod scales;
pub mod sparse;
pub mod status;
pub mod stop_rules;

pub use forecast::{Forecast, Yardstick};
pub use prepare::{Prepared, prepare, solve};
pub use sparse::Patterns;
pub use status::{Iteration, Solution, SolveOptions, SolveStatus, Solver};
pub use stop_rules::StopRules;
