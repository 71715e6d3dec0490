//! Line and column of every path of a document.

use crate::diag::Place;
use saphyr::{LoadableYamlNode, MarkedYaml, Marker, YamlData};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The place of each path of a YAML file, without its value.
#[derive(Clone, Debug, Default)]
pub struct PlaceIndex {
    file: PathBuf,
    /// Line and column (both from 1) of the place to report, and the index of the character at
    /// which the value starts.
    at: BTreeMap<String, (usize, usize, usize)>,
    /// The file of each path that is in another file.
    elsewhere: BTreeMap<String, PathBuf>,
}

impl PlaceIndex {
    /// An index that knows only the file name, for models made in memory.
    pub fn new(file: &Path) -> Self {
        Self { file: file.to_path_buf(), ..Self::default() }
    }

    /// Collects the places of a text. The text must be accepted as YAML before, so its aliases are
    /// harmless.
    pub(super) fn read(text: &str, file: &Path) -> Self {
        let mut index = Self::new(file);
        // this is a second parser; where it disagrees with the first one, messages lose only their
        // line
        if let Ok(documents) = MarkedYaml::load_from_str(text)
            && let Some(root) = documents.first()
        {
            index.walk(root, String::new(), None);
        }
        index
    }

    fn walk(&mut self, node: &MarkedYaml<'_>, path: String, key: Option<Marker>) {
        let start = node.span.start;
        let shown = match key {
            Some(k) if k.line() != start.line() => k,
            _ => start,
        };
        match &node.data {
            YamlData::Mapping(entries) => {
                for (k, v) in entries {
                    let name = match &k.data {
                        YamlData::Value(saphyr::Scalar::String(s)) => s.to_string(),
                        YamlData::Value(saphyr::Scalar::Integer(i)) => i.to_string(),
                        YamlData::Value(saphyr::Scalar::Boolean(b)) => b.to_string(),
                        YamlData::Value(saphyr::Scalar::FloatingPoint(x)) => x.to_string(),
                        _ => continue,
                    };
                    let below = if path.is_empty() { name } else { format!("{path}.{name}") };
                    self.walk(v, below, Some(k.span.start));
                }
            }
            YamlData::Sequence(items) => {
                for (i, item) in items.iter().enumerate() {
                    self.walk(item, format!("{path}[{i}]"), None);
                }
            }
            _ => {}
        }
        self.at.insert(path, (shown.line(), shown.col() + 1, start.index()));
    }

    /// The place of `path` (such as `bolts.rows[1]`), or of its nearest parent that exists.
    pub fn place(&self, path: &str) -> Place {
        let mut place = Place { file: Some(self.file.clone()), ..Place::default() };
        if !path.is_empty() {
            place.path = Some(path.to_string());
        }
        let mut p = path;
        loop {
            if let Some((line, column, _)) = self.at.get(p) {
                if let Some(file) = self.elsewhere.get(p) {
                    place.file = Some(file.clone());
                }
                place.line = Some(*line);
                place.column = Some(*column);
                return place;
            }
            match p.rfind(['.', '[']) {
                Some(i) => p = &p[..i],
                None if p.is_empty() => return place,
                None => p = "",
            }
        }
    }

    /// Adds a path whose value stands in a line of another file.
    pub fn add(&mut self, path: String, file: &Path, line: usize) {
        self.elsewhere.insert(path.clone(), file.to_path_buf());
        self.at.insert(path, (line, 1, 0));
    }

    /// An index of the same file that knows only the place of the whole document.
    pub(super) fn root(&self) -> Self {
        let mut root = Self::new(&self.file);
        root.at.extend(self.at.get_key_value("").map(|(k, v)| (k.clone(), *v)));
        root
    }

    /// Copies the places at and below the path `there` of another index to the path `here`. A path
    /// that is already known keeps its place.
    pub(super) fn take(&mut self, here: &str, from: &Self, there: &str) {
        for (path, spot) in &from.at {
            let Some(below) = path.strip_prefix(there) else { continue };
            let path_here = format!("{here}{below}");
            if !(below.is_empty() || below.starts_with(['.', '['])) || self.has(&path_here) {
                continue;
            }
            let file = from.elsewhere.get(path).unwrap_or(&from.file);
            if *file != self.file {
                self.elsewhere.insert(path_here.clone(), file.clone());
            }
            self.at.insert(path_here, *spot);
        }
    }

    /// True if the file contains exactly this path.
    pub fn has(&self, path: &str) -> bool {
        self.at.contains_key(path)
    }

    /// The place of the last `key` at `path`. The parser for places keeps the last value of a
    /// duplicate key, and the nearest key before that value belongs to it.
    pub(super) fn duplicate(&self, path: &str, key: &str, text: &str) -> Place {
        let mut place = self.place(path);
        if let Some((_, _, start)) = self.at.get(path) {
            let end = text.char_indices().nth(*start).map_or(text.len(), |(i, _)| i);
            if let Some(i) = text[..end].rfind(key) {
                place.line = Some(text[..i].matches('\n').count() + 1);
                place.column = Some(text[..i].chars().rev().take_while(|c| *c != '\n').count() + 1);
            }
        }
        place
    }
}
