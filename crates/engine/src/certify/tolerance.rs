//! Tolerance of certificates.

/// Largest residual of a strict bound, dimensionless: each residual is relative to the largest
/// value of its own field (docs/theory.md, section 10).
///
/// Recovered fields satisfy their equations to rounding, which even slivers keep a hundred times
/// smaller (`recover::restore_equilibrium`). A larger residual than this is an error of the field
/// and not rounding. Two bounds may contradict each other by the same fraction of the larger one.
pub const TOLERANCE: f64 = 1e-9;

/// True when the lower bound does not exceed the upper one beyond the tolerance; false when either
/// of them is NaN.
pub fn in_order(lower: f64, upper: f64) -> bool {
    lower <= upper + TOLERANCE * lower.abs().max(upper.abs())
}
