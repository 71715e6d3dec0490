//! What runs on one mesh: both programs, of each kind of analysis.

pub mod coulomb;
pub mod coulomb_limit;
pub mod diagnosis;
pub mod engine;
pub mod fixed_point;
pub mod hencky;
pub mod limit;
pub mod memory;
pub mod preload;
pub mod program_run;
