//! The cone of one contact point: unilateral contact, with or without friction.

use crate::programs::conic::{Cone, ConicProgram};
use crate::programs::dofs::DofMap;
use bracket_base::math::vec3::{self, V3};

/// Number of rows of a contact cone: 3 with friction, 1 without.
pub fn rows(mu: f64) -> usize {
    if mu > 0.0 { 3 } else { 1 }
}

/// Appends the cone `(g_N + g₀, μ g_T) ∈ K³`, or `g_N + g₀ ≥ 0` without friction, and returns true.
/// Appends nothing and returns false when no unknown of the program moves the point.
///
/// `jump` returns the component of the jump `u_B − u_A` along a direction, times a factor, as a
/// linear form of the full unknowns. `offset` is g₀.
pub fn push_cone(
    program: &mut ConicProgram,
    map: &DofMap,
    (normal, mu, offset): (V3, f64, f64),
    jump: impl Fn(V3, f64) -> Vec<(usize, f64)>,
) -> bool {
    let (t1, t2) = vec3::tangents(normal);
    let row = |direction: V3, factor: f64| map.row(&jump(direction, factor));
    let all = [row(normal, 1.0), row(t1, mu), row(t2, mu)];
    let used = &all[..rows(mu)];
    if used.iter().all(|r| r.is_empty()) {
        return false;
    }
    for (i, row) in used.iter().enumerate() {
        program.g.push_row(row);
        program.h.push(if i == 0 { offset } else { 0.0 });
    }
    program.cones.push(if mu > 0.0 { Cone::SecondOrder(3) } else { Cone::NonNegative });
    true
}
