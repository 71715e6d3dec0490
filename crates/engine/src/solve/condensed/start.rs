//! Starting point of the iteration.

use super::cones::Scaling;
use super::point::Point;
use super::scaled_program::ScaledProgram;
use super::settings::Settings;
use super::system::{CondensedSystem, Solved};
use super::vectors::{dot, largest};
use crate::programs::conic::cone_margin;

/// The minimum of `½ xᵀPx + qᵀx + ½‖s‖²` over `s = Gx + h`, with slacks and multipliers moved
/// inside the cones; and the load factor at which that elastic stress would reach the yield
/// surface, 0 where it never does.
pub fn starting_point(
    problem: &ScaledProgram,
    settings: &Settings,
    system: &CondensedSystem,
) -> (Point, f64) {
    let cones = &problem.cones;
    let minus_q: Vec<f64> = problem.program.q.iter().map(|q| -q).collect();
    let [Solved { x, .. }] = system.solve::<1, false>(
        problem,
        &Scaling::identity(cones),
        [(&minus_q, &problem.program.h)],
    );
    let s = problem.program.slack(&x);
    let reference = match (problem.program.live.is_empty(), x.last()) {
        (false, Some(factor)) => {
            let yields = cones.blocks.iter().filter(|b| b.0 >= problem.points);
            let stress = yields
                .fold(0.0, |m: f64, &(at, d)| m.max(dot(&s[at + 1..at + d], &s[at + 1..at + d])));
            // loads that slide one part over another may stress no part
            if stress.sqrt() > settings.unstressed * factor.abs() {
                factor.abs() / stress.sqrt()
            } else {
                0.0
            }
        }
        _ => 0.0,
    };
    let z: Vec<f64> = s.iter().map(|v| -v).collect();
    let inside = |mut v: Vec<f64>| {
        let margins: Vec<f64> =
            cones.blocks.iter().map(|&(at, d)| cone_margin(&v[at..at + d])).collect();
        let worst = margins.iter().fold(f64::INFINITY, |m, x| m.min(*x));
        let mean = margins.iter().map(|m| m.max(0.0)).sum::<f64>() / cones.degree().max(1.0);
        let target = (0.1 * mean).max(1e-2 * largest(&v)).max(1e-8);
        if worst < target {
            cones.blocks.iter().for_each(|&(at, _)| v[at] += target - worst);
        }
        v
    };
    let (mut x, mut s, mut z) = (x, inside(s), inside(z));
    if !problem.program.live.is_empty() {
        // without elasticity motions and forces have no size of their own; from too large a start τ
        // falls by many orders, and its return takes ten iterations
        let size = (cones.degree() / dot(&s, &z)).sqrt();
        [&mut x, &mut s, &mut z].into_iter().for_each(|v| v.iter_mut().for_each(|v| *v *= size));
        for &(at, d) in cones.blocks.iter().filter(|b| b.0 < problem.points) {
            s[at..at + d].iter_mut().for_each(|v| *v *= settings.opening);
            z[at..at + d].iter_mut().for_each(|v| *v *= settings.pressure);
        }
    }
    (Point { x, s, z, tau: 1.0, kappa: 1.0 }, reference)
}
