//! Convex prisms along a coordinate axis: what cuts and turns leave of boxes and outlines.

use super::assembly::{OutlineEdge, Solid};
use super::axes::unit;
use super::extent::{Extent, SAME_PLACE};
use super::turn::Turn;
use bracket_base::math::vec3::{V3, along, dot, sub};

/// Distance from a border within which a point lies on it \[mm\].
const ON_BORDER: f64 = 1e-6;

/// A convex polygon along an axis. Its coordinates u, v are those of the next two axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Axis, 0 = x.
    pub axis: usize,
    /// Extent along it \[mm\].
    pub span: [f64; 2],
    /// Corners, counter-clockwise when seen from the tip of the axis \[mm\].
    pub polygon: Vec<[f64; 2]>,
}

impl Block {
    /// A box as a block along an axis.
    pub fn of(extent: &Extent, axis: usize) -> Self {
        let (u, v) = (extent[(axis + 1) % 3], extent[(axis + 2) % 3]);
        let polygon = vec![[u[0], v[0]], [u[1], v[0]], [u[1], v[1]], [u[0], v[1]]];
        Self { axis, span: extent[axis], polygon }
    }

    /// Convex blocks of an outline, counter-clockwise, without crossing edges: its triangles.
    pub fn triangles(axis: usize, span: [f64; 2], outline: &[[f64; 2]]) -> Vec<Self> {
        let mut left: Vec<[f64; 2]> = outline.to_vec();
        let mut out = Vec::new();
        while left.len() > 3 {
            let n = left.len();
            let ear = (0..n).find(|&i| {
                let [a, b, c] = [left[(i + n - 1) % n], left[i], left[(i + 1) % n]];
                let others = (0..n).filter(|&k| k != i && k != (i + 1) % n && k != (i + n - 1) % n);
                turns(a, b, c) > 0.0 && others.map(|k| left[k]).all(|p| !covers([a, b, c], p))
            });
            // an outline without crossing edges always has one
            let i = ear.unwrap_or(0);
            let polygon = vec![left[(i + n - 1) % n], left[i], left[(i + 1) % n]];
            out.push(Self { axis, span, polygon });
            left.remove(i);
        }
        out.push(Self { axis, span, polygon: left });
        out
    }

    /// The image of a block under a turn about its own axis.
    pub fn turned(&self, turn: &Turn) -> Self {
        let k = self.axis;
        let place = |p: &[f64; 2]| {
            let mut x = [0.0; 3];
            (x[(k + 1) % 3], x[(k + 2) % 3]) = (p[0], p[1]);
            let x = turn.point(x);
            [x[(k + 1) % 3], x[(k + 2) % 3]]
        };
        Self { polygon: self.polygon.iter().map(place).collect(), ..self.clone() }
    }

    /// What is left of it without a box.
    pub fn minus(&self, cut: &Extent) -> Vec<Self> {
        let bounds = self.bounds();
        let apart = (0..3).any(|k| {
            cut[k][0] > bounds[k][1] - SAME_PLACE || cut[k][1] < bounds[k][0] + SAME_PLACE
        });
        if apart {
            return vec![self.clone()];
        }
        let (mut out, mut rest) = (Vec::new(), self.clone());
        let [low, high] = cut[self.axis];
        if low > rest.span[0] + SAME_PLACE {
            out.push(Self { span: [rest.span[0], low], ..rest.clone() });
            rest.span[0] = low;
        }
        if high < rest.span[1] - SAME_PLACE {
            out.push(Self { span: [high, rest.span[1]], ..rest.clone() });
            rest.span[1] = high;
        }
        for side in [0, 1] {
            let [low, high] = cut[(self.axis + 1 + side) % 3];
            for (at, below) in [(low, true), (high, false)] {
                let [outside, inside] = [below, !below].map(|b| half(&rest.polygon, side, at, b));
                out.extend(wide(outside).map(|polygon| Self { polygon, ..rest.clone() }));
                match wide(inside) {
                    Some(polygon) => rest.polygon = polygon,
                    None => return out,
                }
            }
        }
        out
    }

