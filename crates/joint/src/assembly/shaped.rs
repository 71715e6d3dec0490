//! Lengths of angles, channels and hollow sections as solids, with their convex pieces, walls and
//! planes at mid-thickness.

use super::assembly::{MidPlane, OutlineEdge, Solid};
use super::axes::unit;
use super::block::{Block, extruded, twice_area};
use super::extent::Extent;
use super::facets::{flatten_outline, polygon_radius, regular_polygon};
use super::turn::Turn;
use crate::catalog::{Shape, ShapedProfile};
use bracket_base::math::vec3::V3;
use std::f64::consts::{PI, TAU};

/// Sides of the circle of a circular hollow section. A multiple of four puts corners on both axes.
const SIDES: u32 = 24;

/// A length of a section with its position in space.
#[derive(Clone, Copy, Debug)]
pub struct PlacedShape<'a> {
    /// The section.
    pub profile: &'a ShapedProfile,
    /// Axis of the member, 0 = x.
    pub along: usize,
    /// Axis of the section's depth, 0 = x.
    pub depth: usize,
    /// Extent along the axis \[mm\].
    pub span: [f64; 2],
    /// Heel of an angle, middle of the back of a channel's web, centre of a hollow section \[mm\].
    pub origin: V3,
    /// True for the axes along which legs point the other way.
    pub flip: [bool; 3],
}

/// A corner of an outline across and along the depth, with the centre of the arc that ends there.
type Corner = ([f64; 2], Option<[f64; 2]>);

/// The walls of a section that are rectangles: flanges lie across the depth, webs along it.
#[derive(Clone, Debug, Default)]
pub struct Walls {
    /// Flanges, the legs of an angle.
    pub flanges: Vec<Extent>,
    /// Webs.
    pub webs: Vec<Extent>,
    /// The sides of a circular section: slabs that are turned about the axis of the member.
    pub facets: Vec<(Extent, Turn)>,
}

