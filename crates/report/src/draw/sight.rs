//! The direction from which places of a surface can be seen.

use crate::draw::surface::{Surface, unit_normal};
use crate::draw::view::natural_eye;
use bracket_base::math::vec3::{V3, cross, dot, norm, sub, unit};

/// Places that are looked for at most; a few of many tell whether the zone is seen.
const LOOKED_FOR: usize = 24;
/// Least cosine between a face and the eye at which the face is seen.
const FACING: f64 = 0.2;
/// Share of the places that the best view shows with which an earlier one is preferred.
const ENOUGH: f64 = 0.6;
/// Hits nearer than this part of the shape are the place itself.
const ITSELF: f64 = 1e-6;

/// A direction to the eye, and which of the places are seen from it.
pub(super) struct Sight {
    /// Direction from the shape to the eye.
    pub eye: V3,
    /// Points of the surface that are seen.
    pub seen: Vec<u32>,
}

/// The first of eight views, from above and then from below, that shows nearly as many of the
/// places as the best of them. `places` are points of the surface.
pub(super) fn sight(surface: &Surface, places: &[u32]) -> Sight {
    let step = places.len().div_ceil(LOOKED_FOR).max(1);
    let places: Vec<Place> = places.iter().step_by(step).map(|p| Place::new(surface, *p)).collect();
    let [x, y, z] = natural_eye(surface);
    let around = [[x, y], [-x, y], [x, -y], [-x, -y]];
    let eyes = [z, -z].into_iter().flat_map(|z| around.map(|[x, y]| unit([x, y, z])));
    let views = eyes.map(|eye| {
        let seen = places.iter().filter(|p| p.is_seen(surface, eye)).map(|p| p.point);
        Sight { eye, seen: seen.collect() }
    });
    let views: Vec<Sight> = views.collect();
    let most = views.iter().map(|v| v.seen.len()).max().unwrap_or(0);
    let enough = |v: &Sight| v.seen.len() as f64 >= ENOUGH * most as f64;
    let none = Sight { eye: unit([x, y, z]), seen: Vec::new() };
    views.into_iter().find(enough).unwrap_or(none)
}

/// A point of a surface with its faces.
struct Place {
    point: u32,
    at: V3,
    normals: Vec<V3>,
}

impl Place {
    fn new(surface: &Surface, point: u32) -> Self {
        let own = surface.triangles.iter().filter(|t| t.nodes.contains(&point));
        let normal = |nodes: [u32; 3]| unit_normal(nodes.map(|n| surface.points[n as usize]));
        let normals = own.map(|t| normal(t.nodes)).collect();
        Self { point, at: surface.points[point as usize], normals }
    }

    fn is_seen(&self, surface: &Surface, eye: V3) -> bool {
        let (low, high) = surface.extents();
        let near = ITSELF * norm(sub(high, low));
        let hides = |corners: [V3; 3]| hit(self.at, eye, corners).is_some_and(|s| s > near);
        self.normals.iter().any(|n| dot(*n, eye) > FACING)
            && !surface.triangles.iter().any(|t| hides(t.nodes.map(|n| surface.points[n as usize])))
    }
}

/// How far along a ray a triangle is, if the ray meets it.
fn hit(from: V3, along: V3, [a, b, c]: [V3; 3]) -> Option<f64> {
    let (ab, ac, to) = (sub(b, a), sub(c, a), sub(from, a));
    let p = cross(along, ac);
    let volume = dot(ab, p);
    if volume == 0.0 {
        return None;
    }
    let u = dot(to, p) / volume;
    let q = cross(to, ab);
    let v = dot(along, q) / volume;
    let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
    inside.then(|| dot(ac, q) / volume)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::surface::SurfaceTriangle;

    /// A place under a lid is seen from below alone; one that looks down under a floor never.
    #[test]
    fn a_hidden_place_is_seen_from_another_side() {
        let square = |z: f64, half: f64| {
            [[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]]
        };
        let mut surface = Surface::default();
        for (points, up) in [(square(0.0, 1.0), false), (square(1.0, 20.0), true)] {
            let first = surface.points.len() as u32;
            surface.points.extend(points);
            for [a, b, c] in [[0, 1, 2], [0, 2, 3]] {
                let nodes = if up { [a, b, c] } else { [a, c, b] }.map(|n| first + n);
                surface.triangles.push(SurfaceTriangle { nodes, body: 0 });
            }
        }
        let below = sight(&surface, &[0, 1, 2, 3]);
        assert!(below.eye[2] < 0.0 && below.seen.len() == 4, "{:?}", below.eye);
        let above = sight(&surface, &[4, 5]);
        assert!(above.eye[2] > 0.0 && above.seen == [4, 5]);
        // a lid below too: nothing is seen, and the first view stays
        let first = surface.points.len() as u32;
        surface.points.extend(square(-1.0, 20.0));
        for nodes in [[0, 1, 2], [0, 2, 3]] {
            surface.triangles.push(SurfaceTriangle { nodes: nodes.map(|n| first + n), body: 0 });
        }
        let hidden = sight(&surface, &[0, 1, 2, 3]);
        assert!(hidden.eye[2] > 0.0 && hidden.seen.is_empty());
    }
}
