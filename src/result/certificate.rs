//! Residuals of the fields that prove a pair of bounds, in the form of `result.json`.

use serde::{Deserialize, Serialize};

/// Largest certificate residual of a strict bound, dimensionless.
pub use crate::certify::TOLERANCE as RESIDUAL_TOLERANCE;

/// Residuals of the recovered fields, dimensionless (definitions in docs/results.md), recomputed
/// without the solver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Certificate {
    /// True if every residual is within [`RESIDUAL_TOLERANCE`]. Only then `lower` and `upper` are
    /// bounds.
    pub strict: bool,
    /// max |div σ + b| h / max |σ|.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub equilibrium: Option<f64>,
    /// max |Δt| / max |t|.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub traction_jump: Option<f64>,
    /// max ‖s‖ / (√2 k) − 1; negative inside the yield surface.
    #[serde(default, rename = "yield", skip_serializing_if = "Option::is_none")]
    pub yield_: Option<f64>,
    /// max cone violation / max |r|.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact: Option<f64>,
    /// max |u − u_d| / max |u|.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub compatibility: Option<f64>,
    /// Limit analysis: max |tr ε| h / max |v|.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub volume: Option<f64>,
}

impl Certificate {
    /// Name, definition and value of each residual, in the order of docs/results.md.
    pub fn residuals(&self) -> [(&'static str, &'static str, Option<f64>); 6] {
        [
            ("equilibrium", "max |div σ + b| h / max |σ|", self.equilibrium),
            ("traction jump", "max |Δt| / max |t|", self.traction_jump),
            ("yield", "max ‖s‖ / (√2 k) − 1", self.yield_),
            ("contact", "max cone violation / max |r|", self.contact),
            ("compatibility", "max |u − u_d| / max |u|", self.compatibility),
            ("volume", "max |tr ε| h / max |v|", self.volume),
        ]
    }
}
