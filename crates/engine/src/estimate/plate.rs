//! A plate of a body: where its strain is averaged.

use bracket_base::math::vec3::{V3, along, dot};

/// A flat plate, or a flange or web of a profile, of constant thickness.
///
/// Its coordinates are `x·axes[i]` of a point x; the first two lie in its plane, the third runs
/// through its thickness.
#[derive(Clone, Debug, PartialEq)]
pub struct Plate {
    /// Body of the mesh that it is a part of.
    pub body: u32,
    /// Unit vectors at right angles; the last is its normal.
    pub axes: [V3; 3],
    /// Extent of the meshed plate in its coordinates \[mm\].
    pub extent: [[f64; 2]; 3],
    /// For each coordinate, whether the lower end of the extent is a plane of symmetry. The plate
    /// then continues as the mirror image of the mesh.
    pub mirrored: [bool; 3],
    /// Zones that are left out, through the whole depth.
    pub excluded: Vec<Zone>,
}

/// A zone in the plane of a plate, in its first two coordinates \[mm\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Zone {
    /// A disc, under the head of a bolt.
    Disc {
        /// Its centre.
        centre: [f64; 2],
        /// Its radius.
        radius: f64,
    },
    /// A rectangle, around the toe of a weld or a re-entrant edge.
    Rectangle {
        /// Lowest corner.
        min: [f64; 2],
        /// Highest corner.
        max: [f64; 2],
    },
}

impl Plate {
    /// The plate that fills a box with edges along x, y and z, its normal along axis `normal` (0 =
    /// x); its coordinates are the two others in rising order, then that axis.
    pub fn in_box(body: u32, normal: usize, bounds: [[f64; 2]; 3], mirrored: [bool; 3]) -> Self {
        let order = axes_of(normal);
        Self {
            body,
            axes: order.map(|k| std::array::from_fn(|d| f64::from(u8::from(d == k)))),
            extent: order.map(|k| bounds[k]),
            mirrored: order.map(|k| mirrored[k]),
            excluded: Vec::new(),
        }
    }

    /// Thickness of the whole plate \[mm\].
    pub fn thickness(&self) -> f64 {
        let [low, high] = self.extent[2];
        if self.mirrored[2] { 2.0 * (high - low) } else { high - low }
    }

    /// Coordinates of a point \[mm\].
    pub fn coordinates(&self, x: V3) -> V3 {
        self.axes.map(|a| dot(a, x))
    }

    /// The point with the given coordinates \[mm\].
    pub fn point(&self, c: V3) -> V3 {
        (0..3).fold([0.0; 3], |x, i| along(x, c[i], self.axes[i]))
    }

    /// True if the extent holds a volume.
    pub fn is_solid(&self) -> bool {
        self.extent.iter().all(|[low, high]| high > low)
    }
}

/// The coordinate axes of a plate with its normal along axis `normal`: the two others in rising
/// order, then that axis.
pub fn axes_of(normal: usize) -> [usize; 3] {
    [[1, 2, 0], [0, 2, 1], [0, 1, 2]][normal]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_and_points_are_inverse() {
        let plate =
            Plate::in_box(3, 1, [[0.0, 50.0], [-4.0, 4.0], [10.0, 90.0]], [true, false, false]);
        assert_eq!(plate.extent, [[0.0, 50.0], [10.0, 90.0], [-4.0, 4.0]]);
        assert_eq!((plate.thickness(), plate.mirrored), (8.0, [true, false, false]));
        let x = [1.0, 2.0, 3.0];
        assert_eq!(plate.coordinates(x), [1.0, 3.0, 2.0]);
        assert_eq!(plate.point(plate.coordinates(x)), x);
        let half =
            Plate::in_box(3, 1, [[0.0, 50.0], [0.0, 4.0], [10.0, 90.0]], [false, true, false]);
        assert_eq!(half.thickness(), 8.0);
    }
}
