//! Comparison of inputs with limits. A value that differs from its limit by rounding alone, for
//! example 150 mm written in feet, is at the limit.

use std::ops::RangeInclusive;

/// Largest relative difference of two values that are the same but for rounding.
pub const SLACK: f64 = 1e-9;

/// Largest difference of two values that are the same but for rounding.
fn slack(a: f64, b: f64) -> f64 {
    SLACK * a.abs().max(b.abs())
}

/// True if `value` is at most `limit`, but for rounding.
pub fn at_most(value: f64, limit: f64) -> bool {
    // infinities compare by themselves: their slack is infinite
    value <= limit || value - limit <= slack(value, limit) && value.is_finite()
}

/// True if `value` is at least `limit`, but for rounding.
pub fn at_least(value: f64, limit: f64) -> bool {
    at_most(limit, value)
}

/// True if both values are the same, but for rounding.
pub fn same(a: f64, b: f64) -> bool {
    at_most(a, b) && at_most(b, a)
}

/// True if `value` lies between the limits, but for rounding.
pub fn within(value: f64, limits: &RangeInclusive<f64>) -> bool {
    at_least(value, *limits.start()) && at_most(value, *limits.end())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_decides_nothing() {
        let feet = 150f64.next_down();
        assert!(feet < 150.0 && at_least(feet, 150.0) && same(feet, 150.0));
        assert!(within(0.1 + 0.2, &(0.0..=0.3)) && !within(0.300_000_01, &(0.0..=0.3)));
        assert!(!at_least(149.999_999, 150.0) && !at_most(150.000_001, 150.0));
    }

    #[test]
    fn zero_has_no_slack_and_nothing_is_near_infinity_or_nan() {
        assert!(!at_most(1e-300, 0.0) && at_most(0.0, 0.0) && !at_least(-1e-300, 0.0));
        assert!(at_most(1.0, f64::INFINITY) && !at_most(f64::INFINITY, 1.0));
        assert!(!at_most(f64::NAN, 1.0) && !at_least(f64::NAN, 1.0) && !same(f64::NAN, f64::NAN));
    }
}
