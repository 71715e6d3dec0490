//! Reads and writes YAML; only this file uses a YAML crate.
//!
//! A text is read three times. The first reading has no type and refuses what none of the program's
//! files may contain: duplicate keys, non-finite numbers, tags, and aliases that expand too far.
//! The second reading makes the typed value. The third collects the places, so that later checks
//! can still report a line.

mod extend;
mod outline;
mod place;
mod scan;

pub use extend::REST;
pub use place::PlaceIndex;

use crate::diag::{Diagnostic, Diagnostics, Place, did_you_mean};
use crate::later;
use crate::text_file;
use outline::Outline;
use scan::{Limit, Scan};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// First words of the message about an invalid expression. The YAML reader recognises the message
/// by them and does not report a syntax error.
pub const INVALID_EXPRESSION: &str = "invalid expression: ";

/// A value read from YAML, with the place of each of its parts.
#[derive(Clone, Debug)]
pub struct Parsed<T> {
    /// The value.
    pub value: T,
    /// Line and column of every path in the file.
    pub index: PlaceIndex,
}

/// Reads one YAML document into `T`. Messages name `file`.
///
/// The function refuses the following, each with line and column: syntax errors, more than one
/// document, unknown keys (if `T` denies them), missing keys, duplicate keys in any mapping, NaN
/// and infinity, tags, and aliases that expand beyond a million values.
pub fn parse<T: DeserializeOwned>(text: &str, file: &Path) -> Result<Parsed<T>, Diagnostics> {
    let (index, text) = accepted(text, file)?;
    let value = serde_yaml::from_str(&text).map_err(|e| from_serde(&e, &index, file))?;
    Ok(Parsed { value, index })
}

/// True if a document has these keys at its top level, which distinguishes specs from model files.
/// Of a text that is no document or is too large for one, the keys are the words with which its
/// lines begin.
pub fn top_level(text: &str, keys: &[&str]) -> bool {
    let readable = text.len() <= LARGEST && Scan::of(text).exceeded.is_none();
    let outline = readable.then(|| Outline::read(text));
    let has = |key: &&str| match &outline {
        Some(Ok(Outline::Map(entries))) => entries.iter().any(|(k, _)| k == key),
        _ => {
            let starts = |l: &str| {
                l.strip_prefix(*key).is_some_and(|rest| rest.trim_start().starts_with(':'))
            };
            text.lines().any(starts)
        }
    };
    keys.iter().all(has)
}

/// Largest document \[bytes\]; its values take a hundred times as much memory.
const LARGEST: usize = 16 << 20;

/// Refuses what no document may contain, whatever its type. Returns the places of an accepted
/// document, and its text as the YAML crate reads it.
fn accepted<'t>(text: &'t str, file: &Path) -> Result<(PlaceIndex, Cow<'t, str>), Diagnostics> {
    if text.len() > LARGEST {
        let message =
            format!("the file has {} MB, at most {} are read", text.len() >> 20, LARGEST >> 20);
        let help = "specs have some kB; is this the right file?";
        return Err(Diagnostic::input("yaml/size", message).file(file).help(help).into());
    }
    if text.lines().all(|l| l.trim_start().is_empty() || l.trim_start().starts_with('#')) {
        let d = Diagnostic::input("yaml/empty", "the file is empty").file(file);
        return Err(d.help("`bracket new` writes a starter").into());
    }
    if let Some(what) = text_file::foreign::of_text(text) {
        return Err(text_file::not_ours(what, file).into());
    }
    let scan = Scan::of(text);
    if let Some((limit, at)) = scan.exceeded {
        let before = &text[..at];
        let column = before.rsplit('\n').next().map_or(0, |l| l.chars().count()) + 1;
        return Err(exceeded(limit).file(file).at(before.matches('\n').count() + 1, column).into());
    }
    let joined = scan.joined(text);
    let text = &*joined;
    let outline = Outline::read(text).map_err(|e| {
        let d = from_serde(&e, &PlaceIndex::new(file), file);
        match d.code {
            "yaml/syntax" => tab(text, file).unwrap_or(d),
            "yaml/too-large" if !text.contains('*') => {
                Diagnostic { place: d.place, ..exceeded(Limit::Values) }
            }
            _ => d,
        }
    })?;
    let index = PlaceIndex::read(text, file);
    let mut faults = Vec::new();
    outline.faults(&index, text, &mut faults);
    Diagnostics::refuse(faults)?;
    Ok((index, joined))
}

/// A document of keys and values that is not typed yet, so that it can extend another one.
#[derive(Clone, Debug)]
pub struct Document {
    keys: serde_yaml::Mapping,
    index: PlaceIndex,
    file: PathBuf,
}

