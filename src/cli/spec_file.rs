//! A connection spec from its file: what `bracket run` and `bracket mesh` read.

use crate::assembly::{self, Joint};
use crate::catalog::Catalog;
use crate::diag::{Diagnostic, Diagnostics};
use crate::spec::connection::ConnectionSpec;
use crate::spec::polygon::PolygonFault;
use crate::spec::yaml::{self, Parsed};
use std::path::Path;

/// A spec, its text and the joint it describes.
pub struct SpecFile {
    /// The text as given.
    pub text: String,
    /// The spec with its places; the directions of its polygon are among its loads.
    pub spec: Parsed<ConnectionSpec>,
    /// The joint.
    pub joint: Joint,
    /// The catalogue it was resolved with.
    pub catalog: Catalog,
}

/// Reads a spec and builds its joint.
pub fn read(path: &Path) -> Result<SpecFile, Diagnostics> {
    let text = std::fs::read_to_string(path).map_err(|e| {
        Diagnostic::input("spec/read", format!("the spec `{}` cannot be read: {e}", path.display()))
            .file(path)
            .help("check the path; `bracket new TEMPLATE -o FILE` writes a starter spec")
    })?;
    let mut spec = yaml::parse::<ConnectionSpec>(&text, path).map_err(|mut faults| {
        if top_level(&text, "mesh") && top_level(&text, "bodies") {
            faults.0.truncate(1);
            faults.0[0].help = Some("this looks like a model file: `bracket analyse` reads it".into());
        }
        faults
    })?;
    let value = &mut spec.value;
    if let Some(polygon) = &value.polygon {
        let directions = polygon.loads(&value.loads).map_err(|faults| {
            let told = |f: PolygonFault| {
                let mut d = Diagnostic::input("spec/value", f.problem).help(f.help);
                d.place = spec.index.place(&f.path);
                d
            };
            Diagnostics(faults.into_iter().map(told).collect())
        })?;
        value.loads.extend(directions);
    }
    let catalog = Catalog::builtin().map_err(Diagnostic::from)?;
    let joint = assembly::build(&spec, path.parent().unwrap_or(Path::new("")), &catalog)?;
    Ok(SpecFile { text, spec, joint, catalog })
}

/// True when a line of the file begins with this key: enough to tell the two kinds of input apart.
pub fn top_level(text: &str, key: &str) -> bool {
    text.lines().any(|l| l.strip_prefix(key).is_some_and(|rest| rest.trim_start().starts_with(':')))
}
