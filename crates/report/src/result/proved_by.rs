//! Where the bounds of a load case come from that has no limit analysis of its own.

use bracket_engine::certify::half_space::Actions;
use serde::{Deserialize, Serialize};

/// Where the bounds of a load case without an analysis of its own come from. The theorems are in
/// docs/theory.md, section 11.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ProvedBy {
    /// Analyses whose carried actions add up to those of the case; none: there is no lower bound.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub lower: Vec<Weight>,
    /// Name of the analysis whose mechanism gives the upper bound.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<String>,
}

/// An analysis and its weight μ: the actions of the case are the sum of the actions of the
/// analyses, each times its lower bound and its weight.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Weight {
    /// Name of the analysis.
    pub analysis: String,
    /// Its weight, not negative.
    pub weight: f64,
}

/// Actions of no load case, analysed because the bounds of load cases follow from theirs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Direction {
    /// Name of its entry among the cases.
    pub name: String,
    /// The load case whose model it has, but for the actions.
    pub like: String,
    /// A force and a moment about its reference point on every rigid face of that model, global
    /// axes \[N, N mm\].
    pub actions: Actions,
}
