//! The condensed interior-point method: only unknowns that elements share reach the sparse factor.
//!
//! Slacks and multipliers of the cones are eliminated cone by cone, and elements that yield one by
//! one. Every iteration factors the rest of `P + Gᵀ W⁻² G`, whose pattern is fixed, under one
//! nested-dissection ordering.

pub mod cones;
pub mod correction;
pub mod elements;
pub mod elimination;
pub mod ipm;
pub mod newton;
pub mod panel;
pub mod point;
pub mod prepared;
pub mod residuals;
pub mod scaled_program;
pub mod settings;
pub mod start;
pub mod static_condensation;
pub mod system;
pub mod targets;
#[cfg(test)]
mod tests;
pub mod vectors;
pub mod yield_points;

pub use prepared::Prepared;
