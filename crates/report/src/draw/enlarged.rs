//! How far a displacement is enlarged, and when a zone of a picture is.

use bracket_base::math::vec3::V3;
use bracket_engine::mesh::polyhedron::diagonal;

/// Share of the largest value from which a place belongs to the zone that is drawn enlarged.
pub const MARKED: f64 = 0.2;
/// Size of a zone over that of the shape below which it is drawn enlarged.
const SMALL: f64 = 0.5;

/// A round factor that draws the largest displacement as at most `part` of the size of the shape;
/// `None` if nothing moves.
pub fn enlargement(nodes: &[V3], size: &[f64], part: f64) -> Option<f64> {
    let largest = size.iter().fold(0.0f64, |a, b| a.max(*b));
    if largest == 0.0 {
        return None;
    }
    let wanted = part * diagonal(nodes) / largest;
    let power = 10f64.powf(wanted.log10().floor());
    Some([5.0, 2.0, 1.0].into_iter().map(|m| m * power).find(|f| *f <= wanted).unwrap_or(power))
}

/// Whether the places with at least [`MARKED`], at the nodes of a shape, are a small part of it.
pub fn is_small(nodes: &[V3], values: &[f64]) -> bool {
    let marked = nodes.iter().zip(values).filter(|(_, v)| **v >= MARKED);
    let marked: Vec<V3> = marked.map(|(x, _)| *x).collect();
    !marked.is_empty() && diagonal(&marked) < SMALL * diagonal(nodes)
}
