//! `bracket mesh`.

use super::{Common, Outcome};

/// Geometry and mesh only.
#[derive(Debug, clap::Args)]
pub struct MeshArgs {}

/// Runs `bracket mesh`.
pub fn run(_args: &MeshArgs, _common: &Common) -> Outcome {
    Err(crate::diag::Diagnostic::environment("cli/unavailable", "`bracket mesh` is not part of this build").into())
}
