//! Elements for tests of products through the reference tetrahedron.

use crate::elements::packed_elements::Batch;
use bracket_base::math::vec3::V3;
use bracket_base::math::wide::Lane;

/// Number i of a fixed sequence between −½ and ½.
fn noise(i: usize) -> f64 {
    ((i * 7919) % 1009) as f64 / 1009.0 - 0.5
}

/// Corners of a tet that differs from lane to lane \[mm\].
pub fn corners(lane: usize) -> [V3; 4] {
    let unit = [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.5]];
    std::array::from_fn(|v| std::array::from_fn(|d| unit[v][d] + noise(12 * lane + 3 * v + d)))
}

/// Values without a pattern.
pub fn lanes(count: usize, seed: usize) -> Vec<Lane> {
    (0..count).map(|i| std::array::from_fn(|l| noise(seed + 8 * i + l))).collect()
}

/// Compares a product of a batch with the same product by the stored matrices, to rounding; the
/// largest entry exceeds `least`.
pub fn equals_by_matrix(by_numbers: &Batch, least: f64, product: impl Fn(&Batch) -> Vec<Lane>) {
    let by_matrix = Batch { maps: Vec::new(), ..by_numbers.clone() };
    let (a, b) = (product(by_numbers), product(&by_matrix));
    let size = b.as_flattened().iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let off = a.as_flattened().iter().zip(b.as_flattened());
    let off = off.fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
    assert!(size > least && off < 1e-12 * size, "{off} of {size}");
}
