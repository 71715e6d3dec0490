//! Where a template comes from, and where in its file a fault of it stands.

use super::error::AssemblyError;
use super::template::Template;
use crate::diag::{Diagnostic, Place};
use crate::spec::yaml::PlaceIndex;
use std::path::PathBuf;

/// Where a template comes from.
#[derive(Clone, Debug)]
pub enum Origin {
    /// It is a part of the program.
    Shipped,
    /// A file of the user's.
    File {
        /// The file.
        file: PathBuf,
        /// Lines and columns of its entries.
        index: PlaceIndex,
    },
}

impl Origin {
    /// The diagnostic of a fault that is the template's own, placed in its file; any other fault as
    /// it is.
    pub fn placed(&self, template: &Template, error: AssemblyError) -> Diagnostic {
        let entry = match &error {
            AssemblyError::Template { at, cause } => {
                // a value may be computed because another one needs it: the text of the
                // expression shows which definition is at fault
                let own = template.define.iter().position(|d| d.value.text() == cause.text);
                Some(own.map(|i| format!("define[{i}]")).or_else(|| template.path_of(at)))
            }
            AssemblyError::TemplateEntry { at, .. } | AssemblyError::UnseenBolts { at, .. } => {
                Some(template.path_of(at))
            }
            _ => None,
        };
        let d = Diagnostic::from(error);
        match (self, entry) {
            (Origin::File { index, .. }, Some(Some(path))) => {
                Diagnostic { place: index.place(&path), ..d }
            }
            (Origin::File { file, .. }, Some(None)) => {
                let place = Place { file: Some(file.clone()), ..Place::default() };
                Diagnostic { place, ..d }
            }
            _ => d,
        }
    }
}

impl Template {
    /// The path of an entry in the template's file, from the word an [`AssemblyError`] has for it:
    /// the entry's name, as it stands there or with its loops filled in, the text of a check, or a
    /// key of `hand_checks`.
    fn path_of(&self, at: &str) -> Option<String> {
        if at.starts_with("hand_checks.") {
            return Some(at.to_owned());
        }
        if let Some(text) = at.strip_prefix("checks: ") {
            return self
                .checks
                .iter()
                .position(|c| c.that.text() == text)
                .map(|i| format!("checks[{i}]"));
        }
        fn texts<T>(list: &[T], name: impl Fn(&T) -> &String) -> Vec<&str> {
            list.iter().map(|entry| name(entry).as_str()).collect()
        }
        // the path of a list entry is that of the list
        let base = at
            .rsplit_once('.')
            .filter(|(_, n)| n.parse::<usize>().is_ok())
            .map_or(at, |(base, _)| base);
        let lists = [
            ("parameters", texts(&self.parameters, |e| &e.name)),
            ("define", texts(&self.define, |e| &e.name)),
            ("parts", texts(&self.parts, |e| &e.name)),
            ("bolts", texts(&self.bolts, |e| &e.name)),
            ("contacts", texts(&self.contacts, |e| &e.name)),
            ("welds", texts(&self.welds, |e| &e.name)),
            ("sections", texts(&self.sections, |e| &e.name)),
            ("ends", texts(&self.ends, |e| &e.name)),
            ("supports", texts(&self.supports, |e| &e.name)),
        ];
        let exactly = lists
            .iter()
            .find_map(|(list, names)| Some((list, names.iter().position(|n| *n == base)?)));
        let filled = || {
            lists
                .iter()
                .find_map(|(list, names)| Some((list, names.iter().position(|n| fills(n, at))?)))
        };
        exactly.or_else(filled).map(|(list, i)| format!("{list}[{i}]"))
    }
}

/// True when `name` is `pattern` with something in place of each `{…}`.
fn fills(pattern: &str, name: &str) -> bool {
    match pattern.split_once('{').and_then(|(head, rest)| Some((head, rest.split_once('}')?.1))) {
        None => pattern == name,
        Some((head, tail)) => name.strip_prefix(head).is_some_and(|rest| {
            rest.char_indices()
                .skip(1)
                .map(|(i, _)| i)
                .chain([rest.len()])
                .any(|i| i > 0 && fills(tail, &rest[i..]))
        }),
    }
}