    /// What of it is inside a box.
    pub fn within(&self, window: &Extent) -> Option<Self> {
        let [a, b] = self.span;
        let [c, d] = window[self.axis];
        let span = [a.max(c), b.min(d)];
        let mut polygon = self.polygon.clone();
        for side in [0, 1] {
            let [low, high] = window[(self.axis + 1 + side) % 3];
            polygon = half(&half(&polygon, side, low, false), side, high, true);
        }
        (span[0] < span[1]).then_some(())?;
        Some(Self { axis: self.axis, span, polygon: wide(polygon)? })
    }

    /// Distance from a point inside it or on its border to where it ends along axis `k`, in the
    /// direction of `sign`; `None` outside \[mm\].
    pub fn reach(&self, from: V3, k: usize, sign: f64) -> Option<f64> {
        let at = from[self.axis];
        if at < self.span[0] - ON_BORDER || at > self.span[1] + ON_BORDER {
            return None;
        }
        let p = [from[(self.axis + 1) % 3], from[(self.axis + 2) % 3]];
        let n = self.polygon.len();
        // of each edge: the length, the distance to its left
        let edges = (0..n).map(|i| {
            let (a, b) = (self.polygon[i], self.polygon[(i + 1) % n]);
            let length = (b[0] - a[0]).hypot(b[1] - a[1]);
            let direction = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
            (direction, turns(a, b, p) / length)
        });
        let mut least = match k == self.axis {
            true if sign > 0.0 => self.span[1] - at,
            true => at - self.span[0],
            false => f64::INFINITY,
        };
        for (direction, inside) in edges {
            if inside < -ON_BORDER {
                return None;
            }
            if k != self.axis {
                // the speed at which the way along the axis nears the edge
                let side = (k + 3 - self.axis) % 3 - 1;
                let speed = sign * if side == 0 { direction[1] } else { -direction[0] };
                if speed > 1e-12 {
                    least = least.min(inside / speed);
                }
            }
        }
        Some(least.max(0.0))
    }

    /// True if it is a box along the axes of the joint.
    pub fn is_box(&self) -> bool {
        let b = self.bounds();
        let on = |p: &[f64; 2]| {
            let ends = [b[(self.axis + 1) % 3], b[(self.axis + 2) % 3]];
            (0..2).all(|side| ends[side].contains(&p[side]))
        };
        self.polygon.len() == 4 && self.polygon.iter().all(on)
    }

    /// The box round it.
    pub fn bounds(&self) -> Extent {
        let mut out = [[0.0; 2]; 3];
        out[self.axis] = self.span;
        for side in [0, 1] {
            let all = self.polygon.iter().map(|p| p[side]);
            let ends =
                all.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
            out[(self.axis + 1 + side) % 3] = ends;
        }
        out
    }

    /// Its corners \[mm\]: those of one end, then those of the other.
    pub fn corners(&self) -> Vec<V3> {
        let k = self.axis;
        let place = |at: f64| {
            self.polygon.iter().map(move |p| {
                let mut x = [0.0; 3];
                (x[k], x[(k + 1) % 3], x[(k + 2) % 3]) = (at, p[0], p[1]);
                x
            })
        };
        place(self.span[0]).chain(place(self.span[1])).collect()
    }

