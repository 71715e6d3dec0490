//! Residuals of the fields that prove a pair of bounds, in the form of `result.json`.

use bracket_engine::certify::bracket::{LowerBound, UpperBound};
use bracket_engine::certify::{LowerFactor, UpperFactor};
use serde::{Deserialize, Serialize};

/// Largest certificate residual of a strict bound, dimensionless.
pub use bracket_engine::certify::TOLERANCE as RESIDUAL_TOLERANCE;

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
    /// The residuals of a kinematic and a static field: each its own, the larger one where both
    /// have one.
    pub fn with(&self, other: &Self) -> Self {
        let larger = |a: Option<f64>, b: Option<f64>| [a, b].into_iter().flatten().reduce(f64::max);
        Self {
            strict: self.strict && other.strict,
            equilibrium: larger(self.equilibrium, other.equilibrium),
            traction_jump: larger(self.traction_jump, other.traction_jump),
            yield_: larger(self.yield_, other.yield_),
            contact: larger(self.contact, other.contact),
            compatibility: larger(self.compatibility, other.compatibility),
            volume: larger(self.volume, other.volume),
        }
    }

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

impl From<&LowerBound> for Certificate {
    fn from(bound: &LowerBound) -> Self {
        let c = bound.certificate();
        let welds = c.weld.map(|used| used - 1.0);
        Self {
            strict: bound.is_strict(),
            equilibrium: Some(c.equilibrium),
            traction_jump: Some(c.traction_jump),
            yield_: c.yields.into_iter().chain(welds).reduce(f64::max),
            contact: c.contact,
            ..Self::default()
        }
    }
}

impl From<&UpperBound> for Certificate {
    fn from(bound: &UpperBound) -> Self {
        let c = bound.certificate();
        Self {
            strict: bound.is_strict(),
            contact: c.contact,
            compatibility: Some(c.compatibility),
            ..Self::default()
        }
    }
}

impl From<&LowerFactor> for Certificate {
    fn from(bound: &LowerFactor) -> Self {
        let c = bound.certificate();
        Self {
            strict: bound.is_strict(),
            equilibrium: Some(c.equilibrium),
            traction_jump: Some(c.traction_jump),
            yield_: Some(c.worst() + c.cover - 1.0),
            contact: c.contact,
            ..Self::default()
        }
    }
}

impl From<&UpperFactor> for Certificate {
    fn from(bound: &UpperFactor) -> Self {
        let c = bound.certificate();
        Self {
            strict: bound.is_strict(),
            contact: c.contact,
            compatibility: Some(c.compatibility.max(c.rigid)),
            volume: Some(c.volume),
            ..Self::default()
        }
    }
}
