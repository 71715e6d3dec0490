//! Solids with flat faces only. The mesher receives them, and volumes and areas are computed from
//! them.
//!
//! Circles become regular polygons and root fillets become short chains of chords, both with the
//! area of the smooth shape. Every facet is then an exact plane. Meshes of any size fill the same
//! body, areas can be checked to rounding, and both bounds refer to the same structure on every
//! remesh.

use crate::assembly::assembly::Solid;
use crate::assembly::facets::{flatten_outline, regular_polygon};
use bracket_base::math::vec3::{V3, along, cross, dot, unit};

/// A simple polygon extruded along a unit vector.
#[derive(Clone, Debug, PartialEq)]
pub struct FlatPrism {
    /// Origin of the polygon's plane \[mm\].
    pub origin: V3,
    /// Unit vector of the first coordinate.
    pub u: V3,
    /// Unit vector of the second coordinate.
    pub v: V3,
    /// Unit vector of the extrusion, `w = u × v`.
    pub w: V3,
    /// Corners, counter-clockwise when seen from the tip of `w` \[mm\].
    pub polygon: Vec<[f64; 2]>,
    /// Length of the extrusion \[mm\].
    pub length: f64,
}

/// A tree of Boolean operations on prisms.
#[derive(Clone, Debug, PartialEq)]
pub enum FlatSolid {
    /// A prism.
    Prism(FlatPrism),
    /// Union of all the solids.
    Union(Vec<FlatSolid>),
    /// The first solid minus all the others.
    Difference(Vec<FlatSolid>),
}

/// An axis-parallel bounding box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lowest corner \[mm\].
    pub min: V3,
    /// Highest corner \[mm\].
    pub max: V3,
}

impl FlatPrism {
    /// Point in space at the polygon coordinates `p` and the height `h` \[mm\].
    pub fn point(&self, p: [f64; 2], h: f64) -> V3 {
        along(along(along(self.origin, p[0], self.u), p[1], self.v), h, self.w)
    }

    /// All corners of the first end, then those of the second \[mm\].
    pub fn corners(&self) -> Vec<V3> {
        let end = |h: f64| self.polygon.iter().map(move |&p| self.point(p, h));
        end(0.0).chain(end(self.length)).collect()
    }

    /// Signed area of the polygon \[mm²\].
    pub fn area(&self) -> f64 {
        let n = self.polygon.len();
        (0..n)
            .map(|i| {
                let (a, b) = (self.polygon[i], self.polygon[(i + 1) % n]);
                0.5 * (a[0] * b[1] - b[0] * a[1])
            })
            .sum()
    }
}

impl FlatSolid {
    /// Every prism of the tree, including the subtracted ones.
    pub fn prisms(&self) -> Vec<&FlatPrism> {
        match self {
            FlatSolid::Prism(p) => vec![p],
            FlatSolid::Union(list) | FlatSolid::Difference(list) => {
                list.iter().flat_map(FlatSolid::prisms).collect()
            }
        }
    }

    /// Bounding box of the solid; subtracted solids do not reduce it.
    pub fn bounds(&self) -> Bounds {
        match self {
            FlatSolid::Prism(p) => {
                let mut b = Bounds { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };
                for c in p.corners() {
                    for k in 0..3 {
                        b.min[k] = b.min[k].min(c[k]);
                        b.max[k] = b.max[k].max(c[k]);
                    }
                }
                b
            }
            FlatSolid::Union(list) => {
                list.iter().map(FlatSolid::bounds).reduce(Bounds::union).unwrap_or(Bounds::EMPTY)
            }
            FlatSolid::Difference(list) => list.first().map_or(Bounds::EMPTY, FlatSolid::bounds),
        }
    }

    /// The solid without the pieces that do not reach a box; `None` if nothing is left. Inside the
    /// box it has the same material.
    pub fn within(&self, of: &Bounds) -> Option<FlatSolid> {
        let reach = |s: &FlatSolid| s.bounds().near(of, 0.0);
        match self {
            FlatSolid::Prism(_) => reach(self).then(|| self.clone()),
            FlatSolid::Union(list) => {
                let list: Vec<_> = list.iter().filter_map(|s| s.within(of)).collect();
                (!list.is_empty()).then_some(FlatSolid::Union(list))
            }
            FlatSolid::Difference(list) => {
                let (first, rest) = list.split_first()?;
                let rest = rest.iter().filter_map(|s| s.within(of));
                Some(FlatSolid::Difference([first.within(of)?].into_iter().chain(rest).collect()))
            }
        }
    }

    /// Converts a solid: chords that keep the area replace arcs and circles.
    pub fn from_solid(solid: &Solid) -> Self {
        match solid {
            Solid::Box { min, max } => FlatSolid::Prism(FlatPrism {
                origin: *min,
                u: [1.0, 0.0, 0.0],
                v: [0.0, 1.0, 0.0],
                w: [0.0, 0.0, 1.0],
                polygon: vec![
                    [0.0, 0.0],
                    [max[0] - min[0], 0.0],
                    [max[0] - min[0], max[1] - min[1]],
                    [0.0, max[1] - min[1]],
                ],
                length: max[2] - min[2],
            }),
            Solid::Prism { origin, u, v, start, edges, length } => FlatSolid::Prism(FlatPrism {
                origin: *origin,
                u: *u,
                v: *v,
                w: cross(*u, *v),
                polygon: flatten_outline(*start, edges),
                length: *length,
            }),
            Solid::Cylinder { base, axis, radius, length, segments } => {
                let frame = AxisFrame::new(*axis);
                FlatSolid::Prism(FlatPrism {
                    origin: if frame.flipped { along(*base, *length, *axis) } else { *base },
                    u: frame.u,
                    v: frame.v,
                    w: frame.w,
                    polygon: regular_polygon(*radius, *segments),
                    length: *length,
                })
            }
            Solid::Union(list) => {
                FlatSolid::Union(list.iter().map(FlatSolid::from_solid).collect())
            }
            Solid::Difference(list) => {
                FlatSolid::Difference(list.iter().map(FlatSolid::from_solid).collect())
            }
        }
    }
}

