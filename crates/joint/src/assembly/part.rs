//! Solids of parts: rolled sections, boxes, bolts and their holes, and the convex pieces of parts.

use super::assembly::{MidPlane, OutlineEdge, Solid};
use super::block::Block;
use super::content::{Extent, minus};
use super::turn::Turn;
use crate::catalog::{BoltSize, IProfile};
use bracket_base::math::vec3::V3;

/// Number of wedges that approximate a root fillet in clash checks; the error of the chord is 0.2 %
/// of the radius.
const FILLET_WEDGES: usize = 6;
/// Number of sides of the polygon that approximates a hole in clash checks.
const HOLE_SIDES: usize = 16;

/// Unit vector of an axis.
pub fn unit(axis: usize) -> [f64; 3] {
    let mut v = [0.0; 3];
    v[axis] = 1.0;
    v
}

/// The two axes across an axis, in rising order.
pub fn across(axis: usize) -> [usize; 2] {
    [[1, 2], [0, 2], [0, 1]][axis]
}

/// A box from three intervals.
pub fn cuboid(x: [f64; 2], y: [f64; 2], z: [f64; 2]) -> Solid {
    Solid::Box { min: [x[0], y[0], z[0]], max: [x[1], y[1], z[1]] }
}

/// A length of an I section with its position in space.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    /// The section.
    pub profile: &'a IProfile,
    /// Axis of the member, 0 = x.
    pub along: usize,
    /// Axis of the section's depth, 0 = x.
    pub depth: usize,
    /// Extent along the axis \[mm\].
    pub span: [f64; 2],
    /// A point on the member's axis \[mm\].
    pub centre: [f64; 3],
}

