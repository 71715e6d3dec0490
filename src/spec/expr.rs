//! Expressions of templates: numbers with units, dotted names, arithmetic, comparisons and a few
//! functions.
//!
//! A Pratt parser; every node keeps its byte range so that an error points at its operand.
//! Dimensions are checked while evaluating: `t + F` is an error, not a number. A result that is not
//! finite is an error too.

use crate::units::{self, Dim, Quantity};
use serde::{Deserialize, Deserializer, de};
use std::fmt;
use std::ops::Range;

/// Opens the message of an expression that cannot be read, so that the YAML reader knows it from a
/// syntax error.
pub const INVALID_EXPRESSION: &str = "invalid expression: ";

/// A value: a quantity or a truth.
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
    /// A pure number.
    pub fn number(value: f64) -> Self {
        Value::Quantity(Quantity { value, dim: Dim::NONE })
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Truth(t) => write!(f, "{t}"),
            Value::Quantity(q) => {
                // nine digits hide the rounding of decimal input; messages need no more
                let text = format!("{:.9}", q.value);
                let text = text.trim_end_matches('0').trim_end_matches('.');
                f.write_str(if text == "-0" { "0" } else { text })?;
                match q.dim {
                    Dim::NONE => Ok(()),
                    Dim::LENGTH => f.write_str(" mm"),
                    Dim::FORCE => f.write_str(" N"),
                    Dim::STRESS => f.write_str(" MPa"),
                    Dim::MOMENT => f.write_str(" N mm"),
                    Dim::ANGLE => f.write_str(" rad"),
                    other => write!(f, " {other}"),
                }
            }
        }
    }
}

/// Why an expression has no value; `span` is a byte range of `text`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message} (in `{text}`, at `{}`)", self.excerpt())]
pub struct ExprError {
    /// What is wrong.
    pub message: String,
    /// The whole expression.
    pub text: String,
    /// The faulty piece of it.
    pub span: Range<usize>,
}

impl ExprError {
    /// The faulty piece; `end` when it lies behind the last character.
    pub fn excerpt(&self) -> &str {
        self.text.get(self.span.clone()).filter(|t| !t.is_empty()).unwrap_or("end")
    }
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Literal(Value),
    Name(String),
    Unary(char, Box<Node>),
    Binary(&'static str, Box<Node>, Box<Node>),
    Call(String, Vec<Node>),
}

#[derive(Clone, Debug, PartialEq)]
struct Node {
    kind: Kind,
    span: Range<usize>,
}

/// A parsed expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    text: String,
    root: Node,
    /// A plain number of the YAML file, read as mm where a length is wanted.
    bare: bool,
}

/// Deepest nesting accepted; guards the stack against hostile input.
const MAX_DEPTH: usize = 64;

impl Expr {
    /// Parses a text.
    pub fn parse(text: &str) -> Result<Expr, ExprError> {
        let tokens = lex(text)?;
        let mut parser = Parser { text, tokens, next: 0, depth: 0 };
        let root = parser.expression(0)?;
        match parser.peek() {
            None => Ok(Expr { text: text.to_owned(), root, bare: false }),
            Some(t) => Err(fault(text, t.span.clone(), "unexpected text")),
        }
    }

    /// A plain number.
    pub fn number(value: f64) -> Expr {
        let text = value.to_string();
        let span = 0..text.len();
        Expr { text, root: Node { kind: Kind::Literal(Value::number(value)), span }, bare: true }
    }

    /// The text it was read from.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The names it mentions, in order of appearance.
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

    /// Its value; `lookup` gives the values of names, or says why there is none.
    pub fn eval(
        &self,
        lookup: &mut dyn FnMut(&str) -> Result<Value, String>,
    ) -> Result<Value, ExprError> {
        Eval { text: &self.text, lookup }.node(&self.root)
    }

    /// Its value as a quantity of dimension `dim`; a bare number counts as mm where a length is
    /// wanted.
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

    /// Its value as a truth.
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

impl schemars::JsonSchema for Expr {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Expression".into()
    }
    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "A number, true or false, or an expression: numbers with units (`15 mm`), names (`beam.h`, `plate.thickness`), \
                + - * /, comparisons, `and`, `or`, `not`, min, max, abs, if and others (templates/README.md).",
            "type": ["number", "boolean", "string"],
        })
    }
}

fn fault(text: &str, span: Range<usize>, message: impl Into<String>) -> ExprError {
    ExprError { message: message.into(), text: text.to_owned(), span }
}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Number(f64),
    Word(String),
    Symbol(&'static str),
}

#[derive(Clone, Debug)]
struct Spanned {
    token: Token,
    span: Range<usize>,
}

