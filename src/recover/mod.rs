//! From the unknowns of a solved program to admissible fields.

pub mod elastic;
pub mod free_mechanism;
pub mod limit_lower;
pub mod limit_upper;
pub mod plastic;
pub mod restore_equilibrium;
pub mod unlimited;
