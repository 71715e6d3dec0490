//! Errors of a buckling analysis.

use crate::model::ModelError;
use crate::solve::sparse::LinearError;
use bracket_base::words::Text;
use bracket_base::{display_text, say};

/// Reason why no critical load factor was found.
#[derive(Clone, Debug)]
pub enum BucklingError {
    /// The unknowns of the model could not be numbered.
    Model(ModelError),
    /// A field does not belong to the mesh of the model.
    Size {
        /// Displacement or stress.
        field: &'static str,
        /// Length of the field.
        found: usize,
        /// Length that fits the mesh.
        needed: usize,
    },
    /// A field has a value that is not finite.
    NotFinite(&'static str),
    /// The elastic stiffness cannot be factored.
    Stiffness(LinearError),
    /// The iteration ended before the lowest factor was found.
    NoConvergence {
        /// Steps of the iteration.
        steps: usize,
        /// Smallest relative residual.
        residual: f64,
    },
    /// Below the lowest factor found the structure is not stable: a mode was missed.
    Missed(f64),
}

impl BucklingError {
    /// The reason in words.
    pub fn text(&self) -> Text {
        match self {
            BucklingError::Model(e) => e.text(),
            BucklingError::Size { field, found, needed } => {
                say!("the field of {} has {} values, the mesh needs {}", *field, *found, *needed)
            }
            BucklingError::NotFinite(field) => {
                say!("the field of {} has values that are not finite", *field)
            }
            BucklingError::Stiffness(e) => e.text(),
            BucklingError::NoConvergence { steps, residual } => say!(
                "no critical load factor converged in {} steps; the best residual is {}",
                *steps,
                format!("{residual:.1e}")
            ),
            BucklingError::Missed(factor) => say!(
                "the structure buckles below the load factor {}, but no mode was found there",
                format!("{factor:.4}")
            ),
        }
    }
}

display_text!(BucklingError);

impl std::error::Error for BucklingError {}

impl From<ModelError> for BucklingError {
    fn from(e: ModelError) -> Self {
        BucklingError::Model(e)
    }
}