const SYMBOLS: [&str; 14] =
    ["<=", ">=", "==", "!=", "<", ">", "+", "-", "*", "/", "^", "(", ")", ","];

fn lex(text: &str) -> Result<Vec<Spanned>, ExprError> {
    let bytes = text.as_bytes();
    let mut out = Vec::new();
    let mut i = 0;
    while i < bytes.len() {
        let start = i;
        let b = bytes[i];
        if b.is_ascii_whitespace() {
            i += 1;
            continue;
        }
        let token = if b.is_ascii_digit()
            || (b == b'.' && bytes.get(i + 1).is_some_and(u8::is_ascii_digit))
        {
            while i < bytes.len() && (bytes[i].is_ascii_digit() || bytes[i] == b'.') {
                i += 1;
            }
            // an exponent only if digits follow, so that `2 e` stays a number and a name
            if matches!(bytes.get(i), Some(b'e' | b'E')) {
                let sign = usize::from(matches!(bytes.get(i + 1), Some(b'+' | b'-')));
                if bytes.get(i + 1 + sign).is_some_and(u8::is_ascii_digit) {
                    i += 2 + sign;
                    while bytes.get(i).is_some_and(u8::is_ascii_digit) {
                        i += 1;
                    }
                }
            }
            let value: f64 =
                text[start..i].parse().map_err(|_| fault(text, start..i, "not a number"))?;
            if !value.is_finite() {
                return Err(fault(text, start..i, "number too large"));
            }
            Token::Number(value)
        } else if b.is_ascii_alphabetic() || b == b'_' {
            let word = |c: u8| c.is_ascii_alphanumeric() || c == b'_';
            while i < bytes.len()
                && (word(bytes[i])
                    || (bytes[i] == b'.' && bytes.get(i + 1).is_some_and(|&c| word(c))))
            {
                i += 1;
            }
            Token::Word(text[start..i].to_owned())
        } else if let Some(s) = SYMBOLS.iter().find(|s| text[start..].starts_with(**s)) {
            i += s.len();
            Token::Symbol(s)
        } else {
            let end = start + text[start..].chars().next().map_or(1, char::len_utf8);
            return Err(fault(text, start..end, "character not known in expressions"));
        };
        out.push(Spanned { token, span: start..i });
    }
    Ok(out)
}

struct Parser<'a> {
    text: &'a str,
    tokens: Vec<Spanned>,
    next: usize,
    depth: usize,
}

/// Binding powers (left, right) of binary operators; right-associative where right < left.
fn binding(op: &str) -> Option<(&'static str, u8, u8)> {
    Some(match op {
        "or" => ("or", 1, 2),
        "and" => ("and", 3, 4),
        "<" => ("<", 7, 8),
        "<=" => ("<=", 7, 8),
        ">" => (">", 7, 8),
        ">=" => (">=", 7, 8),
        "==" => ("==", 7, 8),
        "!=" => ("!=", 7, 8),
        "+" => ("+", 9, 10),
        "-" => ("-", 9, 10),
        "*" => ("*", 11, 12),
        "/" => ("/", 11, 12),
        "^" => ("^", 16, 15),
        _ => return None,
    })
}

const NOT_POWER: u8 = 5;
const MINUS_POWER: u8 = 13;

