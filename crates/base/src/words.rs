//! Texts for people as data: a message and what stands in its gaps.
//!
//! The English text of a message is its id, as in gettext: `between {} and {}`. It stands in the
//! program where its fact arises. A file of another language gives the same message by that id. So
//! no finished sentence is ever read: a language fills the gaps of its own text. Names of the user,
//! numbers and symbols are gaps, and stay as they are in every language.
//!
//! In files a text is its English sentence. [`collected`] gives the data of the texts that a file
//! holds, which are kept beside it.

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt;

/// A text for a person. Texts are equal if their English sentences are: one that was read from a
/// file has no other data.
#[derive(Clone, Debug, Default)]
pub struct Text {
    /// The message in English, with `{}` for each gap.
    pub id: Cow<'static, str>,
    /// What stands in its gaps.
    pub gaps: Vec<Gap>,
}

/// What stands in a gap.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Gap {
    /// A name of the user, a number with its unit, a symbol: the same in every language.
    Given(String),
    /// A text with its own message.
    Text(Said),
}

/// A text as data in a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "Record", into = "Record")]
pub struct Said(pub Text);

#[derive(Clone, Serialize, Deserialize)]
struct Record {
    id: String,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    gaps: Vec<Gap>,
}

impl From<Said> for Record {
    fn from(Said(text): Said) -> Self {
        Self { id: text.id.into_owned(), gaps: text.gaps }
    }
}

impl From<Record> for Said {
    fn from(Record { id, gaps }: Record) -> Self {
        Said(Text { id: id.into(), gaps })
    }
}

/// Texts of a file by their English sentences.
pub type Collected = BTreeMap<String, Said>;

/// A text with its gaps: `say!("between {} and {}", low, high)`. A `&'static str`, a [`Text`] and
/// the words of an enum are texts; a `String` and a number are given and stay as they are.
#[macro_export]
macro_rules! say {
    ($id:literal $(, $gap:expr)* $(,)?) => {{
        const {
            let gaps: &[&str] = &[$(stringify!($gap)),*];
            assert!($crate::words::holes($id) == gaps.len(), "gaps of the message");
        }
        $crate::words::Text::new($id, vec![$($crate::words::Gap::from($gap)),*])
    }};
}

/// `Display` of types that have a method `text()`: its English.
#[macro_export]
macro_rules! display_text {
    ($($said:ty),*) => {$(
        impl std::fmt::Display for $said {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                self.text().fmt(f)
            }
        }
    )*};
}

impl Text {
    /// A message with its gaps; see [`say!`](crate::say).
    pub fn new(id: &'static str, gaps: Vec<Gap>) -> Self {
        Self { id: id.into(), gaps }
    }

    /// A text that is the same in every language: a name of the user, a number, a symbol.
    pub fn given(text: impl Into<String>) -> Self {
        Self::new("{}", vec![Gap::Given(text.into())])
    }

