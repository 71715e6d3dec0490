//! The `friction` section of a spec.

use super::word::word_or_none_schema;
use bracket_engine::model::FrictionLaw;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Friction on contact surfaces; at most one of `mu` and `class`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct FrictionSpec {
    /// Friction coefficient, ≥ 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mu: Option<f64>,
    /// Friction class A–D of EN 1090-2.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "word_or_none_schema")]
    pub class: Option<String>,
    /// Friction law.
    pub law: FrictionLaw,
}
