//! Distances between bolts, and from them to the edges of a plate \[mm\]. Places rise.

/// Smallest distance between neighbours; infinite with fewer than two.
pub(super) fn pitch(places: &[f64]) -> f64 {
    places.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min)
}

/// Smallest and largest distance between neighbours; `None` with fewer than two.
pub(super) fn pitches(places: &[f64]) -> Option<[f64; 2]> {
    let most = places.windows(2).map(|w| w[1] - w[0]).reduce(f64::max)?;
    Some([pitch(places), most])
}

/// Distance between the outermost.
pub(super) fn span(places: &[f64]) -> f64 {
    places.first().zip(places.last()).map_or(0.0, |(a, b)| b - a)
}

/// Smallest distance from the edges at `low` and `high`.
pub(super) fn from_ends(places: &[f64], low: f64, high: f64) -> f64 {
    places.iter().map(|x| (x - low).min(high - x)).fold(f64::INFINITY, f64::min)
}

/// The first and the last; 0 where there are none.
pub(super) fn ends(places: &[f64]) -> [f64; 2] {
    [places.first(), places.last()].map(|x| x.copied().unwrap_or(0.0))
}
