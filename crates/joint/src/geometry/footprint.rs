//! Rectangles that are imprinted on faces: footprints of supports and loads, and welds.

use super::scene::{ON_PLANE, Scene};
use crate::assembly::assembly::{FaceRule, MidPlane, Surface};
use bracket_base::math::vec3::{V3, along, sub};

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
        let &Self { axis, at, min, max } = self;
        MidPlane { axis, at, min, max }.corners()
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
}

/// The kept part of a convex polygon; `None` if nothing of it is kept or it lies on a symmetry
/// plane.
pub fn clipped(polygon: &[V3], planes: &[usize]) -> Option<Vec<V3>> {
    let mut kept = polygon.to_vec();
    for &k in planes {
        let mut out = Vec::with_capacity(kept.len() + 2);
        for (i, p) in kept.iter().enumerate() {
            let q = &kept[(i + 1) % kept.len()];
            if p[k] >= 0.0 {
                out.push(*p);
            }
            if p[k] * q[k] < 0.0 {
                out.push(along(*p, p[k] / (p[k] - q[k]), sub(*q, *p)));
            }
        }
        if out.iter().all(|p| p[k] <= ON_PLANE) {
            return None;
        }
        kept = out;
    }
    Some(kept)
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
    let planes: Vec<usize> = scene.symmetry.iter().map(|s| s.axis).collect();
    let kept = scene.assembly.faces.iter().filter(|f| scene.body(&f.part).is_some());
    kept.filter_map(|f| rectangle(f)?.clip(&planes)).collect()
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

    /// The support of the paper's joint: 15 mm along the beam, the whole width of its flange.
    #[test]
    fn footprints_end_at_symmetry_planes() {
        let joint = paper_joint();
        let [footprint] = footprints(&Scene::new(&joint, false))[..] else { panic!("one support") };
        assert_eq!((footprint.axis, footprint.at), (2, -180.0));
        assert_eq!((footprint.min[0], footprint.max[0]), (1007.5, 1022.5));
        assert_eq!((footprint.min[1], footprint.max[1]), (0.0, 85.0));
        assert_eq!(footprints(&Scene::new(&joint, true)).len(), 2);
    }
}
