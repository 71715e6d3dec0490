//! Template files: the shipped ones and those of the user.

use super::origin::Origin;
use super::template::Template;
use bracket_base::diag::{Diagnostic, Diagnostics, did_you_mean};
use bracket_base::later;
use bracket_base::text_file;
use bracket_base::yaml::{self, Document, Parsed};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Where the files of the user's own templates are read.
#[derive(Clone, Copy, Debug)]
pub enum Templates<'a> {
    /// By their paths, which are relative to this folder, that of the spec.
    Beside(&'a Path),
    /// In this folder as [`stored_name`] names them, whatever paths the spec and the templates
    /// give: the copies in a result folder.
    Stored(&'a Path),
}

/// Name of the copy of a template in a result folder. The spec's own template has number 0; then
/// comes the one that it extends, and so on.
pub fn stored_name(number: usize) -> String {
    format!("template_{number}.yaml")
}

/// A template that was read.
pub struct ReadTemplate {
    /// The template, with all that it extends.
    pub template: Template,
    /// The place of its entries.
    pub origin: Origin,
    /// The texts of the user's files among it and those that it extends, in this order.
    pub texts: Vec<String>,
}

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
    read(name, Templates::Beside(base)).map(|r| (r.template, r.origin))
}

/// Shipped templates that this process has read, by name. A shipped template is the same for every
/// spec, and to read it takes most of the time in which a joint is built.
static READ: Mutex<BTreeMap<&'static str, Template>> = Mutex::new(BTreeMap::new());

/// Reads a shipped template or a user's file as [`load`] does, from the given place.
pub fn read(name: &str, files: Templates<'_>) -> Result<ReadTemplate, Diagnostics> {
    let Some((shipped, _)) = SHIPPED.iter().find(|(n, _)| *n == name) else {
        return read_file(name, files);
    };
    // a thread that ended in a panic leaves whole entries
    let known = || READ.lock().unwrap_or_else(PoisonError::into_inner);
    let found = known().get(shipped).cloned();
    let template = match found {
        Some(template) => template,
        None => {
            let template = read_file(name, files)?.template;
            known().insert(shipped, template.clone());
            template
        }
    };
    Ok(ReadTemplate { template, origin: Origin::Shipped, texts: Vec::new() })
}

fn read_file(name: &str, files: Templates<'_>) -> Result<ReadTemplate, Diagnostics> {
    let base = match files {
        Templates::Beside(base) => base,
        Templates::Stored(_) => Path::new("."),
    };
    let source = find(name, base, 0, files)?;
    let document = Document::read(&source.text, &source.file)?;
    let mut chain = vec![source.clone()];
    let Parsed { value, index } = match document.text("extends")?.map(str::to_owned) {
        None => yaml::parse::<Template>(&source.text, &source.file)?,
        Some(other) => extended(document, &other, &mut chain, files)?.typed::<Template>()?,
    };
    let origin = match source.shipped {
        true => Origin::Shipped,
        false => Origin::File { file: source.file, index },
    };
    let texts = chain.into_iter().filter(|s| !s.shipped).map(|s| s.text).collect();
    Ok(ReadTemplate { template: value, origin, texts })
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
/// that lead to the document; the last one is the document's own. The templates that it extends are
/// added.
fn extended(
    document: Document,
    name: &str,
    above: &mut Vec<Source>,
    files: Templates<'_>,
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
    let source = find(name, folder, above.len(), files).map_err(|faults| {
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
    above.push(source);
    let base = match base.text("extends")?.map(str::to_owned) {
        None => base,
        Some(other) => extended(base, &other, above, files)?,
    };
    Ok(document.onto(base, &MERGED))
}

/// Finds a shipped template by its name, or reads a file. `number`: how many templates lead to it.
fn find(
    name: &str,
    base: &Path,
    number: usize,
    files: Templates<'_>,
) -> Result<Source, Diagnostics> {
    if is_path(name) {
        let file = match files {
            Templates::Stored(folder) => folder.join(stored_name(number)),
            Templates::Beside(_) if base == Path::new(".") => PathBuf::from(name),
            Templates::Beside(_) => base.join(name),
        };
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
        let usual = "`bracket templates` lists the shipped ones; a path to your own .yaml file \
                     works too";
        let help = later::not_in_this_edition(name).map_or_else(|| usual.to_owned(), later::help);
        return Err(d.path("template").help(help).into());
    };
    let file = PathBuf::from(format!("templates/{shipped}.yaml"));
    Ok(Source { file, text: (*text).to_owned(), shipped: true })
}
