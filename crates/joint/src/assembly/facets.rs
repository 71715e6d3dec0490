//! Chords that keep the area, in place of circles and arcs.

use super::assembly::OutlineEdge;

/// Number of chords that replace a quarter circle of an outline (a root fillet).
pub const CHORDS_PER_QUARTER: usize = 2;

/// Circumradius of the regular `n`-gon with the area of a circle of radius `radius` \[mm\].
pub fn polygon_radius(radius: f64, n: u32) -> f64 {
    let step = 2.0 * std::f64::consts::PI / f64::from(n);
    radius * (step / step.sin()).sqrt()
}

/// Corners of the regular `n`-gon with the area of the circle, first corner on the first axis
/// \[mm\].
pub fn regular_polygon(radius: f64, n: u32) -> Vec<[f64; 2]> {
    let r = polygon_radius(radius, n);
    (0..n)
        .map(|i| {
            let a = 2.0 * std::f64::consts::PI * f64::from(i) / f64::from(n);
            [rounded(r * a.cos()), rounded(r * a.sin())]
        })
        .collect()
}

/// Rounds to 1e-9 mm. Mirrored corners become exact mirror images, and `6e-17` becomes zero.
fn rounded(x: f64) -> f64 {
    (x * 1e9).round() / 1e9 + 0.0
}

/// The corners of an outline, with arcs replaced by chords.
pub fn flatten_outline(start: [f64; 2], edges: &[OutlineEdge]) -> Vec<[f64; 2]> {
    let mut points = vec![start];
    let mut at = start;
    for edge in edges {
        match edge {
            OutlineEdge::Line { to } => {
                points.push(*to);
                at = *to;
            }
            OutlineEdge::Arc { to, centre } => {
                points.extend(arc_corners(at, *to, *centre));
                points.push(*to);
                at = *to;
            }
        }
    }
    // The last edge ends at the start, so the repeated corner is removed.
    if points.len() > 1 {
        let last = points[points.len() - 1];
        if (last[0] - start[0]).abs() < 1e-6 && (last[1] - start[1]).abs() < 1e-6 {
            points.pop();
        }
    }
    points
}

/// Inner corners of the chain of k chords that replaces an arc of angle θ.
///
/// The ends stay on the circle (radius r). The k − 1 inner corners lie at radius ρ, chosen so that
/// the fan from the centre has the area of the sector: ½ sin(θ/k) (2 r ρ + (k − 2) ρ²) = ½ r² θ.
fn arc_corners(from: [f64; 2], to: [f64; 2], centre: [f64; 2]) -> Vec<[f64; 2]> {
    use std::f64::consts::PI;
    let a = [from[0] - centre[0], from[1] - centre[1]];
    let b = [to[0] - centre[0], to[1] - centre[1]];
    let radius = a[0].hypot(a[1]);
    let start = a[1].atan2(a[0]);
    let mut sweep = b[1].atan2(b[0]) - start;
    if sweep > PI {
        sweep -= 2.0 * PI;
    }
    if sweep < -PI {
        sweep += 2.0 * PI;
    }
    let k = ((sweep.abs() / (PI / 2.0) * CHORDS_PER_QUARTER as f64 - 1e-9).ceil() as usize).max(2);
    let step = sweep.abs() / k as f64;
    let target = radius * radius * sweep.abs() / step.sin();
    let m = (k - 2) as f64;
    let rho = if k == 2 {
        target / (2.0 * radius)
    } else {
        (-radius + (radius * radius + m * target).sqrt()) / m
    };
    (1..k)
        .map(|i| {
            let angle = start + sweep * i as f64 / k as f64;
            [rounded(centre[0] + rho * angle.cos()), rounded(centre[1] + rho * angle.sin())]
        })
        .collect()
}
