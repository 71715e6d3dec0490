//! The scale of a drawing.

/// Maps millimetres of the joint to pixels of the page.
pub(super) struct Scale {
    /// Pixels per millimetre.
    pub k: f64,
    /// Page coordinates of x = 0, z = 0.
    pub origin: [f64; 2],
}

impl Scale {
    /// Page coordinates of a point.
    pub(super) fn at(&self, x: f64, z: f64) -> [f64; 2] {
        [self.origin[0] + self.k * x, self.origin[1] - self.k * z]
    }
}
