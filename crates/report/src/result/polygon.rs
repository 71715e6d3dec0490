//! The capacity polygon of two actions: inner and outer hull, from the bounds of several
//! directions.
//!
//! Inner hull: the loads in equilibrium with admissible stresses form a convex set, because a
//! weighted mean of two admissible stresses is admissible and in equilibrium with the mean of their
//! loads. The hull of the strict lower points is therefore part of the set. Outer hull: the
//! mechanism of each direction bounds a half plane, and every load that can be carried lies in all
//! of them.

use crate::result::demand::ActionValue;
use bracket_base::math::convex::{HalfPlane, bounded, clip, hull};
use serde::{Deserialize, Serialize};

/// Capacity of a joint under two actions at a member end.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CapacityPolygon {
    /// Member end: `beam_right`.
    pub end: String,
    /// The point the actions refer to: `column_face`.
    pub at: String,
    /// The two axes.
    pub axes: [Axis; 2],
    /// The bounds of each direction.
    pub points: Vec<Point>,
    /// Corners of the inner hull \[N, N mm\], in the sense of rotation from the first axis to the
    /// second.
    pub inner: Vec<[f64; 2]>,
    /// Corners of the outer hull, in the same form. If the hull is open, its finite corners.
    pub outer: Vec<[f64; 2]>,
    /// False if no mechanism bounds some direction.
    pub outer_bounded: bool,
}

/// An axis of a polygon.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// `N`, `Vy`, `Vz`, `T`, `My` or `Mz`.
    pub action: String,
    /// Its unit in directions and half planes.
    pub unit: ActionValue,
}

/// The bounds of one direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Name of its load case.
    pub case: String,
    /// Both actions at load factor 1, in their units.
    pub direction: [f64; 2],
    /// Strict lower bound of the load factor; with friction, the bound without friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Strict upper bound of the load factor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<f64>,
    /// Half plane bounded by the mechanism, in the units of the axes. The components of its normal
    /// are the powers of the two unit actions, divided by the power of the direction. Its offset is
    /// the upper bound.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub half_plane: Option<HalfPlane>,
}

impl Point {
    /// Both actions at a load factor, in their units.
    pub(crate) fn at(&self, factor: f64) -> [f64; 2] {
        self.direction.map(|d| factor * d)
    }
}

/// Largest distance of a corner, in multiples of the largest bound. Corners farther away count as
/// unbounded.
const FAR: f64 = 1e3;

/// Inner hull, outer hull and whether the outer hull is bounded, in units of the axes.
fn hulls(points: &[Point]) -> (Vec<[f64; 2]>, Vec<[f64; 2]>, bool) {
    let mut carried: Vec<[f64; 2]> = points.iter().filter_map(|p| Some(p.at(p.lower?))).collect();
    // zero load is always carried
    carried.push([0.0; 2]);
    let planes: Vec<HalfPlane> = points.iter().filter_map(|p| p.half_plane).collect();
    let largest = points
        .iter()
        .flat_map(|p| [p.lower, p.upper])
        .flatten()
        .fold(0.0f64, |m, x| m.max(x.abs()));
    let reach = FAR * if largest > 0.0 { largest } else { 1.0 };
    let far = |c: &[f64; 2]| c.iter().any(|x| x.abs() >= 0.999 * reach);
    let corners = clip(&rectangle([reach; 2]), &planes);
    let closed = bounded(&planes) && !corners.iter().any(far);
    (hull(&carried), hull(&corners.into_iter().filter(|c| !far(c)).collect::<Vec<_>>()), closed)
}

/// The corners of a rectangle around the origin, counter-clockwise.
pub(crate) fn rectangle([x, y]: [f64; 2]) -> [[f64; 2]; 4] {
    [[-x, -y], [x, -y], [x, y], [-x, y]]
}

impl CapacityPolygon {
    /// The polygon with the hulls of the points.
    pub fn new([end, at]: [String; 2], axes: [Axis; 2], points: Vec<Point>) -> Self {
        let (inner, outer, outer_bounded) = hulls(&points);
        let units = axes.each_ref().map(|a| a.unit.value());
        let scaled = |corners: Vec<[f64; 2]>| {
            corners.into_iter().map(|c| [c[0] * units[0], c[1] * units[1]]).collect()
        };
        Self { end, at, axes, points, inner: scaled(inner), outer: scaled(outer), outer_bounded }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::result::fixtures::square;

    #[test]
    fn inner_points_make_a_diamond_and_mechanisms_a_square() {
        let polygon = square(true);
        assert_eq!((polygon.inner.len(), polygon.outer.len(), polygon.outer_bounded), (4, 4, true));
        let near = |c: &[f64; 2], x: f64, y: f64| {
            (c[0] - x * 1e8).abs() < 1.0 && (c[1] - y * 2e5).abs() < 1e-3
        };
        assert!(
            polygon.inner.iter().any(|c| near(c, 0.9, 0.0))
                && polygon.outer.iter().any(|c| near(c, 1.1, -1.1))
        );
        let json = serde_json::to_string(&polygon).expect("plain data");
        assert_eq!(serde_json::from_str::<CapacityPolygon>(&json).expect("reads back"), polygon);
    }

    #[test]
    fn a_side_without_a_mechanism_is_open() {
        let polygon = square(false);
        assert_eq!((polygon.outer.len(), polygon.outer_bounded), (2, false));
    }
}
