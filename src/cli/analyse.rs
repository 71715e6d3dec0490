//! `bracket analyse`.

use super::{Common, Outcome};

/// The same engine on a mesh you bring.
#[derive(Debug, clap::Args)]
pub struct AnalyseArgs {}

/// Runs `bracket analyse`.
pub fn run(_args: &AnalyseArgs, _common: &Common) -> Outcome {
    Err(crate::diag::Diagnostic::environment("cli/unavailable", "`bracket analyse` is not part of this build").into())
}
