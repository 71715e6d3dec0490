//! Where plates and flanges turn about plastic hinges: between a pulled bolt and the toes around
//! it.
//!
//! The stress of a limit state changes from one sign to the other within about a thickness there.
//! Larger elements hold the lower bound of the load factor down (docs/theory.md, section 15).
//!
//! ```text
//!          |web|             a zone: from the bolt to the toe of the web and half a thickness
//!          |   |    [bolt]   further, as far in the other directions if the plate does not end
//!   =======+===+====[====]=======
//!            |-------- zone ------|
//! ```

use super::pulled;
use super::scene::{Body, Scene};
use super::shank::Shank;
use crate::assembly::assembly::PartRole;
use bracket_base::math::vec3::V3;

/// A box of a plate around a bolt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zone {
    /// Lowest corner \[mm\].
    pub min: V3,
    /// Highest corner \[mm\].
    pub max: V3,
    /// Thickness of the plate \[mm\].
    pub thickness: f64,
}

/// Extent of a zone from its bolt, over the distance of the nearest toe.
const REACH: f64 = 4.0 / 3.0;

/// The same without any toe, over the radius of the bolt.
const REACH_WITHOUT_TOE: f64 = 6.0;

/// Least distance of a toe, over the radius of the bolt. What is nearer touches the plate.
const NEAREST_TOE: f64 = 1.5;

/// Height above a plate at which toes are searched, over its thickness.
const ABOVE: f64 = 0.25;

/// The zones of all bolts that a load case may pull.
pub fn zones(scene: &Scene) -> Vec<Zone> {
    let plates: Vec<&Body> =
        scene.bodies.iter().filter(|b| b.part.role != PartRole::Bolt).collect();
    let mut out = Vec::new();
    for bolt in scene.bodies.iter().filter(|b| b.part.role == PartRole::Bolt) {
        let Some(shank) = Shank::of(&bolt.part.solid) else { continue };
        if !pulled::may_be(scene.assembly, &shank) {
            continue;
        }
        for body in &plates {
            if let Some(faces) = shank.plate(body) {
                out.push(zone(&shank, body, faces, &plates));
            }
        }
    }
    out
}

/// The zone of one plate, which surrounds the shank between the coordinates `faces`.
fn zone(shank: &Shank, body: &Body, faces: [f64; 2], plates: &[&Body]) -> Zone {
    let thickness = faces[1] - faces[0];
    let toes = shank.across().map(|d| toe(shank, faces, d, plates));
    let nearest = toes.iter().flatten().copied().reduce(f64::min);
    let reach = nearest.map_or(REACH_WITHOUT_TOE * shank.radius, |t| REACH * t);
    let (mut min, mut max) = (shank.start, shank.start);
    (min[shank.axis], max[shank.axis]) = (faces[0], faces[1]);
    for (d, toe) in shank.across().into_iter().zip(toes) {
        let middle = shank.line(0.5 * (faces[0] + faces[1]), d);
        // the hole has no steel; the plate beside it ends at its edge or at a symmetry plane
        let end = body.stretches(&middle).iter().map(|s| s[1]).fold(0.0, f64::max);
        let far = match toe {
            Some(t) if t <= reach => t + 0.5 * thickness,
            _ => reach,
        };
        let to = shank.start[d.0] + d.1 * far.min(end);
        if d.1 > 0.0 {
            max[d.0] = to;
        } else {
            min[d.0] = to;
        }
    }
    Zone { min, max, thickness }
}

/// Distance from the shank's axis to the first part that stands on either face of the plate.
fn toe(shank: &Shank, faces: [f64; 2], d: (usize, f64), plates: &[&Body]) -> Option<f64> {
    let height = ABOVE * (faces[1] - faces[0]);
    let beside = |at: f64| {
        let line = shank.line(at, d);
        let all = plates.iter().flat_map(|b| line.through(&b.solid));
        let ahead: Vec<[f64; 2]> = all.filter(|s| s[1] > shank.radius).collect();
        // a plate in contact with this face starts at the hole
        let covered = ahead.iter().any(|s| s[0] < NEAREST_TOE * shank.radius);
        if covered { None } else { ahead.iter().map(|s| s[0]).reduce(f64::min) }
    };
    let found = [beside(faces[0] - height), beside(faces[1] + height)];
    found.into_iter().flatten().reduce(f64::min)
}

#[cfg(test)]
mod tests;
