//! Reasons why a hand check cannot be made.

/// A quantity for which the formulas have no meaning, or a joint that the tables of the code do not
/// cover.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CheckError {
    /// A quantity outside the range for which the formulas have a meaning.
    #[error("{quantity} is {value}; {limit}")]
    OutOfRange {
        /// The quantity, with its unit.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// The allowed range.
        limit: &'static str,
    },
    /// The tables of the code do not cover this joint.
    #[error("{what} ({clause})")]
    NotCovered {
        /// The property that is not covered.
        what: String,
        /// The clause whose limits are exceeded.
        clause: &'static str,
        /// What would bring the joint inside.
        step: &'static str,
    },
}

impl CheckError {
    /// What would make the check possible.
    pub fn step(&self) -> &'static str {
        match self {
            CheckError::OutOfRange { .. } => "a value inside this range",
            CheckError::NotCovered { step, .. } => step,
        }
    }
}

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
