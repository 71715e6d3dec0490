//! The printed summary of a sweep as plain data.

use super::Section;
use super::head::Head;
use serde::Serialize;

/// Name of the printed summary in the folder of a sweep.
pub const SUMMARY_PDF: &str = "summary.pdf";

/// All that the printed summary says.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SweepSheet {
    /// Head of its pages.
    #[serde(flatten)]
    pub head: Head,
    /// What stands before the tables: outcomes and choice.
    pub overview: Vec<Section>,
    /// Capacity tables, each on a page of its own.
    pub tables: Vec<Section>,
    /// The cases.
    pub cases: Section,
}