impl PlacedShape<'_> {
    /// True if its walls are no plates.
    pub fn is_round(&self) -> bool {
        matches!(self.profile.shape, Shape::Chs { .. })
    }

    /// Axis across the depth.
    fn width(&self) -> usize {
        3 - self.along - self.depth
    }

    /// The coordinates of a point of the section on the next two axes after the member's, without
    /// the origin.
    fn place(&self, [w, d]: [f64; 2]) -> [f64; 2] {
        let sign = |k: usize, x: f64| if self.flip[k] { -x } else { x };
        let (w, d) = (sign(self.width(), w), sign(self.depth, d));
        if (self.along + 2) % 3 == self.depth { [w, d] } else { [d, w] }
    }

    fn prism(&self, corners: &[Corner]) -> Solid {
        let mut corners: Vec<Corner> =
            corners.iter().map(|(p, c)| (self.place(*p), c.map(|c| self.place(c)))).collect();
        let points: Vec<[f64; 2]> = corners.iter().map(|c| c.0).collect();
        if twice_area(&points) < 0.0 {
            // the arc that ended in a corner begins there now
            let arcs: Vec<_> = corners.iter().map(|c| c.1).collect();
            let n = corners.len();
            corners = (0..n).rev().map(|i| (points[i], arcs[(i + 1) % n])).collect();
        }
        let edge = |&(to, arc): &Corner| match arc {
            Some(centre) => OutlineEdge::Arc { to, centre },
            None => OutlineEdge::Line { to },
        };
        let edges = corners.iter().skip(1).chain(corners.first()).map(edge).collect();
        extruded(self.along, self.span, self.origin, corners[0].0, edges)
    }

    fn cylinder(&self, radius: f64) -> Solid {
        let mut base = self.origin;
        base[self.along] = self.span[0];
        let length = self.span[1] - self.span[0];
        Solid::Cylinder { base, axis: unit(self.along), radius, length, segments: SIDES }
    }

    /// The outer solid, and the hollow inside.
    fn solids(&self) -> (Solid, Option<Solid>) {
        match self.profile.shape {
            Shape::Angle { h, b, t, r, toe } => {
                let c = chamfer(toe);
                let corners = [
                    ([0.0, 0.0], None),
                    ([b, 0.0], None),
                    ([b, t - c], None),
                    ([b - c, t], None),
                    ([t + r, t], None),
                    ([t, t + r], Some([t + r, t + r])),
                    ([t, h - c], None),
                    ([t - c, h], None),
                    ([0.0, h], None),
                ];
                (self.prism(&distinct(&corners)), None)
            }
            Shape::Channel { h, b, tw, tf, r, toe, slope } => {
                let at = thickness_at(h, b, tw);
                // the height of a flange's inner face above the middle, at a distance from the back
                let inner = |x: f64| h / 2.0 - tf - slope * (at - x);
                // the circle that touches the web and the sloping face
                let (x, c) = (tw + r, chamfer(toe));
                let y = inner(x) - r * slope.hypot(1.0);
                let norm = slope.hypot(1.0);
                let touch = [x - r * slope / norm, y + r / norm];
                let half = [
                    ([b, h / 2.0], None),
                    ([0.0, h / 2.0], None),
                    ([tw, y], None),
                    (touch, Some([x, y])),
                    ([b - c, inner(b - c)], None),
                    ([b, inner(b) + c], None),
                ];
                let lower = |(p, a): &Corner| ([p[0], -p[1]], a.map(|a| [a[0], -a[1]]));
                // counter-clockwise from the upper toe along the back to the lower one, and
                // inside back up
                let mut corners = vec![half[0], half[1], lower(&half[1]), lower(&half[0])];
                corners.extend([half[5], half[4]].iter().map(lower));
                corners.push((lower(&half[3]).0, None));
                corners.push((lower(&half[2]).0, half[3].1.map(|a| [a[0], -a[1]])));
                corners.extend([half[2], half[3], half[4], half[5]]);
                (self.prism(&distinct(&corners)), None)
            }
            Shape::Rhs { h, b, t, outer, inner } => {
                let hollow = rounded([b / 2.0 - t, h / 2.0 - t], inner);
                let whole = rounded([b / 2.0, h / 2.0], outer);
                (self.prism(&whole), Some(self.prism(&hollow)))
            }
            Shape::Chs { d, t } => (self.cylinder(d / 2.0), Some(self.cylinder(d / 2.0 - t))),
        }
    }

    /// The section with root radii, extruded. Chamfers of the same area replace toe radii.
    pub fn solid(&self) -> Solid {
        match self.solids() {
            (whole, None) => whole,
            (whole, Some(hollow)) => Solid::Difference(vec![whole, hollow]),
        }
    }

    /// Corners of the meshed outline of a solid of [`Self::solids`] in space.
    fn polygon(&self, solid: &Solid) -> Vec<[f64; 2]> {
        // both have their corners on the next two axes
        let corners = match solid {
            Solid::Prism { start, edges, .. } => flatten_outline(*start, edges),
            Solid::Cylinder { radius, segments, .. } => regular_polygon(*radius, *segments),
            Solid::Box { .. } | Solid::Union(_) | Solid::Difference(_) => Vec::new(),
        };
        let [i, j] = [1, 2].map(|k| self.origin[(self.along + k) % 3]);
        corners.into_iter().map(|[u, v]| [i + u, j + v]).collect()
    }

    /// Convex blocks along the member that fill the section exactly as it is meshed.
    pub fn blocks(&self) -> Vec<Block> {
        let (axis, span) = (self.along, self.span);
        let (whole, hollow) = self.solids();
        let outer = self.polygon(&whole);
        let Some(inner) = hollow.map(|h| self.polygon(&h)) else {
            return Block::triangles(axis, span, &outer);
        };
        let n = outer.len();
        let side = |i: usize| vec![outer[i], outer[(i + 1) % n], inner[(i + 1) % n], inner[i]];
        (0..n).map(|i| Block { axis, span, polygon: side(i) }).collect()
    }

    /// A box of the section over the whole length.
    fn wall(&self, across: [f64; 2], deep: [f64; 2]) -> Extent {
        let mut x = [[0.0; 2]; 3];
        x[self.along] = self.span;
        for (k, ends) in [(self.width(), across), (self.depth, deep)] {
            let ends = if self.flip[k] { [-ends[1], -ends[0]] } else { ends };
            x[k] = ends.map(|e| e + self.origin[k]);
        }
        x
    }

    /// Its walls. The flanges of a rectangular hollow section reach over its whole width; a tapered
    /// flange has its nominal thickness.
    pub fn walls(&self) -> Walls {
        match self.profile.shape {
            Shape::Angle { h, b, t, .. } => Walls {
                flanges: vec![self.wall([t, b], [0.0, t])],
                webs: vec![self.wall([0.0, t], [0.0, h])],
                ..Walls::default()
            },
            Shape::Channel { h, b, tw, tf, .. } => Walls {
                flanges: [[h / 2.0 - tf, h / 2.0], [-h / 2.0, tf - h / 2.0]]
                    .map(|deep| self.wall([0.0, b], deep))
                    .to_vec(),
                webs: vec![self.wall([0.0, tw], [tf - h / 2.0, h / 2.0 - tf])],
                ..Walls::default()
            },
            Shape::Rhs { h, b, t, .. } => {
                let (x, y) = (b / 2.0, h / 2.0);
                Walls {
                    flanges: vec![self.wall([-x, x], [y - t, y]), self.wall([-x, x], [-y, t - y])],
                    webs: [[x - t, x], [-x, t - x]].map(|w| self.wall(w, [t - y, y - t])).to_vec(),
                    ..Walls::default()
                }
            }
            Shape::Chs { d, t } => {
                let step = PI / f64::from(SIDES);
                let [inner, outer] = [d / 2.0 - t, d / 2.0].map(|r| polygon_radius(r, SIDES));
                let half = 0.5 * (inner + outer) * step.sin();
                let [i, j] = [1, 2].map(|k| (self.along + k) % 3);
                let mut x = [[0.0; 2]; 3];
                x[self.along] = self.span;
                x[i] = [inner, outer].map(|r| self.origin[i] + r * step.cos());
                x[j] = [-half, half].map(|y| self.origin[j] + y);
                let turn = |k: u32| Turn {
                    axis: self.along,
                    angle: TAU * (f64::from(k) + 0.5) / f64::from(SIDES),
                    at: self.origin,
                };
                let facets = (0..SIDES).map(|k| (x, turn(k))).collect();
                Walls { facets, ..Walls::default() }
            }
        }
    }

    /// Planes at mid-thickness of the walls along the axes of the joint. Each ends on the next one.
    pub fn mid_planes(&self) -> Vec<MidPlane> {
        let plane = |axis: usize, across: [f64; 2], deep: [f64; 2]| {
            let x = self.wall(across, deep);
            let at = x[axis][0];
            MidPlane { axis, at, min: x.map(|i| i[0]), max: x.map(|i| i[1]) }
        };
        let (w, d) = (self.width(), self.depth);
        match self.profile.shape {
            Shape::Angle { h, b, t, .. } => {
                let m = t / 2.0;
                vec![plane(w, [m, m], [m, h]), plane(d, [m, b], [m, m])]
            }
            Shape::Channel { h, b, tw, tf, .. } => {
                let (x, y) = (tw / 2.0, (h - tf) / 2.0);
                let flange = |y: f64| plane(d, [x, b], [y, y]);
                vec![flange(y), flange(-y), plane(w, [x, x], [-y, y])]
            }
            // the planes of the sides meet those of the corners: `oblique_planes`
            Shape::Rhs { .. } | Shape::Chs { .. } => Vec::new(),
        }
    }

    /// Planes halfway between the outer and the inner outline of a hollow section.
    pub fn oblique_planes(&self) -> Vec<Vec<V3>> {
        let (whole, Some(hollow)) = self.solids() else { return Vec::new() };
        let (outer, inner) = (self.polygon(&whole), self.polygon(&hollow));
        let [i, j] = [1, 2].map(|k| (self.along + k) % 3);
        let middle = |n: usize, at: f64| {
            let mut x = [0.0; 3];
            x[self.along] = at;
            x[i] = 0.5 * (outer[n][0] + inner[n][0]);
            x[j] = 0.5 * (outer[n][1] + inner[n][1]);
            x
        };
        let [a, b] = self.span;
        let n = outer.len();
        let side = |k: usize| {
            let next = (k + 1) % n;
            vec![middle(k, a), middle(next, a), middle(next, b), middle(k, b)]
        };
        (0..n).map(side).collect()
    }
}

