//! `bracket templates`.

use super::{Common, Outcome};

/// List the connection templates.
#[derive(Debug, clap::Args)]
pub struct TemplatesArgs {}

/// Runs `bracket templates`.
pub fn run(_args: &TemplatesArgs, _common: &Common) -> Outcome {
    Err(crate::diag::Diagnostic::environment("cli/unavailable", "`bracket templates` is not part of this build").into())
}
