//! Origin of a template, and the place of a fault in its file.

use super::error::AssemblyError;
use super::template::Template;
use bracket_base::diag::{Diagnostic, Place};
use bracket_base::yaml::PlaceIndex;
use std::path::PathBuf;

/// Origin of a template.
#[derive(Clone, Debug)]
pub enum Origin {
    /// Shipped with the program.
    Shipped,
    /// A file of the user.
    File {
        /// Path of the file.
        file: PathBuf,
        /// Lines and columns of the entries.
        index: PlaceIndex,
    },
}

impl Origin {
    /// The diagnostic of a fault. A fault of the template gets its place in the template's file;
    /// any other fault is converted unchanged.
    pub fn placed(&self, template: &Template, error: AssemblyError) -> Diagnostic {
        let entry = match &error {
            AssemblyError::Template { at, cause } => {
                // one value may be computed on demand of another: the text of the expression
                // identifies the definition at fault
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
    /// The path of an entry in the template's file, from the entry's description in an
    /// [`AssemblyError`]. The description is one of: the entry's name as written or with its loop
    /// variables filled in, the text of a check, a key of `hand_checks`.
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

/// True if `name` equals `pattern` with some text in place of each `{…}`.
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
