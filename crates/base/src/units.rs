//! Units of input and output. The program computes in one internal system (mm, N, MPa, N mm, rad)
//! and reads numbers with unit suffixes.
//!
//! A bare number is a length in mm wherever a length is expected. Forces, moments and stresses must
//! have a suffix, because a moment in the wrong unit is the costliest typing error.

mod dim;
pub mod limits;
mod parse;
mod typed;

pub use dim::{Dim, Quantity, unit};
pub use parse::{Kind, UnitError, bare, parse, plain_minus, with_point};
pub use typed::{Force, INVALID_QUANTITY, Length, Moment, Seconds, Stress};

#[cfg(test)]
mod tests;
