//! Preloaded bolts of a result.

use crate::model::AnalysisModel;
use serde::{Deserialize, Serialize};

/// A tightened bolt.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PreloadedBolt {
    /// Body of the bolt.
    pub body: String,
    /// The cut of its shank.
    pub cut: String,
    /// Preload of its meshed part \[N\].
    pub force: f64,
    /// A plane of symmetry halves the bolt: force and tension are those of one half.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub halved: bool,
    /// Relative closure of the cut, frozen \[mm\].
    pub closure: f64,
    /// Tension of the shank under all loads in the static field \[N\]: an estimate, no bound.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension: Option<f64>,
}

/// The bolts of a model whose cuts are frozen; `tensions`: the tension of each in a static field
/// \[N\].
pub fn preloaded_bolts(model: &AnalysisModel, tensions: Option<&[f64]>) -> Vec<PreloadedBolt> {
    let bolts = model.preload.iter().enumerate();
    bolts
        .filter_map(|(i, p)| {
            Some(PreloadedBolt {
                body: p.body.clone(),
                cut: p.cut.clone(),
                force: p.force,
                halved: false,
                closure: p.closure?,
                tension: tensions.and_then(|t| t.get(i).copied()),
            })
        })
        .collect()
}
