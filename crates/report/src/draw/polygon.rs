//! The plot of a capacity polygon.

use crate::draw::axes::Axes;
use crate::draw::svg::{Anchor, Drawing, LINE, Pen, Svg};
use crate::result::polygon::{Axis, CapacityPolygon, Point, rectangle};
use bracket_base::math::convex::{HalfPlane, clip};
use bracket_base::say;
use bracket_base::words::Text;

/// The plot; `code`: corners N, My \[N, N mm\] of what the code allows, drawn where these are the
/// axes.
pub fn drawing(polygon: &CapacityPolygon, code: Option<&[[f64; 2]]>) -> Svg {
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
    let place = |action: &str| polygon.axes.iter().position(|a| a.action == action);
    let code: Vec<[f64; 2]> = match (code, place("N"), place("My")) {
        (Some(corners), Some(n), Some(_)) => {
            corners.iter().map(|c| show(&[c[n], c[1 - n]])).collect()
        }
        _ => Vec::new(),
    };
    // open sides extend beyond the frame, and so do far corners
    let seen = lower.iter().chain(&upper).chain(&inner).chain(&code);
    let mut reach = seen.fold([0.0f64; 2], |r, c| [r[0].max(c[0].abs()), r[1].max(c[1].abs())]);
    for c in &corners {
        (0..2).for_each(|k| reach[k] = reach[k].max(c[k].abs().min(1.5 * reach[k])));
    }
    let axes = Axes::new(reach);
    let (reach, at) = (axes.reach(), |c: [f64; 2]| axes.at(c));
    let mut d = Drawing::default();
    let planes: Vec<HalfPlane> = polygon.points.iter().filter_map(|p| p.half_plane).collect();
    let outer: Vec<[f64; 2]> =
        clip(&rectangle([reach[0] / units[0], reach[1] / units[1]]), &planes)
            .into_iter()
            .map(|c| at([c[0] * units[0], c[1] * units[1]]))
            .collect();
    d.polygon(Pen::Edge, "#fde0c5", &outer);
    d.polygon(Pen::Edge, "#bfe3c0", &inner.iter().map(|c| at(*c)).collect::<Vec<_>>());
    if !code.is_empty() {
        d.polygon(Pen::Action, "none", &code.iter().map(|c| at(*c)).collect::<Vec<_>>());
    }
    let name = |a: &Axis| Text::given(format!("{} [{}]", a.action, a.unit.shown().1));
    let [legend, top] = axes.draw(&mut d, polygon.axes.each_ref().map(name));
    for c in &lower {
        d.circle(Pen::Edge, "#2e7d32", at(*c), 3.0);
    }
    for c in &upper {
        d.circle(Pen::Edge, "#ffffff", at(*c), 3.0);
    }
    let outer = match polygon.outer_bounded {
        true => "undecided, within the outer hull",
        false => "undecided, within the outer hull, open",
    };
    let lines = [("#bfe3c0", "carried (hull of lower bounds)"), ("#fde0c5", outer)];
    for (i, (fill, text)) in lines.into_iter().enumerate() {
        let y = top + (2.0 + 1.5 * i as f64) * LINE;
        d.rectangle(Pen::Edge, fill, [legend, y], [legend + 22.0, y + 12.0]);
        d.text([legend + 30.0, y + 6.0], Anchor::Start, text);
    }
    for (i, (fill, text)) in
        [("#2e7d32", "lower bound of a direction"), ("#ffffff", "upper bound of a direction")]
            .into_iter()
            .enumerate()
    {
        let y = top + (5.5 + 1.5 * i as f64) * LINE;
        d.circle(Pen::Edge, fill, [legend + 11.0, y], 3.0);
        d.text([legend + 30.0, y], Anchor::Start, text);
    }
    if !code.is_empty() {
        let y = top + 8.5 * LINE;
        d.line(Pen::Action, [legend, y], [legend + 22.0, y]);
        d.text([legend + 30.0, y], Anchor::Start, "allowed by the code");
    }
    let [a, b] = &polygon.axes;
    d.finish(say!("Capacity in {} and {}", &a.action, &b.action))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::result::fixtures::square;

    #[test]
    fn an_open_side_is_named() {
        let polygon = square(false);
        assert!(drawing(&polygon, None).file.contains("open"));
    }

    /// The axes of the polygon are My and N; the corners of the code come as N and My.
    #[test]
    fn the_code_is_drawn_on_its_own_axes() {
        let mut polygon = square(true);
        let code = [[2e5, 0.0], [0.0, 1e8], [-2e5, 0.0]];
        let points = |svg: String| {
            let (_, last) = svg.rsplit_once("<polygon points=\"").expect("a polygon");
            last.split_once('"').expect("an end").0.to_owned()
        };
        let hull = points(drawing(&polygon, None).file);
        let drawn = points(drawing(&polygon, Some(&code)).file);
        let xy: Vec<Vec<f64>> = drawn
            .split(' ')
            .map(|p| p.split(',').map(|x| x.parse().expect("a number")).collect())
            .collect();
        assert!(xy[1][0] > xy[0][0] && xy[0][0] == xy[2][0] && xy[0][1] < xy[2][1], "{drawn}");
        polygon.axes[0].action = "Vz".into();
        assert_eq!(points(drawing(&polygon, Some(&code)).file), hull);
    }

    #[test]
    fn the_plot_has_both_hulls_all_points_and_its_scales() {
        for polygon in [square(true), square(false)] {
            let svg = drawing(&polygon, None).file;
            assert_eq!(svg.matches("<polygon").count(), 2);
            assert_eq!(svg.matches("<circle").count(), 8 + 2);
            for part in ["My [kN m]", "N [kN]", ">100<", ">−200<"] {
                assert!(svg.contains(part), "{part}: {svg}");
            }
        }
    }
}
