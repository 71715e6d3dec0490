//! Elastic analysis: bounds of the potential energy on one mesh.
//!
//! Preloaded bolts are tightened first (`preload`). With Coulomb friction the kinematic program is
//! a fixed point, and both bounds belong to its last problem (`coulomb`).

mod coulomb;
mod preload;

use crate::analysis::energy_pass::EnergyPass;
use crate::analysis::engine::both;
use crate::analysis::event::Progress;
use crate::analysis::pass::{PassError, PassOptions};
use crate::model::AnalysisModel;
use crate::programs::{Kinematic, Static};
use std::time::Instant;

/// Runs both programs, or the one whose bound the model requests.
pub fn run(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<EnergyPass, PassError> {
    if !model.preload.iter().any(|p| p.closure.is_none() && !p.faces.is_empty()) {
        return run_loaded(model, options, progress);
    }
    let start = Instant::now();
    match preload::tighten(model, options, progress)? {
        preload::Tightened::Frozen(frozen) => {
            run_loaded(&frozen, &options.remaining(start), progress)
        }
        preload::Tightened::Failed(pass) => Ok(*pass),
    }
}

/// Runs the programs of a model whose bolts, if any, are tightened.
fn run_loaded(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<EnergyPass, PassError> {
    if model.has_coulomb_friction() {
        return coulomb::run(model, options, progress);
    }
    let (kinematic, statics) = both(model, options, progress, Kinematic::new, Static::new)?;
    let mut pass = EnergyPass::default();
    pass.add_kinematic(kinematic);
    pass.add_static(statics);
    pass.join(model)?;
    Ok(pass)
}