    /// Points that span what of it lies between two planes across `normal`, given by their
    /// distances from the origin \[mm\].
    pub fn between(&self, normal: V3, [low, high]: [f64; 2]) -> Vec<V3> {
        let corners = self.corners();
        let n = self.polygon.len();
        let edges = (0..n).flat_map(|i| [[i, (i + 1) % n], [n + i, n + (i + 1) % n], [i, n + i]]);
        let mut out: Vec<V3> = Vec::new();
        for [a, b] in edges {
            let (p, q) = (corners[a], corners[b]);
            let (s, t) = (dot(p, normal), dot(q, normal));
            out.extend([(p, s), (q, t)].iter().filter(|e| low <= e.1 && e.1 <= high).map(|e| e.0));
            for at in [low, high] {
                if (s - at) * (t - at) < 0.0 {
                    out.push(along(p, (at - s) / (t - s), sub(q, p)));
                }
            }
        }
        out
    }

    /// The block as a solid.
    pub fn solid(&self) -> Solid {
        prism(self.axis, self.span, &self.polygon)
    }
}

/// The prism of an outline, counter-clockwise, along an axis.
pub fn prism(axis: usize, span: [f64; 2], outline: &[[f64; 2]]) -> Solid {
    let n = outline.len();
    let edges = (1..=n).map(|i| OutlineEdge::Line { to: outline[i % n] }).collect();
    extruded(axis, span, [0.0; 3], outline[0], edges)
}

/// An outline on the next two axes about `origin`, extruded over `span` along an axis.
pub fn extruded(
    axis: usize,
    span: [f64; 2],
    mut origin: [f64; 3],
    start: [f64; 2],
    edges: Vec<OutlineEdge>,
) -> Solid {
    origin[axis] = span[0];
    let [u, v] = [1, 2].map(|k| unit((axis + k) % 3));
    Solid::Prism { origin, u, v, start, edges, length: span[1] - span[0] }
}

/// Twice the area of an outline \[mm²\], positive where it runs counter-clockwise.
pub fn twice_area(outline: &[[f64; 2]]) -> f64 {
    let n = outline.len();
    let of = |i: usize| {
        let (a, b) = (outline[i], outline[(i + 1) % n]);
        a[0] * b[1] - b[0] * a[1]
    };
    (0..n).map(of).sum()
}

/// True if two edges of an outline cross or touch, but for neighbours in their corner.
pub fn crosses_itself(outline: &[[f64; 2]]) -> bool {
    let n = outline.len();
    let edge = |i: usize| [outline[i], outline[(i + 1) % n]];
    (0..n).any(|i| {
        (i + 1..n).filter(|j| (j + 1) % n != i && *j != i + 1).any(|j| {
            let ([a, b], [c, d]) = (edge(i), edge(j));
            let across =
                turns(a, b, c) * turns(a, b, d) < 0.0 && turns(c, d, a) * turns(c, d, b) < 0.0;
            across || on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)
        })
    })
}

