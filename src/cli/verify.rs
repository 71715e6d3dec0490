//! `bracket verify`.

use super::{Common, Outcome};

/// Recompute the certificate of a finished result.
#[derive(Debug, clap::Args)]
pub struct VerifyArgs {}

/// Runs `bracket verify`.
pub fn run(_args: &VerifyArgs, _common: &Common) -> Outcome {
    Err(crate::diag::Diagnostic::environment("cli/unavailable", "`bracket verify` is not part of this build").into())
}