impl Placed<'_> {
    /// Axis of the flanges' width.
    pub fn width(&self) -> usize {
        3 - self.along - self.depth
    }

    /// Axes `u`, `v` of the outline, with `u × v = along`.
    fn frame(&self) -> (usize, usize) {
        ((self.along + 1) % 3, (self.along + 2) % 3)
    }

    /// A point of the section (across, deep) in the outline's frame. Where the axes differ, the map
    /// is a quarter turn, which keeps the sense of rotation.
    fn turn(&self, [w, d]: [f64; 2]) -> [f64; 2] {
        if self.frame().1 == self.depth { [w, d] } else { [d, -w] }
    }

    fn prism(&self, start: [f64; 2], edges: Vec<OutlineEdge>) -> Solid {
        let (u, v) = self.frame();
        let mut origin = self.centre;
        origin[self.along] = self.span[0];
        Solid::Prism {
            origin,
            u: unit(u),
            v: unit(v),
            start,
            edges,
            length: self.span[1] - self.span[0],
        }
    }

    /// The exact section with its root fillets, extruded.
    pub fn solid(&self) -> Solid {
        let p = self.profile;
        let (b, h, w, f, r) = (p.b / 2.0, p.h / 2.0, p.tw / 2.0, p.h / 2.0 - p.tf, p.r);
        // counter-clockwise from the lower right corner, with the width to the right and the depth
        // upwards; `true` marks the end of a fillet
        let c = [w + r, f - r];
        let points: [([f64; 2], Option<[f64; 2]>); 16] = [
            ([b, -h], None),
            ([b, -f], None),
            ([w + r, -f], None),
            ([w, -f + r], Some([c[0], -c[1]])),
            ([w, f - r], None),
            ([w + r, f], Some([c[0], c[1]])),
            ([b, f], None),
            ([b, h], None),
            ([-b, h], None),
            ([-b, f], None),
            ([-w - r, f], None),
            ([-w, f - r], Some([-c[0], c[1]])),
            ([-w, -f + r], None),
            ([-w - r, -f], Some([-c[0], -c[1]])),
            ([-b, -f], None),
            ([-b, -h], None),
        ];
        let start = self.turn(points[0].0);
        let mut edges: Vec<OutlineEdge> = points[1..]
            .iter()
            .filter(|(_, arc)| r > 0.0 || arc.is_none())
            .map(|&(to, arc)| match arc {
                Some(centre) => OutlineEdge::Arc { to: self.turn(to), centre: self.turn(centre) },
                None => OutlineEdge::Line { to: self.turn(to) },
            })
            .collect();
        edges.push(OutlineEdge::Line { to: start });
        self.prism(start, edges)
    }

    /// A box of the section over the whole length, from its extents across and along the depth.
    fn block(&self, across: [f64; 2], deep: [f64; 2]) -> [[f64; 2]; 3] {
        let mut x = [[0.0; 2]; 3];
        x[self.along] = self.span;
        x[self.width()] = across.map(|a| a + self.centre[self.width()]);
        x[self.depth] = deep.map(|d| d + self.centre[self.depth]);
        x
    }

    /// Both flanges and the web over the whole length.
    pub fn blocks(&self) -> [[[f64; 2]; 3]; 3] {
        let p = self.profile;
        let (b, h, w, f) = (p.b / 2.0, p.h / 2.0, p.tw / 2.0, p.h / 2.0 - p.tf);
        [([-b, b], [f, h]), ([-b, b], [-h, -f]), ([-w, w], [-f, f])]
            .map(|(across, deep)| self.block(across, deep))
    }

    /// Flanges, web and wedges of the fillets, with holes and cuts left free.
    pub fn convex(&self, holes: &[Hole], cuts: &[Extent]) -> Vec<Solid> {
        let p = self.profile;
        let (w, f, r) = (p.tw / 2.0, p.h / 2.0 - p.tf, p.r);
        let mut out = Vec::new();
        for block in self.blocks().into_iter().flat_map(|b| without(b, cuts)) {
            out.extend(perforated(block, holes));
        }
        for wedge in self.wedges() {
            let [sw, sd] = wedge.side;
            let across = [sw * w, sw * (w + r)];
            let bounds = self.block(across, [sd * f, sd * (f - r)]).map(ordered);
            for left in without(bounds, cuts) {
                // a piece that a cut leaves only a part of is left out over the whole cut
                let whole = (0..3).all(|k| k == self.along || left[k] == bounds[k]);
                if whole {
                    out.push(self.wedge(&wedge, left[self.along]));
                }
            }
        }
        out
    }

    /// The wedges of the fillets of a turned profile. Where a cut meets an edge of a wedge, the
    /// wedge is left out.
    pub fn turned_fillets(&self, turn: &Turn, cuts: &[Extent]) -> Vec<Solid> {
        let (u, v) = self.frame();
        let mut out = Vec::new();
        for wedge in self.wedges() {
            let line = |q: [f64; 2]| {
                let q = self.turn(q);
                self.span.map(|at| {
                    let mut p = self.centre;
                    p[self.along] = at;
                    (p[u], p[v]) = (p[u] + q[0], p[v] + q[1]);
                    turn.point(p)
                })
            };
            let lines = wedge.corners.map(line);
            let inside = cuts.iter().flat_map(|c| lines.iter().filter_map(|l| inside(l, c)));
            let [a, b] = self.span;
            let mut left = vec![self.span];
            for [from, to] in inside {
                let [from, to] = [from, to].map(|f| a + f * (b - a));
                let beside = |[x, y]: [f64; 2]| [[x, y.min(from)], [x.max(to), y]];
                left = left.into_iter().flat_map(beside).filter(|[x, y]| y - x > 1e-3).collect();
            }
            out.extend(left.into_iter().map(|span| turn.solid(&self.wedge(&wedge, span))));
        }
        out
    }

    /// The triangles that approximate the root fillets.
    fn wedges(&self) -> Vec<Wedge> {
        let p = self.profile;
        let (w, f, r) = (p.tw / 2.0, p.h / 2.0 - p.tf, p.r);
        let mut out = Vec::new();
        for (sw, sd) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
            let arc = |i: usize| {
                let a = std::f64::consts::FRAC_PI_2 * i as f64 / FILLET_WEDGES as f64;
                [sw * (w + r - r * a.cos()), sd * (f - r + r * a.sin())]
            };
            for i in 0..if r > 0.0 { FILLET_WEDGES } else { 0 } {
                // the arc runs from the web to the flange; the orientation of the triangle depends
                // on the quadrant
                let (from, to) =
                    if sw * sd > 0.0 { (arc(i), arc(i + 1)) } else { (arc(i + 1), arc(i)) };
                out.push(Wedge { side: [sw, sd], corners: [from, to, [sw * w, sd * f]] });
            }
        }
        out
    }

    fn wedge(&self, wedge: &Wedge, span: [f64; 2]) -> Solid {
        let edges = wedge.corners.map(|q| OutlineEdge::Line { to: self.turn(q) });
        let piece = Placed { span, ..*self };
        piece.prism(self.turn(wedge.corners[2]), edges.to_vec())
    }

    /// Mid-thickness planes of the flanges and of the web. The web's plane ends on those of the
    /// flanges, so that no edge of a plane ends inside the steel.
    pub fn mid_planes(&self) -> Vec<MidPlane> {
        let p = self.profile;
        let middle = (p.h - p.tf) / 2.0;
        let plane = |axis: usize, x: [[f64; 2]; 3]| MidPlane {
            axis,
            at: (x[axis][0] + x[axis][1]) / 2.0,
            min: x.map(|i| i[0]),
            max: x.map(|i| i[1]),
        };
        let half = p.b / 2.0;
        vec![
            plane(self.depth, self.block([-half, half], [middle, middle])),
            plane(self.depth, self.block([-half, half], [-middle, -middle])),
            plane(self.width(), self.block([0.0, 0.0], [-middle, middle])),
        ]
    }
}

