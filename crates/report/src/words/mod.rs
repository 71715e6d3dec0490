//! The words of the reports in the language of their reader.
//!
//! English texts are written where their facts arise, and `result.json` keeps them. A language file
//! gives each of them in another language, with gaps `{1}`, `{2}` for numbers and names:
//! `between {1} and {2}: zwischen {1} und {2}`. Names that the user gave stay as they are.

mod gaps;
mod picture;

use bracket_base::yaml;
use bracket_joint::spec::connection::Language;
use gaps::Gapped;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::path::Path;
use std::sync::{LazyLock, Mutex, PoisonError};

const GERMAN: &str = include_str!("de.yaml");

/// A text with fewer fixed letters is tried only on parts that cannot be taken apart.
const FEW: usize = 8;

/// A language file.
#[derive(Debug, Default)]
struct Dictionary {
    /// Texts without gaps.
    exact: HashMap<String, String>,
    /// Texts with gaps, those with the most fixed letters first.
    gapped: Vec<(Gapped, String)>,
    /// The same with few fixed letters, such as `{1} and {2}`.
    short: Vec<(Gapped, String)>,
}

/// The German file; a test reads it without a fault.
static OF_GERMAN: LazyLock<Dictionary> = LazyLock::new(|| Dictionary::read(GERMAN));

impl Dictionary {
    fn read(text: &str) -> Self {
        let texts: BTreeMap<String, String> =
            yaml::parse(text, Path::new("de.yaml")).map(|p| p.value).unwrap_or_default();
        let (gapped, exact): (Vec<_>, Vec<_>) =
            texts.into_iter().partition(|t| t.0.contains("{1}"));
        let mut gapped: Vec<_> = gapped.into_iter().map(|(k, v)| (Gapped::new(&k), v)).collect();
        gapped.sort_by_key(|(g, _)| std::cmp::Reverse(g.letters()));
        let (short, gapped) = gapped.into_iter().partition(|(g, _)| g.letters() < FEW);
        Self { exact: exact.into_iter().collect(), gapped, short }
    }
}

/// Translates the texts of one report.
#[derive(Debug, Default)]
pub struct Words {
    language: Language,
    dictionary: Option<&'static Dictionary>,
    /// Names of the user.
    names: HashSet<String>,
    /// Texts that the language file does not have.
    unknown: Mutex<BTreeSet<String>>,
}

impl Words {
    /// Words of a language; `names` are texts of the user, which stay as they are.
    pub fn new(language: Language, names: impl IntoIterator<Item = String>) -> Self {
        let dictionary = match language {
            Language::En => None,
            Language::De => Some(&*OF_GERMAN),
        };
        Self { language, dictionary, names: names.into_iter().collect(), ..Self::default() }
    }

