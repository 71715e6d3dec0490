//! Formulas with their fractions.
//!
//! A stroke divides what stands to its left, a product of factors, by the one factor to its right:
//! `0.9 f_y A_vc/(√3 γ_M0)`. Where it is not between factors, as in a word, it stays a stroke.

use super::formula::{Piece, is_power, pieces};

/// Units behind a number, longer ones first. `m` alone is a symbol.
const UNITS: [&str; 8] = ["kN m/rad", "kN m", "kN", "N/mm", "mm²", "mm", "MPa", "rad"];

/// An element of a row.
#[derive(Clone, Debug)]
struct Item {
    kind: Kind,
    pieces: Vec<Piece>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// A number, a symbol, a root, a call.
    Factor,
    /// A number with its unit.
    Measure,
    /// One letter, which may also be an article.
    Letter,
    /// Something in brackets, which are its first and last piece.
    Group,
    /// Blanks and points between factors.
    Glue,
    /// The stroke.
    Stroke,
    /// A fraction.
    Fraction,
    /// A word of a sentence.
    Word,
    /// Everything else.
    Break,
}

/// The pieces of a formula, with fractions.
pub fn formula(text: &str) -> Vec<Piece> {
    let chars: Vec<char> = text.chars().collect();
    let mut at = 0;
    let items = row(&chars, &mut at, false);
    joined(items.into_iter().flat_map(|i| i.pieces))
}

/// Neighbouring texts as one.
fn joined(pieces: impl Iterator<Item = Piece>) -> Vec<Piece> {
    let mut out: Vec<Piece> = Vec::new();
    for piece in pieces {
        let plain = |p: &Piece| !p.symbol && p.top.is_empty();
        match out.last_mut().filter(|last| plain(last) && plain(&piece)) {
            Some(last) => last.text.push_str(&piece.text),
            None => out.push(piece),
        }
    }
    out
}

/// The items up to the end, or up to the bracket that closes the row.
fn row(chars: &[char], at: &mut usize, in_group: bool) -> Vec<Item> {
    let mut items = Vec::new();
    while *at < chars.len() && !(in_group && chars[*at] == ')') {
        let item = item(chars, at);
        items.push(item);
    }
    fractions(items)
}

fn item(chars: &[char], at: &mut usize) -> Item {
    let start = *at;
    let text = |from: usize, to: usize| chars[from..to].iter().collect::<String>();
    let new = |kind, text: String| Item { kind, pieces: vec![Piece::text(text)] };
    let c = chars[start];
    *at += 1;
    match c {
        '(' => group(chars, at),
        '/' => new(Kind::Stroke, "/".into()),
        ' ' | '·' => {
            while chars.get(*at).is_some_and(|c| matches!(c, ' ' | '·')) {
                *at += 1;
            }
            new(Kind::Glue, text(start, *at))
        }
        // a root or a sum with what it stands before
        '√' | 'Σ'
            if chars.get(*at).is_some_and(|n| *n == '(' || (c == '√' && n.is_alphanumeric())) =>
        {
            let mut inner = item(chars, at);
            inner.pieces.insert(0, Piece::text(c));
            Item { kind: Kind::Factor, pieces: inner.pieces }
        }
        // a sum over the product behind it
        'Σ' if chars.get(*at) == Some(&' ') => new(Kind::Break, c.into()),
        c if c.is_ascii_digit() => {
            let kind = if number(chars, at) { Kind::Measure } else { Kind::Factor };
            // a unit stays on the line of its number
            new(kind, text(start, *at).replace(' ', "\u{a0}"))
        }
        c if c.is_alphabetic() => {
            word(chars, at);
            let found = pieces(&text(start, *at));
            let kind = match found.as_slice() {
                [p] if !p.symbol && letters(&p.text) > 1 => Kind::Word,
                [p] if !p.symbol => Kind::Letter,
                _ => Kind::Factor,
            };
            let call = matches!(found[0].text.as_str(), "max" | "min") && found.len() == 1;
            if call && chars.get(*at) == Some(&'(') {
                *at += 1;
                let arguments = group(chars, at);
                let pieces = found.into_iter().chain(arguments.pieces).collect();
                return Item { kind: Kind::Factor, pieces };
            }
            Item { kind, pieces: found }
        }
        c => new(Kind::Break, c.into()),
    }
}

fn letters(word: &str) -> usize {
    word.chars().filter(|c| c.is_alphabetic()).count()
}

/// What stands in brackets, with them and with a power behind them.
fn group(chars: &[char], at: &mut usize) -> Item {
    let inside = row(chars, at, true);
    let mut all = vec![Piece::text("(")];
    all.extend(joined(inside.into_iter().flat_map(|i| i.pieces)));
    if chars.get(*at) != Some(&')') {
        return Item { kind: Kind::Break, pieces: all };
    }
    *at += 1;
    let mut close = ")".to_string();
    while let Some(c) = chars.get(*at).filter(|c| is_power(**c)) {
        close.push(*c);
        *at += 1;
    }
    let kind = if close == ")" { Kind::Group } else { Kind::Factor };
    all.push(Piece::text(close));
    Item { kind, pieces: all }
}

