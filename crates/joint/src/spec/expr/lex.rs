//! Splits an expression into tokens.

use super::value::{ExprError, fault};
use std::ops::Range;

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    Number(f64),
    Word(String),
    Symbol(&'static str),
}

#[derive(Clone, Debug)]
pub(super) struct Spanned {
    pub(super) token: Token,
    pub(super) span: Range<usize>,
}

const SYMBOLS: [&str; 14] =
    ["<=", ">=", "==", "!=", "<", ">", "+", "-", "*", "/", "^", "(", ")", ","];

pub(super) fn lex(text: &str) -> Result<Vec<Spanned>, ExprError> {
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
            // an exponent needs digits; without them, `2 e` is a number and a name
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
        } else if text[start..].starts_with('−') {
            // the minus sign of typesetting, as a report prints it
            i += '−'.len_utf8();
            Token::Symbol("-")
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
