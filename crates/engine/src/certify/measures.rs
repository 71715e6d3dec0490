//! Largest values and ratios of which residuals are made.

/// The largest value, at least 0; skips NaN.
pub(crate) fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, f64::max)
}

/// `a / b`; 0 for 0 / 0.
pub(crate) fn ratio(a: f64, b: f64) -> f64 {
    if a == 0.0 { 0.0 } else { a / b.max(f64::MIN_POSITIVE) }
}

/// The largest value; `None` for an empty list, NaN if any value is NaN.
pub(crate) fn largest_of_each(values: &[f64]) -> Option<f64> {
    values.iter().copied().reduce(|a, b| if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) })
}
