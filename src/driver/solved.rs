//! What the analyses of a run leave: the data between solving, judging and presenting.

use crate::driver::adaptive::Adapted;
use crate::driver::setup::RunSetup;
use crate::driver::spec_file::SpecFile;
use bracket_base::diag::Diagnostics;
use bracket_base::words::Text;
use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::certify::fields::DisplacementField;
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::file::ModelFile;
use bracket_joint::meshing::joint::JointMesh;
use bracket_report::markdown::report_data::ModelTraits;
use bracket_report::result::result_file::ResultFile;

/// The solved cases of a run, without their fields.
pub struct Solved {
    /// The result: cases with bounds and forces, polygon, warnings. Utilisations, demands, checks
    /// and verdict come from [`crate::driver::judge`].
    pub result: ResultFile,
    /// The models of the cases.
    pub models: Models,
}

/// What the reports say of the models of a run.
#[derive(Clone, Debug, Default)]
pub struct Models {
    /// Their properties.
    pub traits: ModelTraits,
    /// Decisions and remarks of the reader of the model file.
    pub notes: Vec<Text>,
}

impl Solved {
    /// A run without analyses.
    pub fn without_cases(result: ResultFile) -> Self {
        Self { result, models: Models::default() }
    }
}

/// A case whose analyses have ended, with its fields.
pub struct SolvedCase<'a> {
    /// The entry of the result, and the passes with the best bounds.
    pub adapted: &'a Adapted,
    /// Stem of its file names.
    pub stem: &'a str,
    /// Name and content of the model file on the first mesh.
    pub model_file: &'a (String, ModelFile),
    /// True if the run has no other case.
    pub alone: bool,
    /// Buckling modes on the mesh of its fields, for the route of analysis.
    pub modes: &'a [DisplacementField],
}

/// Takes what a run makes on the way. The fields of a large mesh fill the memory, so that each case
/// is handed over before the next one is solved, and dropped behind.
pub trait RunSink {
    /// The mesh of a spec's joint.
    fn meshed(&mut self, input: &SpecFile, mesh: &JointMesh) -> Result<(), Diagnostics>;

    /// A load step of a case, before the case: the stem of its files and the number of the step,
    /// its model and its pass.
    fn step(
        &mut self,
        of: (&str, usize),
        model: &AnalysisModel,
        pass: &AnalysisPass,
    ) -> Result<(), Diagnostics>;

    /// A solved case.
    fn solved(&mut self, case: &SolvedCase<'_>, setup: &RunSetup) -> Result<(), Diagnostics>;
}

/// Keeps no meshes and no fields.
pub struct NoFiles;

impl RunSink for NoFiles {
    fn meshed(&mut self, _: &SpecFile, _: &JointMesh) -> Result<(), Diagnostics> {
        Ok(())
    }

    fn step(
        &mut self,
        _: (&str, usize),
        _: &AnalysisModel,
        _: &AnalysisPass,
    ) -> Result<(), Diagnostics> {
        Ok(())
    }

    fn solved(&mut self, _: &SolvedCase<'_>, _: &RunSetup) -> Result<(), Diagnostics> {
        Ok(())
    }
}
