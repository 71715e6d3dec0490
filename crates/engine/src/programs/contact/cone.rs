//! The cone of one contact point: unilateral contact, with or without friction.
//!
//! Where the ground gives way, the cone bounds `g_N + c` with the closing c of the ground. Crushing
//! ground has `c ≥ 0` and dissipates its strength times c: the multiplier of the cone, the
//! pressure, is then at most the strength. Elastic ground (Winkler) stores `½ k ∫ c²`: the pressure
//! is then k c.

use crate::model::AnalysisModel;
use crate::programs::conic::{Cone, ConicProgram};
use crate::programs::dofs::DofMap;
use bracket_base::math::vec3::{self, V3};

/// How the ground gives way at a contact cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Closing {
    /// It crushes, with the dissipation per unit of closing \[N\].
    Crushing(f64),
    /// It is elastic; the quadratic term of the program has its energy.
    Elastic,
}

impl Closing {
    /// True in limit analysis for crushing ground, and in the other analyses for elastic ground.
    pub fn is_part(self, limit: bool) -> bool {
        limit == matches!(self, Closing::Crushing(_))
    }
}

/// Closing of the ground at a cone of a contact, `None` where it is rigid. `share`: the area of the
/// cone's part of the face \[mm²\].
pub fn closing_of(model: &AnalysisModel, contact: usize, share: f64) -> Option<Closing> {
    let crushing = model.crushing_strength(contact).map(|f| Closing::Crushing(f * share));
    crushing.or_else(|| model.ground_stiffness(contact).map(|_| Closing::Elastic))
}

/// Number of rows of a contact cone: 3 with friction, 1 without.
pub fn rows(mu: f64) -> usize {
    if mu > 0.0 { 3 } else { 1 }
}

/// Appends the cone `(g_N + g₀, μ g_T) ∈ K³`, or `g_N + g₀ ≥ 0` without friction, and returns true.
/// Appends nothing and returns false when no unknown of the program moves the point.
///
/// `jump` returns the component of the jump `u_B − u_A` along a direction, times a factor, as a
/// linear form of the full unknowns. `offset` is g₀; `closing` holds the unknowns of closings with
/// their factors in the first row.
pub fn push_cone(
    program: &mut ConicProgram,
    map: &DofMap,
    (normal, mu, offset): (V3, f64, f64),
    closing: &[(u32, f64)],
    jump: impl Fn(V3, f64) -> Vec<(usize, f64)>,
) -> bool {
    let (t1, t2) = vec3::tangents(normal);
    let row = |direction: V3, factor: f64| map.row(&jump(direction, factor));
    let mut all = [row(normal, 1.0), row(t1, mu), row(t2, mu)];
    if all[..rows(mu)].iter().all(|r| r.is_empty()) {
        return false;
    }
    // closings are the last unknowns
    all[0].extend(closing);
    let used = &all[..rows(mu)];
    for (i, row) in used.iter().enumerate() {
        program.g.push_row(row);
        program.h.push(if i == 0 { offset } else { 0.0 });
    }
    program.cones.push(if mu > 0.0 { Cone::SecondOrder(3) } else { Cone::NonNegative });
    true
}

/// Appends the closings of the ground to a program: scales and, where it crushes, the dissipation
/// and `c ≥ 0`. Each comes with its contact cone (a row of `g`), if something of it can move.
pub fn append_closings(
    program: &mut ConicProgram,
    map: &DofMap,
    closings: &[(Option<usize>, Closing)],
) {
    if closings.is_empty() {
        return;
    }
    let energy = program.p.diagonal();
    for (k, &(row, closing)) in map.closings().zip(closings) {
        let scaled = !program.stiffness.is_empty();
        let Closing::Crushing(dissipation) = closing else {
            if scaled {
                program.stiffness[k] = energy[k];
            }
            continue;
        };
        program.q[k] += dissipation;
        if scaled {
            let beside = row.into_iter().flat_map(|r| program.g.row(r)).filter(|(c, _)| *c != k);
            let stiffest = beside.map(|(c, _)| program.stiffness[c]).fold(0.0, f64::max);
            program.stiffness[k] = if stiffest > 0.0 { stiffest } else { 1.0 };
        }
        program.g.push_row(&[(k as u32, 1.0)]);
        program.h.push(0.0);
        program.cones.push(Cone::NonNegative);
    }
}
