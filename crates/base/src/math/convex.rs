//! Convex polygons in the plane: convex hull of points, intersection of half planes.

use serde::{Deserialize, Serialize};

/// A half plane `normal · x ≤ offset`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct HalfPlane {
    /// Outward normal, of any length.
    pub normal: [f64; 2],
    /// Offset, in units of the length of the normal.
    pub offset: f64,
}

impl HalfPlane {
    /// Distance of a point outside the half plane, in units of the length of the normal; negative
    /// inside.
    pub fn outside(&self, x: [f64; 2]) -> f64 {
        self.normal[0] * x[0] + self.normal[1] * x[1] - self.offset
    }
}

/// Twice the signed area of the triangle a, b, c; positive if the corners run anticlockwise.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Corners of the convex hull of the points, anticlockwise, starting with the leftmost corner (the
/// lowest if there are several). Points on the sides of the hull are left out.
///
/// # Source
/// Andrew's monotone chain.
pub fn hull(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let chain = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut out: Vec<[f64; 2]> = Vec::new();
        for p in points {
            while out.len() > 1 && turn(out[out.len() - 2], out[out.len() - 1], p) <= 0.0 {
                out.pop();
            }
            out.push(p);
        }
        out.pop();
        out
    };
    let mut out = chain(&mut sorted.iter().copied());
    out.extend(chain(&mut sorted.iter().rev().copied()));
    out
}

/// Intersection of a convex polygon with all half planes, in the same sense of rotation. May be
/// empty.
pub fn clip(polygon: &[[f64; 2]], half_planes: &[HalfPlane]) -> Vec<[f64; 2]> {
    let mut left = polygon.to_vec();
    for plane in half_planes {
        let mut next = Vec::with_capacity(left.len() + 1);
        for (i, &p) in left.iter().enumerate() {
            let q = left[(i + 1) % left.len()];
            let (a, b) = (plane.outside(p), plane.outside(q));
            if a <= 0.0 {
                next.push(p);
            }
            if (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0) {
                let t = a / (a - b);
                next.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
            }
        }
        left = next;
    }
    left
}

/// True if the intersection of the half planes is bounded: every gap between the directions of
/// their normals is smaller than half a turn.
pub fn bounded(half_planes: &[HalfPlane]) -> bool {
    let mut angles: Vec<f64> = half_planes
        .iter()
        .filter(|h| h.normal != [0.0; 2])
        .map(|h| h.normal[1].atan2(h.normal[0]))
        .collect();
    angles.sort_by(f64::total_cmp);
    let Some((first, last)) = angles.first().zip(angles.last()) else { return false };
    let around = first + 2.0 * std::f64::consts::PI - last;
    let widest = angles.windows(2).map(|w| w[1] - w[0]).fold(around, f64::max);
    // a gap of almost half a turn leaves a strip that is unbounded for practical purposes
    widest < std::f64::consts::PI - 1e-6
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(a: f64) -> [[f64; 2]; 4] {
        [[-a, -a], [a, -a], [a, a], [-a, a]]
    }

    #[test]
    fn the_hull_of_points_turns_left_without_those_inside_or_on_its_sides() {
        let mut points = square(2.0).to_vec();
        points.extend([[0.0, 0.0], [1.0, -2.0], [2.0, 2.0], [-2.0, 0.0]]);
        assert_eq!(hull(&points), square(2.0));
        assert_eq!(hull(&[[1.0, 1.0], [1.0, 1.0]]), [[1.0, 1.0]]);
        assert_eq!(hull(&[[0.0, 0.0], [2.0, 2.0], [1.0, 1.0]]), [[0.0, 0.0], [2.0, 2.0]]);
    }

    #[test]
    fn half_planes_cut_a_regular_octagon_out_of_a_square() {
        let planes: Vec<HalfPlane> = (0..8)
            .map(|k| {
                let (s, c) = (0.25 * f64::from(k) * std::f64::consts::PI).sin_cos();
                HalfPlane { normal: [3.0 * c, 3.0 * s], offset: 3.0 }
            })
            .collect();
        let octagon = clip(&square(100.0), &planes);
        assert_eq!(octagon.len(), 8);
        let circumscribed = 1.0 / (std::f64::consts::PI / 8.0).cos();
        octagon.iter().for_each(|[x, y]| assert!((x.hypot(*y) - circumscribed).abs() < 1e-12));
        assert!(
            bounded(&planes)
                && !bounded(&planes[..4])
                && !bounded(&planes[..5])
                && bounded(&planes[..6])
        );
        let beyond = HalfPlane { normal: [1.0, 0.0], offset: -200.0 };
        assert!(clip(&square(100.0), &[beyond]).is_empty());
    }
}
