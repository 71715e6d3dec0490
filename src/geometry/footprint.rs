//! Rectangles that are imprinted on faces: footprints of supports and loads, and welds.

use super::line::Line;
use super::scene::{Body, ON_PLANE, Scene};
use crate::assembly::assembly::{FaceRule, Surface};
use crate::math::vec3::V3;

/// A rectangle of a coordinate plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// Normal axis, 0 = x.
    pub axis: usize,
    /// Coordinate of the plane along the axis \[mm\].
    pub at: f64,
    /// Lowest corner \[mm\]; its coordinate along the axis is ignored.
    pub min: V3,
    /// Highest corner \[mm\]; its coordinate along the axis is ignored.
    pub max: V3,
}

/// Distance of the mesh lines beside an edge of a footprint, over the footprint's width.
const MARGIN: f64 = 0.125;

/// Depth below a face at which a part's steel is looked for \[mm\].
const BELOW: f64 = 0.1;

impl Rectangle {
    /// Shorter side \[mm\].
    pub fn width(&self) -> f64 {
        let [a, b] = self.sides().map(|k| self.max[k] - self.min[k]);
        a.min(b)
    }

    /// The two axes of the plane.
    fn sides(&self) -> [usize; 2] {
        [(self.axis + 1) % 3, (self.axis + 2) % 3]
    }

    /// The corners, in order around the rectangle.
    pub fn corners(&self) -> [V3; 4] {
        let [a, b] = self.sides();
        let corner = |p: f64, q: f64| {
            let mut c = [0.0; 3];
            c[self.axis] = self.at;
            c[a] = p;
            c[b] = q;
            c
        };
        let (low, high) = (self.min, self.max);
        [
            corner(low[a], low[b]),
            corner(high[a], low[b]),
            corner(high[a], high[b]),
            corner(low[a], high[b]),
        ]
    }

    /// The kept part; `None` if nothing of it is kept or it lies on a symmetry plane.
    pub fn clip(mut self, planes: &[usize]) -> Option<Self> {
        for &k in planes {
            if k == self.axis {
                if self.at <= ON_PLANE {
                    return None;
                }
            } else {
                self.min[k] = self.min[k].max(0.0);
                if self.max[k] - self.min[k] <= ON_PLANE {
                    return None;
                }
            }
        }
        Some(self)
    }

    /// The rectangle with its edges moved outward by `by` where the body's face continues beyond
    /// them, or inward if `by` is negative.
    fn moved(&self, body: &Body, by: f64) -> Self {
        let mut out = *self;
        for k in self.sides() {
            let beyond = MARGIN * self.width();
            if self.steel_at(body, k, self.max[k] + beyond) {
                out.max[k] += by;
            }
            if self.steel_at(body, k, self.min[k] - beyond) {
                out.min[k] -= by;
            }
        }
        out
    }

    /// True if the body has steel below the plane beside the middle of an edge, at the coordinate
    /// `to` along `k`.
    fn steel_at(&self, body: &Body, k: usize, to: f64) -> bool {
        let mut start: V3 = std::array::from_fn(|i| 0.5 * (self.min[i] + self.max[i]));
        (start[self.axis], start[k]) = (self.at, to);
        let mut direction = [0.0; 3];
        direction[self.axis] = 1.0;
        let inside = body.stretches(&Line { start, direction });
        let has = |t: f64| inside.iter().any(|s| s[0] < t && t < s[1]);
        has(BELOW) != has(-BELOW)
    }
}

fn rectangle(face: &FaceRule) -> Option<Rectangle> {
    match face.surface {
        Surface::Plane { axis, at, min, max } if face.imprint => {
            Some(Rectangle { axis, at, min, max })
        }
        _ => None,
    }
}

/// The imprinted faces on the kept side.
pub fn footprints(scene: &Scene) -> Vec<Rectangle> {
    on_bodies(scene).map(|(_, footprint)| footprint).collect()
}

fn on_bodies<'s>(scene: &'s Scene<'s>) -> impl Iterator<Item = (&'s Body<'s>, Rectangle)> {
    let planes: Vec<usize> = scene.symmetry.iter().map(|s| s.axis).collect();
    scene.assembly.faces.iter().filter_map(move |f| {
        let body = &scene.bodies[scene.body(&f.part)?];
        Some((body, rectangle(f)?.clip(&planes)?))
    })
}

/// Rectangles whose outlines are mesh lines just inside and just outside the edges of footprints.
///
/// The stress below a footprint falls to that of the free face beside it within a short distance.
/// Without these lines a linear stress cannot do so, and the lower bound of a limit load is small
/// (docs/theory.md, section 15).
pub fn margins(scene: &Scene) -> Vec<Rectangle> {
    let both = |(body, footprint): (&Body, Rectangle)| {
        let by = MARGIN * footprint.width();
        [by, -by].map(|by| footprint.moved(body, by)).into_iter().filter(move |r| *r != footprint)
    };
    on_bodies(scene).flat_map(both).collect()
}

/// The imprinted rectangles of welds on the kept side; they set no element size.
pub fn weld_lines(scene: &Scene) -> Vec<Rectangle> {
    let planes: Vec<usize> = scene.symmetry.iter().map(|s| s.axis).collect();
    let kept = scene
        .assembly
        .welds
        .iter()
        .filter(|w| w.imprint && w.between.iter().all(|p| scene.body(p).is_some()));
    kept.filter_map(|w| match w.surface {
        Surface::Plane { axis, at, min, max } => Rectangle { axis, at, min, max }.clip(&planes),
        Surface::Mantle { .. } => None,
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::fixtures::paper_joint;

    /// The support of the paper's joint: 15 mm along the beam, the whole width of its flange. The
    /// flange goes on in x; in y it ends, at its edge and at the symmetry plane.
    #[test]
    fn margins_lie_inside_and_outside_the_edges_beside_free_steel() {
        let joint = paper_joint();
        let scene = Scene::new(&joint, false);
        assert_eq!(footprints(&scene).len(), 1);
        let found: Vec<[f64; 4]> =
            margins(&scene).iter().map(|r| [r.min[0], r.max[0], r.min[1], r.max[1]]).collect();
        assert_eq!(found, [[1005.625, 1024.375, 0.0, 85.0], [1009.375, 1020.625, 0.0, 85.0]]);
        assert!(margins(&scene).iter().all(|r| r.axis == 2 && r.at == -180.0));
        let whole = Scene::new(&joint, true);
        assert_eq!((footprints(&whole).len(), margins(&whole).len()), (2, 4));
    }
}
