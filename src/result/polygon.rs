//! The capacity polygon of two actions: inner and outer hull from the bounds of several directions,
//! as data, table and drawing.
//!
//! Inner: loads that an admissible stress carries form a convex set (a mean of two admissible
//! stresses is admissible, and carries the mean of their loads), so the hull of the strict lower
//! points belongs to it. Outer: the mechanism of every direction bounds a half plane, and what can
//! be carried lies in all of them.

use crate::math::convex::{HalfPlane, bounded, clip, hull};
use crate::report::draw::axes::Axes;
use crate::report::draw::svg::{Anchor, Drawing, LINE, Pen};
use crate::report::figures::{Rounding, significant};
use crate::report::markdown::page::Table;
use crate::report::markdown::text::{heading, inline, paragraph, strings, table};
use crate::result::data::ResultFile;
use crate::result::demand::ActionValue;
use serde::{Deserialize, Serialize};

/// What two actions at a member's end are carried of together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CapacityPolygon {
    /// Member end: `beam_right`.
    pub end: String,
    /// The point the actions refer to: `column_face`.
    pub at: String,
    /// The two axes.
    pub axes: [Axis; 2],
    /// What was found, direction by direction.
    pub points: Vec<Point>,
    /// Corners of what is carried at least, turning from the first axis to the second \[N, N mm\].
    pub inner: Vec<[f64; 2]>,
    /// Corners of what is carried at most, likewise; where it is not bounded, those there are.
    pub outer: Vec<[f64; 2]>,
    /// False where no mechanism was found that bounds some direction.
    pub outer_bounded: bool,
}

/// An axis of a polygon.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// `N`, `Vy`, `Vz`, `T`, `My` or `Mz`.
    pub action: String,
    /// Its unit: what directions and half planes count it in.
    pub unit: ActionValue,
}

/// The bounds of one direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Its load case.
    pub case: String,
    /// Both actions at load factor 1, in their units.
    pub direction: [f64; 2],
    /// Strict lower bound of the load factor, with friction that without it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Strict upper bound of it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<f64>,
    /// What the mechanism bounds, in the units of the axes: the normal is the powers of the two
    /// units over the power of the direction, the offset the upper bound.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub half_plane: Option<HalfPlane>,
}

impl Point {
    fn at(&self, factor: f64) -> [f64; 2] {
        self.direction.map(|d| factor * d)
    }
}

/// How far corners may lie, in the largest bound found: beyond, nothing bounds them worth the name.
const FAR: f64 = 1e3;

/// Inner hull, outer hull and whether that is bounded, in units of the axes.
fn hulls(points: &[Point]) -> (Vec<[f64; 2]>, Vec<[f64; 2]>, bool) {
    let mut carried: Vec<[f64; 2]> = points.iter().filter_map(|p| Some(p.at(p.lower?))).collect();
    // without loads nothing is needed
    carried.push([0.0; 2]);
    let planes: Vec<HalfPlane> = points.iter().filter_map(|p| p.half_plane).collect();
    let largest = points
        .iter()
        .flat_map(|p| [p.lower, p.upper])
        .flatten()
        .fold(0.0f64, |m, x| m.max(x.abs()));
    let reach = FAR * if largest > 0.0 { largest } else { 1.0 };
    let far = |c: &[f64; 2]| c.iter().any(|x| x.abs() >= 0.999 * reach);
    let corners = clip(&frame([reach; 2]), &planes);
    let closed = bounded(&planes) && !corners.iter().any(far);
    (hull(&carried), hull(&corners.into_iter().filter(|c| !far(c)).collect::<Vec<_>>()), closed)
}

/// The corners of a rectangle around the origin, turning left.
fn frame([x, y]: [f64; 2]) -> [[f64; 2]; 4] {
    [[-x, -y], [x, -y], [x, y], [-x, y]]
}

impl CapacityPolygon {
    /// The hulls of what was found.
    pub fn new([end, at]: [String; 2], axes: [Axis; 2], points: Vec<Point>) -> Self {
        let (inner, outer, outer_bounded) = hulls(&points);
        let units = axes.each_ref().map(|a| a.unit.value());
        let scaled = |corners: Vec<[f64; 2]>| {
            corners.into_iter().map(|c| [c[0] * units[0], c[1] * units[1]]).collect()
        };
        Self { end, at, axes, points, inner: scaled(inner), outer: scaled(outer), outer_bounded }
    }
}

/// The section of the report; nothing without a polygon.
pub(crate) fn section(page: &mut String, result: &ResultFile) {
    let Some(polygon) = &result.polygon else { return };
    let [first, second] = &polygon.axes;
    heading(page, &format!("Capacity in {} and {}", first.action, second.action));
    paragraph(
        page,
        &format!(
            "{} and {} on {} at {} together. The hull of the inner points is carried: stresses \
             that carry two loads carry every mean of them. What lies outside the outer hull is \
             not: the mechanism of every direction bounds a half plane, not only its own load.{}",
            first.action,
            second.action,
            inline(&polygon.end),
            inline(&polygon.at),
            if polygon.outer_bounded {
                ""
            } else {
                " Not every side has such a bound: the outer hull is open."
            }
        ),
    );
    let shown = |axis: &Axis, factor: Option<f64>, part: f64, rounding: Rounding| {
        let size = |f: f64| significant(f * part.abs() * axis.unit.shown().0, 4, rounding);
        let sign = if part < 0.0 { "−" } else { "" };
        factor.map_or("–".into(), |f| {
            if part == 0.0 { "0".into() } else { format!("{sign}{}", size(f)) }
        })
    };
    let rows = polygon.points.iter().map(|p| {
        let at = |bound, rounding| {
            [0, 1].map(|k| shown(&polygon.axes[k], bound, p.direction[k], rounding))
        };
        let ([a, b], [c, d]) = (
            at(p.lower.map(f64::next_down), Rounding::Down),
            at(p.upper.map(f64::next_up), Rounding::Up),
        );
        vec![p.case.clone(), a, b, c, d]
    });
    let name =
        |axis: &Axis, what: &str| format!("{} {what} [{}]", axis.action, axis.unit.shown().1);
    let mut columns = strings(["direction"]);
    for what in ["at least", "at most"] {
        columns.extend(polygon.axes.iter().map(|a| name(a, what)));
    }
    table(page, &Table { columns, rows: rows.collect() });
}

