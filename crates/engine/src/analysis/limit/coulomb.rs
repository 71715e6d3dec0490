//! Limit analysis under Coulomb's law: an estimate of the load factor from a fixed point.
//!
//! The kinematic program with shifted cones, `g_N + s ≥ μ‖g_T‖`, has the dual `max λ − ∫ r_N s`
//! over stresses that obey the friction cone. Where s equals `μ‖g_T‖` of the solution itself, slip
//! does not dilate. The load factor of the dual solution is then the power of yield and friction,
//! `λ = D(u) + ∫ μ r_N ‖g_T‖`, less the power of the dead loads, at unit power of the live loads.
//! The dual solution obeys the cones of the associated law, and the velocities are admissible
//! without friction: on one mesh λ lies between the factor without friction and the one with
//! associated friction. Where wedging decides which contacts press, Coulomb's law may have several
//! load factors for one structure; this is one of them.
//!
//! # Source
//! V. Acary, F. Cadoux, C. Lemaréchal, J. Malick, A formulation of the linear discrete Coulomb
//! friction problem via convex optimization, ZAMM 91 (2011), 155–175.

use crate::analysis::cone_shift::{ConeShiftIteration, FixedPointRun, load_factor};
use crate::analysis::discrete_program::{DiscreteProgram, NextProblem};
use crate::analysis::engine::kinematic_alone;
use crate::analysis::event::{Event, Progress};
use crate::analysis::limit::programs::{SUBDIVISIONS, velocity_of};
use crate::analysis::pass::{PassError, PassOptions};
use crate::analysis::program::Program;
use crate::certify::limit_certificate::certify_upper;
use crate::certify::velocity_field::VelocityField;
use crate::elements::hencky_kinematic::Flow;
use crate::model::file::Bounds;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::Kinematic;
use crate::recover::elastic::RecoverError;
use crate::solve::{Patterns, Solution, SolveOptions, SolveStatus};
use bracket_base::math::vec3::V3;
use bracket_base::say;
use bracket_base::words::Text;

/// The estimate with the convergence of its fixed point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CoulombEstimate {
    /// The load factor at the fixed point, its dissipation evaluated as in the upper bound. Where
    /// it lies a little beyond a bound under Coulomb's law, that bound. `None`: the fixed point was
    /// not reached.
    pub factor: Option<f64>,
    /// The load factor of the program itself, which integrates the dissipation on a coarser rule
    /// (measured on coarse stacks of blocks: up to a tenth above the upper bound).
    pub raw: Option<f64>,
    /// Convergence, including the problem with associated friction.
    pub run: FixedPointRun,
    /// Iterations of all solves.
    pub iterations: u32,
    /// Why there is no load factor.
    pub trouble: Option<Text>,
}

/// The kinematic program of limit analysis with shifted cones.
struct CoulombLimitKinematic {
    program: Kinematic,
    iteration: ConeShiftIteration,
}

/// The last solution of the fixed point.
struct FixedPointFactor {
    /// The load factor with the quadrature of the upper bound.
    factor: f64,
    /// The load factor of the program itself.
    raw: f64,
    run: FixedPointRun,
    converged: bool,
}

impl CoulombLimitKinematic {
    fn new(model: &AnalysisModel, velocities: Option<&[V3]>) -> Result<Self, ModelError> {
        let mut program = Kinematic::limit(model, Flow::Split)?;
        let iteration = ConeShiftIteration::after(model, &program, velocities);
        program.program.h = iteration.offsets();
        Ok(Self { program, iteration })
    }
}

impl DiscreteProgram for CoulombLimitKinematic {
    type Base = Kinematic;
    type Answer = FixedPointFactor;

    fn base(&self) -> &Kinematic {
        &self.program
    }

    /// As for the static program: the load factor belongs to the stresses, which must balance.
    fn accuracy(&self, asked: &SolveOptions) -> SolveOptions {
        asked.with(asked.stop.for_resistance())
    }

    /// None: a mechanism is a regular result here.
    fn contact_modes(&self, _: &AnalysisModel) -> Vec<Vec<f64>> {
        Vec::new()
    }

    fn next_problem(&self, model: &AnalysisModel, solution: &Solution) -> Option<NextProblem> {
        self.iteration.next_problem(model, &self.program, solution)
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        _: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        let u = self.program.nodal(&solution.x);
        let friction = self.iteration.friction(model, &self.program, solution, &u);
        let power = certify_upper(model, &velocity_of(&self.program, &solution.x), SUBDIVISIONS);
        let (run, converged) = self.iteration.progress();
        Ok(FixedPointFactor {
            factor: power.factor + friction / power.live_power,
            raw: load_factor(&self.program, solution).unwrap_or(f64::NAN),
            run,
            converged,
        })
    }
}

/// Runs the fixed point, from the velocities under associated friction where they are known.
pub(crate) fn estimate(
    model: &AnalysisModel,
    associated: Option<&VelocityField>,
    options: &PassOptions,
    progress: &Progress,
) -> Result<CoulombEstimate, PassError> {
    progress(Program::Kinematic, Event::Coulomb);
    let model = &AnalysisModel { bounds: Bounds::Kinematic, ..model.clone() };
    let build = || CoulombLimitKinematic::new(model, associated.map(|v| &v.nodes.u[..]));
    let kinematic = kinematic_alone(model, options, progress, build)?;
    let Some(finished) = kinematic else { return Ok(CoulombEstimate::default()) };
    let iterations = finished.outcome.iterations;
    let Some(FixedPointFactor { factor, raw, run, converged }) = finished.answer else {
        let words = match finished.outcome.status {
            SolveStatus::TooLarge => "its problems do not fit into the memory".into(),
            status => say!("one of its problems ended with status `{}`", status.words()),
        };
        return Ok(CoulombEstimate {
            trouble: Some(words),
            iterations,
            ..CoulombEstimate::default()
        });
    };
    if !converged {
        let words = say!("it was not reached in {} problems", run.solves);
        return Ok(CoulombEstimate {
            run,
            iterations,
            trouble: Some(words),
            ..CoulombEstimate::default()
        });
    }
    Ok(CoulombEstimate { factor: Some(factor), raw: Some(raw), run, iterations, trouble: None })
}