impl Document {
    /// Reads one document. Refuses what [`parse`] refuses for every type.
    pub fn read(text: &str, file: &Path) -> Result<Self, Diagnostics> {
        let (index, text) = accepted(text, file)?;
        let keys = serde_yaml::from_str(&text).map_err(|e| from_serde(&e, &index, file))?;
        Ok(Self { keys, index, file: file.to_path_buf() })
    }

    /// The text at a key; `None` if the key is absent.
    pub fn text(&self, key: &str) -> Result<Option<&str>, Diagnostics> {
        let Some(value) = self.keys.get(key) else { return Ok(None) };
        value.as_str().map(Some).ok_or_else(|| {
            let mut d = Diagnostic::input("yaml/type", format!("`{key}` is not a text"));
            d.place = self.index.place(key);
            d.help("write a name, in quotes where it looks like a number").into()
        })
    }

    /// The place of a path.
    pub fn place(&self, path: &str) -> Place {
        self.index.place(path)
    }

    /// This document, completed by the keys of `base` that it leaves out. The values of the keys
    /// `merged` are mappings and are completed key by key. For lists with names see [`REST`].
    pub fn onto(self, base: Self, merged: &[&str]) -> Self {
        let own = (self.keys, &self.index);
        let (keys, index) = extend::extend(own, (base.keys, &base.index), merged);
        Self { keys, index, file: self.file }
    }

    /// The typed value. A fault is reported in the file that the entry comes from.
    pub fn typed<T: DeserializeOwned>(self) -> Result<Parsed<T>, Diagnostics> {
        let (index, file) = (self.index, self.file);
        // the value is converted through text, because only the reader of text reports the path of
        // a fault
        let value = serde_yaml::to_string(&self.keys)
            .and_then(|text| serde_yaml::from_str(&text))
            .map_err(|e| from_serde(&e, &index, &file))?;
        Ok(Parsed { value, index })
    }
}

/// The fault of the first line that is indented with a tab, which YAML does not allow.
fn tab(text: &str, file: &Path) -> Option<Diagnostic> {
    let at = text.lines().enumerate().find_map(|(i, line)| {
        let body = line.trim_start_matches([' ', '\t']);
        let column = line[..line.len() - body.len()].find('\t')?;
        (!body.is_empty() && !body.starts_with('#')).then_some((i + 1, column + 1))
    });
    let (line, column) = at?;
    let d = Diagnostic::input(
        "yaml/tab",
        format!("line {line} is indented with a tab, which YAML does not allow"),
    );
    Some(
        d.file(file)
            .at(line, column)
            .help("indent with blanks, two a level; many editors can replace all tabs at once"),
    )
}

/// Writes a value as a YAML document.
pub fn to_string<T: Serialize>(value: &T) -> Result<String, Diagnostics> {
    serde_yaml::to_string(value).map_err(|e| {
        Diagnostic::input("yaml/write", format!("this value cannot be written as YAML: {e}")).into()
    })
}

