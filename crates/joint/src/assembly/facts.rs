//! What the hand checks read of a joint, by family of connections.

use super::actions::PlaneActions;
use super::end_plate::EndPlate;
use serde::Serialize;

/// Facts of a joint for its hand checks. Each room that needs more than the actions matches the
/// family once.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Facts {
    /// A bolted end plate, on a column or of a splice.
    EndPlate(EndPlate),
}

impl Facts {
    /// The actions of the load cases at the planes of the connection.
    pub fn actions(&self) -> &[PlaneActions] {
        match self {
            Facts::EndPlate(e) => &e.actions,
        }
    }
}
