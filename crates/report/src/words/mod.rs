//! The words of the reports in the language of their reader.
//!
//! A text is a message with its gaps ([`bracket_base::words`]), and English is its id. The files of
//! another language give each message by that id, with gaps `{1}`, `{2}` in the order of the id:
//! `"between {} and {}": "zwischen {1} und {2}"`.

mod picture;

use bracket_base::words::{Collected, Language as Messages, Said, Text, has_words};
use bracket_base::yaml;
use bracket_joint::spec::connection::Language;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::Path;
use std::sync::{LazyLock, Mutex, PoisonError};

/// The files of a language with their names, a file a room. English needs none.
fn files(language: Language) -> &'static [(&'static str, &'static str)] {
    match language {
        Language::En => &[],
        Language::De => &[
            ("de/codes.yaml", include_str!("de/codes.yaml")),
            ("de/joint.yaml", include_str!("de/joint.yaml")),
            ("de/report.yaml", include_str!("de/report.yaml")),
            ("de/pictures.yaml", include_str!("de/pictures.yaml")),
        ],
    }
}

/// Messages by their ids.
type Dictionary = HashMap<String, String>;

/// The messages of each language; a test reads the files without a fault.
static MESSAGES: LazyLock<Vec<(Language, Dictionary)>> = LazyLock::new(|| {
    let read = |(name, text): &(&str, &str)| -> BTreeMap<String, String> {
        yaml::parse(text, Path::new(name)).map(|p| p.value).unwrap_or_default()
    };
    Language::ALL.map(|l| (l, files(l).iter().flat_map(read).collect())).into()
});

/// Says the texts of one report.
#[derive(Debug, Default)]
pub struct Words {
    language: Language,
    messages: Option<&'static Dictionary>,
    /// Data of the sentences of files.
    read: Collected,
    /// Messages that the language does not have.
    unknown: Mutex<BTreeSet<String>>,
}

impl Words {
    /// Words of a language.
    pub fn new(language: Language) -> Self {
        let of = |l: &&(Language, Dictionary)| l.0 == language;
        let messages = match files(language) {
            [] => None,
            _ => MESSAGES.iter().find(of).map(|(_, messages)| messages),
        };
        Self { language, messages, ..Self::default() }
    }

    /// The words with the data of the sentences of files.
    #[must_use]
    pub fn with(self, read: Collected) -> Self {
        Self { read, ..self }
    }

    /// Code of the language, as in HTML: `de`.
    pub fn code(&self) -> &'static str {
        self.language.code()
    }

    /// Messages that had no translation and stayed English.
    pub fn unknown(&self) -> Vec<String> {
        self.unknown.lock().unwrap_or_else(PoisonError::into_inner).iter().cloned().collect()
    }

    /// A text in the language.
    pub fn say(&self, text: &Text) -> String {
        text.parts(self).into_iter().map(|p| p.0).collect()
    }

    /// A layout or script of the program, in which messages stand between `⟦` and `⟧`.
    pub fn fill(&self, layout: &str) -> String {
        let mut out = String::with_capacity(layout.len());
        let mut rest = layout;
        while let Some((before, inside)) = rest.split_once('⟦') {
            let (id, after) = inside.split_once('⟧').unwrap_or((inside, ""));
            out.push_str(before);
            out.push_str(&self.message(id).unwrap_or(id.into()));
            rest = after;
        }
        out + rest
    }
}

impl Messages for Words {
    fn message(&self, id: &str) -> Option<Cow<'_, str>> {
        let found = self.messages?.get(id);
        if found.is_none() && has_words(id) {
            let mut unknown = self.unknown.lock().unwrap_or_else(PoisonError::into_inner);
            unknown.insert(id.into());
        }
        found.map(|message| message.as_str().into())
    }

    fn read(&self, sentence: &str) -> Option<&Text> {
        self.read.get(sentence).map(|Said(text)| text)
    }
}

#[cfg(test)]
mod tests;