/// Converts a serde message into a diagnostic: its kind becomes the code, its path the place.
fn from_serde(error: &serde_yaml::Error, index: &PlaceIndex, file: &Path) -> Diagnostic {
    let text = error.to_string();
    let text = without_position(&text);
    let named = |d: Diagnostic, path: &str| {
        let mut d = d;
        d.place = index.place(path);
        if d.place.line.is_none() {
            d.place.file = Some(file.to_path_buf());
            if let Some(at) = error.location() {
                d.place.line = Some(at.line());
                d.place.column = Some(at.column());
            }
        }
        d
    };
    if let Some((path, rest)) = split_at_marker(text, "unknown field `") {
        let (key, known) = rest.split_once('`').unwrap_or((rest, ""));
        let known = backticked(known);
        let within = if path.is_empty() { String::new() } else { format!(" in `{path}`") };
        let hint = did_you_mean(key, known.iter().copied());
        let d = Diagnostic::input("yaml/unknown-key", format!("unknown key `{key}`{within}{hint}"));
        let help = if let Some(what) = later::not_in_this_edition(key) {
            later::help(what)
        } else if known.is_empty() {
            "remove it: nothing may be written here".to_string()
        } else {
            format!("the keys known here are: {}", known.join(", "))
        };
        let full = if path.is_empty() { key.to_string() } else { format!("{path}.{key}") };
        // a path that ends in the unknown key already names it
        return named(d.help(help), if index.has(&full) { &full } else { path });
    }
    if let Some((path, rest)) = split_at_marker(text, "missing field `") {
        let key = rest.split('`').next().unwrap_or(rest);
        let within = if path.is_empty() { "the file".to_string() } else { format!("`{path}`") };
        let d = Diagnostic::input("yaml/missing-key", format!("{within} lacks the key `{key}`"));
        return named(
            d.help(format!("add `{key}: …`; `bracket schema` lists every key with its unit")),
            path,
        );
    }
    if let Some((path, rest)) = split_at_marker(text, "unknown variant `") {
        let (word, known) = rest.split_once('`').unwrap_or((rest, ""));
        let known = backticked(known);
        let hint = did_you_mean(word, known.iter().copied());
        let d = Diagnostic::input(
            "yaml/unknown-value",
            format!("`{word}` is not a value known at `{path}`{hint}"),
        );
        return named(d.help(format!("write one of: {}", known.join(", "))), path);
    }
    for marker in ["invalid type: ", "invalid value: ", "invalid length ", "data did not match"] {
        if let Some((path, rest)) = split_at_marker(text, marker) {
            let at = if path.is_empty() { String::new() } else { format!("`{path}`: ") };
            let d = Diagnostic::input("yaml/type", format!("{at}{marker}{}", in_words(rest)));
            let d = d.help(match rest.split('"').nth(1).and_then(crate::units::with_point) {
                Some(number) => format!("a number has a point before its decimals: `{number}`"),
                None => "write the kind of value that is expected here; `bracket schema` lists \
                         them"
                    .into(),
            });
            return named(d, path);
        }
    }
    for (code, marker) in
        [("yaml/quantity", crate::units::INVALID_QUANTITY), ("yaml/expression", INVALID_EXPRESSION)]
    {
        if let Some((path, rest)) = split_at_marker(text, marker) {
            let at = if path.is_empty() { String::new() } else { format!("`{path}`: ") };
            let d = Diagnostic::input(code, format!("{at}{rest}"));
            let help = match code {
                "yaml/expression" => {
                    "expressions have names, numbers with units, brackets in pairs, `+ - * / ^` \
                     and comparisons: `==`, `<=`"
                }
                _ => "`bracket schema` lists every key with its unit",
            };
            return named(d.help(help), path);
        }
    }
    if text.contains("repetition limit") || text.contains(outline::TOO_LARGE) {
        let d = Diagnostic::input(
            "yaml/too-large",
            "the aliases of this file expand beyond a million values",
        );
        return named(d.help("write the values out instead of `*alias`"), "");
    }
    if text.contains("recursion limit") {
        return named(exceeded(Limit::Depth), "");
    }
    if text.contains(outline::TAGGED) {
        let d = Diagnostic::input("yaml/tag", "YAML tags (`!name`) mean nothing here");
        return named(d.help("remove the tag, or put the value in quotes"), "");
    }
    if text.contains("more than one document") {
        let d = Diagnostic::input("yaml/documents", "the file holds more than one YAML document");
        return named(d.help("keep one document: remove the `---` between them"), "");
    }
    let d = Diagnostic::input("yaml/syntax", format!("not valid YAML: {text}"));
    let d = d.help("check indentation, closing brackets and quotes on this line and the one above");
    let mut d = d.file(file);
    if let Some(at) = error.location() {
        d = d.at(at.line(), at.column());
    }
    d
}

fn exceeded(limit: Limit) -> Diagnostic {
    let (code, message, help) = match limit {
        Limit::Depth => (
            "yaml/too-deep",
            "the file is nested deeper than 128 levels",
            "no input of this program needs more than 8 levels",
        ),
        Limit::Entries => (
            "yaml/too-large",
            "the file has more than 10 000 entries between braces",
            "specs have some dozen; write long lists with brackets, or a line each",
        ),
        Limit::Values => (
            "yaml/too-large",
            "the file has more than a million values",
            "specs have some hundred; is this the right file?",
        ),
    };
    Diagnostic::input(code, message).help(help)
}

/// Removes the trailing ` at line L column C`; the place is reported separately.
fn without_position(text: &str) -> &str {
    match text.rfind(" at line ") {
        Some(i) if text[i + 9..].chars().all(|c| c.is_ascii_digit() || " column".contains(c)) => {
            &text[..i]
        }
        _ => text,
    }
}

/// Splits `path: <marker>rest` into path and rest.
fn split_at_marker<'a>(text: &'a str, marker: &str) -> Option<(&'a str, &'a str)> {
    let i = text.find(marker)?;
    Some((text[..i].trim_end().trim_end_matches(':'), &text[i + marker.len()..]))
}

/// Replaces the type names of a serde message by plain words; only programmers understand `unit
/// value, expected u32`.
fn in_words(text: &str) -> String {
    let Some((found, expected)) = text.rsplit_once(", expected ") else { return text.into() };
    let found = match found {
        "unit value" => "nothing",
        "sequence" => "a list",
        "map" => "keys with values",
        other => other,
    };
    let expected = match expected {
        "f64" => "a number without a unit",
        "u32" | "u64" | "usize" => "a whole number that is not negative",
        "a string" | "path string" => "a text",
        "a sequence" => "a list",
        "a boolean" => "true or false",
        e if e == "a map" || e.starts_with("struct ") => "keys with values",
        other => other,
    };
    format!("{found}, expected {expected}")
}

/// The words in backticks of a serde message, in order.
fn backticked(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

#[cfg(test)]
mod tests;
