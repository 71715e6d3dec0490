//! Reasons why a hand check cannot be made.

use bracket_base::display_text;
use bracket_base::say;
use bracket_base::words::Text;

/// A quantity for which the formulas have no meaning, or a joint that the tables of the code do not
/// cover.
#[derive(Clone, Debug, PartialEq)]
pub enum CheckError {
    /// A quantity outside the range for which the formulas have a meaning.
    OutOfRange {
        /// The quantity, with its unit.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// The allowed range.
        limit: &'static str,
    },
    /// The tables of the code do not cover this joint.
    NotCovered {
        /// The property that is not covered.
        what: Text,
        /// The clause whose limits are exceeded.
        clause: &'static str,
        /// What would bring the joint inside.
        step: &'static str,
    },
}

impl CheckError {
    /// The reason as a report prints it.
    pub fn text(&self) -> Text {
        match self {
            CheckError::OutOfRange { quantity, value, limit } => {
                say!("{} is {}; {}", *quantity, value.to_string(), *limit)
            }
            CheckError::NotCovered { what, clause, .. } => say!("{} ({})", what, *clause),
        }
    }

    /// What would make the check possible.
    pub fn step(&self) -> &'static str {
        match self {
            CheckError::OutOfRange { .. } => "a value inside this range",
            CheckError::NotCovered { step, .. } => step,
        }
    }
}

display_text!(CheckError);

impl std::error::Error for CheckError {}

/// Refuses a value that is not positive and finite.
pub fn positive(quantity: &'static str, value: f64) -> Result<(), CheckError> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(CheckError::OutOfRange { quantity, value, limit: "it must be above 0" })
    }
}

/// Refuses a value that is negative, infinite or NaN.
pub fn not_negative(quantity: &'static str, value: f64) -> Result<(), CheckError> {
    if value.is_finite() && value >= 0.0 {
        Ok(())
    } else {
        Err(CheckError::OutOfRange { quantity, value, limit: "it must be 0 or more" })
    }
}
