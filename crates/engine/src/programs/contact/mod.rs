//! Contact cones of both programs: their rows, and the points of the interface that carry them.
//!
//! The kinematic program has a cone at each control point (Bernstein coefficient of gap and slip),
//! the static program one at each vertex of a contact face.

pub mod cone;
pub mod elastic_ground;
pub mod kinematic_contact;
pub mod static_contact;