impl Bounds {
    /// The empty box.
    pub const EMPTY: Bounds = Bounds { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };

    /// Bounding box of both boxes.
    pub fn union(self, other: Bounds) -> Bounds {
        let mut b = self;
        for k in 0..3 {
            b.min[k] = b.min[k].min(other.min[k]);
            b.max[k] = b.max[k].max(other.max[k]);
        }
        b
    }

    /// Distance of the boxes; 0 if they meet \[mm\].
    pub fn distance(&self, other: &Bounds) -> f64 {
        let gap = |k: usize| (self.min[k] - other.max[k]).max(other.min[k] - self.max[k]).max(0.0);
        (0..3).map(|k| gap(k) * gap(k)).sum::<f64>().sqrt()
    }

    /// True if the distance of the boxes is below `margin` \[mm\].
    pub fn near(&self, other: &Bounds, margin: f64) -> bool {
        (0..3).all(|k| self.min[k] <= other.max[k] + margin && other.min[k] <= self.max[k] + margin)
    }
}

/// The frame in which a cylinder's polygon is drawn. It depends on the line of the axis but not on
/// its sense, so a shank and its hole get the same corners.
pub struct AxisFrame {
    /// First unit vector of the polygon's plane.
    pub u: V3,
    /// Second unit vector of the polygon's plane.
    pub v: V3,
    /// Direction of the extrusion.
    pub w: V3,
    /// True if `w = −axis`.
    pub flipped: bool,
}

impl AxisFrame {
    /// The frame of a unit axis.
    pub fn new(axis: V3) -> Self {
        let largest = (0..3)
            .fold(0, |best, k| if axis[k].abs() > axis[best].abs() + 1e-12 { k } else { best });
        let flipped = axis[largest] < 0.0;
        let w = if flipped { axis.map(|c| -c) } else { axis };
        // The next coordinate axis, made orthogonal to w. For axis-parallel cylinders it is exactly
        // that axis.
        let mut u = [0.0; 3];
        u[(largest + 1) % 3] = 1.0;
        let u = unit(along(u, -dot(u, w), w));
        AxisFrame { u, v: cross(w, u), w, flipped }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::assembly::OutlineEdge;

    fn area(polygon: &[[f64; 2]]) -> f64 {
        let n = polygon.len();
        (0..n)
            .map(|i| {
                let (a, b) = (polygon[i], polygon[(i + 1) % n]);
                0.5 * (a[0] * b[1] - b[0] * a[1])
            })
            .sum()
    }

    #[test]
    fn polygon_has_the_circle_s_area() {
        for n in [12, 16, 24, 48] {
            let a = area(&regular_polygon(9.0, n));
            assert!((a / (std::f64::consts::PI * 81.0) - 1.0).abs() < 1e-8, "{n}: {a}");
        }
    }

    #[test]
    fn polygon_is_mirror_symmetric_to_the_bit() {
        let p = regular_polygon(9.0, 12);
        for q in &p {
            assert!(p.contains(&[q[0], -q[1] + 0.0]) && p.contains(&[-q[0] + 0.0, q[1]]), "{q:?}");
        }
    }

    #[test]
    fn shank_and_hole_agree_whatever_the_sense_of_the_axis() {
        let make = |base: V3, axis: V3| {
            FlatSolid::from_solid(&Solid::Cylinder {
                base,
                axis,
                radius: 9.0,
                length: 30.0,
                segments: 12,
            })
        };
        assert_eq!(
            make([85.0, 50.0, 110.0], [1.0, 0.0, 0.0]),
            make([115.0, 50.0, 110.0], [-1.0, 0.0, 0.0])
        );
    }

    #[test]
    fn fillet_keeps_its_area_convex_and_concave() {
        // A 10 × 10 square with one corner rounded by r = 4, and one with a corner cut out by a
        // concave arc.
        let exact_round = 100.0 - (1.0 - std::f64::consts::PI / 4.0) * 16.0;
        let round = flatten_outline(
            [0.0, 0.0],
            &[
                OutlineEdge::Line { to: [10.0, 0.0] },
                OutlineEdge::Line { to: [10.0, 6.0] },
                OutlineEdge::Arc { to: [6.0, 10.0], centre: [6.0, 6.0] },
                OutlineEdge::Line { to: [0.0, 10.0] },
                OutlineEdge::Line { to: [0.0, 0.0] },
            ],
        );
        assert!((area(&round) - exact_round).abs() < 1e-7, "{} {exact_round}", area(&round));
        let exact_cut = 100.0 - std::f64::consts::PI / 4.0 * 16.0;
        let cut = flatten_outline(
            [0.0, 0.0],
            &[
                OutlineEdge::Line { to: [10.0, 0.0] },
                OutlineEdge::Line { to: [10.0, 6.0] },
                OutlineEdge::Arc { to: [6.0, 10.0], centre: [10.0, 10.0] },
                OutlineEdge::Line { to: [0.0, 10.0] },
                OutlineEdge::Line { to: [0.0, 0.0] },
            ],
        );
        assert!((area(&cut) - exact_cut).abs() < 1e-7, "{} {exact_cut}", area(&cut));
    }
}
