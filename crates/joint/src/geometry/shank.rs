//! The shanks of bolts, and the plates around them.

use super::line::Line;
use super::scene::Body;
use crate::assembly::assembly::Solid;
use bracket_base::math::vec3::V3;

/// Distance from a bolt's axis at which a plate is sounded, over the radius of the bolt: outside
/// the hole, below the head.
const BESIDE: f64 = 1.25;

/// The shank of a bolt along a coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shank {
    /// Axis, 0 = x.
    pub axis: usize,
    /// Centre of the lower end \[mm\].
    pub start: V3,
    /// Length \[mm\].
    pub length: f64,
    /// Radius \[mm\].
    pub radius: f64,
}

impl Shank {
    /// The first cylinder of a bolt; `None` if it is not along a coordinate axis.
    pub(super) fn of(solid: &Solid) -> Option<Self> {
        match solid {
            Solid::Cylinder { base, axis, radius, length, .. } => {
                let k = (0..3).find(|&k| axis[k].abs() > 1.0 - 1e-9)?;
                let mut start = *base;
                start[k] = start[k].min(start[k] + axis[k] * length);
                Some(Self { axis: k, start, length: *length, radius: *radius })
            }
            Solid::Union(list) | Solid::Difference(list) => list.iter().find_map(Self::of),
            Solid::Box { .. } | Solid::Prism { .. } => None,
        }
    }

    /// The four directions across the shank: axis and sign.
    pub(super) fn across(&self) -> [(usize, f64); 4] {
        let (a, b) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        [(a, 1.0), (a, -1.0), (b, 1.0), (b, -1.0)]
    }

    /// A line across the shank, at the coordinate `at` of its axis.
    pub(super) fn line(&self, at: f64, (k, sign): (usize, f64)) -> Line {
        let mut start = self.start;
        start[self.axis] = at;
        let mut direction = [0.0; 3];
        direction[k] = sign;
        Line { start, direction }
    }

    /// The interval of the axis in which a part surrounds the shank: the least of the four
    /// directions, so that webs and fillets do not count.
    pub(super) fn plate(&self, body: &Body) -> Option<[f64; 2]> {
        let mut direction = [0.0; 3];
        direction[self.axis] = 1.0;
        let sounded = self.across().into_iter().filter_map(|(k, sign)| {
            let mut start = self.start;
            start[k] += sign * BESIDE * self.radius;
            let line = Line { start, direction };
            let inside = body.stretches(&line);
            inside.into_iter().find(|s| s[0] < self.length - 1e-6 && s[1] > 1e-6)
        });
        let least = sounded.min_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
        let within = least[0] > -1e-6 && least[1] < self.length + 1e-6;
        within.then(|| least.map(|t| self.start[self.axis] + t))
    }
}
