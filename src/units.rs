//! Units at the border: one internal system (mm, N, MPa, N mm, rad) and the reading of numbers with
//! suffixes.
//!
//! A bare number is a length in mm wherever a length is expected. Forces, moments and stresses must
//! carry a suffix: a moment entered in the wrong unit is the costliest typing error there is.

mod dim;
mod parse;
mod typed;

pub use dim::{Dim, Quantity, unit};
pub use parse::{Kind, UnitError, bare, parse, with_point};
pub use typed::{Force, INVALID_QUANTITY, Length, Moment, Seconds, Stress};

#[cfg(test)]
mod tests;
