//! A printed report is set as PDF, if this program has typst.

use bracket_base::diag::Diagnostic;
use bracket_report::pdf::Printout;
#[cfg(feature = "pdf")]
use bracket_report::pdf::fault;

/// The bytes of the PDF.
#[cfg(feature = "pdf")]
pub fn pdf(printout: Printout) -> Result<Vec<u8>, Box<Diagnostic>> {
    let Printout { file, layout, data, pictures, head } = printout;
    let archival = head.date.is_some();
    let (identity, creator) = (head.hash, head.software);
    let sheet = bracket_typeset::Sheet { layout, data, pictures, identity, creator, archival };
    bracket_typeset::pdf(sheet).map_err(|what| fault(file, &what))
}

/// A program without the feature `pdf` prints no report.
#[cfg(not(feature = "pdf"))]
pub fn pdf(_: Printout) -> Result<Vec<u8>, Box<Diagnostic>> {
    let message = "this program was built without the feature `pdf`: it prints no report";
    let help = "build it with default features; the pages of the result are complete";
    Err(Box::new(Diagnostic::environment("report/pdf", message).help(help)))
}
