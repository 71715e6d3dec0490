//! Solvers of conic programs and of linear systems.

pub mod clarabel;
pub mod collapse;
pub mod linear;
pub mod ordering;
pub mod status;

pub use status::{Solution, SolveOptions, SolveStatus};
