//! The input of a run except its cases: title block, checks, drawings, limits of adaptation.

use crate::driver::demands::CaseDemand;
use bracket_codes::HandChecks;
use bracket_engine::refine::plan;
use bracket_joint::assembly::BoltLine;
use bracket_joint::spec::connection::Language;
use bracket_joint::spec::polygon::PolygonSpec;
use bracket_report::draw::moment_rotation;
use bracket_report::markdown::report_data::CatalogueRow;
use bracket_report::markdown::report_data::PictureRef;
use bracket_report::markdown::report_data::ResolvedValue;
use bracket_report::markdown::report_data::Table;
use bracket_report::words::Words;

/// The input of a run as the report presents it.
#[derive(Clone, Debug, Default)]
pub struct RunContext {
    /// Title block.
    pub project: Vec<(String, String)>,
    /// Language of the reports.
    pub language: Language,
    /// Name of the input file.
    pub input_name: String,
    /// Text of the input file.
    pub input_text: String,
    /// The input as it was read, as YAML.
    pub input_read: String,
    /// Hash of everything the result depends on.
    pub input_hash: String,
    /// Resolved values.
    pub resolved: Vec<ResolvedValue>,
    /// Catalogue rows.
    pub catalogue_rows: Vec<CatalogueRow>,
    /// Mesh quality.
    pub mesh_quality: Table,
    /// Symmetry planes used (axes).
    pub mirror: Vec<usize>,
    /// Limits of the adaptation; `None`: there is only one mesh, and no gap is requested.
    pub adapt: Option<plan::Limits>,
    /// Advice to the user on how to get a finer mesh.
    pub finer: &'static str,
    /// Advice to the user on how to get a coarser mesh.
    pub coarser: &'static str,
    /// Hand checks of the code.
    pub checks: HandChecks,
    /// The load cases that are demands on the joint; a model file has none.
    pub demands: Vec<CaseDemand>,
    /// The actions at the bolt planes; empty where they are given there.
    pub plane_actions: Table,
    /// What the diagram of moment and rotation shows beside the resistance.
    pub rotation: moment_rotation::Frame,
    /// Drawings as SVG text, with file name and caption.
    pub drawings: Vec<(PictureRef, String)>,
    /// The end plate as DXF, where the joint has one.
    pub plate_dxf: Option<String>,
    /// Bolts and plates.
    pub schedule: Table,
    /// Welds.
    pub welds: Table,
    /// Supports of the model.
    pub supports: Table,
    /// Positions of the bolts.
    pub bolts: Vec<BoltLine>,
    /// The requested polygon.
    pub polygon: Option<PolygonSpec>,
}

impl RunContext {
    /// The words of the reports, for texts without names of the user.
    pub fn words(&self) -> Words {
        Words::new(self.language, [])
    }
}
