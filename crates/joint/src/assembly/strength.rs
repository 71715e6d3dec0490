//! Nominal strengths of a steel and of fillet welds to it.

use serde::Serialize;

/// Nominal strengths of a steel at the thickness of its part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Strength {
    /// Grade.
    pub grade: String,
    /// Yield strength \[MPa\].
    pub fy: f64,
    /// Ultimate strength \[MPa\].
    pub fu: f64,
    /// Young's modulus \[MPa\].
    pub e: f64,
    /// β_w of fillet welds, if the code gives one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub beta_w: Option<f64>,
}

impl Strength {
    /// The steel that governs the design of fillet welds between two parts: the one with the
    /// smaller f_u.
    pub fn weaker<'a>(&'a self, other: &'a Strength) -> &'a Strength {
        if other.fu < self.fu { other } else { self }
    }

    /// Design shear strength of a fillet weld \[MPa\], `f_vw,d = f_u/(√3 β_w γ_M2)`; `None` for
    /// grades without β_w.
    ///
    /// # Source
    /// EN 1993-1-8:2005 4.5.3.3(3), formula 4.4.
    pub fn weld_strength(&self, gamma_m2: f64) -> Option<f64> {
        Some(self.fu / (3f64.sqrt() * self.beta_w? * gamma_m2))
    }
}