impl Parser<'_> {
    fn peek(&self) -> Option<&Spanned> {
        self.tokens.get(self.next)
    }

    fn take(&mut self) -> Result<Spanned, ExprError> {
        let t = self.peek().cloned();
        self.next += 1;
        t.ok_or_else(|| {
            fault(self.text, self.text.len()..self.text.len(), "the expression ends too early")
        })
    }

    fn expect(&mut self, symbol: &'static str) -> Result<usize, ExprError> {
        let t = self.take()?;
        if t.token == Token::Symbol(symbol) {
            Ok(t.span.end)
        } else {
            Err(fault(self.text, t.span, format!("`{symbol}` expected")))
        }
    }

    fn expression(&mut self, power: u8) -> Result<Node, ExprError> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(fault(self.text, 0..self.text.len(), "nested too deeply"));
        }
        let mut left = self.operand()?;
        while let Some(t) = self.peek() {
            let op = match &t.token {
                Token::Symbol(s) => *s,
                Token::Word(w) => w.as_str(),
                Token::Number(_) => break,
            };
            let Some((op, _, r)) = binding(op).filter(|(_, l, _)| *l >= power) else { break };
            self.next += 1;
            let right = self.expression(r)?;
            let span = left.span.start..right.span.end;
            left = Node { kind: Kind::Binary(op, Box::new(left), Box::new(right)), span };
        }
        self.depth -= 1;
        Ok(left)
    }

    fn operand(&mut self) -> Result<Node, ExprError> {
        let t = self.take()?;
        let start = t.span.start;
        match t.token {
            Token::Number(value) => Ok(self.with_unit(value, t.span)),
            Token::Symbol("(") => {
                let inner = self.expression(0)?;
                let end = self.expect(")")?;
                Ok(Node { span: start..end, ..inner })
            }
            Token::Symbol("-") => {
                let a = self.expression(MINUS_POWER)?;
                Ok(Node { span: start..a.span.end, kind: Kind::Unary('-', Box::new(a)) })
            }
            Token::Word(w) if w == "not" => {
                let a = self.expression(NOT_POWER)?;
                Ok(Node { span: start..a.span.end, kind: Kind::Unary('!', Box::new(a)) })
            }
            Token::Word(w) if w == "true" || w == "false" => {
                Ok(Node { kind: Kind::Literal(Value::Truth(w == "true")), span: t.span })
            }
            Token::Word(w) if w != "and" && w != "or" => {
                if self.peek().is_some_and(|t| t.token == Token::Symbol("(")) {
                    self.next += 1;
                    let mut args = vec![self.expression(0)?];
                    while self.peek().is_some_and(|t| t.token == Token::Symbol(",")) {
                        self.next += 1;
                        args.push(self.expression(0)?);
                    }
                    let end = self.expect(")")?;
                    return Ok(Node { kind: Kind::Call(w, args), span: start..end });
                }
                Ok(Node { kind: Kind::Name(w), span: t.span })
            }
            _ => Err(fault(self.text, t.span, "a number, a name or `(` expected")),
        }
    }

    /// A number takes the longest unit that follows it: `12 mm`, `8 kN`, `8 kN m`, `5 N/mm2`.
    fn with_unit(&mut self, value: f64, span: Range<usize>) -> Node {
        let rest = &self.tokens[self.next.min(self.tokens.len())..];
        for n in (1..=3.min(rest.len())).rev() {
            let end = rest[n - 1].span.end;
            let starts_with_word = matches!(rest[0].token, Token::Word(_));
            if let Some((factor, dim)) =
                units::unit(&self.text[rest[0].span.start..end]).filter(|_| starts_with_word)
            {
                self.next += n;
                let quantity = Quantity { value: value * factor, dim };
                return Node {
                    kind: Kind::Literal(Value::Quantity(quantity)),
                    span: span.start..end,
                };
            }
        }
        Node { kind: Kind::Literal(Value::number(value)), span }
    }
}

struct Eval<'a> {
    text: &'a str,
    lookup: &'a mut dyn FnMut(&str) -> Result<Value, String>,
}