/// A triangle of a root fillet: the side of the web and of the axis on which it is, +1 or −1, and
/// its corners across and along the depth, the last in the root \[mm\].
struct Wedge {
    side: [f64; 2],
    corners: [[f64; 2]; 3],
}

/// The fractions of a line between which it runs inside a box; `None`: it does not meet it.
fn inside([a, b]: &[V3; 2], cut: &Extent) -> Option<[f64; 2]> {
    let mut out = [0.0f64, 1.0];
    for k in 0..3 {
        let d = b[k] - a[k];
        if d.abs() < 1e-9 {
            if a[k] <= cut[k][0] || a[k] >= cut[k][1] {
                return None;
            }
            continue;
        }
        let ends = cut[k].map(|x| (x - a[k]) / d);
        out = [out[0].max(ends[0].min(ends[1])), out[1].min(ends[0].max(ends[1]))];
    }
    (out[0] < out[1]).then_some(out)
}

/// A cylindrical hole, and the bolt shank in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hole {
    /// Centre of the hole at the head's bearing face \[mm\].
    pub base: [f64; 3],
    /// Axis of the shank, 0 = x.
    pub axis: usize,
    /// Direction from head to nut along the axis: +1 or −1.
    pub toward: f64,
    /// Grip length \[mm\].
    pub length: f64,
    /// Radius \[mm\].
    pub radius: f64,
    /// Number of sides of the meshed circle.
    pub segments: u32,
}

impl Hole {
    /// Unit vector from head to nut.
    pub fn direction(&self) -> [f64; 3] {
        unit(self.axis).map(|x| if x == 0.0 { 0.0 } else { x * self.toward })
    }

    /// The point on the axis at a distance from the head's bearing face, towards the nut \[mm\].
    pub fn point(&self, distance: f64) -> [f64; 3] {
        let mut x = self.base;
        x[self.axis] += self.toward * distance;
        x
    }

    /// Half side of the square that the clash checks leave free \[mm\]. It contains all corners of
    /// the meshed polygon, which has the area of the circle.
    fn spared(&self) -> f64 {
        let step = std::f64::consts::TAU / f64::from(self.segments);
        self.radius * (step / step.sin()).sqrt()
    }

    /// Half extent along axis `k` of a plane across the shank that is wider than the shank \[mm\].
    pub fn beyond(&self, k: usize) -> f64 {
        if k == self.axis { 0.0 } else { 1.25 * self.radius }
    }

    /// The cylinder of the bolt's shank; the same cylinder is cut from the parts.
    pub fn cylinder(&self) -> Solid {
        Solid::Cylinder {
            base: self.base,
            axis: self.direction(),
            radius: self.radius,
            length: self.length,
            segments: self.segments,
        }
    }
}

/// Head, shank and nut of a bolt.
pub fn bolt_pieces(size: &BoltSize, hole: &Hole, corner: usize) -> [Solid; 3] {
    let head =
        hexagon(hole.base, hole.axis, -hole.toward, corner, size.head_width, size.head_height);
    let nut = hexagon(
        hole.point(hole.length),
        hole.axis,
        hole.toward,
        corner,
        size.nut_width,
        size.nut_height,
    );
    [hole.cylinder(), head, nut]
}

/// A hexagonal prism that stands on `base` and extends in the direction `sign` along the axis. Two
/// of its corners lie on axis `corner`.
fn hexagon(
    base: [f64; 3],
    axis: usize,
    sign: f64,
    corner: usize,
    across_flats: f64,
    height: f64,
) -> Solid {
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut origin = base;
    if sign < 0.0 {
        origin[axis] -= height;
    }
    let (long, half) = (across_flats / 3f64.sqrt(), across_flats / 2.0);
    let corners = [
        [long, 0.0],
        [long / 2.0, half],
        [-long / 2.0, half],
        [-long, 0.0],
        [-long / 2.0, -half],
        [long / 2.0, -half],
    ];
    let turn = |[p, q]: [f64; 2]| if corner == u { [p, q] } else { [-q, p] };
    let start = turn(corners[0]);
    let edges = (1..=6).map(|i| OutlineEdge::Line { to: turn(corners[i % 6]) }).collect();
    Solid::Prism { origin, u: unit(u), v: unit(v), start, edges, length: height }
}

/// An interval with its lower end first.
fn ordered([a, b]: [f64; 2]) -> [f64; 2] {
    [a.min(b), a.max(b)]
}

/// What cuts leave of a box.
pub fn without(of: Extent, cuts: &[Extent]) -> Vec<Extent> {
    let cut = |left: Vec<Extent>, c: &Extent| left.into_iter().flat_map(|e| minus(e, c)).collect();
    cuts.iter().fold(vec![of], cut)
}

