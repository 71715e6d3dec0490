//! Texts with symbols as pieces: `F_t,Rd` is a letter with its subscript. The fractions of formulas
//! are in [`super::derivation`].

use serde::Serialize;

/// A piece of a formula.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Piece {
    /// Text on the line.
    pub text: String,
    /// True for a symbol, which is set in italics.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub symbol: bool,
    /// Subscript.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub below: String,
    /// Numerator of a fraction, which has no text.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub top: Vec<Piece>,
    /// Its denominator.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub bottom: Vec<Piece>,
}

impl Piece {
    /// A text without symbols.
    pub fn text(text: impl Into<String>) -> Self {
        Self { text: text.into(), ..Self::default() }
    }
}

/// Marks that stand on the letter before them: the overline of λ̄.
fn is_mark(c: char) -> bool {
    ('\u{300}'..='\u{36f}').contains(&c)
}

/// Raised digits, which belong to the symbol and not to its subscript.
fn is_power(c: char) -> bool {
    matches!(c, '²' | '³' | '¹' | '⁴')
}

/// The pieces of a text. A letter is a symbol where a subscript follows it: `F_t,Rd`, `e1`.
pub fn pieces(text: &str) -> Vec<Piece> {
    let chars: Vec<char> = text.chars().collect();
    let mut out: Vec<Piece> = Vec::new();
    let mut i = 0;
    while i < chars.len() {
        let start = i;
        while i < chars.len() && (chars[i].is_alphabetic() || is_mark(chars[i])) {
            i += 1;
        }
        let word: String = chars[start..i].iter().collect();
        let found = if word.is_empty() { None } else { below(&chars, start, i) };
        match found {
            Some((below, end)) => {
                out.push(Piece { text: word, symbol: true, below, ..Piece::default() });
                i = end;
            }
            None => {
                if word.is_empty() {
                    i += 1;
                }
                let text: String = chars[start..i].iter().collect();
                match out.last_mut().filter(|last| !last.symbol) {
                    Some(last) => last.text.push_str(&text),
                    None => out.push(Piece::text(text)),
                }
            }
        }
    }
    out
}

/// The subscript of the word of letters from `start` to `end`, and where it ends.
fn below(chars: &[char], start: usize, end: usize) -> Option<(String, usize)> {
    let letters = chars[start..end].iter().filter(|c| !is_mark(**c)).count();
    let in_word = start > 0 && chars[start - 1].is_alphanumeric();
    match chars.get(end)? {
        '_' if letters <= 2 => subscript(chars, end + 1),
        c if c.is_ascii_digit() && letters == 1 && !in_word && chars[start].is_lowercase() => {
            digits(chars, end)
        }
        _ => None,
    }
}

/// The subscript from a place on: letters and digits, commas and dashes between them.
fn subscript(chars: &[char], start: usize) -> Option<(String, usize)> {
    let word = |c: Option<&char>| c.is_some_and(|c| c.is_alphanumeric() && !is_power(*c));
    let mut end = start;
    while end < chars.len() {
        let joins =
            matches!(chars[end], ',' | '–' | '-') && end > start && word(chars.get(end + 1));
        if !(word(chars.get(end)) || is_mark(chars[end]) || joins) {
            break;
        }
        end += 1;
    }
    (end > start).then(|| (chars[start..end].iter().collect(), end))
}

/// The digits from a place on, as a subscript.
fn digits(chars: &[char], start: usize) -> Option<(String, usize)> {
    let count = chars[start..].iter().take_while(|c| c.is_ascii_digit()).count();
    let end = start + count;
    // `e1` is a symbol, `x2.5` and `d16x` are not
    let ends = chars.get(end).is_none_or(|c| !c.is_alphanumeric() && *c != '.');
    (count == 1 && ends).then(|| (chars[start..end].iter().collect(), end))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pieces as text: symbols in brackets.
    fn shown(formula: &str) -> String {
        let one = |p: Piece| match p.symbol {
            true => format!("[{}|{}]", p.text, p.below),
            false => p.text,
        };
        pieces(formula).into_iter().map(one).collect()
    }

    #[test]
    fn symbols_have_their_subscripts() {
        for (formula, want) in [
            (
                "F_t,Rd = k2 f_ub A_s / γ_M2 = 0.9 · 800 · 157 / 1.25 = 90.43 kN; k2 = 0.9",
                "[F|t,Rd] = [k|2] [f|ub] [A|s] / [γ|M2] = 0.9 · 800 · 157 / 1.25 = 90.43 kN; \
                 [k|2] = 0.9",
            ),
            (
                "max(F_v,Ed/F_v,Rd + F_t,Ed/(1.4 F_t,Rd), F_t,Ed/F_t,Rd)",
                "max([F|v,Ed]/[F|v,Rd] + [F|t,Ed]/(1.4 [F|t,Rd]), [F|t,Ed]/[F|t,Rd])",
            ),
            ("λ̄_p = 0.5, F_T,1-2,Rd", "[λ̄|p] = 0.5, [F|T,1-2,Rd]"),
            ("order M16 × 50, 4 for each end plate", "order M16 × 50, 4 for each end plate"),
            ("e1 = 70 mm ≥ 1.2 d0", "[e|1] = 70 mm ≥ 1.2 [d|0]"),
            ("ΣF_t,Rd and 8.8", "[ΣF|t,Rd] and 8.8"),
            ("A_w²/(4 t_w)", "[A|w]²/(4 [t|w])"),
        ] {
            assert_eq!(shown(formula), want);
        }
    }
}
