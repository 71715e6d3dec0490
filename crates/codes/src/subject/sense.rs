//! Sense of bending of a joint.

use bracket_joint::assembly::Way;
use serde::{Deserialize, Serialize};

/// Side of the beam that a moment puts in tension.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Sense {
    /// Tension at the top.
    Top,
    /// Tension at the bottom.
    Bottom,
}

impl Sense {
    /// The sense as a report prints it.
    pub fn words(self) -> &'static str {
        match self {
            Sense::Top => "tension at the top",
            Sense::Bottom => "tension at the bottom",
        }
    }

    /// Flange of the beam in tension.
    pub fn pulled(self) -> Way {
        if self == Sense::Top { Way::Up } else { Way::Down }
    }

    /// Flange of the beam in compression.
    pub fn compressed(self) -> Way {
        if self == Sense::Top { Way::Down } else { Way::Up }
    }

    /// Sense of a moment My of a member end; positive: tension at the top.
    pub fn of_moment(my: f64) -> Self {
        if my < 0.0 { Sense::Bottom } else { Sense::Top }
    }

    /// Converts z of the turned joint to the axes of the spec, and back.
    pub fn z(self, z: f64) -> f64 {
        if self == Sense::Bottom { -z } else { z }
    }
}
