//! Mathematical tools: convex polygons, vectors, Mandel tensors, quadrature, small dense matrices,
//! compensated sums, significant figures.

pub mod convex;
pub mod dense;
pub mod eigen;
pub mod figures;
pub mod gauge;
pub mod lanes;
pub mod mandel;
pub mod quadrature;
pub mod rigid_motion;
pub mod vec3;
pub mod wide;

/// Sum with a running compensation (Neumaier): the rounding error does not grow with the number of
/// terms.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sum {
    total: f64,
    compensation: f64,
}

impl Sum {
    /// Adds one term.
    #[inline]
    pub fn add(&mut self, x: f64) {
        let t = self.total + x;
        self.compensation +=
            if self.total.abs() >= x.abs() { (self.total - t) + x } else { (x - t) + self.total };
        self.total = t;
    }

    /// The sum so far.
    #[inline]
    pub fn value(self) -> f64 {
        self.total + self.compensation
    }

    /// The compensated sum of an iterator.
    pub fn of(terms: impl IntoIterator<Item = f64>) -> f64 {
        let mut s = Sum::default();
        terms.into_iter().for_each(|x| s.add(x));
        s.value()
    }
}