/// Convex pieces of a block, with the squares about its holes left free, and what a square about a
/// hole along the block's axis takes too much.
pub fn around_holes(block: &Block, holes: &[Hole]) -> Vec<Solid> {
    let bounds = block.bounds();
    let mut left = vec![block.clone()];
    let mut corners = Vec::new();
    for h in holes {
        let (a, b) = (h.point(0.0)[h.axis], h.point(h.length)[h.axis]);
        let square: Extent = std::array::from_fn(|k| match k == h.axis {
            true => [a.min(b), a.max(b)],
            false => [h.base[k] - h.spared(), h.base[k] + h.spared()],
        });
        let inside = (0..3)
            .all(|k| k == h.axis || bounds[k][0] < square[k][0] && square[k][1] < bounds[k][1]);
        let before = left.len();
        left = left.iter().flat_map(|b| b.minus(&square)).collect();
        if h.axis == block.axis && inside && left.len() > before {
            let (u, v) = ((h.axis + 1) % 3, (h.axis + 2) % 3);
            corners.extend(corners_around(h, block.span, u, v));
        }
    }
    left.iter().map(Block::solid).chain(corners).collect()
}

/// Convex pieces of a box, with the holes that pass right through it left free.
pub fn perforated(x: [[f64; 2]; 3], holes: &[Hole]) -> Vec<Solid> {
    let inside = |h: &&Hole| {
        let (a, b) = (h.point(0.0)[h.axis], h.point(h.length)[h.axis]);
        let across = [(h.axis + 1) % 3, (h.axis + 2) % 3];
        a.min(b) <= x[h.axis][0] + 1e-6
            && a.max(b) >= x[h.axis][1] - 1e-6
            && across
                .iter()
                .all(|&k| h.base[k] + h.spared() > x[k][0] && h.base[k] - h.spared() < x[k][1])
    };
    let holes: Vec<&Hole> = holes.iter().filter(inside).collect();
    let Some(first) = holes.first() else { return vec![cuboid(x[0], x[1], x[2])] };
    let axis = first.axis;
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let clip = |t: f64, k: usize| t.clamp(x[k][0], x[k][1]);
    let mut cuts: Vec<f64> = x[v].to_vec();
    cuts.extend(
        holes
            .iter()
            .flat_map(|h| [clip(h.base[v] - h.spared(), v), clip(h.base[v] + h.spared(), v)]),
    );
    cuts.sort_by(f64::total_cmp);
    let mut out = Vec::new();
    let mut push = |iu: [f64; 2], iv: [f64; 2]| {
        if iu[1] - iu[0] > 1e-9 && iv[1] - iv[0] > 1e-9 {
            let mut y = x;
            (y[u], y[v]) = (iu, iv);
            out.push(cuboid(y[0], y[1], y[2]));
        }
    };
    for band in cuts.windows(2) {
        let middle = (band[0] + band[1]) / 2.0;
        let mut gaps: Vec<[f64; 2]> = holes
            .iter()
            .filter(|h| (h.base[v] - middle).abs() < h.spared())
            .map(|h| [clip(h.base[u] - h.spared(), u), clip(h.base[u] + h.spared(), u)])
            .collect();
        gaps.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut from = x[u][0];
        for g in gaps {
            push([from, g[0]], [band[0], band[1]]);
            from = from.max(g[1]);
        }
        push([from, x[u][1]], [band[0], band[1]]);
    }
    for h in holes.iter().filter(|h| h.axis == axis) {
        out.extend(corners_around(h, x[axis], u, v));
    }
    out
}

/// The four corner regions of the square about a hole, outside the polygon that encloses the
/// circle.
fn corners_around(h: &Hole, span: [f64; 2], u: usize, v: usize) -> Vec<Solid> {
    let step = std::f64::consts::TAU / HOLE_SIDES as f64;
    let outer = h.spared() / (step / 2.0).cos();
    let mut origin = h.base;
    origin[h.axis] = span[0];
    let mut out = Vec::new();
    for quadrant in 0..4 {
        let (sin, cos) = (f64::from(quadrant) * std::f64::consts::FRAC_PI_2).sin_cos();
        let turn = |p: [f64; 2]| [cos * p[0] - sin * p[1], sin * p[0] + cos * p[1]];
        let corner = turn([h.spared(), h.spared()]);
        let vertex = |i: usize| {
            let a = (i as f64 + 0.5) * step;
            turn([outer * a.cos(), outer * a.sin()])
        };
        for i in 0..HOLE_SIDES / 4 - 1 {
            // clockwise along the circle is counter-clockwise around the triangle
            let edges = [vertex(i + 1), vertex(i), corner].map(|to| OutlineEdge::Line { to });
            out.push(Solid::Prism {
                origin,
                u: unit(u),
                v: unit(v),
                start: corner,
                edges: edges.to_vec(),
                length: span[1] - span[0],
            });
        }
    }
    out
}
