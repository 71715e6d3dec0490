//! Why a hand check cannot be made.

use crate::diag::Diagnostic;

/// A quantity the formulas have no meaning for, or a joint the code's tables do not cover.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CheckError {
    /// A quantity outside the range in which the formulas mean something.
    #[error("{quantity} is {value}; {limit}")]
    OutOfRange {
        /// What, with its unit.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        limit: &'static str,
    },
    /// The tables of the code have no row for this joint.
    #[error("{what} ({clause})")]
    NotCovered {
        /// What is not covered.
        what: String,
        /// The clause whose limits are left.
        clause: &'static str,
    },
}

impl From<CheckError> for Diagnostic {
    fn from(e: CheckError) -> Self {
        let text = e.to_string();
        match e {
            CheckError::OutOfRange { .. } => Diagnostic::input("checks/range", text)
                .help("correct the quantity; lengths are in mm, strengths in MPa"),
            CheckError::NotCovered { .. } => Diagnostic::input("checks/not-covered", text)
                .help("the analysis covers this joint, the hand checks of the code do not"),
        }
    }
}

/// Refuses what is not a positive number.
pub fn positive(quantity: &'static str, value: f64) -> Result<(), CheckError> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(CheckError::OutOfRange { quantity, value, limit: "it must be above 0" })
    }
}

/// Refuses what is negative or no number.
pub fn not_negative(quantity: &'static str, value: f64) -> Result<(), CheckError> {
    if value.is_finite() && value >= 0.0 {
        Ok(())
    } else {
        Err(CheckError::OutOfRange { quantity, value, limit: "it must be 0 or more" })
    }
}
