//! A load case that is ready to be analysed.

use crate::driver::remesh::Remesh;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::analysis::Traction;
use bracket_engine::model::file::ModelFile;
use bracket_report::result::file_names::stem_of;

/// One load case ready to be analysed.
pub struct Case<'a> {
    /// Name, used in file names.
    pub name: String,
    /// The model.
    pub model: AnalysisModel,
    /// Its `MODEL.yaml`, written into the folder under this name.
    pub model_file: (String, ModelFile),
    /// Makes further meshes; `None` if the case has only one.
    pub remesh: Option<Box<dyn Remesh<'a> + 'a>>,
    /// Wall time of meshing \[s\], if this run made the mesh.
    pub mesh_seconds: Option<f64>,
    /// For a direction of the spec's polygon: both actions in the units of its axes.
    pub direction: Option<[f64; 2]>,
}

/// Refuses a case without load: its answer is zero, and most likely a load was forgotten.
pub fn refuse_idle(case: &Case) -> Result<(), Diagnostics> {
    let m = &case.model;
    let acts = m.surface_loads.iter().any(|l| match l.traction {
        Traction::Pressure(p) => p != 0.0,
        Traction::Linear { traction0, gradient } => {
            traction0 != [0.0; 3] || gradient != [[0.0; 3]; 3]
        }
    }) || m.body_loads.iter().any(|l| l.force != [0.0; 3])
        || m.rigid.iter().any(|r| r.action.iter().chain(&r.dead_action).any(|a| *a != 0.0))
        || m.has_preload();
    if acts {
        return Ok(());
    }
    Err(Diagnostic::input(
        "model/no-load",
        format!("nothing acts on the model of `{}`: every load is zero", case.name),
    )
    .path("loads")
    .help("give a load that is not zero")
    .into())
}

/// The warning about the cases that a run has not analysed, because it ended before.
pub fn not_analysed(cases: &[String]) -> Text {
    say!("the run ended before all load cases: not analysed were {}", cases.join(", "))
}

/// The stems of the file names of the cases. The kind of analysis is added if an earlier case has
/// the same name.
pub fn stems(cases: &[Case]) -> Vec<String> {
    let again = |i: usize| cases[..i].iter().any(|c| c.name == cases[i].name);
    cases.iter().enumerate().map(|(i, c)| stem_of(&c.name, c.model.analysis, again(i))).collect()
}
