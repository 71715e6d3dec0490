//! `bracket run`.

use super::{Common, Outcome};

/// Connection spec → geometry → mesh → dual analyses → bracket and report.
#[derive(Debug, clap::Args)]
pub struct RunArgs {}

/// Runs `bracket run`.
pub fn run(_args: &RunArgs, _common: &Common) -> Outcome {
    Err(crate::diag::Diagnostic::environment("cli/unavailable", "`bracket run` is not part of this build").into())
}
