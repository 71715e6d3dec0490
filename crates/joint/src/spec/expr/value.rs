//! Values of expressions, and the error of an expression that has no value.

use bracket_base::units::{Dim, Quantity};
use bracket_base::words::Text;
use std::fmt;
use std::ops::Range;

/// Value of an expression: a quantity, or true or false.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number with its dimension, in internal units.
    Quantity(Quantity),
    /// True or false.
    Truth(bool),
}

impl Value {
    /// A length in mm.
    pub fn length(value: f64) -> Self {
        Value::Quantity(Quantity { value, dim: Dim::LENGTH })
    }
    /// A force in N.
    pub fn force(value: f64) -> Self {
        Value::Quantity(Quantity { value, dim: Dim::FORCE })
    }
    /// An angle in rad.
    pub fn angle(value: f64) -> Self {
        Value::Quantity(Quantity { value, dim: Dim::ANGLE })
    }
    /// A pure number.
    pub fn number(value: f64) -> Self {
        Value::Quantity(Quantity { value, dim: Dim::NONE })
    }
    /// The value as a text for a person: the words `true` and `false`, or a number with its unit.
    pub fn text(&self) -> Text {
        match self {
            Value::Truth(true) => "true".into(),
            Value::Truth(false) => "false".into(),
            Value::Quantity(_) => Text::given(self.to_string()),
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Truth(t) => write!(f, "{t}"),
            Value::Quantity(q) => {
                // people measure angles in degrees
                let value = if q.dim == Dim::ANGLE { q.value.to_degrees() } else { q.value };
                // nine decimals hide the rounding error of decimal input; messages need no more
                let text =
                    if value.abs() < 1e15 { format!("{value:.9}") } else { format!("{value:e}") };
                let text = match text.contains('e') {
                    true => &text,
                    false => text.trim_end_matches('0').trim_end_matches('.'),
                };
                f.write_str(if text == "-0" { "0" } else { text })?;
                match q.dim {
                    Dim::NONE => Ok(()),
                    Dim::LENGTH => f.write_str(" mm"),
                    Dim::FORCE => f.write_str(" N"),
                    Dim::STRESS => f.write_str(" MPa"),
                    Dim::MOMENT => f.write_str(" N mm"),
                    Dim::ANGLE => f.write_str(" deg"),
                    other => write!(f, " {other}"),
                }
            }
        }
    }
}

/// Reason why an expression has no value. `span` is a byte range of `text`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message} (in `{text}`, at `{}`)", self.excerpt())]
pub struct ExprError {
    /// What is wrong.
    pub message: String,
    /// The whole expression.
    pub text: String,
    /// Byte range of the faulty part.
    pub span: Range<usize>,
}

impl ExprError {
    /// The faulty part; `end` if it is behind the last character.
    pub fn excerpt(&self) -> &str {
        self.text.get(self.span.clone()).filter(|t| !t.is_empty()).unwrap_or("end")
    }
}

/// An error at a part of a text.
pub(super) fn fault(text: &str, span: Range<usize>, message: impl Into<String>) -> ExprError {
    ExprError { message: message.into(), text: text.to_owned(), span }
}
