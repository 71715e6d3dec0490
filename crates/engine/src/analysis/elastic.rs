//! Elastic analysis: bounds of the potential energy on one mesh.
//!
//! Preloaded bolts are tightened first (`tightening`). With Coulomb friction the kinematic program
//! is a fixed point, and both bounds belong to its last problem (`coulomb`).

mod coulomb;

use crate::analysis::energy_pass::EnergyPass;
use crate::analysis::engine::both;
use crate::analysis::event::Progress;
use crate::analysis::pass::{PassError, PassOptions};
use crate::analysis::tightening::tightened_first;
use crate::model::AnalysisModel;
use crate::programs::{Kinematic, Static};

/// Runs both programs, or the one whose bound the model requests.
pub fn run(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<EnergyPass, PassError> {
    tightened_first(model, options, progress, run_loaded)
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
