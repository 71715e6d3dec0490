//! The tree of a formula.

use crate::unit::Unit;
use bracket_base::words::Text;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::sync::Arc;

/// A term of a formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Term {
    /// A number of the code.
    Constant(f64),
    /// A symbol with its value in the internal unit.
    Symbol(Text, #[serde(with = "extended")] f64, Unit),
    /// Sum of two terms.
    Sum(Arc<Term>, Arc<Term>),
    /// Difference of two terms.
    Difference(Arc<Term>, Arc<Term>),
    /// Product of two terms.
    Product(Arc<Term>, Arc<Term>),
    /// Quotient of two terms.
    Quotient(Arc<Term>, Arc<Term>),
    /// A term with the opposite sign.
    Negative(Arc<Term>),
    /// Base and exponent.
    Power(Arc<Term>, Arc<Term>),
    /// Square root.
    Root(Arc<Term>),
    /// Absolute value.
    Absolute(Arc<Term>),
    /// The least of several terms.
    Least(Vec<Arc<Term>>),
    /// The largest of several terms.
    Largest(Vec<Arc<Term>>),
    /// Sum over several terms of the same form, such as rows of bolts. Their symbols are those of
    /// the first.
    Series(Vec<Arc<Term>>),
}

impl Term {
    /// The symbols of the term with their values and units, each name once.
    pub fn symbols(&self) -> Vec<(&Text, f64, Unit)> {
        let mut out = Vec::new();
        self.collect(&mut out);
        out
    }

    fn collect<'a>(&'a self, out: &mut Vec<(&'a Text, f64, Unit)>) {
        match self {
            Term::Constant(_) => {}
            Term::Symbol(name, value, unit) => {
                if !out.iter().any(|(known, ..)| *known == name) {
                    out.push((name, *value, *unit));
                }
            }
            Term::Sum(a, b)
            | Term::Difference(a, b)
            | Term::Product(a, b)
            | Term::Quotient(a, b)
            | Term::Power(a, b) => {
                a.collect(out);
                b.collect(out);
            }
            Term::Negative(a) | Term::Root(a) | Term::Absolute(a) => a.collect(out),
            Term::Least(all) | Term::Largest(all) | Term::Series(all) => {
                all.iter().for_each(|t| t.collect(out));
            }
        }
    }
}

/// Values in JSON, which has no infinite numbers: these are texts there.
pub(super) mod extended {
    use super::{Deserialize, Deserializer, Serialize, Serializer};

    #[derive(Serialize, Deserialize)]
    #[serde(untagged)]
    enum Value {
        Finite(f64),
        Text(String),
    }

    pub fn serialize<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
        match value.is_finite() {
            true => Value::Finite(*value).serialize(to),
            false => Value::Text(value.to_string()).serialize(to),
        }
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
        match Value::deserialize(from)? {
            Value::Finite(value) => Ok(value),
            Value::Text(text) => text.parse().map_err(serde::de::Error::custom),
        }
    }
}