/// Moves behind the number and its unit; true if it has one.
fn number(chars: &[char], at: &mut usize) -> bool {
    let digit = |i: usize| chars.get(i).is_some_and(|c| c.is_ascii_digit());
    while digit(*at) || (chars.get(*at) == Some(&'.') && digit(*at + 1)) {
        *at += 1;
    }
    // an exponent
    if chars.get(*at) == Some(&'e') {
        let sign = usize::from(chars.get(*at + 1).is_some_and(|c| matches!(c, '-' | '+')));
        if digit(*at + 1 + sign) {
            *at += 1 + sign;
            while digit(*at) {
                *at += 1;
            }
        }
    }
    while chars.get(*at).is_some_and(|c| is_power(*c)) {
        *at += 1;
    }
    let rest: String = chars[*at..].iter().take(12).collect();
    for unit in UNITS {
        let behind = rest.strip_prefix(' ').and_then(|r| r.strip_prefix(unit));
        let ends = |r: &str| r.chars().next().is_none_or(|c| !c.is_alphanumeric() && c != '_');
        if behind.is_some_and(ends) {
            *at += 1 + unit.chars().count();
            return true;
        }
    }
    false
}

/// Moves behind the letters, subscript and power of a word or symbol.
fn word(chars: &[char], at: &mut usize) {
    let inside = |i: usize| {
        let letter = |c: &char| c.is_alphanumeric() || ('\u{300}'..='\u{36f}').contains(c);
        let joins = |c: char| matches!(c, ',' | '.' | '–' | '-' | '_');
        match chars.get(i) {
            Some(c) if letter(c) => true,
            // `F_t,Rd`: a comma, a dash or a point joins where a letter follows at once
            Some(c) if joins(*c) => chars.get(i + 1).is_some_and(letter),
            _ => false,
        }
    };
    while inside(*at) {
        *at += 1;
    }
}

/// Joins what stands round a stroke.
fn fractions(items: Vec<Item>) -> Vec<Item> {
    let mut out: Vec<Item> = Vec::new();
    let mut rest = items.into_iter().peekable();
    while let Some(item) = rest.next() {
        if item.kind != Kind::Stroke {
            out.push(item);
            continue;
        }
        // a stroke may stand between blanks
        let blank = |i: &Item| i.kind == Kind::Glue && i.pieces[0].text.trim().is_empty();
        let before = out.pop_if(|i| blank(i));
        let after = rest.next_if(blank);
        let from = numerator(&out);
        let measured = out[from..].iter().any(|i| i.kind == Kind::Measure);
        // in `30/2 mm` the unit may be that of the quotient
        let divides = |i: &Item| match i.kind {
            Kind::Factor | Kind::Letter | Kind::Group => true,
            Kind::Measure => measured,
            _ => false,
        };
        match rest.next_if(divides) {
            Some(below) if from < out.len() => {
                let top: Vec<Item> = out.split_off(from);
                let alone = top.len() == 1;
                let top = top.into_iter().flat_map(|i| bare(i, alone));
                let piece = Piece {
                    top: joined(top),
                    bottom: joined(bare(below, true).into_iter()),
                    ..Piece::default()
                };
                out.push(Item { kind: Kind::Fraction, pieces: vec![piece] });
            }
            other => {
                out.extend(before);
                out.push(Item { kind: Kind::Break, ..item });
                out.extend(after);
                out.extend(other);
            }
        }
    }
    out
}

/// The place from which the last items are a product; the end where they are none.
fn numerator(items: &[Item]) -> usize {
    let mut from = items.len();
    for (i, item) in items.iter().enumerate().rev() {
        let last = i + 1 == items.len();
        let prose = || i >= 2 && items[i - 1].kind == Kind::Glue && items[i - 2].kind == Kind::Word;
        match item.kind {
            Kind::Factor | Kind::Measure | Kind::Group => from = i,
            // behind a word, a letter away from the stroke may be an article
            Kind::Letter if last || !prose() => from = i,
            Kind::Fraction if last => return i,
            Kind::Glue if !last => {}
            _ => break,
        }
    }
    from
}

/// The pieces of an item of a fraction, where a letter is a symbol. An item alone over or under the
/// line has no brackets.
fn bare(item: Item, alone: bool) -> Vec<Piece> {
    let mut pieces = item.pieces;
    if item.kind == Kind::Letter {
        pieces.iter_mut().for_each(|p| p.symbol = true);
    }
    if alone && item.kind == Kind::Group {
        pieces.pop();
        pieces.remove(0);
    }
    pieces
}

#[cfg(test)]
mod tests;