/// The plot as SVG text.
pub fn drawing(polygon: &CapacityPolygon) -> String {
    let scales = polygon.axes.each_ref().map(|a| a.unit.shown().0 / a.unit.value());
    let show = |c: &[f64; 2]| [c[0] * scales[0], c[1] * scales[1]];
    let units = polygon.axes.each_ref().map(|a| a.unit.shown().0);
    let points = |bound: fn(&Point) -> Option<f64>| -> Vec<[f64; 2]> {
        let at = |p: &Point| Some(p.at(bound(p)?));
        polygon.points.iter().filter_map(at).map(|c| [c[0] * units[0], c[1] * units[1]]).collect()
    };
    let (lower, upper) = (points(|p| p.lower), points(|p| p.upper));
    let inner: Vec<[f64; 2]> = polygon.inner.iter().map(show).collect();
    let corners: Vec<[f64; 2]> = polygon.outer.iter().map(show).collect();
    // open sides leave the frame, far corners as well
    let seen = lower.iter().chain(&upper).chain(&inner);
    let mut reach = seen.fold([0.0f64; 2], |r, c| [r[0].max(c[0].abs()), r[1].max(c[1].abs())]);
    for c in &corners {
        (0..2).for_each(|k| reach[k] = reach[k].max(c[k].abs().min(1.5 * reach[k])));
    }
    let axes = Axes::new(reach);
    let (reach, at) = (axes.reach(), |c: [f64; 2]| axes.at(c));
    let mut d = Drawing::default();
    let planes: Vec<HalfPlane> = polygon.points.iter().filter_map(|p| p.half_plane).collect();
    let outer: Vec<[f64; 2]> = clip(&frame([reach[0] / units[0], reach[1] / units[1]]), &planes)
        .into_iter()
        .map(|c| at([c[0] * units[0], c[1] * units[1]]))
        .collect();
    d.polygon(Pen::Edge, "#fde0c5", &outer);
    d.polygon(Pen::Edge, "#bfe3c0", &inner.iter().map(|c| at(*c)).collect::<Vec<_>>());
    let names = polygon.axes.each_ref().map(|a| format!("{} [{}]", a.action, a.unit.shown().1));
    let [legend, top] = axes.draw(&mut d, names.each_ref().map(String::as_str));
    for c in &lower {
        d.circle(Pen::Edge, "#2e7d32", at(*c), 3.0);
    }
    for c in &upper {
        d.circle(Pen::Edge, "#ffffff", at(*c), 3.0);
    }
    let open = if polygon.outer_bounded { "" } else { ", open" };
    let lines = [
        ("#bfe3c0", "carried (hull of lower bounds)".to_string()),
        ("#fde0c5", format!("undecided, within the outer hull{open}")),
    ];
    for (i, (fill, text)) in lines.iter().enumerate() {
        let y = top + (2.0 + 1.5 * i as f64) * LINE;
        d.rectangle(Pen::Edge, fill, [legend, y], [legend + 22.0, y + 12.0]);
        d.text([legend + 30.0, y + 6.0], Anchor::Start, text);
    }
    for (i, (fill, text)) in
        [("#2e7d32", "lower bound of a direction"), ("#ffffff", "upper bound of a direction")]
            .iter()
            .enumerate()
    {
        let y = top + (5.5 + 1.5 * i as f64) * LINE;
        d.circle(Pen::Edge, fill, [legend + 11.0, y], 3.0);
        d.text([legend + 30.0, y], Anchor::Start, text);
    }
    d.finish(&format!("Capacity in {} and {}", polygon.axes[0].action, polygon.axes[1].action))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four directions of a structure that carries the square |x| ≤ 1, |y| ≤ 1 exactly.
    fn square(bounds: bool) -> CapacityPolygon {
        let axes = [
            Axis { action: "My".into(), unit: ActionValue::Moment(1e8) },
            Axis { action: "N".into(), unit: ActionValue::Force(2e5) },
        ];
        let points = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]
            .into_iter()
            .enumerate()
            .map(|(k, direction)| Point {
                case: format!("polygon_{}", 90 * k),
                direction,
                lower: Some(0.9),
                upper: Some(1.1),
                half_plane: (bounds || k != 2)
                    .then_some(HalfPlane { normal: direction, offset: 1.1 }),
            });
        CapacityPolygon::new(["beam_right".into(), "column_face".into()], axes, points.collect())
    }

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
    fn a_side_without_a_mechanism_is_open_and_said_so() {
        let polygon = square(false);
        assert_eq!((polygon.outer.len(), polygon.outer_bounded), (2, false));
        assert!(drawing(&polygon).contains("open"));
    }

    #[test]
    fn the_plot_has_both_hulls_all_points_and_its_scales() {
        for polygon in [square(true), square(false)] {
            let svg = drawing(&polygon);
            assert_eq!(svg.matches("<polygon").count(), 2);
            assert_eq!(svg.matches("<circle").count(), 8 + 2);
            for part in ["My [kN m]", "N [kN]", ">100<", ">−200<"] {
                assert!(svg.contains(part), "{part}: {svg}");
            }
        }
    }
}
