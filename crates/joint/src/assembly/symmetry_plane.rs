//! A plane of symmetry of a joint.

use serde::{Deserialize, Serialize};

/// A symmetry plane `x[axis] = 0` of geometry, supports and loads. The side with positive
/// coordinates is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SymmetryPlane {
    /// Normal axis, 0 = x, 1 = y, 2 = z.
    pub axis: usize,
}
