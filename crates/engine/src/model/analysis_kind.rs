//! The kinds of analysis.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which pair of programs is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AnalysisKind {
    /// Linear elastic bodies with contact: brackets the potential energy.
    Elastic,
    /// Elastic, perfectly plastic (Hencky).
    Elastoplastic,
    /// Rigid, perfectly plastic: brackets the factor on the loads at collapse. Bodies of a material
    /// without `fy` are rigid; E, nu, gaps and preload do not matter.
    Limit,
}

impl AnalysisKind {
    /// Name of the kind in the files.
    pub fn word(self) -> &'static str {
        match self {
            AnalysisKind::Elastic => "elastic",
            AnalysisKind::Elastoplastic => "elastoplastic",
            AnalysisKind::Limit => "limit",
        }
    }
}
