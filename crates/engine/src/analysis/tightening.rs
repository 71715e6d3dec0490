//! Preloaded bolts: tightened first, then loaded with the cuts of their shanks frozen.
//!
//! Step 1, under the dead loads: every cut closes by δ, driven by its preload. The preload is the
//! term `−F_p δ` in the kinematic program and a resultant F_p of the tractions in the static one.
//! All bodies are elastic in this step. Where nothing else is loaded, the two closures enclose the
//! exact one; their mean is used. Step 2, under all loads: both programs have this closure, so both
//! bounds are strict for the structure with this closure. In step 2 the bodies around elastic bolts
//! may yield.

use crate::analysis::discrete_program::{BaseProgram, DiscreteProgram};
use crate::analysis::energy_pass::EnergyPass;
use crate::analysis::engine::{Finished, both};
use crate::analysis::event::{Event, Progress};
use crate::analysis::pass::{PassError, PassOptions};
use crate::analysis::program::Program;
use crate::model::AnalysisModel;
use crate::programs::{Kinematic, Static};
use crate::recover::elastic::RecoverError;
use crate::solve::{Patterns, Solution};
use std::time::Instant;

/// Result of the tightening.
enum Tightened {
    /// The model with the closures of its cuts frozen.
    Frozen(Box<AnalysisModel>),
    /// A program gave no closures: the outcomes of both.
    Failed(Box<EnergyPass>),
}

/// A program whose cuts close under their preload.
struct TighteningProgram<P>(P);

impl<P: BaseProgram + Sized> DiscreteProgram for TighteningProgram<P> {
    type Base = P;
    type Answer = Vec<f64>;

    fn base(&self) -> &P {
        &self.0
    }

    /// None: the rigid motions of the model do not include those that close a cut.
    fn contact_modes(&self, _: &AnalysisModel) -> Vec<Vec<f64>> {
        Vec::new()
    }

    /// The closures of the cuts: results of this solve without a bound.
    fn recover(
        &self,
        _: &AnalysisModel,
        solution: &Solution,
        _: &Patterns,
    ) -> Result<Vec<f64>, RecoverError> {
        let map = self.0.map();
        Ok(solution.x[map.n - map.closures..].to_vec())
    }
}

/// Tightens the bolts whose closures are unknown, then runs `loaded` with the cuts frozen.
pub(super) fn tightened_first(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
    loaded: impl Fn(&AnalysisModel, &PassOptions, &Progress) -> Result<EnergyPass, PassError>,
) -> Result<EnergyPass, PassError> {
    if !model.preload.iter().any(|p| p.closure.is_none() && !p.faces.is_empty()) {
        return loaded(model, options, progress);
    }
    let start = Instant::now();
    match tighten(model, options, progress)? {
        Tightened::Frozen(frozen) => loaded(&frozen, &options.remaining(start), progress),
        Tightened::Failed(pass) => Ok(*pass),
    }
}

/// Tightens the bolts under the dead loads.
fn tighten(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<Tightened, PassError> {
    progress(Program::Kinematic, Event::Tightening);
    let bare = model.without_live_loads();
    let (kinematic, statics) = both(
        &bare,
        options,
        progress,
        |model| Kinematic::new(model).map(TighteningProgram),
        |model| Static::new(model).map(TighteningProgram),
    )?;
    let finished = || [&kinematic, &statics].into_iter().flatten();
    let answers: Vec<&Vec<f64>> = finished().filter_map(|f| f.answer.as_ref()).collect();
    if answers.len() < finished().count() || answers.is_empty() {
        let outcome = |f: Option<Finished<Vec<f64>>>| f.map(|f| f.outcome);
        return Ok(Tightened::Failed(Box::new(EnergyPass {
            kinematic: outcome(kinematic),
            statics: outcome(statics),
            ..EnergyPass::default()
        })));
    }
    let mean = |i: usize| answers.iter().map(|a| a[i]).sum::<f64>() / answers.len() as f64;
    let mut frozen = model.clone();
    frozen.preload.iter_mut().enumerate().for_each(|(i, p)| p.closure = Some(mean(i)));
    Ok(Tightened::Frozen(Box::new(frozen)))
}
