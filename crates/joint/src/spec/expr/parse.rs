//! Parser of expressions (Pratt). Binding powers decide which operands belong to an operator.

use super::lex::{Spanned, Token};
use super::node::{Kind, Node};
use super::value::{ExprError, Value, fault};
use bracket_base::units::{self, Quantity};
use std::ops::Range;

/// Deepest nesting that is accepted. It protects the stack against hostile input.
const MAX_DEPTH: usize = 64;

pub(super) struct Parser<'a> {
    pub(super) text: &'a str,
    pub(super) tokens: Vec<Spanned>,
    pub(super) next: usize,
    pub(super) depth: usize,
}

/// Left and right binding powers of the binary operators. An operator with right < left is
/// right-associative.
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
    pub(super) fn peek(&self) -> Option<&Spanned> {
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

    pub(super) fn expression(&mut self, power: u8) -> Result<Node, ExprError> {
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

    /// Reads the unit after a number, as long as possible: `12 mm`, `8 kN`, `8 kN m`, `5 N/mm2`.
    fn with_unit(&mut self, value: f64, span: Range<usize>) -> Node {
        let rest = &self.tokens[self.next.min(self.tokens.len())..];
        for n in (1..=3.min(rest.len())).rev() {
            let end = rest[n - 1].span.end;
            // `*` behind a unit multiplies what follows: `10 mm * x`
            let words = [&rest[0], &rest[n - 1]];
            let is_unit = words.iter().all(|t| matches!(t.token, Token::Word(_)));
            if let Some((factor, dim)) =
                units::unit(&self.text[rest[0].span.start..end]).filter(|_| is_unit)
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
