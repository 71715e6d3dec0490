//! Errors of the factorisation.

/// Reason why a factorisation failed.
#[derive(Clone, Debug, thiserror::Error)]
pub enum LinearError {
    /// The matrix is not positive definite: some part can move freely.
    #[error("the stiffness matrix is singular: some part of the model is not held")]
    Singular,
    /// Out of memory or too large an index.
    #[error("the sparse factorisation could not be set up: {0}")]
    Setup(String),
}
