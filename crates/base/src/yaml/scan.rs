//! A first look at the characters of a document, before the YAML crate reads it: brackets nested
//! too deep and too many values, on which the crate spends minutes or gigabytes, and surrogate
//! pairs, which it refuses.
//!
//! The look knows quotes, comments and block texts. It reports no syntax errors; that is the work
//! of the crate.

use crate::yaml::outline::BUDGET;
use std::borrow::Cow;
use std::ops::Range;

/// Deepest nesting of brackets that is read; the kinds of the open ones are the bits of a number.
const DEEPEST: usize = 128;

/// Most entries between braces: the time of the crate grows with the square of their number.
const MOST_ENTRIES: usize = 10_000;

/// A limit that a document exceeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Limit {
    /// [`DEEPEST`].
    Depth,
    /// [`MOST_ENTRIES`].
    Entries,
    /// [`BUDGET`].
    Values,
}

/// What the look at a document finds.
#[derive(Debug, Default)]
pub(super) struct Scan {
    /// The first limit that is exceeded, and the byte at which it is.
    pub(super) exceeded: Option<(Limit, usize)>,
    /// Bytes of the double-quoted texts, without their quotes.
    double_quoted: Vec<Range<usize>>,
}

impl Scan {
    /// Looks at a document. Ends at the first limit that it exceeds.
    pub(super) fn of(text: &str) -> Self {
        let bytes = text.as_bytes();
        let mut out = Self::default();
        let (mut i, mut depth) = (0, 0_usize);
        let (mut braces, mut entries) = (0_u128, 0_usize);
        // commas within brackets, keys and items outside: not more than the document has values
        let mut values = 0_usize;
        // true where a value may begin, and right behind a colon
        let (mut begins, mut colon) = (true, false);
        let blank = |b: Option<&u8>| b.is_none_or(u8::is_ascii_whitespace);
        while let Some(&b) = bytes.get(i) {
            let behind_colon = std::mem::take(&mut colon);
            match b {
                b'#' if i == 0 || blank(bytes.get(i - 1)) => i = end_of_line(bytes, i),
                b'"' if begins => {
                    let end = end_of_double(bytes, i + 1);
                    out.double_quoted.push(i + 1..end);
                    i = end;
                    begins = false;
                }
                b'\'' if begins => {
                    i = end_of_single(bytes, i + 1);
                    begins = false;
                }
                b'|' | b'>' if begins && depth == 0 => match end_of_block(text, i) {
                    Some(end) => i = end,
                    None => begins = false,
                },
                b'[' | b'{' if begins => {
                    depth += 1;
                    if depth > DEEPEST {
                        out.exceeded = Some((Limit::Depth, i));
                        return out;
                    }
                    braces = braces << 1 | u128::from(b == b'{');
                }
                b']' | b'}' => {
                    depth = depth.saturating_sub(1);
                    braces >>= 1;
                    begins = false;
                }
                b'\n' | b'\r' => begins = true,
                b' ' | b'\t' => begins |= behind_colon,
                b',' if depth > 0 => {
                    begins = true;
                    entries += (braces & 1) as usize;
                    values += 1;
                    if entries > MOST_ENTRIES {
                        out.exceeded = Some((Limit::Entries, i));
                        return out;
                    }
                }
                // within brackets a value may stand right behind the colon of a quoted key
                b':' => {
                    (begins, colon) = (depth > 0, true);
                    values += usize::from(depth == 0 && blank(bytes.get(i + 1)));
                }
                b'-' if begins && blank(bytes.get(i + 1)) => values += 1,
                b'?' if begins && blank(bytes.get(i + 1)) => {}
                // the value stands behind its anchor
                b'&' if begins => {
                    while !blank(bytes.get(i + 1)) {
                        i += 1;
                    }
                }
                _ => begins = false,
            }
            if values > BUDGET {
                out.exceeded = Some((Limit::Values, i));
                return out;
            }
            i += 1;
        }
        out
    }

    /// The document with every surrogate pair `\ud83d\ude00` of its double-quoted texts as one
    /// character `\U0001F600`. JSON writes characters beyond 16 bits in pairs.
    pub(super) fn joined<'t>(&self, text: &'t str) -> Cow<'t, str> {
        let mut out = Cow::Borrowed(text);
        // from the end, so that the places before stay
        for range in self.double_quoted.iter().rev() {
            for (at, character) in pairs(&text[range.clone()]).into_iter().rev() {
                let at = range.start + at;
                let escape = format!("\\U{:08X}", u32::from(character));
                out.to_mut().replace_range(at..at + PAIR, &escape);
            }
        }
        out
    }
}

/// Bytes of two escapes with four digits.
const PAIR: usize = 12;

