//! What the bounds of a load factor have at supports, ties, ground and cuts: utilisation and share
//! in the dissipation.

use serde::{Deserialize, Serialize};

/// Slip of a body along the faces of a support.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SupportSlip {
    /// Name of the support's faces.
    pub support: String,
    /// Its share in the dissipation of the mechanism, a fraction.
    pub share: f64,
}

/// Slip along the common faces of two bodies tied together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TieSlip {
    /// The two bodies: `BEAM-PLATE`.
    pub tie: String,
    /// Its share in the dissipation of the mechanism, a fraction.
    pub share: f64,
}

/// Ground that crushes under a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GroundUse {
    /// Name of the face on the ground.
    pub ground: String,
    /// Pressure at which the ground crushes \[MPa\].
    pub strength: f64,
    /// Largest pressure in the static field over the strength, a fraction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<f64>,
    /// Its share in the dissipation of the mechanism, a fraction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub share: Option<f64>,
}

/// Use of a resultant limit, in the meshed part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ResultantUse {
    /// Name of the limit.
    pub limit: String,
    /// Largest value \[N\].
    pub at_most: f64,
    /// Sum of the resultants in the static field \[N\], global axes: force of side B on side A.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<[f64; 3]>,
    /// Its value `along · force + ‖across force‖` over `at_most`, a fraction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<f64>,
    /// Its share in the dissipation of the mechanism, a fraction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub share: Option<f64>,
}
