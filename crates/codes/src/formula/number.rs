//! What the clauses of a code compute with.

use crate::unit::Unit;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of a clause: `f64`, or [`Traced`](super::Traced), which records the formula.
pub trait Number:
    Clone
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A number with its symbol; its value is in the internal unit.
    fn symbol(name: &'static str, value: f64, unit: Unit) -> Self;
    /// The value, internal unit.
    fn value(&self) -> f64;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// Integer power.
    fn powi(self, exponent: i32) -> Self;
    /// Power.
    fn powf(self, exponent: Self) -> Self;
    /// The smaller of two, as [`f64::min`].
    fn min(self, other: Self) -> Self;
    /// The larger of two, as [`f64::max`].
    fn max(self, other: Self) -> Self;
    /// An intermediate value of the clause with a symbol of its own. A formula with it prints the
    /// symbol.
    fn named(self, symbol: &'static str, unit: Unit) -> Self;
}

impl Number for f64 {
    fn symbol(_: &'static str, value: f64, _: Unit) -> Self {
        value
    }

    fn value(&self) -> f64 {
        *self
    }

    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }

    fn abs(self) -> Self {
        f64::abs(self)
    }

    fn powi(self, exponent: i32) -> Self {
        f64::powi(self, exponent)
    }

    fn powf(self, exponent: Self) -> Self {
        f64::powf(self, exponent)
    }

    fn min(self, other: Self) -> Self {
        f64::min(self, other)
    }

    fn max(self, other: Self) -> Self {
        f64::max(self, other)
    }

    fn named(self, _: &'static str, _: Unit) -> Self {
        self
    }
}
