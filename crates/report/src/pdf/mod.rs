//! The printed reports as layouts of typst (`*.typ`) with their data and pictures; `src/` has them
//! set as PDF.

use crate::markdown::report_data::ReportData;
use crate::printed::picture;
use crate::sheet::build::sheet;
use crate::sheet::head::{Head, Paper};
use crate::sheet::sweep::{SUMMARY_PDF, SweepSheet};
use crate::sheet::{Extent, PDF_FILE};
use crate::words::Words;
use bracket_base::diag::{Diagnostic, visible};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;

/// What the layouts share; each stands behind it.
const COMMON: &str = include_str!("common.typ");
/// The layout of the report of a joint.
const REPORT: &str = include_str!("report.typ");
/// The layout of the summary of a sweep.
const SWEEP: &str = include_str!("sweep.typ");

/// A printed report before it is set.
#[derive(Clone, Debug)]
pub struct Printout {
    /// Name of its file.
    pub file: &'static str,
    /// Code of typst, in the language of the report.
    pub layout: String,
    /// What the layout reads as `data.json`.
    pub data: Value,
    /// Pictures by name.
    pub pictures: BTreeMap<String, Vec<u8>>,
    /// What stands at its head, and its properties.
    pub head: Head,
}

/// The report of a joint, with the pictures of the result folder. Pictures that it does not have
/// are left out.
pub fn report(
    data: &ReportData,
    words: &Words,
    folder: &Path,
    extent: Extent,
    paper: Paper,
) -> Result<Printout, Box<Diagnostic>> {
    let mut sheet = sheet(data, words, extent, paper);
    let mut pictures = BTreeMap::new();
    for listed in [&mut sheet.drawings, &mut sheet.pictures] {
        listed.retain(|p| match picture(folder, &p.file, words) {
            Some(bytes) => pictures.insert(p.file.clone(), bytes).is_none(),
            None => false,
        });
    }
    let layout = words.fill(&format!("{COMMON}{REPORT}"));
    Ok(Printout {
        file: PDF_FILE,
        layout,
        data: plain(PDF_FILE, &sheet)?,
        pictures,
        head: sheet.head,
    })
}

/// The summary of a sweep.
pub fn summary(sheet: SweepSheet, words: &Words) -> Result<Printout, Box<Diagnostic>> {
    Ok(Printout {
        file: SUMMARY_PDF,
        layout: words.fill(&format!("{COMMON}{SWEEP}")),
        data: plain(SUMMARY_PDF, &sheet)?,
        pictures: BTreeMap::new(),
        head: sheet.head,
    })
}

/// The error of a report named `file` that cannot be set.
pub fn fault(file: &str, what: &str) -> Box<Diagnostic> {
    let message = format!("`{file}` cannot be set: {what}");
    let help = "the other reports of the folder are complete; please report this message";
    Box::new(Diagnostic::environment("report/pdf", message).help(help))
}

/// The data of a layout with texts that command nothing and turn no direction of writing.
fn plain(file: &str, sheet: &impl serde::Serialize) -> Result<Value, Box<Diagnostic>> {
    fn made_plain(data: Value) -> Value {
        match data {
            Value::String(text) => Value::String(visible(&text)),
            Value::Array(items) => items.into_iter().map(made_plain).collect(),
            Value::Object(keys) => keys.into_iter().map(|(k, v)| (k, made_plain(v))).collect(),
            other => other,
        }
    }
    serde_json::to_value(sheet).map(made_plain).map_err(|e| fault(file, &e.to_string()))
}
