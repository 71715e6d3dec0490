//! Preloaded bolts: first tightened, then loaded with the cuts of their shanks frozen.
//!
//! Step 1, under the dead loads: every cut closes by δ, driven by its preload: `−F_p δ` in the
//! kinematic program, a resultant F_p of the tractions in the static one. The two closures enclose
//! the exact one where nothing else is loaded; their mean is taken. Step 2: the same closure on
//! both sides, all loads: both bounds are strict for the structure with that closure.

use crate::analysis::engine::{
    Both, Done, Event, Pass, PassError, PassOptions, Progress, both, run,
};
use crate::analysis::program_run::{DiscreteProgram, Program};
use crate::math::vec3::V3;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::dofs::DofMap;
use crate::programs::{ConicProgram, Kinematic, Static};
use crate::recover::elastic::RecoverError;
use crate::solve::{Patterns, Solution};
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// A tightened bolt.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Tightened {
    /// Body of the bolt.
    pub body: String,
    /// The cut of its shank.
    pub cut: String,
    /// Its preload, of its meshed part \[N\].
    pub force: f64,
    /// A plane of symmetry halves the bolt: force and tension are those of one half.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub halved: bool,
    /// Relative closure of the cut, frozen \[mm\].
    pub closure: f64,
    /// Tension of the shank under all loads in the static field \[N\]: an estimate, no bound.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension: Option<f64>,
}

/// A program whose cuts close under their preload.
struct Tightening<P>(P);

impl<'a, P: DiscreteProgram<'a>> DiscreteProgram<'a> for Tightening<P> {
    type Answer = Vec<f64>;
    const PROGRAM: Program = P::PROGRAM;

    fn assemble(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        P::assemble(model).map(Self)
    }

    fn program(&self) -> &ConicProgram {
        self.0.program()
    }

    fn map(&self) -> &DofMap {
        self.0.map()
    }

    /// None: the motions that close a cut are not among those the model knows of.
    fn contact_modes(&self, _: &AnalysisModel) -> Vec<Vec<f64>> {
        Vec::new()
    }

    /// The closures of the cuts: chosen by this solve, not bounded by it.
    fn recover(
        &self,
        _: &AnalysisModel,
        solution: &Solution,
        _: &Patterns,
    ) -> Result<Vec<f64>, RecoverError> {
        Ok(solution.x[self.map().n - self.map().closures..].to_vec())
    }

    fn motion(&self, model: &AnalysisModel, x: &[f64]) -> Vec<(u32, V3)> {
        self.0.motion(model, x)
    }

    fn contacts(&self) -> Vec<usize> {
        self.0.contacts()
    }
}

/// Tightens the bolts, then runs both programs under all loads.
pub(crate) fn tighten_and_run(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<Pass, PassError> {
    let start = Instant::now();
    progress(Program::Kinematic, Event::Tightening);
    let bare = model.without_live_loads();
    let (kinematic, statics): Both<Vec<f64>, Vec<f64>> =
        both::<Tightening<Kinematic>, Tightening<Static>>(&bare, options, progress)?;
    let answers: Vec<&Vec<f64>> =
        [&kinematic, &statics].into_iter().flatten().filter_map(|d| d.answer.as_ref()).collect();
    let asked = [&kinematic, &statics].into_iter().flatten().count();
    if answers.len() < asked || answers.is_empty() {
        let run = |done: Option<Done<Vec<f64>>>| done.map(|d| d.run);
        return Ok(Pass { kinematic: run(kinematic), statics: run(statics), ..Pass::default() });
    }
    let mean = |i: usize| answers.iter().map(|a| a[i]).sum::<f64>() / answers.len() as f64;
    let mut frozen = model.clone();
    frozen.preload.iter_mut().enumerate().for_each(|(i, p)| p.closure = Some(mean(i)));
    let mut options = options.clone();
    options.solve.time_limit = (options.solve.time_limit - start.elapsed().as_secs_f64()).max(0.0);
    run(&frozen, &options, progress)
}

/// The bolts of a model whose cuts are frozen, with the tension that a static field leaves in each
/// \[N\].
pub fn tightened(model: &AnalysisModel, tensions: Option<&[f64]>) -> Vec<Tightened> {
    let bolts = model.preload.iter().enumerate();
    bolts
        .filter_map(|(i, p)| {
            Some(Tightened {
                body: p.body.clone(),
                cut: p.cut.clone(),
                force: p.force,
                halved: false,
                closure: p.closure?,
                tension: tensions.and_then(|t| t.get(i).copied()),
            })
        })
        .collect()
}