    /// A name that is one of these words of the program, or else one of the user.
    pub fn word_of(words: &[&'static str], name: &str) -> Self {
        words.iter().find(|w| **w == name).map_or_else(|| Self::given(name), |w| (*w).into())
    }

    /// Texts one behind the other.
    pub fn joined(between: &'static str, of: impl IntoIterator<Item = Text>) -> Self {
        let gaps: Vec<Gap> = of.into_iter().filter(|t| !t.is_empty()).map(Gap::from).collect();
        Self { id: vec!["{}"; gaps.len()].join(between).into(), gaps }
    }

    /// The sentence alone, of a text whose data stand beside it.
    #[must_use]
    pub fn sentence(&self) -> Self {
        Self { id: self.to_string().into(), gaps: Vec::new() }
    }

    /// Whether it says nothing.
    pub fn is_empty(&self) -> bool {
        self.id.is_empty()
    }

    /// The parts of the text in a language. `true` marks what is given.
    pub fn parts(&self, language: &dyn Language) -> Vec<(String, bool)> {
        let mut out = Vec::new();
        self.say_into(language, &mut |part, given| match out.last_mut() {
            _ if part.is_empty() => {}
            Some((last, g)) if *g == given => String::push_str(last, part),
            _ => out.push((part.to_owned(), given)),
        });
        out
    }

    fn say_into(&self, language: &dyn Language, out: &mut dyn FnMut(&str, bool)) {
        let read = if self.gaps.is_empty() { language.read(&self.id) } else { None };
        if let Some(text) = read {
            return text.say_into(&Kept(language), out);
        }
        let found = language.message(&self.id);
        let mut rest = found.as_deref().unwrap_or(&self.id);
        let mut next = 0;
        // a text that was read from a file has no gaps, whatever its letters
        while !self.gaps.is_empty()
            && let Some((before, number, after)) = first_gap(rest)
        {
            out(before, false);
            next += 1;
            match self.gaps.get(number.unwrap_or(next) - 1) {
                Some(Gap::Given(given)) => out(given, true),
                Some(Gap::Text(Said(text))) => text.say_into(language, out),
                None => {}
            }
            rest = after;
        }
        out(rest, false);
    }
}

impl PartialEq for Text {
    fn eq(&self, other: &Self) -> bool {
        match (self.gaps.as_slice(), other.gaps.as_slice()) {
            ([], []) => self.id == other.id,
            (a, b) if self.id == other.id && a == b => true,
            _ => self.to_string() == other.to_string(),
        }
    }
}

impl Eq for Text {}

impl PartialEq<str> for Text {
    fn eq(&self, english: &str) -> bool {
        self.to_string().as_str() == english
    }
}

impl PartialEq<&str> for Text {
    fn eq(&self, english: &&str) -> bool {
        self == *english
    }
}

impl PartialOrd for Text {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Text {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.to_string().cmp(&other.to_string())
    }
}

/// The messages of a language.
pub trait Language {
    /// The message of an id, with `{1}`, `{2}` for its gaps; `None` stands for the English one.
    fn message(&self, id: &str) -> Option<Cow<'_, str>>;

    /// The data of a sentence that was read from a file; see [`collected`].
    fn read(&self, _sentence: &str) -> Option<&Text> {
        None
    }
}

/// English, whose messages are the ids.
pub struct English;

impl Language for English {
    fn message(&self, _id: &str) -> Option<Cow<'_, str>> {
        None
    }
}

/// A language without data of files: the texts of such data are complete.
struct Kept<'a>(&'a dyn Language);

impl Language for Kept<'_> {
    fn message(&self, id: &str) -> Option<Cow<'_, str>> {
        self.0.message(id)
    }
}

/// The first gap of a message, `{}` or `{1}`: what is before it, its number, what is behind it.
fn first_gap(message: &str) -> Option<(&str, Option<usize>, &str)> {
    message.match_indices('{').find_map(|(start, _)| {
        let (inside, after) = message[start + 1..].split_once('}')?;
        let number = match inside {
            "" => None,
            digits => Some(digits.parse().ok().filter(|n| *n > 0)?),
        };
        Some((&message[..start], number, after))
    })
}

/// Number of the gaps `{}` of an id.
pub const fn holes(id: &str) -> usize {
    let (bytes, mut i, mut found) = (id.as_bytes(), 1, 0);
    while i < bytes.len() {
        if bytes[i - 1] == b'{' && bytes[i] == b'}' {
            found += 1;
        }
        i += 1;
    }
    found
}

/// True for messages with at least one word that is no symbol, unit or name of a profile: those
/// that a language must have.
pub fn has_words(message: &str) -> bool {
    let word = |w: &str| {
        let w = w.trim_matches(|c: char| !c.is_alphanumeric());
        w.len() > 2
            && w.chars().all(|c| c.is_alphabetic() || c == '-')
            && w.chars().skip(1).all(char::is_lowercase)
    };
    message.split_whitespace().any(word)
}

/// The English text.
impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut result = Ok(());
        self.say_into(&English, &mut |part, _| {
            result = result.and_then(|()| f.write_str(part));
        });
        result
    }
}

impl From<&'static str> for Text {
    fn from(id: &'static str) -> Self {
        Self { id: id.into(), gaps: Vec::new() }
    }
}

/// What is made at run time is given.
impl From<String> for Text {
    fn from(given: String) -> Self {
        Text::given(given)
    }
}

