//! The syntax tree of an expression.

use super::value::Value;
use std::ops::Range;

#[derive(Clone, Debug, PartialEq)]
/// Kind of a node with its operands.
pub(super) enum Kind {
    Literal(Value),
    Name(String),
    Unary(char, Box<Node>),
    Binary(&'static str, Box<Node>, Box<Node>),
    Call(String, Vec<Node>),
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node {
    pub(super) kind: Kind,
    pub(super) span: Range<usize>,
}
