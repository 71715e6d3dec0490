//! The printed report of a result folder.

use crate::markdown::report_data::ReportData;
use crate::sheet::Extent;
use crate::sheet::head::Paper;
use crate::sheet::sweep::SweepSheet;
use crate::words::Words;
use bracket_base::diag::Diagnostic;
use std::path::{Component, Path, PathBuf};

/// The bytes of the PDF, with the pictures in the result folder.
#[cfg(feature = "pdf")]
pub fn pdf(
    data: &ReportData,
    words: &Words,
    folder: &Path,
    extent: Extent,
    paper: Paper,
) -> Result<Vec<u8>, Box<Diagnostic>> {
    let sheet = crate::sheet::build::sheet(data, words, extent, paper);
    crate::pdf::pdf(&sheet, words, |name| picture(folder, name, words))
}

/// A program without the feature `pdf` prints no report.
#[cfg(not(feature = "pdf"))]
pub fn pdf(
    _: &ReportData,
    _: &Words,
    _: &Path,
    _: Extent,
    _: Paper,
) -> Result<Vec<u8>, Box<Diagnostic>> {
    Err(no_pdf())
}

#[cfg(not(feature = "pdf"))]
fn no_pdf() -> Box<Diagnostic> {
    let message = "this program was built without the feature `pdf`: it prints no report";
    let help = "build it with default features; the pages of the result are complete";
    Box::new(Diagnostic::environment("report/pdf", message).help(help))
}

/// The bytes of the printed summary of a sweep.
#[cfg(feature = "pdf")]
pub fn sweep_pdf(sheet: &SweepSheet, words: &Words) -> Result<Vec<u8>, Box<Diagnostic>> {
    crate::pdf::sweep_pdf(sheet, words)
}

/// A program without the feature `pdf` prints no summary.
#[cfg(not(feature = "pdf"))]
pub fn sweep_pdf(_: &SweepSheet, _: &Words) -> Result<Vec<u8>, Box<Diagnostic>> {
    Err(no_pdf())
}

/// A picture of a result folder, drawings with `words`; `None` if there is none of this name.
pub fn picture(folder: &Path, name: &str, words: &Words) -> Option<Vec<u8>> {
    let mut parts = Path::new(name).components();
    let inside = matches!((parts.next(), parts.next()), (Some(Component::Normal(_)), None));
    let bytes =
        inside.then(|| bracket_base::text_file::bytes(&folder.join(name)).ok()).flatten()?;
    match String::from_utf8(bytes) {
        Ok(text) if name.ends_with(".svg") => Some(words.drawing(&text).into_bytes()),
        Ok(text) => Some(text.into_bytes()),
        Err(other) => Some(other.into_bytes()),
    }
}

/// The temporary name under which a file is written.
pub fn part(path: &Path) -> PathBuf {
    let mut part = path.as_os_str().to_owned();
    part.push(".part");
    part.into()
}

/// Writes a file aside and renames it, so that no half of it is ever seen.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Box<Diagnostic>> {
    let part = part(path);
    let written = std::fs::write(&part, bytes).and_then(|()| std::fs::rename(&part, path));
    written.map_err(|e| {
        let _ = std::fs::remove_file(&part);
        let message = format!("`{}` cannot be written: {e}", path.display());
        let help = "check the folder and the disk, or name another file with --out";
        Box::new(Diagnostic::environment("report/write", message).file(path).help(help))
    })
}
