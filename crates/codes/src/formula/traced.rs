//! A number that records its formula.

use super::number::Number;
use super::term::Term;
use crate::unit::Unit;
use bracket_base::words::Text;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::Arc;

/// A value with the term that gives it. Its operations are those of `f64` in the same order, so
/// that a clause has the same value with either number, bit for bit.
#[derive(Clone, Debug, PartialEq)]
pub struct Traced {
    value: f64,
    term: Arc<Term>,
    /// The term that an intermediate value stands for.
    definition: Option<Arc<Term>>,
}

impl Traced {
    /// A term with its value.
    pub(super) fn new(value: f64, term: Term) -> Self {
        Self { value, term: Arc::new(term), definition: None }
    }

    /// A symbol with its value in the internal unit.
    pub fn symbol(name: impl Into<Text>, value: f64, unit: Unit) -> Self {
        Self::new(value, Term::Symbol(name.into(), value, unit))
    }

    /// A pure number.
    pub fn number(name: impl Into<Text>, value: f64) -> Self {
        Self::symbol(name, value, Unit::Number)
    }

    /// A length \[mm\].
    pub fn length(name: impl Into<Text>, value: f64) -> Self {
        Self::symbol(name, value, Unit::Length)
    }

    /// An area \[mm²\].
    pub fn area(name: impl Into<Text>, value: f64) -> Self {
        Self::symbol(name, value, Unit::Area)
    }

    /// A stress or a strength \[MPa\].
    pub fn stress(name: impl Into<Text>, value: f64) -> Self {
        Self::symbol(name, value, Unit::Stress)
    }

    /// A force \[N\].
    pub fn force(name: impl Into<Text>, value: f64) -> Self {
        Self::symbol(name, value, Unit::Force)
    }

    /// The term.
    pub fn term(&self) -> &Term {
        &self.term
    }

    /// The term of an intermediate value that prints a symbol of its own.
    pub fn definition(&self) -> Option<&Term> {
        self.definition.as_deref()
    }

    /// The sum over terms of the same form; 0 without any.
    pub fn series(of: impl IntoIterator<Item = Self>) -> Self {
        let (value, terms) = of.into_iter().fold((0.0, Vec::new()), |(sum, mut terms), t| {
            terms.push(t.term);
            (sum + t.value, terms)
        });
        let term = if terms.is_empty() { Term::Constant(0.0) } else { Term::Series(terms) };
        Self::new(value, term)
    }

    /// The least or largest of two; one that is already so adds its own terms to the list.
    fn listed(self, other: Self, value: f64, join: fn(Vec<Arc<Term>>) -> Term) -> Self {
        let same = std::mem::discriminant(&join(Vec::new()));
        let parts = |t: Arc<Term>| match &*t {
            Term::Least(all) | Term::Largest(all) if std::mem::discriminant(&*t) == same => {
                all.clone()
            }
            _ => vec![t],
        };
        Self::new(value, join([self.term, other.term].into_iter().flat_map(parts).collect()))
    }
}

impl From<f64> for Traced {
    fn from(value: f64) -> Self {
        Self::new(value, Term::Constant(value))
    }
}

impl<S: Into<Text>> From<(S, f64, Unit)> for Traced {
    fn from((name, value, unit): (S, f64, Unit)) -> Self {
        Self::symbol(name, value, unit)
    }
}

impl Add for Traced {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, Term::Sum(self.term, other.term))
    }
}

impl Sub for Traced {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, Term::Difference(self.term, other.term))
    }
}

impl Mul for Traced {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::new(self.value * other.value, Term::Product(self.term, other.term))
    }
}

impl Div for Traced {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self::new(self.value / other.value, Term::Quotient(self.term, other.term))
    }
}

impl Neg for Traced {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.value, Term::Negative(self.term))
    }
}

impl Number for Traced {
    fn symbol(name: &'static str, value: f64, unit: Unit) -> Self {
        // the constructor of the type itself
        Traced::symbol(name, value, unit)
    }

    fn value(&self) -> f64 {
        self.value
    }

    fn sqrt(self) -> Self {
        Self::new(self.value.sqrt(), Term::Root(self.term))
    }

    fn abs(self) -> Self {
        Self::new(self.value.abs(), Term::Absolute(self.term))
    }

    fn powi(self, exponent: i32) -> Self {
        let power = Arc::new(Term::Constant(f64::from(exponent)));
        Self::new(self.value.powi(exponent), Term::Power(self.term, power))
    }

    fn powf(self, exponent: Self) -> Self {
        Self::new(self.value.powf(exponent.value), Term::Power(self.term, exponent.term))
    }

    fn min(self, other: Self) -> Self {
        let value = self.value.min(other.value);
        self.listed(other, value, Term::Least)
    }

    fn max(self, other: Self) -> Self {
        let value = self.value.max(other.value);
        self.listed(other, value, Term::Largest)
    }

    fn named(self, symbol: &'static str, unit: Unit) -> Self {
        let definition = Some(self.definition.unwrap_or(self.term));
        let term = Arc::new(Term::Symbol(symbol.into(), self.value, unit));
        Self { value: self.value, term, definition }
    }
}
