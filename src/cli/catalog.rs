//! `bracket catalog`.

use super::{Common, Outcome};

/// List and show catalogue data.
#[derive(Debug, clap::Args)]
pub struct CatalogArgs {}

/// Runs `bracket catalog`.
pub fn run(_args: &CatalogArgs, _common: &Common) -> Outcome {
    Err(crate::diag::Diagnostic::environment("cli/unavailable", "`bracket catalog` is not part of this build").into())
}
