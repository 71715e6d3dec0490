//! A case of a sweep: its place in the expansion, its name and its key.

use crate::assembly::LoadedTemplate;
use crate::catalog::Catalog;
use crate::spec::connection::{ConnectionSpec, Project};
use serde::{Deserialize, Serialize};
use std::fmt::Write;

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

/// The key of a case: a hash of the resolved spec without its title block, of the rows of the
/// user's catalogue that it names, of its template, and of the versions of the program and of the
/// mesher. The same case has the same key in every sweep, whatever its name.
pub fn key(spec: &ConnectionSpec, common: &str, catalog: &Catalog) -> String {
    let plain = ConnectionSpec { project: Project::default(), ..spec.clone() };
    let mut text = String::from(common);
    // a spec that was read from JSON can be written as JSON
    text.push_str(&serde_json::to_string(&plain).unwrap_or_default());
    own_rows(spec, catalog, &mut text);
    blake3::hash(text.as_bytes()).to_hex()[..32].to_string()
}

/// The part of a key that all cases with one template share.
pub fn common(template: &LoadedTemplate, mesher: &str) -> String {
    format!(
        "{} {} {mesher}\n{}\n",
        env!("CARGO_PKG_NAME"),
        env!("CARGO_PKG_VERSION"),
        template.content()
    )
}

/// The rows that the spec names in tables of the user's own. The built-in tables belong to the
/// version of the program.
fn own_rows(spec: &ConnectionSpec, catalog: &Catalog, out: &mut String) {
    let own = |file: &str| catalog.provenance(file).is_none_or(|p| p.standard.is_none());
    let mut put = |file: &str, row: &dyn std::fmt::Debug| {
        if own(file) {
            // writing to a String cannot fail
            let _ = writeln!(out, "{row:?}");
        }
    };
    for member in spec.members.values() {
        if let Ok(p) = catalog.profile(&member.profile) {
            put(&p.source.file, p);
        }
    }
    let steels = spec.members.values().map(|m| &m.steel);
    let of_plate = spec.plate.iter().filter_map(|p| p.steel.as_ref());
    for name in steels.chain(of_plate) {
        if let Ok(s) = catalog.steel(name) {
            put(&s.source.file, s);
        }
    }
    if let Some(bolts) = &spec.bolts {
        if let Ok(b) = catalog.bolt(&bolts.size) {
            put(&b.source.file, b);
        }
        if let Ok(g) = catalog.bolt_grade(&bolts.grade) {
            put(&g.source.file, g);
        }
    }
    if let Some(Ok(f)) = spec.friction.class.as_ref().map(|c| catalog.friction_class(c)) {
        put(&f.source.file, f);
    }
}
