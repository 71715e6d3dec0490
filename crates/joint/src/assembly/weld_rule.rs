//! Fillet welds of a joint.

use super::assembly::Surface;
use crate::strength::WeldSteel;
use serde::{Deserialize, Serialize};

/// Fillet welds along both sides of a plate on another part, modelled as an interface of finite
/// strength.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WeldRule {
    /// Name, also that of the physical surface.
    pub name: String,
    /// The two parts; the normal points out of the first.
    pub between: [String; 2],
    /// The surface where the parts meet.
    pub surface: Surface,
    /// True if no edges of the parts bound the surface, so that it must be imprinted.
    pub imprint: bool,
    /// Throat of each weld \[mm\].
    pub throat: f64,
    /// Area of the interface divided by half the length of its welds \[mm\]. For a plate with a
    /// weld on each side this is the thickness of the plate.
    pub thickness: f64,
    /// Length of all of them \[mm\]; none: twice the area of the surface over `thickness`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// True: one weld round the outside of a hollow section.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub closed: bool,
    /// The weaker steel of the two parts.
    pub steel: WeldSteel,
}
