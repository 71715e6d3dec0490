//! One symmetric positive definite sparse system: ordered once, factored as often as its values
//! change.

pub mod blocks;
pub mod cholesky;
pub mod dense;
pub mod error;
pub mod factor;
pub mod layout;
pub mod locator;
pub mod ordering;
pub mod pattern;
pub mod patterns;
pub mod plan;
pub mod substitution;
pub mod symbolic;
#[cfg(test)]
mod tests;

pub use cholesky::{SparseCholesky, solve_refined};
pub use error::LinearError;
pub use locator::Locator;
pub use patterns::Patterns;
