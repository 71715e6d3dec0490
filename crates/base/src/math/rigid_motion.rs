//! Small rigid motions.

use super::vec3::{self, V3};

/// Displacement `U + θ × (x − at)` of the point `x` of a rigid body. `[U, θ]` is the motion of the
/// body about the point `at`.
///
/// # Units
/// mm; θ in rad.
#[inline]
pub fn rigid_displacement(motion: &[f64; 6], at: V3, x: V3) -> V3 {
    let theta = [motion[3], motion[4], motion[5]];
    vec3::add([motion[0], motion[1], motion[2]], vec3::cross(theta, vec3::sub(x, at)))
}
