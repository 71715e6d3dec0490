//! The `friction` section of a spec, and the friction law of any contact.

use super::word::word_or_none_schema;
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

/// Friction law.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FrictionLaw {
    /// Coulomb's law without dilation.
    #[default]
    Coulomb,
    /// Slip dilates; both programs are convex duals of each other.
    Associated,
}