    /// Code of the language, as in HTML: `de`.
    pub fn code(&self) -> &'static str {
        self.language.code()
    }

    /// Texts that had no translation and stayed English.
    pub fn unknown(&self) -> Vec<String> {
        self.unknown.lock().unwrap_or_else(PoisonError::into_inner).iter().cloned().collect()
    }

    /// A text of the report in the language. What the language file does not have as a whole is
    /// taken apart at its sentences, colons, commas and brackets.
    pub fn say(&self, text: &str) -> String {
        let Some(dictionary) = self.dictionary else { return text.into() };
        let (said, complete) = self.translated(text, dictionary);
        if !complete {
            let mut unknown = self.unknown.lock().unwrap_or_else(PoisonError::into_inner);
            unknown.insert(text.trim().into());
        }
        said
    }

    /// A text in the language, and whether all of it is.
    fn translated(&self, text: &str, dictionary: &Dictionary) -> (String, bool) {
        let core = text.trim();
        if core.is_empty() || self.names.contains(core) {
            return (text.into(), true);
        }
        let (before, after) = text.split_once(core).unwrap_or_default();
        let (said, complete) = self.core(core, dictionary);
        (format!("{before}{said}{after}"), complete)
    }

    fn core(&self, text: &str, dictionary: &Dictionary) -> (String, bool) {
        if let Some(exact) = dictionary.exact.get(text) {
            return (exact.clone(), true);
        }
        if let Some(found) = self.fitted(text, &dictionary.gapped, dictionary) {
            return found;
        }
        let within = |mark: &str| {
            let inner = text.strip_prefix(mark)?.strip_suffix(mark)?;
            (!inner.is_empty() && !inner.contains(mark)).then_some(inner)
        };
        if within("`").is_some() {
            return (text.into(), true);
        }
        // `**Welds.** Where …`
        let led = text.strip_prefix("**").and_then(|t| t.split_once("** "));
        if let Some((lead, rest)) = led.filter(|(lead, _)| lead.ends_with('.')) {
            let (lead, known) = self.translated(lead, dictionary);
            let (rest, complete) = self.translated(rest, dictionary);
            return (format!("**{lead}** {rest}"), known && complete);
        }
        if let Some(inner) = within("**") {
            let (said, complete) = self.translated(inner, dictionary);
            return (format!("**{said}**"), complete);
        }
        for end in [".", ":"] {
            if let Some(sentence) = text.strip_suffix(end) {
                let (said, complete) = self.translated(sentence, dictionary);
                return (said + end, complete);
            }
        }
        for between in [". ", "; ", ": ", ", "] {
            let open = |at: &usize| gaps::balanced(&text[..*at]);
            if let Some(at) = text.match_indices(between).map(|m| m.0).find(open) {
                let (first, known) = self.translated(&text[..at], dictionary);
                let (rest, complete) = self.translated(&text[at + between.len()..], dictionary);
                return (format!("{first}{between}{rest}"), known && complete);
            }
        }
        if let Some((outside, inside)) = text.strip_suffix(')').and_then(|t| t.split_once(" (")) {
            let (outside, known) = self.translated(outside, dictionary);
            let (inside, complete) = self.translated(inside, dictionary);
            return (format!("{outside} ({inside})"), known && complete);
        }
        let fitted = self.fitted(text, &dictionary.short, dictionary);
        fitted.unwrap_or_else(|| (text.into(), !has_words(text)))
    }

    /// The translation of a whole text that fits one with gaps.
    fn fitted(
        &self,
        text: &str,
        gapped: &[(Gapped, String)],
        dictionary: &Dictionary,
    ) -> Option<(String, bool)> {
        let (gaps, meaning) = gapped.iter().find_map(|(g, m)| Some((g.fit(text)?, m)))?;
        let parts = gaps.iter().map(|t| self.translated(t, dictionary));
        let (said, complete): (Vec<String>, Vec<bool>) = parts.unzip();
        Some((gaps::filled(meaning, &said), complete.into_iter().all(|c| c)))
    }

    /// A text in Markdown: headings, items, cells and paragraphs, a line each. Code stays.
    pub fn markdown(&self, text: &str) -> String {
        if self.dictionary.is_none() {
            return text.into();
        }
        let mut out = String::with_capacity(text.len());
        let mut fence: Option<&str> = None;
        for line in text.lines() {
            let mark = line.trim_end_matches(|c| c != '`');
            if line.starts_with("```") {
                match fence {
                    Some(open) if mark == open && line == mark => fence = None,
                    None => fence = Some(mark),
                    _ => {}
                }
                out.push_str(line);
            } else if fence.is_some() || line.starts_with("# ") || line.starts_with("| ---") {
                out.push_str(line);
            } else if let Some(cells) = line.strip_prefix('|').and_then(|l| l.strip_suffix('|')) {
                // a stroke within a cell is escaped
                let cells = cells.replace("\\|", "\u{0}");
                let one = |c: &str| self.say(&c.replace('\u{0}', "|")).replace('|', "\\|");
                let said: Vec<String> = cells.split('|').map(one).collect();
                out.push_str(&format!("|{}|", said.join("|")));
            } else if let Some((caption, file)) =
                line.strip_prefix("![").and_then(|l| l.split_once("]("))
            {
                let name = file.strip_suffix(')').and_then(|f| self.file(f));
                let file = name.map_or_else(|| file.to_owned(), |name| format!("{name})"));
                out.push_str(&format!("![{}]({file}", self.say(caption)));
            } else {
                let rest = line.trim_start_matches(['#', '-', ' ']);
                let (mark, rest) = line.split_at(line.len() - rest.len());
                out.push_str(mark);
                out.push_str(&self.say(rest));
            }
            out.push('\n');
        }
        out
    }

    /// A layout or script of the program, in which texts stand between `⟦` and `⟧`.
    pub fn fill(&self, layout: &str) -> String {
        let mut out = String::with_capacity(layout.len());
        let mut rest = layout;
        while let Some((before, inside)) = rest.split_once('⟦') {
            let (text, after) = inside.split_once('⟧').unwrap_or((inside, ""));
            out.push_str(before);
            out.push_str(&self.say(text));
            rest = after;
        }
        out + rest
    }
}

/// True for texts with at least one word that is no symbol, unit or name of a profile.
fn has_words(text: &str) -> bool {
    let word = |w: &str| {
        let w = w.trim_matches(|c: char| !c.is_alphanumeric());
        w.len() > 2
            && w.chars().all(|c| c.is_alphabetic() || c == '-')
            && w.chars().skip(1).all(char::is_lowercase)
    };
    text.split_whitespace().any(word)
}

#[cfg(test)]
mod tests;