/// Leg of the chamfer at 45° that takes as much of a right corner as a radius.
fn chamfer(radius: f64) -> f64 {
    (2.0 - PI / 2.0).sqrt() * radius
}

/// Distance from the back of a channel at which its tapered flange has the nominal thickness:
/// half of the width up to a depth of 300 mm, half of the outstand beyond it (DIN 1026-1).
fn thickness_at(h: f64, b: f64, tw: f64) -> f64 {
    if h > 300.0 { 0.5 * (b + tw) } else { 0.5 * b }
}

/// The corners without those that a radius of zero puts at one place.
fn distinct(corners: &[Corner]) -> Vec<Corner> {
    let n = corners.len();
    let apart = |i: &usize| {
        let (a, b) = (corners[*i].0, corners[(i + n - 1) % n].0);
        (a[0] - b[0]).hypot(a[1] - b[1]) > 1e-9
    };
    (0..n).filter(apart).map(|i| corners[i]).collect()
}

/// A rectangle about the origin with rounded corners, from its half sizes.
fn rounded([x, y]: [f64; 2], r: f64) -> Vec<Corner> {
    let arc = |a: f64, b: f64| Some([a * (x - r), b * (y - r)]);
    vec![
        ([x, r - y], arc(1.0, -1.0)),
        ([x, y - r], None),
        ([x - r, y], arc(1.0, 1.0)),
        ([r - x, y], None),
        ([-x, y - r], arc(-1.0, 1.0)),
        ([-x, r - y], None),
        ([r - x, -y], arc(-1.0, -1.0)),
        ([x - r, -y], None),
    ]
}

#[cfg(test)]
mod tests;
