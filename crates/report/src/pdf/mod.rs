//! The printed reports, set by typst in this process.
//!
//! The layouts (`*.typ`) read a sheet as JSON, so that no text of the user is ever part of their
//! code. Fonts are embedded. Equal sheets and pictures give equal bytes.

use crate::sheet::head::Head;
use crate::sheet::sweep::{SUMMARY_PDF, SweepSheet};
use crate::sheet::{PDF_FILE, Sheet};
use crate::words::Words;
use bracket_base::diag::{Diagnostic, visible};
use serde_json::Value;
use std::collections::HashMap;
use std::sync::LazyLock;
use typst::diag::{FileError, FileResult};
use typst::foundations::{Bytes, Datetime, Duration, Smart};
use typst::syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World};
use typst_layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards};

/// What the layouts share; each stands behind it.
const COMMON: &str = include_str!("common.typ");
/// The layout of the report of a joint.
const REPORT: &str = include_str!("report.typ");
/// The layout of the summary of a sweep.
const SWEEP: &str = include_str!("sweep.typ");

/// The embedded fonts, under the licences in `NOTICE`.
const FONT_FILES: [&[u8]; 6] = [
    include_bytes!("fonts/LibertinusSerif-Regular.otf"),
    include_bytes!("fonts/LibertinusSerif-Bold.otf"),
    include_bytes!("fonts/LibertinusSerif-Italic.otf"),
    include_bytes!("fonts/LibertinusSerif-BoldItalic.otf"),
    include_bytes!("fonts/DejaVuSansMono.ttf"),
    include_bytes!("fonts/DejaVuSansMono-Bold.ttf"),
];

/// The fonts and their index.
static FONTS: LazyLock<(Vec<Font>, LazyHash<FontBook>)> = LazyLock::new(|| {
    let fonts: Vec<Font> =
        FONT_FILES.into_iter().flat_map(|data| Font::iter(Bytes::new(data))).collect();
    let book = LazyHash::new(FontBook::from_fonts(&fonts));
    (fonts, book)
});

/// The files that the layout sees: the sheet and the pictures, nothing of the disk.
struct Files {
    library: LazyHash<Library>,
    main: Source,
    files: HashMap<FileId, Bytes>,
}

/// The identity of a file beside the layout; `None` for a name that leaves the folder.
fn id(name: &str) -> Option<FileId> {
    Some(RootedPath::new(VirtualRoot::Project, VirtualPath::new(name).ok()?).intern())
}

impl World for Files {
    fn library(&self) -> &LazyHash<Library> {
        &self.library
    }
    fn book(&self) -> &LazyHash<FontBook> {
        &FONTS.1
    }
    fn main(&self) -> FileId {
        self.main.id()
    }
    fn source(&self, id: FileId) -> FileResult<Source> {
        if id == self.main.id() { Ok(self.main.clone()) } else { Err(FileError::AccessDenied) }
    }
    fn file(&self, id: FileId) -> FileResult<Bytes> {
        self.files.get(&id).cloned().ok_or(FileError::AccessDenied)
    }
    fn font(&self, index: usize) -> Option<Font> {
        FONTS.0.get(index).cloned()
    }
    fn today(&self, _: Option<Duration>) -> Option<Datetime> {
        None
    }
}

/// The bytes of the report of a joint. `picture` reads a picture of the result folder; pictures
/// that it does not have are left out.
pub fn pdf(
    sheet: &Sheet,
    words: &Words,
    picture: impl Fn(&str) -> Option<Vec<u8>>,
) -> Result<Vec<u8>, Box<Diagnostic>> {
    let mut sheet = sheet.clone();
    let mut files = HashMap::new();
    for pictures in [&mut sheet.drawings, &mut sheet.pictures] {
        pictures.retain(|p| match (id(&p.file), picture(&p.file)) {
            (Some(id), Some(bytes)) => files.insert(id, Bytes::new(bytes)).is_none(),
            _ => false,
        });
    }
    typeset(PDF_FILE, &words.fill(&format!("{COMMON}{REPORT}")), (&sheet, &sheet.head), files)
}

/// The bytes of the summary of a sweep.
pub fn sweep_pdf(sheet: &SweepSheet, words: &Words) -> Result<Vec<u8>, Box<Diagnostic>> {
    let layout = words.fill(&format!("{COMMON}{SWEEP}"));
    typeset(SUMMARY_PDF, &layout, (sheet, &sheet.head), HashMap::new())
}

/// The data of a layout with texts that command nothing and turn no direction of writing.
fn plain(data: Value) -> Value {
    match data {
        Value::String(text) => Value::String(visible(&text)),
        Value::Array(items) => items.into_iter().map(plain).collect(),
        Value::Object(keys) => keys.into_iter().map(|(k, v)| (k, plain(v))).collect(),
        other => other,
    }
}

/// Sets a sheet, to be named `file`, with a layout. With a date the file is PDF/A-2b, unless a text
/// has characters that the fonts do not have.
fn typeset(
    file: &str,
    layout: &str,
    (sheet, head): (&impl serde::Serialize, &Head),
    mut files: HashMap<FileId, Bytes>,
) -> Result<Vec<u8>, Box<Diagnostic>> {
    let fault = |what: String| {
        let message = format!("`{file}` cannot be set: {what}");
        let help = "the other reports of the folder are complete; please report this message";
        Box::new(Diagnostic::environment("report/pdf", message).help(help))
    };
    let main = id("main.typ").ok_or_else(|| fault("its layout has no name".into()))?;
    let data = serde_json::to_value(sheet).map_err(|e| fault(e.to_string()))?;
    let data = plain(data).to_string().into_bytes();
    files.extend(id("data.json").map(|id| (id, Bytes::new(data))));
    let library = LazyHash::new(Library::default());
    let world = Files { library, main: Source::new(main, layout.into()), files };
    let first = |faults: &[typst::diag::SourceDiagnostic]| {
        fault(faults.first().map_or_else(String::new, |d| d.message.to_string()))
    };
    let document: PagedDocument = typst::compile(&world).output.map_err(|e| first(&e))?;
    let options = |standards| PdfOptions {
        ident: Smart::Custom(head.hash.clone()),
        creator: Smart::Custom(Some(head.software.clone())),
        standards,
        ..PdfOptions::default()
    };
    if head.date.is_some()
        && let Ok(archival) = PdfStandards::new(&[PdfStandard::A_2b])
        && let Ok(bytes) = typst_pdf::pdf(&document, &options(archival))
    {
        return Ok(bytes);
    }
    typst_pdf::pdf(&document, &options(PdfStandards::default())).map_err(|e| first(&e))
}
