//! A case of a sweep: its place in the expansion, its name and its key.

use bracket_joint::assembly::LoadedTemplate;
use bracket_joint::spec::connection::{ConnectionSpec, Project};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// A case of a plan.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Case {
    /// Position among all combinations, those that a condition drops included.
    pub index: u64,
    /// Name, unique in the sweep.
    pub name: String,
    /// Content key, see [`key`].
    pub key: String,
}

/// The key of a case: a hash of the resolved spec without its title block, and of what all cases
/// with its template share ([`common`]). The same case has the same key in every sweep, whatever
/// its name.
pub fn key(spec: &ConnectionSpec, common: &str) -> String {
    let plain = ConnectionSpec { project: Project::default(), ..spec.clone() };
    // a spec that was read from JSON can be written as JSON
    let text = serde_json::to_string(&plain).unwrap_or_default();
    blake3::hash(format!("{common}{text}").as_bytes()).to_hex()[..32].to_string()
}

/// The part of a key that all cases with one template share: a hash of the versions of program and
/// mesher, what is computed, the template, and the user's own tables.
pub fn common(template: &LoadedTemplate, shared: &str) -> String {
    let text = format!("{shared}\n{}\n", template.content());
    blake3::hash(text.as_bytes()).to_hex().to_string()
}

/// The part of a key that all cases of a sweep share.
pub fn shared(mesher: &str, limit: bool, tables: &str) -> String {
    let kind = if limit { "limit" } else { "as the spec says" };
    let (name, version) = (env!("CARGO_PKG_NAME"), env!("CARGO_PKG_VERSION"));
    format!("{name} {version} {mesher} {kind}\n{tables}\n")
}

/// The tables of the user's catalogue folder as text; empty without one. The built-in tables belong
/// to the version of the program.
pub fn own_tables(folder: Option<&Path>) -> String {
    let Some(entries) = folder.and_then(|dir| std::fs::read_dir(dir).ok()) else {
        return String::new();
    };
    let mut files: Vec<PathBuf> = entries.flatten().map(|e| e.path()).collect();
    files.retain(|f| f.extension().is_some_and(|e| e.eq_ignore_ascii_case("csv")));
    files.sort();
    let texts = files.iter().filter_map(|f| bracket_base::text_file::bytes(f).ok());
    texts.map(|bytes| blake3::hash(&bytes).to_hex().to_string()).collect()
}
