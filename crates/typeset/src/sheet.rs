//! What is to be set, and how typst sets it.

use crate::fonts::FONTS;
use std::collections::{BTreeMap, HashMap};
use typst::diag::{FileError, FileResult, SourceDiagnostic};
use typst::foundations::{Bytes, Datetime, Duration, Smart};
use typst::syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World};
use typst_layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards};

/// What is to be set.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Code of typst; it reads the data as `data.json` and the pictures by their names.
    pub layout: String,
    /// The data of the layout. No text of a user is ever part of its code.
    pub data: serde_json::Value,
    /// Pictures by name, as their files hold them.
    pub pictures: BTreeMap<String, Vec<u8>>,
    /// Identity of the document, in its properties.
    pub identity: String,
    /// The program that wrote it, in its properties.
    pub creator: String,
    /// PDF/A-2b is wanted. It needs a date in the layout; a text with characters that the fonts do
    /// not have makes it an ordinary PDF.
    pub archival: bool,
}

/// The files that the layout sees: the data and the pictures, nothing of the disk.
struct Files {
    library: LazyHash<Library>,
    main: Source,
    files: HashMap<FileId, Bytes>,
}

/// The identity of a file beside the layout; an error for a name that leaves the folder.
fn id(name: &str) -> Result<FileId, String> {
    let path = VirtualPath::new(name).map_err(|_| format!("`{name}` is no name of a file"))?;
    Ok(RootedPath::new(VirtualRoot::Project, path).intern())
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

/// The bytes of the PDF. The error says what typst could not set.
pub fn pdf(sheet: Sheet) -> Result<Vec<u8>, String> {
    let mut files = HashMap::new();
    for (name, bytes) in sheet.pictures {
        files.insert(id(&name)?, Bytes::new(bytes));
    }
    // no picture takes the place of the data
    files.insert(id("data.json")?, Bytes::new(sheet.data.to_string().into_bytes()));
    let main = Source::new(id("main.typ")?, sheet.layout);
    let world = Files { library: LazyHash::new(Library::default()), main, files };
    let first = |faults: &[SourceDiagnostic]| {
        faults.first().map_or_else(String::new, |d| d.message.to_string())
    };
    let document: PagedDocument = typst::compile(&world).output.map_err(|e| first(&e))?;
    let options = |standards| PdfOptions {
        ident: Smart::Custom(sheet.identity.clone()),
        creator: Smart::Custom(Some(sheet.creator.clone())),
        standards,
        ..PdfOptions::default()
    };
    if sheet.archival
        && let Ok(archival) = PdfStandards::new(&[PdfStandard::A_2b])
        && let Ok(bytes) = typst_pdf::pdf(&document, &options(archival))
    {
        return Ok(bytes);
    }
    typst_pdf::pdf(&document, &options(PdfStandards::default())).map_err(|e| first(&e))
}
