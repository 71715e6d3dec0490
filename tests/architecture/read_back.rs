//! Finds code that reads back what it wrote for people: comparisons of a text with words.

use super::tokens::{tokens_with_literals, without_tests};
use std::collections::BTreeMap;

/// Methods that look into a text.
const LOOKS: [&str; 13] = [
    "contains",
    "starts_with",
    "ends_with",
    "strip_prefix",
    "strip_suffix",
    "find",
    "rfind",
    "split_once",
    "rsplit_once",
    "split",
    "matches",
    "eq",
    "eq_ignore_ascii_case",
];

/// The content of a string literal as written; `None` of any other token.
pub fn content(token: &str) -> Option<String> {
    let body = token.trim_start_matches(['b', 'c', 'r', '#']).strip_prefix('"')?;
    let body = body.trim_end_matches('#').strip_suffix('"')?;
    // a line that goes on
    let (first, others) = body.split_once("\\\n").unwrap_or((body, ""));
    Some(first.to_owned() + &others.split("\\\n").map(str::trim_start).collect::<String>())
}

/// The string literals of a source, without its tests.
pub fn literals(text: &str) -> Vec<String> {
    let (code, _) = without_tests(&tokens_with_literals(text));
    code.iter().filter_map(|t| content(t)).collect()
}

/// Whether a text is one that people read: several words, or one of `words`.
fn human(text: &str, words: &[String]) -> bool {
    let letters = |word: &str| word.chars().filter(|c| c.is_alphabetic()).count() > 1;
    let several = text.contains(char::is_whitespace) && text.split_whitespace().any(letters);
    several || words.iter().any(|w| w == text)
}

/// Constants whose value is a text that people read, with that text.
pub fn constants(code: &[String], words: &[String]) -> BTreeMap<String, String> {
    let named =
        code.windows(2).enumerate().filter(|(_, w)| w[0] == "const").filter_map(|(i, w)| {
            let value = code.get(i..)?.iter().take(10).skip_while(|t| *t != "=").nth(1)?;
            Some((w[1].clone(), content(value).filter(|text| human(text, words))?))
        });
    named.collect()
}

/// The texts that people read with which code compares another text: by `==` and `!=`, by methods
/// that look into a text, as patterns.
pub fn read_back(text: &str, words: &[String], names: &BTreeMap<String, String>) -> Vec<String> {
    let (code, _) = without_tests(&tokens_with_literals(text));
    let at = |i: usize| code.get(i).map_or("", String::as_str);
    let known = |i: usize| {
        let text = content(at(i)).or_else(|| names.get(at(i)).cloned())?;
        human(&text, words).then_some(text)
    };
    let mut out = Vec::new();
    for i in 0..code.len() {
        match at(i) {
            // a == "text", "text" == a
            "=" if at(i + 1) == "=" => {
                let right = if matches!(at(i + 2), "&" | "*") { i + 3 } else { i + 2 };
                out.extend(known(right).into_iter().chain(i.checked_sub(1).and_then(known)));
            }
            "!" if at(i + 1) == "=" => {
                let right = if matches!(at(i + 2), "&" | "*") { i + 3 } else { i + 2 };
                out.extend(known(right).into_iter().chain(i.checked_sub(1).and_then(known)));
            }
            // a.contains("text"), a.contains(["text", …])
            "." if LOOKS.contains(&at(i + 1)) && at(i + 2) == "(" => {
                let end = closed(&code, i + 2);
                out.extend((i + 3..end).filter(|k| direct(&code, i + 2, *k)).filter_map(known));
                // ["text", …].contains(a)
                if i > 0 && at(i - 1) == "]" {
                    out.extend((opened(&code, i - 1)..i).filter_map(known));
                }
            }
            // matches!(a, "text" | …)
            "matches" if at(i + 1) == "!" => {
                let end = closed(&code, i + 2);
                let comma = (i + 3..end).find(|k| at(*k) == "," && depth(&code, i + 2, *k) == 1);
                out.extend((comma.unwrap_or(end)..end).filter_map(known));
            }
            // "text" | … =>
            "=" if at(i + 1) == ">" => {
                out.extend(pattern(&code, i).filter_map(known));
            }
            _ => {}
        }
    }
    out
}

/// Brackets that are open at `at`, counted from `from`.
fn depth(code: &[String], from: usize, at: usize) -> usize {
    code[from..at].iter().fold(0usize, |d, t| match t.as_str() {
        "(" | "[" | "{" => d + 1,
        ")" | "]" | "}" => d.saturating_sub(1),
        _ => d,
    })
}

/// Whether the token `at` is an argument of the call whose bracket opens at `open`, or an item of
/// a list that is its first argument.
fn direct(code: &[String], open: usize, at: usize) -> bool {
    let inner = depth(code, open, at);
    let list = code[open + 1..].iter().find(|t| *t != "&").is_some_and(|t| t == "[");
    inner == 1 || list && inner == 2
}

/// The position of the bracket that closes the one at `open`.
fn closed(code: &[String], open: usize) -> usize {
    (open + 1..code.len()).find(|k| depth(code, open, *k + 1) == 0).unwrap_or(code.len())
}

/// The position of the bracket that opens the one that closes at `close`.
fn opened(code: &[String], close: usize) -> usize {
    let mut depth = 0;
    for i in (0..=close).rev() {
        match code[i].as_str() {
            ")" | "]" | "}" => depth += 1,
            "(" | "[" | "{" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return i;
        }
    }
    0
}

/// The tokens of the pattern in front of the arrow at `arrow`, with its guard.
fn pattern(code: &[String], arrow: usize) -> impl Iterator<Item = usize> {
    let mut start = arrow;
    while start > 0 {
        start = match code[start - 1].as_str() {
            ")" | "]" => opened(code, start - 1),
            "}" if start == arrow => opened(code, start - 1),
            "," | "{" | "}" | "(" | "[" => break,
            _ => start - 1,
        };
    }
    start..arrow
}
