//! A turn of a solid about an axis of the joint.

use super::assembly::{MidPlane, Solid};
use bracket_base::math::vec3::{V3, sub};
use serde::Serialize;

/// A turn about a line along a coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Turn {
    /// Axis, 0 = x.
    pub axis: usize,
    /// Angle \[rad\], right-handed about the axis.
    pub angle: f64,
    /// A point of the line \[mm\].
    pub at: V3,
}

impl Turn {
    /// The image of a vector.
    pub fn vector(&self, v: V3) -> V3 {
        let (i, j) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        let (sin, cos) = self.angle.sin_cos();
        let mut out = v;
        out[i] = cos * v[i] - sin * v[j];
        out[j] = sin * v[i] + cos * v[j];
        out
    }

    /// The image of a point \[mm\].
    pub fn point(&self, p: V3) -> V3 {
        let moved = self.vector(sub(p, self.at));
        std::array::from_fn(|k| self.at[k] + moved[k])
    }

    /// The image of a solid.
    pub fn solid(&self, solid: &Solid) -> Solid {
        let each = |list: &[Solid]| list.iter().map(|s| self.solid(s)).collect();
        match solid {
            Solid::Box { min, max } => {
                let size: V3 = std::array::from_fn(|k| max[k] - min[k]);
                self.solid(&Solid::rectangle(*min, size))
            }
            Solid::Prism { origin, u, v, start, edges, length } => Solid::Prism {
                origin: self.point(*origin),
                u: self.vector(*u),
                v: self.vector(*v),
                start: *start,
                edges: edges.clone(),
                length: *length,
            },
            Solid::Cylinder { base, axis, radius, length, segments } => Solid::Cylinder {
                base: self.point(*base),
                axis: self.vector(*axis),
                radius: *radius,
                length: *length,
                segments: *segments,
            },
            Solid::Union(list) => Solid::Union(each(list)),
            Solid::Difference(list) => Solid::Difference(each(list)),
        }
    }

    /// The corners of the image of a plane at mid-thickness.
    pub fn mid_plane(&self, plane: &MidPlane) -> Vec<V3> {
        plane.corners().into_iter().map(|c| self.point(c)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::flat::FlatSolid;

    /// 30° about y: what points along x sinks by sin 30°, what points up moves along x.
    #[test]
    fn a_turn_about_y_moves_x_down_and_keeps_sizes() {
        let turn = Turn { axis: 1, angle: std::f64::consts::FRAC_PI_6, at: [5.0, 0.0, 7.0] };
        let near = |a: V3, b: V3| (0..3).all(|k| (a[k] - b[k]).abs() < 1e-12);
        assert!(near(turn.vector([1.0, 0.0, 0.0]), [0.75f64.sqrt(), 0.0, -0.5]));
        assert!(near(turn.vector([0.0, 2.0, 1.0]), [0.5, 2.0, 0.75f64.sqrt()]));
        assert_eq!(turn.point([5.0, 3.0, 7.0]), [5.0, 3.0, 7.0]);
        let bar = Solid::Box { min: [5.0, -1.0, 7.0], max: [15.0, 1.0, 10.0] };
        let FlatSolid::Prism(p) = FlatSolid::from_solid(&turn.solid(&bar)) else { panic!() };
        assert!((p.area() * p.length - 60.0).abs() < 1e-9);
        let lowest = p.corners().iter().fold(f64::INFINITY, |z, c| z.min(c[2]));
        assert!((lowest - 2.0).abs() < 1e-9, "7 mm − 10 mm · sin 30°: {lowest}");
    }
}
