//! A load step of elastoplastic analysis: bounds and estimates at a part of the demand, or beyond
//! it.

use crate::result::face_motion::FaceMotion;
use crate::result::quantity::LoadSize;
use bracket_base::math::vec3;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::route::BoltSections;
use serde::{Deserialize, Serialize};

/// Bounds and estimates at a load factor.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LoadStep {
    /// The factor of the live loads.
    pub factor: f64,
    /// Lower bound of the potential energy \[N mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Upper bound of the potential energy \[N mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<f64>,
    /// True if both numbers are bounds.
    pub strict: bool,
    /// The only load at this factor, of the whole structure; absent with several loads.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<LoadSize>,
    /// Lower bound of the displacement of the only load in its own direction \[mm; rad for a
    /// moment\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_displacement_at_least: Option<f64>,
    /// Upper bound of it; none at the last step.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_displacement_at_most: Option<f64>,
    /// Motion of each loaded rigid face: an estimate.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub face_motions: Vec<FaceMotion>,
    /// Forces in the sections of the bolts from both fields: estimates.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bolts: Vec<BoltSections>,
}

impl LoadStep {
    /// Largest displacement of a loaded face \[mm\]: an estimate.
    pub fn displacement(&self) -> Option<f64> {
        self.face_motions.iter().map(|m| vec3::norm(m.displacement)).reduce(f64::max)
    }

    /// Largest rotation of a loaded face \[rad\]: an estimate.
    pub fn turn(&self) -> Option<f64> {
        self.face_motions.iter().map(FaceMotion::turn).reduce(f64::max)
    }
}

/// The warning about load steps that the run did not analyse.
pub fn without_steps(factors: &[f64]) -> Text {
    let each = factors.iter().map(|f| Text::given(bracket_base::diag::number(*f)));
    say!(
        "load steps that were not analysed, because the time ended or the bolts could not be \
         tightened: {}",
        Text::joined(", ", each)
    )
}
