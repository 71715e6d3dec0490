//! Template files: the shipped ones and those of the user.

use super::origin::Origin;
use super::template::Template;
use crate::diag::{Diagnostic, Diagnostics, did_you_mean};
use crate::spec::yaml::{self, Document, Parsed};
use crate::text_file;
use std::path::{Path, PathBuf};

/// The shipped templates, as name and text in the order of the names. They are the files of
/// `templates/`.
pub const SHIPPED: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/templates.rs"));

/// True if `name` is a path to a user's file rather than the name of a shipped template.
pub fn is_path(name: &str) -> bool {
    name.contains(['/', '\\']) || name.ends_with(".yaml") || name.ends_with(".yml")
}

/// Keys of a template that are merged key by key with those of the base.
const MERGED: [&str; 1] = ["hand_checks"];

/// Reads a shipped template or a user's file. `name` is a path if it ends in `.yaml` or `.yml` or
/// contains a separator; it is then relative to `base` (the folder of the spec).
pub fn load(name: &str, base: &Path) -> Result<(Template, Origin), Diagnostics> {
    let source = find(name, base)?;
    let document = Document::read(&source.text, &source.file)?;
    let Parsed { value, index } = match document.text("extends")?.map(str::to_owned) {
        None => yaml::parse::<Template>(&source.text, &source.file)?,
        Some(other) => {
            extended(document, &other, &mut vec![source.clone()])?.typed::<Template>()?
        }
    };
    let origin = match source.shipped {
        true => Origin::Shipped,
        false => Origin::File { file: source.file, index },
    };
    Ok((value, origin))
}

/// Templates in a chain of `extends`, at most.
const LONGEST_CHAIN: usize = 16;

/// The text of a template and its origin.
#[derive(Clone)]
struct Source {
    file: PathBuf,
    text: String,
    shipped: bool,
}

impl Source {
    /// True if both are the same file, even by different paths.
    fn is(&self, other: &Self) -> bool {
        let plain = |f: &Path| f.canonicalize().unwrap_or_else(|_| f.to_owned());
        self.shipped == other.shipped && plain(&self.file) == plain(&other.file)
    }
}

/// A document merged with the template `name` that it extends. `above` is the chain of templates
/// that lead to the document; the last one is the document's own.
fn extended(
    document: Document,
    name: &str,
    above: &mut Vec<Source>,
) -> Result<Document, Diagnostics> {
    let here = document.place("extends");
    let folder = above.last().and_then(|s| s.file.parent()).unwrap_or(Path::new("."));
    let shipped = above.last().is_some_and(|s| s.shipped);
    let folder = if folder == Path::new("") || shipped { Path::new(".") } else { folder };
    if above.len() >= LONGEST_CHAIN {
        let text = format!("a chain of more than {LONGEST_CHAIN} templates that extend each other");
        let d = Diagnostic::input("template/chain", text)
            .help("extend a template nearer to the end of the chain");
        return Err(Diagnostic { place: here, ..d }.into());
    }
    // a template that is not found is a fault of the key that names it
    let source = find(name, folder).map_err(|faults| {
        faults.map(|d| match &d.place.file {
            None => Diagnostic { place: here.clone(), ..d },
            Some(_) => d,
        })
    })?;
    if above.iter().any(|s| s.is(&source)) {
        let ring: Vec<String> =
            above.iter().chain([&source]).map(|s| s.file.display().to_string()).collect();
        let d = Diagnostic::input(
            "template/circle",
            format!("these templates extend each other: {}", ring.join(" -> ")),
        );
        let d = d.help("let one of them stand alone, without `extends`");
        return Err(Diagnostic { place: here, ..d }.into());
    }
    let base = Document::read(&source.text, &source.file)?;
    let base = match base.text("extends")?.map(str::to_owned) {
        None => base,
        Some(other) => {
            above.push(source);
            extended(base, &other, above)?
        }
    };
    Ok(document.onto(base, &MERGED))
}

/// Finds a shipped template by its name, or reads a file.
fn find(name: &str, base: &Path) -> Result<Source, Diagnostics> {
    if is_path(name) {
        let file = if base == Path::new(".") { PathBuf::from(name) } else { base.join(name) };
        let text = text_file::read(&file, |e| {
            Diagnostic::input(
                "template/unreadable",
                format!("template `{}` cannot be read: {e}", file.display()),
            )
            .path("template")
            .help(
                "the path is relative to the file that names it; `bracket templates` lists the \
                 shipped ones",
            )
        })?;
        return Ok(Source { file, text, shipped: false });
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
    Ok(Source { file, text: (*text).to_owned(), shipped: true })
}
