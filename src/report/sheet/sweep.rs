//! The printed summary of a sweep as plain data.

use super::{Paper, Section};
use serde::Serialize;

/// Name of the printed summary in the folder of a sweep.
pub const SUMMARY_PDF: &str = "summary.pdf";

/// All that the printed summary says.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct SweepSheet {
    /// Paper.
    pub paper: Paper,
    /// Title of the sweep.
    pub title: String,
    /// Project number and revision, on every page; empty without them.
    pub running: String,
    /// Author, for the properties of the document.
    pub author: String,
    /// Date as year, month, day; absent without one that can be read.
    pub date: Option<[u32; 3]>,
    /// Title block: names and values.
    pub project: Vec<(String, String)>,
    /// Program and version.
    pub software: String,
    /// Hash of the input; empty: each case has its own.
    pub hash: String,
    /// Its sections.
    pub sections: Vec<Section>,
}
