//! Errors of a buckling analysis.

use crate::model::ModelError;
use crate::solve::sparse::LinearError;

/// Reason why no critical load factor was found.
#[derive(Clone, Debug, thiserror::Error)]
pub enum BucklingError {
    /// The unknowns of the model could not be numbered.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A field does not belong to the mesh of the model.
    #[error("the {field} field has {found} values, the mesh needs {needed}")]
    Size {
        /// Displacement or stress.
        field: &'static str,
        /// Length of the field.
        found: usize,
        /// Length that fits the mesh.
        needed: usize,
    },
    /// A field has a value that is not finite.
    #[error("the {0} field has values that are not finite")]
    NotFinite(&'static str),
    /// The elastic stiffness cannot be factored.
    #[error(transparent)]
    Stiffness(LinearError),
    /// The iteration ended before the lowest factor was found.
    #[error(
        "no critical load factor converged in {steps} steps; the best residual is {residual:e}"
    )]
    NoConvergence {
        /// Steps of the iteration.
        steps: usize,
        /// Smallest relative residual.
        residual: f64,
    },
    /// Below the lowest factor found the structure is not stable: a mode was missed.
    #[error("the structure buckles below the load factor {0}, but no mode was found there")]
    Missed(f64),
}
