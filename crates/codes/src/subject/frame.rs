//! Kinds of frames.

use serde::{Deserialize, Serialize};

/// Whether bracing reduces the sway of the frame by 80 %.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Frame {
    /// Bracing reduces the horizontal displacement by 80 % or more: k_b = 8.
    Braced,
    /// Any other frame with K_b/K_c ≥ 0.1 in every storey: k_b = 25.
    Unbraced,
}

impl Frame {
    /// k_b of 5.2.2.5(1).
    pub fn factor(self) -> f64 {
        match self {
            Frame::Braced => 8.0,
            Frame::Unbraced => 25.0,
        }
    }

    /// The kind of frame as a report prints it.
    pub fn words(self) -> &'static str {
        match self {
            Frame::Braced => "braced frame",
            Frame::Unbraced => "other frames",
        }
    }
}
