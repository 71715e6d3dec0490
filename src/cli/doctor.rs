//! `bracket doctor`.

use super::{Common, Outcome};

/// Say what this machine has and what is missing.
#[derive(Debug, clap::Args)]
pub struct DoctorArgs {}

/// Runs `bracket doctor`.
pub fn run(_args: &DoctorArgs, _common: &Common) -> Outcome {
    Err(crate::diag::Diagnostic::environment("cli/unavailable", "`bracket doctor` is not part of this build").into())
}
