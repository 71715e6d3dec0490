//! The cone of one contact point: unilateral contact, with or without friction.
//!
//! Where the ground crushes, the cone bounds `g_N + c` with the closing `c ≥ 0` of the ground. It
//! dissipates the strength of the ground times c. The multiplier of the cone, the pressure, is then
//! at most the strength.

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
/// linear form of the full unknowns. `offset` is g₀; `closing` is the unknown c with its factor in
/// the first row.
pub fn push_cone(
    program: &mut ConicProgram,
    map: &DofMap,
    (normal, mu, offset): (V3, f64, f64),
    closing: Option<(usize, f64)>,
    jump: impl Fn(V3, f64) -> Vec<(usize, f64)>,
) -> bool {
    let (t1, t2) = vec3::tangents(normal);
    let row = |direction: V3, factor: f64| map.row(&jump(direction, factor));
    let mut all = [row(normal, 1.0), row(t1, mu), row(t2, mu)];
    if all[..rows(mu)].iter().all(|r| r.is_empty()) {
        return false;
    }
    // closings are the last unknowns
    all[0].extend(closing.map(|(k, factor)| (k as u32, factor)));
    let used = &all[..rows(mu)];
    for (i, row) in used.iter().enumerate() {
        program.g.push_row(row);
        program.h.push(if i == 0 { offset } else { 0.0 });
    }
    program.cones.push(if mu > 0.0 { Cone::SecondOrder(3) } else { Cone::NonNegative });
    true
}

/// Appends the closings of crushing ground to a program: their dissipation and `c ≥ 0`. Each comes
/// with its contact cone (a row of `g`), if something of it can move, and with the dissipation per
/// unit of closing \[N\].
pub fn append_closings(
    program: &mut ConicProgram,
    map: &DofMap,
    closings: &[(Option<usize>, f64)],
) {
    for (k, &(row, dissipation)) in map.crushing().zip(closings) {
        program.q[k] += dissipation;
        if !program.stiffness.is_empty() {
            let beside = row.into_iter().flat_map(|r| program.g.row(r)).filter(|(c, _)| *c != k);
            let stiffest = beside.map(|(c, _)| program.stiffness[c]).fold(0.0, f64::max);
            program.stiffness[k] = if stiffest > 0.0 { stiffest } else { 1.0 };
        }
        program.g.push_row(&[(k as u32, 1.0)]);
        program.h.push(0.0);
        program.cones.push(Cone::NonNegative);
    }
}
