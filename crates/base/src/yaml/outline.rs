//! Reads a document without types, only as far as the general rules need it.

use super::place::PlaceIndex;
use crate::diag::Diagnostic;
use serde::de::{self, DeserializeSeed, Deserializer, EnumAccess, MapAccess, SeqAccess, Visitor};
use std::cell::Cell;
use std::collections::BTreeSet;
use std::fmt;

/// Part of the message when aliases expand too far.
pub(super) const TOO_LARGE: &str = "more than a million values";
/// Part of the message when a value carries a tag.
pub(super) const TAGGED: &str = "tagged value";
/// Number of values that a document may contain after aliases are expanded.
pub(super) const BUDGET: usize = 1_000_000;
/// Most bytes of one text. Names and titles stand in every table and picture of a report, and a
/// page is set a text at a time.
pub(super) const LONGEST: usize = 10_000;

/// A document reduced to its keys and its numbers.
#[derive(Debug)]
pub(super) enum Outline {
    /// A mapping: entries in file order, with duplicates.
    Map(Vec<(String, Outline)>),
    /// A sequence.
    Seq(Vec<Outline>),
    /// A number that is NaN or infinite.
    NotFinite,
    /// A key without value.
    Nothing,
    /// A text of more than [`LONGEST`] bytes, with their number.
    Long(usize),
    /// Any other value.
    Other,
}

impl Outline {
    /// Reads the outline of one document.
    pub(super) fn read(text: &str) -> Result<Self, serde_yaml::Error> {
        let left = Cell::new(BUDGET);
        Seed(&left).deserialize(serde_yaml::Deserializer::from_str(text))
    }

    /// Adds a fault for each duplicate key, each non-finite number and each text that is too long,
    /// in file order.
    pub(super) fn faults(&self, index: &PlaceIndex, text: &str, faults: &mut Vec<Diagnostic>) {
        self.walk("", index, text, faults);
    }

    fn walk(&self, path: &str, index: &PlaceIndex, text: &str, faults: &mut Vec<Diagnostic>) {
        match self {
            Outline::Map(entries) => {
                let mut seen = BTreeSet::new();
                for (key, value) in entries {
                    let at = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
                    if matches!(value, Outline::Nothing) && is_half_a_number(key) {
                        let message = format!(
                            "the comma before `{key}` ends an entry, and `{key}` becomes a key of \
                             its own"
                        );
                        let mut d = Diagnostic::input("yaml/comma", message);
                        d.place = index.place(&at);
                        faults.push(d.help(
                            "a number has a point before its decimals: `20.5 mm`, not `20,5 mm`",
                        ));
                        continue;
                    }
                    if !seen.insert(key) {
                        let within =
                            if path.is_empty() { String::new() } else { format!(" in `{path}`") };
                        let mut d = Diagnostic::input(
                            "yaml/duplicate-key",
                            format!("the key `{key}`{within} stands twice"),
                        );
                        d.place = index.duplicate(&at, key, text);
                        faults.push(d.help("keep one of them: the other would be lost silently"));
                    }
                    value.walk(&at, index, text, faults);
                }
            }
            Outline::Seq(items) => {
                for (i, item) in items.iter().enumerate() {
                    item.walk(&format!("{path}[{i}]"), index, text, faults);
                }
            }
            Outline::NotFinite => {
                let mut d = Diagnostic::input(
                    "yaml/not-finite",
                    format!("`{path}` is not a finite number"),
                );
                d.place = index.place(path);
                faults.push(
                    d.help("write a finite number; leave the key out where a limit is absent"),
                );
            }
            Outline::Long(bytes) => {
                let message =
                    format!("`{path}` is a text of {bytes} bytes, at most {LONGEST} are read");
                let mut d = Diagnostic::input("yaml/long-text", message);
                d.place = index.place(path);
                faults.push(d.help("shorten it; names and titles have some dozen characters"));
            }
            Outline::Nothing | Outline::Other => {}
        }
    }
}

/// True for the rest of a number with decimal comma between braces: `{t: 20,5 mm}` has the keys `t`
/// and `5 mm`. No valid key begins with a digit.
fn is_half_a_number(key: &str) -> bool {
    key.starts_with(|c: char| c.is_ascii_digit())
}

/// Counts down the number of values that may still be read.
#[derive(Clone, Copy)]
struct Seed<'a>(&'a Cell<usize>);

impl<'de> DeserializeSeed<'de> for Seed<'_> {
    type Value = Outline;
    fn deserialize<D: Deserializer<'de>>(self, d: D) -> Result<Outline, D::Error> {
        let left = self.0.get().checked_sub(1).ok_or_else(|| de::Error::custom(TOO_LARGE))?;
        self.0.set(left);
        d.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Seed<'_> {
    type Value = Outline;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a YAML value")
    }
    fn visit_bool<E>(self, _: bool) -> Result<Outline, E> {
        Ok(Outline::Other)
    }
    fn visit_i64<E>(self, _: i64) -> Result<Outline, E> {
        Ok(Outline::Other)
    }
    fn visit_i128<E>(self, _: i128) -> Result<Outline, E> {
        Ok(Outline::Other)
    }
    fn visit_u64<E>(self, _: u64) -> Result<Outline, E> {
        Ok(Outline::Other)
    }
    fn visit_u128<E>(self, _: u128) -> Result<Outline, E> {
        Ok(Outline::Other)
    }
    fn visit_f64<E>(self, x: f64) -> Result<Outline, E> {
        Ok(if x.is_finite() { Outline::Other } else { Outline::NotFinite })
    }
    fn visit_str<E>(self, text: &str) -> Result<Outline, E> {
        Ok(if text.len() > LONGEST { Outline::Long(text.len()) } else { Outline::Other })
    }
    fn visit_unit<E>(self) -> Result<Outline, E> {
        Ok(Outline::Nothing)
    }
    fn visit_none<E>(self) -> Result<Outline, E> {
        Ok(Outline::Nothing)
    }
    fn visit_some<D: Deserializer<'de>>(self, d: D) -> Result<Outline, D::Error> {
        self.deserialize(d)
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Outline, A::Error> {
        let mut all = Vec::new();
        while let Some(item) = items.next_element_seed(self)? {
            all.push(item);
        }
        Ok(Outline::Seq(all))
    }
    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Outline, A::Error> {
        let mut all = Vec::new();
        while let Some(key) = entries.next_key::<String>()? {
            all.push((key, entries.next_value_seed(self)?));
        }
        Ok(Outline::Map(all))
    }
    fn visit_enum<A: EnumAccess<'de>>(self, _: A) -> Result<Outline, A::Error> {
        Err(de::Error::custom(TAGGED))
    }
}
