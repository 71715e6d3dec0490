//! Motion of a loaded face.

use bracket_base::math::vec3;
use serde::{Deserialize, Serialize};

/// Motion of a rigid face.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FaceMotion {
    /// Name of the face.
    pub face: String,
    /// Displacement of its reference point \[mm\].
    pub displacement: [f64; 3],
    /// Rotation about the axes x, y, z \[rad\].
    pub rotation: [f64; 3],
}

impl FaceMotion {
    /// Size of the rotation \[rad\].
    pub fn turn(&self) -> f64 {
        vec3::norm(self.rotation)
    }
}
