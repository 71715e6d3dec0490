//! The `welds` section of a spec: how the workshop makes the fillet welds.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How the fillet welds are made; left out: returned at the tips of the flanges, and no contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct WeldSpec {
    /// Ends of the fillet welds, which decide their effective length.
    #[serde(skip_serializing_if = "WeldEnds::is_default")]
    pub ends: WeldEnds,
    /// True: the beam's end is prepared for full contact with its end plate, so that compression
    /// goes through the contact. False: the welds carry it.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub bearing_in_contact: bool,
}

impl WeldSpec {
    /// Whether nothing differs from a spec without the section.
    pub fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// Ends of fillet welds. The effective length of a run is its length less twice its throat, unless
/// it is full-size up to its ends (EN 1993-1-8:2005 4.5.1(1)).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WeldEnds {
    /// Full-size round the tips of the beam's flanges: the runs of a flange are one weld, which
    /// loses a leg √2 a at either end. All other runs lose twice their throat.
    #[default]
    Returned,
    /// Every run stops at its ends and loses twice its throat.
    Open,
    /// Full-size everywhere, round tips and root fillets: no run loses anything.
    AllRound,
}

impl WeldEnds {
    /// Whether it is the value of a spec without the key.
    pub fn is_default(&self) -> bool {
        *self == Self::default()
    }
}
