//! Errors of the factorisation.

use bracket_base::display_text;
use bracket_base::say;
use bracket_base::words::Text;

/// Reason why a factorisation failed.
#[derive(Clone, Debug)]
pub enum LinearError {
    /// The matrix is not positive definite: some part can move freely.
    Singular,
    /// Out of memory or too large an index.
    Setup(Text),
}

impl LinearError {
    /// The reason in words.
    pub fn text(&self) -> Text {
        match self {
            LinearError::Singular => {
                "the stiffness matrix is singular: some part of the model is not held".into()
            }
            LinearError::Setup(why) => {
                say!("the sparse factorisation could not be set up: {}", why)
            }
        }
    }
}

display_text!(LinearError);

impl std::error::Error for LinearError {}
