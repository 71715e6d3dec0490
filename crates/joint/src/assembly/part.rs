//! Lengths of rolled sections as solids, with their convex pieces.

use super::assembly::{MidPlane, OutlineEdge, Solid};
use super::axes::without;
use super::block::extruded;
use super::extent::Extent;
use super::hole::{Hole, perforated};
use super::turn::Turn;
use crate::catalog::IProfile;
use bracket_base::math::vec3::V3;

/// Number of wedges that approximate a root fillet in clash checks; the error of the chord is 0.2 %
/// of the radius.
const FILLET_WEDGES: usize = 6;

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
        extruded(self.along, self.span, self.centre, start, edges)
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

/// An interval with its lower end first.
fn ordered([a, b]: [f64; 2]) -> [f64; 2] {
    [a.min(b), a.max(b)]
}
