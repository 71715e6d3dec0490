//! From the unknowns of a solved program to admissible fields.

pub mod draw_inside;
pub mod elastic;
pub mod force_sets;
pub mod free_mechanism;
pub mod interface_balance;
pub mod limit_lower;
pub mod limit_upper;
pub mod load_tractions;
pub mod moving_parts;
pub mod plastic;
pub mod restore_equilibrium;
pub mod unlimited;
pub mod unloaded_contacts;