impl From<Text> for Gap {
    fn from(text: Text) -> Self {
        // a given text is no message
        match text.gaps.as_slice() {
            [given @ Gap::Given(_)] if text.id == "{}" => given.clone(),
            _ => Gap::Text(Said(text)),
        }
    }
}

impl From<&Text> for Gap {
    fn from(text: &Text) -> Self {
        text.clone().into()
    }
}

impl From<&'static str> for Gap {
    fn from(id: &'static str) -> Self {
        Text::from(id).into()
    }
}

impl From<String> for Gap {
    fn from(given: String) -> Self {
        Gap::Given(given)
    }
}

impl From<&String> for Gap {
    fn from(given: &String) -> Self {
        Gap::Given(given.clone())
    }
}

macro_rules! numbers {
    ($($number:ty),*) => {$(
        impl From<$number> for Gap {
            fn from(number: $number) -> Self {
                Gap::Given(number.to_string())
            }
        }
    )*};
}

numbers!(usize, u64, u32, u8, i32);

thread_local! {
    /// The texts that are being written.
    static WRITTEN: RefCell<Option<Collected>> = const { RefCell::new(None) };
}

/// Does `write`, and gives the texts that it wrote with serde. A text that is given wins over a
/// message with the same letters: it is a name of the user.
pub fn collected<T>(write: impl FnOnce() -> T) -> (T, Collected) {
    let outer = WRITTEN.replace(Some(Collected::new()));
    let done = write();
    (done, WRITTEN.replace(outer).unwrap_or_default())
}

impl Serialize for Text {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let english = self.to_string();
        WRITTEN.with_borrow_mut(|written| {
            if let Some(written) = written.as_mut().filter(|_| !self.gaps.is_empty()) {
                let kept = written.entry(english.clone()).or_insert_with(|| Said(self.clone()));
                if self.id == "{}" {
                    *kept = Said(self.clone());
                }
            }
        });
        serializer.serialize_str(&english)
    }
}

impl<'de> Deserialize<'de> for Text {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Self { id: String::deserialize(deserializer)?.into(), gaps: Vec::new() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_language_fills_the_gaps_of_its_own_text() {
        struct German;
        impl Language for German {
            fn message(&self, id: &str) -> Option<Cow<'_, str>> {
                match id {
                    "row {} of the {}" => Some("{2}, Reihe {1}".into()),
                    "end plate" => Some("Stirnplatte".into()),
                    _ => None,
                }
            }
        }
        let text = say!("row {} of the {}", 2, "end plate");
        assert_eq!(text.to_string(), "row 2 of the end plate");
        let said: String = text.parts(&German).into_iter().map(|p| p.0).collect();
        assert_eq!(said, "Stirnplatte, Reihe 2");
        let all = Text::joined(", ", [Text::given("end plate"), "end plate".into(), text]);
        assert_eq!(all.to_string(), "end plate, end plate, row 2 of the end plate");
        let want =
            [("end plate", true), (", Stirnplatte, Stirnplatte, Reihe ", false), ("2", true)];
        assert_eq!(all.parts(&German), want.map(|(t, g)| (t.to_owned(), g)));
        assert_eq!(Text::given("{1} {}").to_string(), "{1} {}", "a name of the user is no message");
        assert_eq!(holes("{2} {} {x} {{} {"), 2);
    }

    #[test]
    fn files_hold_sentences_and_the_data_beside_them() {
        let text = say!("row {} of the {}", 2, "end plate");
        let write = || serde_json::to_string(&[text.clone(), Text::given("x"), "plain".into()]);
        let (written, kept) = collected(write);
        let written = written.expect("text");
        assert_eq!(written, r#"["row 2 of the end plate","x","plain"]"#);
        let keys: Vec<&str> = kept.keys().map(String::as_str).collect();
        assert_eq!(keys, ["row 2 of the end plate", "x"]);
        let beside = serde_json::to_string(&kept).expect("data");
        let read: Collected = serde_json::from_str(&beside).expect("data");
        assert_eq!(read, kept);
        let read: Vec<Text> = serde_json::from_str(&written).expect("texts");
        assert_eq!(read[0].to_string(), "row 2 of the end plate");
    }
}