impl Eval<'_> {
    fn node(&mut self, node: &Node) -> Result<Value, ExprError> {
        let value = match &node.kind {
            Kind::Literal(v) => *v,
            Kind::Name(name) => {
                (self.lookup)(name).map_err(|m| fault(self.text, node.span.clone(), m))?
            }
            Kind::Unary('!', a) => Value::Truth(!self.truth(a)?),
            Kind::Unary(_, a) => {
                let q = self.quantity(a)?;
                Value::Quantity(Quantity { value: -q.value, ..q })
            }
            Kind::Binary(op, a, b) => self.binary(op, a, b, node)?,
            Kind::Call(name, args) => self.call(name, args, node)?,
        };
        match value {
            Value::Quantity(q) if !q.value.is_finite() => Err(fault(
                self.text,
                node.span.clone(),
                format!("the result is not finite ({})", q.value),
            )),
            _ => Ok(value),
        }
    }

    fn truth(&mut self, node: &Node) -> Result<bool, ExprError> {
        match self.node(node)? {
            Value::Truth(t) => Ok(t),
            Value::Quantity(_) => {
                Err(fault(self.text, node.span.clone(), "true or false is wanted here"))
            }
        }
    }

    fn quantity(&mut self, node: &Node) -> Result<Quantity, ExprError> {
        match self.node(node)? {
            Value::Quantity(q) => Ok(q),
            Value::Truth(_) => Err(fault(self.text, node.span.clone(), "a number is wanted here")),
        }
    }

    /// Two quantities of the same dimension.
    fn pair(&mut self, a: &Node, b: &Node) -> Result<(f64, f64, Dim), ExprError> {
        let (p, q) = (self.quantity(a)?, self.quantity(b)?);
        if p.dim == q.dim {
            Ok((p.value, q.value, p.dim))
        } else {
            Err(fault(
                self.text,
                b.span.clone(),
                format!("units do not match: {} and {}", p.dim, q.dim),
            ))
        }
    }

    fn binary(&mut self, op: &str, a: &Node, b: &Node, node: &Node) -> Result<Value, ExprError> {
        let overflow = || fault(self.text, node.span.clone(), "the unit's exponent is too large");
        Ok(match op {
            // lazy, so that a guard protects what follows it
            "and" => Value::Truth(self.truth(a)? && self.truth(b)?),
            "or" => Value::Truth(self.truth(a)? || self.truth(b)?),
            "*" | "/" => {
                let overflow = overflow();
                let (p, q) = (self.quantity(a)?, self.quantity(b)?);
                let (value, sign) =
                    if op == "*" { (p.value * q.value, 1) } else { (p.value / q.value, -1) };
                let dim = q.dim.power(sign).and_then(|d| p.dim.times(d)).ok_or(overflow)?;
                Value::Quantity(Quantity { value, dim })
            }
            "^" => {
                let overflow = overflow();
                let (p, q) = (self.quantity(a)?, self.quantity(b)?);
                if q.dim != Dim::NONE {
                    return Err(fault(self.text, b.span.clone(), "an exponent has no unit"));
                }
                let dim = if p.dim == Dim::NONE {
                    Dim::NONE
                } else if q.value.fract() == 0.0 && q.value.abs() <= 16.0 {
                    p.dim.power(q.value as i8).ok_or(overflow)?
                } else {
                    return Err(fault(
                        self.text,
                        b.span.clone(),
                        "a quantity with a unit takes a whole exponent up to 16",
                    ));
                };
                Value::Quantity(Quantity { value: p.value.powf(q.value), dim })
            }
            "+" | "-" => {
                let (p, q, dim) = self.pair(a, b)?;
                Value::Quantity(Quantity { value: if op == "+" { p + q } else { p - q }, dim })
            }
            _ => {
                let (p, q, _) = self.pair(a, b)?;
                Value::Truth(match op {
                    "<" => p < q,
                    "<=" => p <= q,
                    ">" => p > q,
                    ">=" => p >= q,
                    "==" => p == q,
                    _ => p != q,
                })
            }
        })
    }

    fn call(&mut self, name: &str, args: &[Node], node: &Node) -> Result<Value, ExprError> {
        const FUNCTIONS: [&str; 7] = ["min", "max", "abs", "sqrt", "ceil", "round_up", "if"];
        if !FUNCTIONS.contains(&name) {
            let hint = crate::diag::did_you_mean(name, FUNCTIONS);
            let known = FUNCTIONS.join(", ");
            return Err(fault(
                self.text,
                node.span.clone(),
                format!("unknown function `{name}`{hint} (known: {known})"),
            ));
        }
        let wanted = match name {
            "min" | "max" => args.len().max(1),
            "round_up" => 2,
            "if" => 3,
            _ => 1,
        };
        if args.len() != wanted {
            let message = format!("`{name}` takes {wanted} argument(s), not {}", args.len());
            return Err(fault(self.text, node.span.clone(), message));
        }
        match name {
            "if" => {
                let chosen = if self.truth(&args[0])? { &args[1] } else { &args[2] };
                self.node(chosen)
            }
            "abs" | "ceil" | "sqrt" => {
                let q = self.quantity(&args[0])?;
                match name {
                    "abs" => Ok(Value::Quantity(Quantity { value: q.value.abs(), ..q })),
                    "ceil" if q.dim == Dim::NONE => Ok(Value::number(q.value.ceil())),
                    "sqrt"
                        if q.dim.length % 2 == 0
                            && q.dim.force % 2 == 0
                            && q.dim.angle % 2 == 0 =>
                    {
                        let dim = Dim {
                            length: q.dim.length / 2,
                            force: q.dim.force / 2,
                            angle: q.dim.angle / 2,
                        };
                        Ok(Value::Quantity(Quantity { value: q.value.sqrt(), dim }))
                    }
                    "ceil" => Err(fault(
                        self.text,
                        node.span.clone(),
                        "`ceil` takes a number without unit; use round_up(x, step)",
                    )),
                    _ => Err(fault(
                        self.text,
                        node.span.clone(),
                        format!("`sqrt` of a {} has no unit", q.dim),
                    )),
                }
            }
            "round_up" => {
                let (x, step, dim) = self.pair(&args[0], &args[1])?;
                if step <= 0.0 {
                    return Err(fault(
                        self.text,
                        args[1].span.clone(),
                        "the step of `round_up` must be positive",
                    ));
                }
                // a hair below a multiple counts as the multiple: 0.1 + 0.2 is not 0.4
                Ok(Value::Quantity(Quantity { value: (x / step - 1e-9).ceil() * step, dim }))
            }
            _ => {
                let mut best = self.quantity(&args[0])?;
                for a in &args[1..] {
                    let (_, x, _) = self.pair(&args[0], a)?;
                    best.value = if name == "min" { best.value.min(x) } else { best.value.max(x) };
                }
                Ok(Value::Quantity(best))
            }
        }
    }
}

#[cfg(test)]
mod tests;