/// Twice the area of a triangle, positive counter-clockwise.
fn turns(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

/// True if a point lies on a straight edge.
fn on(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> bool {
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    let along = (0..2).map(|i| (b[i] - a[i]) * (p[i] - a[i])).sum::<f64>() / length;
    turns(a, b, p).abs() <= ON_BORDER * length && (-ON_BORDER..=length + ON_BORDER).contains(&along)
}

/// True if a triangle, counter-clockwise, holds a point or has it on its border.
fn covers([a, b, c]: [[f64; 2]; 3], p: [f64; 2]) -> bool {
    turns(a, b, p) >= 0.0 && turns(b, c, p) >= 0.0 && turns(c, a, p) >= 0.0
}

/// The part of a convex polygon below or above a coordinate.
fn half(polygon: &[[f64; 2]], side: usize, at: f64, below: bool) -> Vec<[f64; 2]> {
    let depth = |p: [f64; 2]| if below { at - p[side] } else { p[side] - at };
    let mut out = Vec::new();
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        let (a, b) = (depth(p), depth(q));
        if a >= 0.0 {
            out.push(p);
        }
        if a * b < 0.0 {
            let f = a / (a - b);
            out.push([p[0] + f * (q[0] - p[0]), p[1] + f * (q[1] - p[1])]);
        }
    }
    out
}

/// A polygon that is wider than rounding in every direction.
fn wide(polygon: Vec<[f64; 2]>) -> Option<Vec<[f64; 2]>> {
    let length = |side: usize| {
        let all = polygon.iter().map(|p| p[side]);
        all.clone().fold(f64::NEG_INFINITY, f64::max) - all.fold(f64::INFINITY, f64::min)
    };
    let area = twice_area(&polygon);
    (polygon.len() > 2 && area > SAME_PLACE * length(0).max(length(1))).then_some(polygon)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(blocks: &[Block]) -> f64 {
        blocks.iter().map(|b| 0.5 * twice_area(&b.polygon) * (b.span[1] - b.span[0])).sum()
    }

    /// A flange that slopes by 10° and is cut at x = 20: the trapezoid left has the mean length of
    /// its two edges, L − 20/cos 10° along the axis.
    #[test]
    fn a_turned_bar_is_cut_by_a_plane() {
        let turn = Turn { axis: 1, angle: -10f64.to_radians(), at: [0.0; 3] };
        let bar = Block::of(&[[0.0, 400.0], [-90.0, 90.0], [-7.0, 7.0]], 1).turned(&turn);
        let left = bar.minus(&[[-900.0, 20.0], [-900.0, 900.0], [-900.0, 900.0]]);
        let exact = 180.0 * 14.0 * (400.0 - 20.0 / 10f64.to_radians().cos());
        assert!((area(&left) - exact).abs() < 1e-6 * exact, "{}", area(&left));
        assert!(left.iter().all(|b| b.bounds()[0][0] > 20.0 - 1e-9));
        assert_eq!(bar.minus(&[[-900.0, -60.0], [-900.0, 900.0], [-900.0, 900.0]]).len(), 1);
    }

    /// A hole in a plate leaves its area around it; a box that ends inside the thickness too.
    #[test]
    fn a_box_inside_a_block_is_left_free() {
        let plate = Block::triangles(1, [-5.0, 5.0], &[[0.0, 0.0], [0.0, 300.0], [200.0, 0.0]]);
        assert_eq!(plate.len(), 1);
        // u is z, v is x for the axis y; this triangle runs clockwise
        assert!(twice_area(&plate[0].polygon) < 0.0);
        let plate = Block::triangles(1, [-5.0, 5.0], &[[0.0, 0.0], [200.0, 0.0], [0.0, 300.0]]);
        let hole = [[40.0, 60.0], [-9.0, 9.0], [30.0, 50.0]];
        assert!((area(&plate[0].minus(&hole)) - 10.0 * (30_000.0 - 400.0)).abs() < 1e-6);
        let pocket = [[40.0, 60.0], [0.0, 9.0], [30.0, 50.0]];
        let left = area(&plate[0].minus(&pocket));
        assert!((left - 10.0 * 30_000.0 + 5.0 * 400.0).abs() < 1e-6, "{left}");
    }

    /// An L and a star-like outline: the triangles have its area and none reaches beyond it.
    #[test]
    fn outlines_with_notches_are_cut_into_triangles() {
        let l = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
        let blocks = Block::triangles(0, [0.0, 2.0], &l);
        assert_eq!(blocks.len(), 4);
        assert!((area(&blocks) - 2.0 * 6.0).abs() < 1e-12);
        assert!(blocks.iter().all(|b| twice_area(&b.polygon) > 0.0));
        assert!(!crosses_itself(&l));
        assert!(crosses_itself(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0], [4.0, 3.0]]));
        // a corner on an edge; two edges of a notch on one line
        assert!(crosses_itself(&[[0.0, 0.0], [4.0, 0.0], [2.0, 0.0], [2.0, 3.0]]));
        assert!(!crosses_itself(&[
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 2.0],
            [3.0, 2.0],
            [2.0, 1.0],
            [1.0, 2.0],
            [0.0, 2.0]
        ]));
    }
}