/// The surrogate pairs of a double-quoted text: their bytes, and the characters that they write.
fn pairs(text: &str) -> Vec<(usize, char)> {
    let unit = |at: usize| {
        let digits = text.get(at..at + 6)?.strip_prefix("\\u")?;
        let hexadecimal = digits.bytes().all(|b| b.is_ascii_hexdigit());
        if hexadecimal { u16::from_str_radix(digits, 16).ok() } else { None }
    };
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(next) = text[at..].find('\\') {
        at += next;
        let pair = unit(at).zip(unit(at + 6));
        let decoded = pair.and_then(|(a, b)| char::decode_utf16([a, b]).next()?.ok());
        match decoded.filter(|c| u32::from(*c) > 0xffff) {
            Some(character) => {
                found.push((at, character));
                at += PAIR;
            }
            // the character after the backslash belongs to it
            None => at += 1 + text[at + 1..].chars().next().map_or(0, char::len_utf8),
        }
    }
    found
}

/// The byte of the closing quote, or the end of the document.
fn end_of_double(bytes: &[u8], from: usize) -> usize {
    let mut i = from;
    while i < bytes.len() && bytes[i] != b'"' {
        i += if bytes[i] == b'\\' { 2 } else { 1 };
    }
    i.min(bytes.len())
}

/// The same for single quotes, where two stand for one.
fn end_of_single(bytes: &[u8], from: usize) -> usize {
    let mut i = from;
    while i < bytes.len() {
        match (bytes[i], bytes.get(i + 1)) {
            (b'\'', Some(b'\'')) => i += 2,
            (b'\'', _) => break,
            _ => i += 1,
        }
    }
    i
}

/// The last byte before the end of the line.
fn end_of_line(bytes: &[u8], from: usize) -> usize {
    let length = bytes[from..].iter().position(|b| *b == b'\n');
    length.map_or(bytes.len(), |n| from + n).saturating_sub(1)
}

/// The last byte of the block text whose mark `|` or `>` stands at a byte: lines that are indented
/// more than the line of the mark. `None` if the mark begins no block text.
fn end_of_block(text: &str, mark: usize) -> Option<usize> {
    let line = text[..mark].rfind('\n').map_or(0, |i| i + 1);
    let indent = text[line..].len() - text[line..].trim_start_matches(' ').len();
    let first = text[mark + 1..].split('\n').next().unwrap_or_default();
    let rest = first.trim_start_matches(['+', '-', '1', '2', '3', '4', '5', '6', '7', '8', '9']);
    let rest = rest.trim();
    if !rest.is_empty() && !rest.starts_with('#') {
        return None;
    }
    let mut end = mark + 1 + first.len();
    for line in text.get(end + 1..).unwrap_or_default().split('\n') {
        let blanks = line.len() - line.trim_start_matches(' ').len();
        if blanks <= indent && !line.trim().is_empty() {
            break;
        }
        end += 1 + line.len();
    }
    Some(end.min(text.len()).saturating_sub(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brackets_are_counted_only_where_they_nest() {
        let deep = "[".repeat(DEEPEST + 1);
        let shallow = "[".repeat(DEEPEST);
        for text in [
            &deep,
            &format!("a: {deep}"),
            &format!("a: |\n  x\nb: \"]\" \n{deep}"),
            &format!("- &x {deep}"),
        ] {
            let exceeded = Scan::of(text).exceeded;
            assert!(matches!(exceeded, Some((Limit::Depth, _))), "{text}");
        }
        for text in [
            &shallow,
            &format!("a: '{deep}'"),
            &format!("a: \"\\\"{deep}\""),
            &format!("a: 1 # {deep}"),
            &format!("a: |\n  it's\n  {deep}\n\n  \"\nb: 1"),
            &format!("- > # x\n  {deep}"),
            &format!("a: b{deep}"),
            &format!("a: it is \" and ' {deep}\nb: [\"{deep}\", 1]"),
            &"[1], ".repeat(1000),
        ] {
            assert_eq!(Scan::of(text).exceeded, None, "{text}");
        }
    }

    #[test]
    fn surrogate_pairs_are_joined_in_double_quotes_alone() {
        let joined = |text: &str| Scan::of(text).joined(text).into_owned();
        assert_eq!(joined(r#"a: "x\ud83d\ude00y\uD83D\uDE01""#), r#"a: "x\U0001F600y\U0001F601""#);
        for text in [
            r#"a: '\ud83d\ude00'"#,
            r"a: \ud83d\ude00",
            r#"a: "\\ud83d\\ude00""#,
            r#"a: "\\\\ud83d\ude00""#,
            r#"a: "\ud83d""#,
            r#"a: "\ud83d\u0041""#,
            r#"a: "\u00e4\u00f6""#,
            "a: |\n  \"\\ud83d\\ude00\"",
            r#"a: "\"#,
        ] {
            assert_eq!(joined(text), text);
        }
    }
}
