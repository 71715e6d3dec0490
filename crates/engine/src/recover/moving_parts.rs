//! A motion of parts in words.

use crate::model::AnalysisModel;
use bracket_base::math::rigid_motion::rigid_displacement;
use bracket_base::math::vec3::{self, V3};
use bracket_base::say;
use bracket_base::words::Text;

/// A part is named where its motion reaches this fraction of the largest.
const NAMED: f64 = 0.05;

/// The parts that move along an unbounded direction; `moved`: displacement of points, each with its
/// part.
pub fn mechanism(model: &AnalysisModel, moved: impl IntoIterator<Item = (u32, V3)>) -> Text {
    let mut sums = vec![([0.0; 3], 0.0f64, 0.0); model.parts.len()];
    for (p, u) in moved {
        let s = &mut sums[p as usize];
        *s = (vec3::add(s.0, u), s.1.max(vec3::norm(u)), s.2 + 1.0);
    }
    let mean: Vec<V3> =
        sums.iter().map(|(s, _, n)| vec3::scale(1.0 / f64::max(*n, 1.0), *s)).collect();
    let largest = mean.iter().map(|m| vec3::norm(*m)).fold(0.0, f64::max);
    let fastest = sums.iter().map(|s| s.1).fold(0.0, f64::max);
    let parts = || model.parts.iter().enumerate();
    let moving = parts().filter_map(|(i, name)| {
        let m = mean[i];
        let d = (0..3).max_by(|&a, &b| m[a].abs().total_cmp(&m[b].abs())).unwrap_or(0);
        let sign = if m[d] < 0.0 { "−" } else { "+" };
        let moves = vec3::norm(m) > NAMED * largest && vec3::norm(m) > 1e-9 * fastest;
        let axis = ["x", "y", "z"][d];
        moves.then(|| say!("part {} moves along {}", name, format!("{sign}{axis}")))
    });
    let moving = Text::joined(", ", moving);
    if !moving.is_empty() {
        return moving;
    }
    let turning = parts().filter(|(i, _)| sums[*i].1 > NAMED * fastest);
    Text::joined(", ", turning.map(|(_, name)| say!("part {} turns about its centre", name)))
}

/// The same for rigid motions `[U, θ]` of the parts about the origin.
pub(crate) fn rigid_mechanism(model: &AnalysisModel, motions: &[[f64; 6]]) -> Text {
    let points = model.node_parts().into_iter().zip(&model.mesh.nodes);
    mechanism(
        model,
        points.map(|(p, x)| (p, rigid_displacement(&motions[p as usize], [0.0; 3], *x))),
    )
}
