//! `bracket schema`.

use super::{Common, Outcome};

/// Print the JSON Schema of an input file.
#[derive(Debug, clap::Args)]
pub struct SchemaArgs {}

/// Runs `bracket schema`.
pub fn run(_args: &SchemaArgs, _common: &Common) -> Outcome {
    Err(crate::diag::Diagnostic::environment("cli/unavailable", "`bracket schema` is not part of this build").into())
}
