//! The input of a run except its cases: title block, checks, drawings, limits of adaptation.

use bracket_codes::HandChecks;
use bracket_engine::refine::plan;
use bracket_joint::assembly::BoltLine;
use bracket_joint::spec::polygon::PolygonSpec;
use bracket_report::draw::moment_rotation;
use bracket_report::markdown::report_data::{InputFacts, Table};
use bracket_report::words::Words;

/// The input of a run as the report presents it.
#[derive(Clone, Debug, Default)]
pub struct RunContext {
    /// What the reports say of the input.
    pub input: InputFacts,
    /// Hash of everything the result depends on.
    pub input_hash: String,
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
    /// What the diagram of moment and rotation shows beside the resistance.
    pub rotation: moment_rotation::Frame,
    /// Files made from the input alone, name and text: drawings, and the end plate as DXF.
    pub files: Vec<(String, String)>,
    /// Positions of the bolts.
    pub bolts: Vec<BoltLine>,
    /// The requested polygon.
    pub polygon: Option<PolygonSpec>,
}

impl RunContext {
    /// The words of the reports, for texts without names of the user.
    pub fn words(&self) -> Words {
        Words::new(self.input.language, [])
    }
}
