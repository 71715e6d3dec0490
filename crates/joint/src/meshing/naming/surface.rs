//! Surfaces of the joint in the mesh: tests of position, and their description in messages.

use crate::assembly::assembly::Surface;
use crate::geometry::exact::MANTLE_TOLERANCE;
use crate::geometry::scene::Scene;
use bracket_base::math::vec3::{V3, cross, dot, sub};

/// Nodes closer than this to a named plane count as lying on it \[mm\].
pub const SNAP: f64 = 1e-6;

/// True when a triangle lies on the surface.
pub fn on_surface(surface: &Surface, t: &[V3; 3]) -> bool {
    match surface {
        Surface::Plane { axis, at, min, max } => t.iter().all(|x| {
            (x[*axis] - at).abs() < SNAP
                && (0..3).all(|k| k == *axis || (x[k] > min[k] - SNAP && x[k] < max[k] + SNAP))
        }),
        Surface::Mantle { base, axis, radius, length } => {
            let normal = cross(sub(t[1], t[0]), sub(t[2], t[0]));
            // the annulus at the end of the mantle has corners at the same radius, but its normal
            // is parallel to the axis
            dot(normal, *axis).abs() < 1e-3 * dot(normal, normal).sqrt()
                && t.iter().all(|x| {
                    let r = sub(*x, *base);
                    let h = dot(r, *axis);
                    let distance = (dot(r, r) - h * h).max(0.0).sqrt();
                    h > -SNAP
                        && h < length + SNAP
                        && (distance / radius - 1.0).abs() < MANTLE_TOLERANCE
                })
        }
    }
}

/// True when a box lies on the removed side of a symmetry plane.
pub fn beyond(scene: &Scene, min: &V3, max: &V3) -> bool {
    scene.symmetry.iter().any(|s| max[s.axis] <= SNAP && min[s.axis] < -SNAP)
}

/// A length rounded to a micrometre, for messages.
fn mm(x: f64) -> f64 {
    (1e3 * x).round() / 1e3
}

/// Description of the position of a surface, for messages.
pub fn looked_for(surface: &Surface) -> String {
    match surface {
        Surface::Plane { axis, at, min, max } => {
            format!(
                "on the plane {} = {} mm, {}",
                ["x", "y", "z"][*axis],
                mm(*at),
                extent(min, max, Some(*axis))
            )
        }
        Surface::Mantle { base, axis, radius, length } => {
            let [x, y, z] = base.map(mm);
            let [u, v, w] = axis.map(mm);
            let (r, l) = (mm(*radius), mm(*length));
            format!(
                "on the cylinder of radius {r} mm from ({x}, {y}, {z}) mm along ({u}, {v}, {w}), \
                 {l} mm long"
            )
        }
    }
}

/// The extent of a box as text, with one axis left out: `x from 0 to 200 mm, z from -9 to 9 mm`.
pub fn extent(min: &V3, max: &V3, without: Option<usize>) -> String {
    let sides = (0..3).filter(|k| Some(*k) != without);
    let words =
        sides.map(|k| format!("{} from {} to {} mm", ["x", "y", "z"][k], mm(min[k]), mm(max[k])));
    words.collect::<Vec<_>>().join(", ")
}
