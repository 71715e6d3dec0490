//! The printed report as plain data: what stands on its pages, in the order of the pages, without a
//! layout.

pub mod build;
pub mod derivation;
pub mod head;
pub mod sweep;

use crate::document::block::{Block, Grid, Spans};
use crate::document::symbols::Piece;
use crate::summary::Tone;
use head::Head;
use serde::Serialize;

/// Name of the printed report in a result folder.
pub const PDF_FILE: &str = "report.pdf";

/// Extent of a printed report.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub enum Extent {
    /// Verdict, drawings, actions, summary of the checks, bounds.
    #[default]
    Short,
    /// Also the checks with their numbers, analyses, catalogue rows and input.
    Full,
}

/// The verdict.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct VerdictBox {
    /// `OK`, `NOT OK`, `UNDECIDED`, `none`.
    pub word: String,
    /// Its colour.
    pub tone: Tone,
    /// Reason, in a sentence.
    pub reason: Vec<Piece>,
    /// By code and by analysis: name, word, colour and what it stands on.
    pub parts: Vec<(String, String, Tone, Spans)>,
    /// What brings the user further; empty where nothing is left to do.
    pub next: Spans,
}

/// The bracket of a load factor on an axis. Numbers are load factors.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bar {
    /// Lower bound; 0 without one.
    pub low: f64,
    /// Upper bound; absent without one.
    pub up: Option<f64>,
    /// Load factor of the component method.
    pub method: Option<f64>,
    /// The three as texts, bounds rounded outwards.
    pub labels: BarLabels,
}

/// Texts of a bar.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct BarLabels {
    /// Lower bound; absent without one.
    pub low: Option<String>,
    /// Upper bound.
    pub up: Option<String>,
    /// Load factor of the component method.
    pub method: Option<String>,
}

/// A picture of the result folder.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Picture {
    /// File name, relative to the folder.
    pub file: String,
    /// Caption.
    pub caption: String,
}

/// The bounds of a load case.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CaseAnswer {
    /// Name of the case and kind of analysis.
    pub name: String,
    /// The bracket as a bar; absent for energies.
    pub bar: Option<Bar>,
    /// Sentences and tables.
    pub blocks: Vec<Block>,
}

/// A row of the summary of checks.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SummaryLine {
    /// Check and place.
    pub what: Vec<Piece>,
    /// Load case, or `all`.
    pub case: String,
    /// Demand with its unit.
    pub demand: String,
    /// Resistance with its unit.
    pub resistance: String,
    /// Demand over resistance.
    pub utilisation: String,
    /// Clause.
    pub clause: String,
    /// Status.
    pub status: String,
    /// Its colour.
    pub tone: Tone,
    /// True for a row that governs.
    pub governs: bool,
}

/// A check with its numbers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct WorkedRow {
    /// Load case and part.
    pub of: String,
    /// Name of the check.
    pub check: Vec<Piece>,
    /// Formula with its numbers.
    pub formula: Vec<Piece>,
    /// Intermediate values.
    pub values: Vec<Vec<Piece>>,
    /// Clause.
    pub clause: String,
    /// Demand over resistance.
    pub utilisation: String,
    /// Status.
    pub status: String,
    /// Its colour.
    pub tone: Tone,
}

/// The checks of a topic.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct TopicSheet {
    /// Title.
    pub title: String,
    /// What a reader must know of them.
    pub words: Vec<Piece>,
    /// The checks.
    pub rows: Vec<WorkedRow>,
}

/// A section of blocks.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Section {
    /// Its title.
    pub title: String,
    /// Its elements.
    pub blocks: Vec<Block>,
}

/// All that the printed report says.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sheet {
    /// Extent.
    pub extent: Extent,
    /// Head of its pages.
    #[serde(flatten)]
    pub head: Head,
    /// Verdict.
    pub verdict: VerdictBox,
    /// Drawings of the joint and of its actions.
    pub drawings: Vec<Picture>,
    /// Actions of the load cases, with what the joint carries.
    pub actions: Grid,
    /// Actions at the bolt planes; empty where they are given there.
    pub plane_actions: Grid,
    /// What the table before is.
    pub plane_note: Vec<Piece>,
    /// Many load cases, the worst first; empty where each has its own rows.
    pub load_cases: Grid,
    /// What the table before is, and how many load cases it leaves out.
    pub load_cases_note: Vec<Piece>,
    /// Checks with a demand, worst first.
    pub summary: Vec<SummaryLine>,
    /// What the summary leaves out; empty where it has all.
    pub summary_note: Vec<Piece>,
    /// Bounds of the load cases.
    pub answers: Vec<CaseAnswer>,
    /// Resistance and stiffness for the analysis of the frame in the short report.
    pub frame: Grid,
    /// The component method with its numbers, in the short report of the senses of bending of the
    /// load cases.
    pub method: Vec<Section>,
    /// Pictures of mesh and mechanism.
    pub pictures: Vec<Picture>,
    /// Partial factors and strengths: symbol, of what, value.
    pub design_values: Vec<(Vec<Piece>, String, String)>,
    /// Bolts, plates and masses.
    pub schedule: Grid,
    /// Welds.
    pub welds: Grid,
    /// Supports of the model.
    pub supports: Grid,
    /// Warnings.
    pub warnings: Vec<Spans>,
    /// Checks with their numbers; empty in the short report.
    pub topics: Vec<TopicSheet>,
    /// Assumptions and limits.
    pub assumptions: Vec<Spans>,
    /// Sections on the analyses in the full report: mechanism, meshes, certificate.
    pub analysis: Vec<Section>,
    /// Values and input in the full report.
    pub sections: Vec<Section>,
}
