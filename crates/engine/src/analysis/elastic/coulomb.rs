//! Elastic analysis under Coulomb's law: the fixed point of the cone shift.
//!
//! The static program solves the last problem of the kinematic one, with the same shift: both
//! bounds are strict for one problem.

use crate::analysis::cone_shift::{ConeShiftIteration, ConvergedShift};
use crate::analysis::discrete_program::{BaseProgram, DiscreteProgram, NextProblem};
use crate::analysis::energy_pass::EnergyPass;
use crate::analysis::engine::{kinematic_alone, static_alone};
use crate::analysis::event::Progress;
use crate::analysis::pass::{PassError, PassOptions};
use crate::certify::bracket::UpperBound;
use crate::certify::certificate::certify_displacement;
use crate::certify::fields::DisplacementField;
use crate::model::file::Bounds;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::{Kinematic, Static};
use crate::recover::elastic::{self, RecoverError};
use crate::solve::{Patterns, Solution};
use std::time::Instant;

/// The kinematic program with shifted cones.
struct CoulombKinematic {
    program: Kinematic,
    iteration: ConeShiftIteration,
}

impl CoulombKinematic {
    fn new(model: &AnalysisModel) -> Result<Self, ModelError> {
        let program = Kinematic::new(model)?;
        let iteration = ConeShiftIteration::new(&program, None);
        Ok(Self { program, iteration })
    }
}

impl DiscreteProgram for CoulombKinematic {
    type Base = Kinematic;
    type Answer = (DisplacementField, UpperBound, ConvergedShift);

    fn base(&self) -> &Kinematic {
        &self.program
    }

    fn origin(&self, model: &AnalysisModel) -> Vec<f64> {
        self.program.closed_cuts(model)
    }

    fn next_problem(&self, model: &AnalysisModel, solution: &Solution) -> Option<NextProblem> {
        self.iteration.next_problem(model, &self.program, solution)
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        let shift = self.iteration.converged(model, &self.program)?;
        let offsets = self.iteration.offsets();
        let field = elastic::displacement_at(model, &self.program, &offsets, solution, patterns)?;
        let certificate = certify_displacement(&shift.shifted(model), &field);
        let bound = UpperBound::new(certificate, model.symmetry);
        Ok((field, bound, shift))
    }
}

/// Runs the fixed point on the kinematic program, then the static program of its last problem.
pub(super) fn run(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<EnergyPass, PassError> {
    let start = Instant::now();
    let mut pass = EnergyPass::default();
    let alone = AnalysisModel { bounds: Bounds::Kinematic, ..model.clone() };
    let kinematic = kinematic_alone(&alone, options, progress, || CoulombKinematic::new(&alone))?;
    let Some(kinematic) = kinematic else { return Ok(pass) };
    pass.kinematic = Some(kinematic.outcome);
    let Some((field, bound, found)) = kinematic.answer else { return Ok(pass) };
    pass.displacement = Some(field);
    pass.upper = Some(bound);
    pass.fixed_point = Some(found.run);
    let shifted = AnalysisModel { bounds: Bounds::Static, shift: found.shift, ..alone };
    if model.bounds != Bounds::Kinematic {
        let options = options.remaining(start);
        let statics = static_alone(&shifted, &options, progress, || Static::new(&shifted))?;
        pass.add_static(statics);
    }
    pass.join(&shifted)?;
    pass.shift = shifted.shift;
    Ok(pass)
}
