//! The `code` section of a spec: the design code and its partial factors.

use super::word::word_or_none_schema;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Design code and its factors; left out: the recommended values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Code {
    /// Edition of the code.
    pub edition: Edition,
    /// National annex whose partial factors apply where this spec gives none: `DE`, `UK` …
    /// (`bracket catalog list annexes`); left out: the recommended values.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "word_or_none_schema")]
    pub annex: Option<String>,
    /// Partial factor of cross-sections, 0.5 to 3.
    #[serde(rename = "gamma_M0", skip_serializing_if = "Option::is_none")]
    pub gamma_m0: Option<f64>,
    /// Partial factor of members and web panels against instability, 0.5 to 3.
    #[serde(rename = "gamma_M1", skip_serializing_if = "Option::is_none")]
    pub gamma_m1: Option<f64>,
    /// Partial factor of bolts, welds and net sections, 0.5 to 3.
    #[serde(rename = "gamma_M2", skip_serializing_if = "Option::is_none")]
    pub gamma_m2: Option<f64>,
    /// Partial factor of slip at the ultimate limit state, 0.5 to 3.
    #[serde(rename = "gamma_M3", skip_serializing_if = "Option::is_none")]
    pub gamma_m3: Option<f64>,
    /// Partial factor of slip at serviceability, 0.5 to 3.
    #[serde(rename = "gamma_M3_ser", skip_serializing_if = "Option::is_none")]
    pub gamma_m3_ser: Option<f64>,
    /// Partial factor of the preload of bolts, 0.5 to 3.
    #[serde(rename = "gamma_M7", skip_serializing_if = "Option::is_none")]
    pub gamma_m7: Option<f64>,
    /// Partial factor of concrete, 0.5 to 3. It counts where a joint stands on concrete.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gamma_c: Option<f64>,
    /// Coefficient α_cc of the strength of concrete, 0.8 to 1. It counts where a joint stands on
    /// concrete.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alpha_cc: Option<f64>,
    /// Table the yield strengths come from.
    pub fy_source: FySource,
    /// Whether prying forces develop in T-stubs.
    #[serde(skip_serializing_if = "PryingRule::is_default")]
    pub prying: PryingRule,
}

/// All partial factors of one spec, in the order of the standard.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PartialFactors {
    /// γ_M0: cross-sections.
    pub gamma_m0: f64,
    /// γ_M1: members and web panels against instability.
    pub gamma_m1: f64,
    /// γ_M2: bolts, welds, net sections.
    pub gamma_m2: f64,
    /// γ_M3: slip at the ultimate limit state.
    pub gamma_m3: f64,
    /// γ_M3,ser: slip at serviceability.
    pub gamma_m3_ser: f64,
    /// γ_M7: preload of bolts.
    pub gamma_m7: f64,
    /// Those of concrete; the facts of a joint on concrete show them.
    #[serde(skip)]
    pub concrete: ConcreteFactors,
}

/// Factors of the strength of concrete, EN 1992-1-1:2004.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ConcreteFactors {
    /// γ_c, 2.4.2.4.
    pub gamma_c: f64,
    /// α_cc, 3.1.6(1).
    pub alpha_cc: f64,
}

impl ConcreteFactors {
    /// The values that the code recommends.
    pub const RECOMMENDED: Self = Self { gamma_c: 1.5, alpha_cc: 1.0 };
}

/// Whether prying forces develop in T-stubs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PryingRule {
    /// Where the bolts are no longer than L_b* of EN 1993-1-8 Table 6.2.
    #[default]
    ByLength,
    /// Everywhere, whatever the length of the bolts.
    Always,
}

impl PryingRule {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

impl Default for Code {
    fn default() -> Self {
        Self {
            edition: Edition::Ec2005,
            annex: None,
            gamma_m0: None,
            gamma_m1: None,
            gamma_m2: None,
            gamma_m3: None,
            gamma_m3_ser: None,
            gamma_m7: None,
            gamma_c: None,
            alpha_cc: None,
            fy_source: FySource::Table31,
            prying: PryingRule::ByLength,
        }
    }
}

/// Edition of the code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Edition {
    /// EN 1993-1-8:2005.
    #[serde(rename = "EN 1993-1-8:2005")]
    Ec2005,
}

/// Where yield strengths come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FySource {
    /// EN 1993-1-1 Table 3.1: steps at 40 mm.
    #[serde(rename = "table_3_1")]
    Table31,
    /// The product standard: steps from 16 mm up.
    ProductStandard,
}
