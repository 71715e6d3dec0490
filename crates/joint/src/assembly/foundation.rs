//! The concrete that a base plate stands on.

use crate::strength::Nominal;
use serde::{Deserialize, Serialize};

/// A concrete block with a layer of grout under a base plate. Lengths along the plate's two axes,
/// in the order of the joint's axes \[mm\].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Foundation {
    /// Characteristic cylinder strength f_ck of the concrete.
    pub f_ck: Nominal,
    /// Lengths of the base plate.
    pub plate: [f64; 2],
    /// Distance from each edge of the plate to the edge of the block, in the negative and the
    /// positive direction of each axis.
    pub edge: [[f64; 2]; 2],
    /// Depth of the block.
    pub depth: f64,
    /// Thickness of the grout.
    pub grout: f64,
    /// Characteristic strength of the grout.
    pub grout_strength: Nominal,
    /// Coefficient of friction C_f,d between plate and grout.
    pub friction: f64,
    /// True where the ground does not settle in elastic and elastoplastic analysis.
    pub rigid: bool,
}
