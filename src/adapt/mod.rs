//! Passes of dual analysis over meshes, and which mesh comes next.

pub mod coulomb;
pub mod coulomb_limit;
pub mod fixed_point;
pub mod limit;
pub mod memory;
pub mod optimum;
pub mod pass;
pub mod plan;
pub mod plastic;
pub mod preload;
pub mod problem;
pub mod rates;
pub mod words;
