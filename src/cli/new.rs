//! `bracket new`.

use super::{Common, Outcome};

/// Write a commented starter spec.
#[derive(Debug, clap::Args)]
pub struct NewArgs {}

/// Runs `bracket new`.
pub fn run(_args: &NewArgs, _common: &Common) -> Outcome {
    Err(crate::diag::Diagnostic::environment("cli/unavailable", "`bracket new` is not part of this build").into())
}
