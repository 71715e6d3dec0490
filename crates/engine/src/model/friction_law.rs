//! The friction law of a contact.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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
