//! The axes of the joint: unit vectors, and boxes along them as solids.

use super::assembly::Solid;
use super::extent::{Extent, minus};

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

/// What cuts leave of a box.
pub fn without(of: Extent, cuts: &[Extent]) -> Vec<Extent> {
    let cut = |left: Vec<Extent>, c: &Extent| left.into_iter().flat_map(|e| minus(e, c)).collect();
    cuts.iter().fold(vec![of], cut)
}
