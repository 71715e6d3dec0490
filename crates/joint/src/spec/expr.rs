//! Expressions in templates: numbers with units, dotted names, arithmetic, comparisons and a few
//! functions.
//!
//! The parser is a Pratt parser. Every node keeps its byte range, so that an error can point at the
//! operand. The evaluation checks dimensions: `t + F` is an error, not a number. A result that is
//! not finite is an error too.

mod evaluate;
mod lex;
mod node;
mod parse;
mod stock;
mod value;

use bracket_base::units::Dim;
use bracket_base::yaml::INVALID_EXPRESSION;
use evaluate::Eval;
use lex::lex;
use node::{Kind, Node};
use parse::Parser;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use std::fmt;
use value::fault;
pub use value::{ExprError, Value};

/// Most numbers, names and signs of an expression. A sum of many terms is a deep tree, which would
/// overflow the stack.
const MOST_TOKENS: usize = 1000;

/// A parsed expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    text: String,
    root: Node,
    /// True for a plain number of the YAML file. Where a length is expected it is read as mm.
    bare: bool,
}

impl Expr {
    /// Parses an expression.
    pub fn parse(text: &str) -> Result<Expr, ExprError> {
        let tokens = lex(text)?;
        if tokens.len() > MOST_TOKENS {
            let message = format!(
                "{} words and signs in one expression, at most {MOST_TOKENS}: define its parts",
                tokens.len()
            );
            return Err(fault(text, 0..text.len().min(60), message));
        }
        let mut parser = Parser { text, tokens, next: 0, depth: 0 };
        let root = parser.expression(0)?;
        match parser.peek() {
            None => Ok(Expr { text: text.to_owned(), root, bare: false }),
            Some(t) => Err(fault(text, t.span.clone(), "unexpected text")),
        }
    }

    /// The expression of a plain number.
    pub fn number(value: f64) -> Expr {
        let text = value.to_string();
        let span = 0..text.len();
        Expr { text, root: Node { kind: Kind::Literal(Value::number(value)), span }, bare: true }
    }

    /// The source text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The names in the expression, in order of appearance.
    pub fn names(&self) -> Vec<&str> {
        fn walk<'a>(node: &'a Node, out: &mut Vec<&'a str>) {
            match &node.kind {
                Kind::Literal(_) => {}
                Kind::Name(n) => out.push(n),
                Kind::Unary(_, a) => walk(a, out),
                Kind::Binary(_, a, b) => {
                    walk(a, out);
                    walk(b, out);
                }
                Kind::Call(_, args) => args.iter().for_each(|a| walk(a, out)),
            }
        }
        let mut out = Vec::new();
        walk(&self.root, &mut out);
        out
    }

    /// Evaluates the expression. `lookup` returns the value of a name, or the reason why it has
    /// none.
    pub fn eval(
        &self,
        lookup: &mut dyn FnMut(&str) -> Result<Value, String>,
    ) -> Result<Value, ExprError> {
        Eval { text: &self.text, lookup }.node(&self.root)
    }

    /// Evaluates the expression as a quantity of dimension `dim`. Where a length is expected, a
    /// bare number is read as mm.
    pub fn eval_as(
        &self,
        dim: Dim,
        lookup: &mut dyn FnMut(&str) -> Result<Value, String>,
    ) -> Result<f64, ExprError> {
        match self.eval(lookup)? {
            Value::Quantity(q) if q.dim == dim || (self.bare && dim == Dim::LENGTH) => Ok(q.value),
            Value::Quantity(q) if q.dim == Dim::NONE => {
                Err(self.whole(format!("a {dim} is wanted, this number has no unit")))
            }
            Value::Quantity(q) => {
                Err(self.whole(format!("a {dim} is wanted, this is a {}", q.dim)))
            }
            Value::Truth(_) => Err(self.whole(format!("a {dim} is wanted, this is true or false"))),
        }
    }

    /// Evaluates the expression as true or false.
    pub fn eval_truth(
        &self,
        lookup: &mut dyn FnMut(&str) -> Result<Value, String>,
    ) -> Result<bool, ExprError> {
        match self.eval(lookup)? {
            Value::Truth(t) => Ok(t),
            Value::Quantity(_) => {
                Err(self.whole("true or false is wanted, this is a number".into()))
            }
        }
    }

    fn whole(&self, message: String) -> ExprError {
        ExprError { message, text: self.text.clone(), span: self.root.span.clone() }
    }
}

impl<'de> Deserialize<'de> for Expr {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        struct V;
        impl de::Visitor<'_> for V {
            type Value = Expr;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number or an expression")
            }
            fn visit_f64<E: de::Error>(self, v: f64) -> Result<Expr, E> {
                if v.is_finite() {
                    Ok(Expr::number(v))
                } else {
                    Err(E::custom("a number must be finite"))
                }
            }
            fn visit_i64<E: de::Error>(self, v: i64) -> Result<Expr, E> {
                Ok(Expr::number(v as f64))
            }
            fn visit_u64<E: de::Error>(self, v: u64) -> Result<Expr, E> {
                Ok(Expr::number(v as f64))
            }
            fn visit_bool<E: de::Error>(self, v: bool) -> Result<Expr, E> {
                Expr::parse(if v { "true" } else { "false" }).map_err(E::custom)
            }
            fn visit_str<E: de::Error>(self, v: &str) -> Result<Expr, E> {
                Expr::parse(v).map_err(|e| E::custom(format_args!("{INVALID_EXPRESSION}{e}")))
            }
        }
        d.deserialize_any(V)
    }
}

impl Serialize for Expr {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        s.serialize_str(&self.text)
    }
}

impl schemars::JsonSchema for Expr {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Expression".into()
    }
    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "A number, true or false, or an expression: numbers with units \
                (`15 mm`), names (`beam.h`, `plate.thickness`), + - * /, comparisons, `and`, `or`, \
                `not`, min, max, abs, if and others (templates/README.md).",
            "type": ["number", "boolean", "string"],
        })
    }
}

#[cfg(test)]
mod tests;
