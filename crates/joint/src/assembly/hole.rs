//! Holes of bolts, the bolts in them, and the convex pieces of plates with holes.

use super::assembly::{OutlineEdge, Solid};
use super::axes::{cuboid, unit};
use super::block::Block;
use super::extent::Extent;
use crate::catalog::BoltSize;

/// Number of sides of the polygon that approximates a hole in clash checks.
const HOLE_SIDES: usize = 16;

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
///
/// An anchor has no head: its shank goes on below the parts by the length `anchor` \[mm\].
pub fn bolt_pieces(size: &BoltSize, hole: &Hole, corner: usize, anchor: Option<f64>) -> Vec<Solid> {
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
    match anchor {
        Some(length) => {
            let whole = Hole { base: hole.point(-length), length: hole.length + length, ..*hole };
            vec![whole.cylinder(), nut]
        }
        None => vec![hole.cylinder(), head, nut],
    }
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
