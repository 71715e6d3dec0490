//! Template files: the shipped ones and those of the user.

use super::origin::Origin;
use super::template::Template;
use crate::diag::{Diagnostic, Diagnostics, did_you_mean};
use crate::spec::yaml::{self, Parsed};
use crate::text_file;
use std::path::{Path, PathBuf};

/// The shipped templates: name and text, in the order of the names. They are the files of
/// `templates/`.
pub const SHIPPED: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/templates.rs"));

/// True for what names a file of the user's rather than a shipped template.
pub fn is_path(name: &str) -> bool {
    name.contains(['/', '\\']) || name.ends_with(".yaml") || name.ends_with(".yml")
}

/// Reads a shipped template, or a file of the user's: `name` is a path if it ends in `.yaml` or
/// `.yml` or holds a separator, and is taken relative to `base` (the folder of the spec).
pub fn load(name: &str, base: &Path) -> Result<(Template, Origin), Diagnostics> {
    if is_path(name) {
        let file = if base == Path::new(".") { PathBuf::from(name) } else { base.join(name) };
        let text = text_file::read(&file, |e| {
            Diagnostic::input(
                "template/unreadable",
                format!("template `{}` cannot be read: {e}", file.display()),
            )
            .path("template")
            .help("the path is relative to the spec; `bracket templates` lists the shipped ones")
        })?;
        let Parsed { value, index } = yaml::parse::<Template>(&text, &file)?;
        return Ok((value, Origin::File { file, index }));
    }
    let Some((shipped, text)) = SHIPPED.iter().find(|(n, _)| *n == name) else {
        let hint = did_you_mean(name, SHIPPED.iter().map(|(n, _)| *n));
        let d =
            Diagnostic::input("template/unknown", format!("there is no template `{name}`{hint}"));
        return Err(d
            .path("template")
            .help(
                "`bracket templates` lists the shipped ones; a path to your own .yaml file works \
                 too",
            )
            .into());
    };
    let file = PathBuf::from(format!("templates/{shipped}.yaml"));
    Ok((yaml::parse::<Template>(text, &file)?.value, Origin::Shipped))
}
