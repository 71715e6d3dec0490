//! Coulomb's law in limit analysis: the load factor of a fixed point, an estimate.
//!
//! The kinematic program with shifted cones, `g_N + s ≥ μ‖g_T‖`, has the dual `max λ − ∫ r_N s`
//! over stresses that obey the friction cone. Where s is `μ‖g_T‖` of the solution itself nothing
//! dilates by its slip, and the load factor of the dual solution is the power of yield and
//! friction, `λ = D(u) + ∫ μ r_N ‖g_T‖` less the power of the dead loads, at unit power of the live
//! ones. The dual solution obeys the cones of the associated law, and the velocities are admissible
//! without friction: on one mesh λ lies between the factor without friction and the one with
//! associated friction. Coulomb's law may have several load factors for one structure, where
//! wedging decides what presses; this is one of them.
//!
//! # Source
//! V. Acary, F. Cadoux, C. Lemaréchal, J. Malick, A formulation of the linear discrete Coulomb
//! friction problem via convex optimization, ZAMM 91 (2011), 155–175.

use crate::analysis::coulomb::{FixedPointRun, Slips, load_factor};
use crate::analysis::engine::{Both, Event, PassError, PassOptions, Progress, both_of};
use crate::analysis::limit::{SUBDIVISIONS, velocity};
use crate::analysis::program_run::{Another, DiscreteProgram, Program};
use crate::certify::fields::DisplacementField;
use crate::certify::flow::VelocityField;
use crate::certify::limit_certificate::certify_upper;
use crate::elements::hencky_kinematic::Flow;
use crate::math::vec3::V3;
use crate::model::file::Bounds;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::dofs::DofMap;
use crate::programs::{ConicProgram, Kinematic, Static};
use crate::recover::elastic::RecoverError;
use crate::solve::{Patterns, Solution, SolveOptions, SolveStatus};

/// What the fixed point has come to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CoulombEstimate {
    /// The load factor at the fixed point, the dissipation evaluated as that of the upper bound is;
    /// where it is a little beyond a bound of the structure under Coulomb's law, that bound.
    /// `None`: it was not reached.
    pub factor: Option<f64>,
    /// The load factor of the program itself, whose quadrature of the dissipation is coarser
    /// (measured on coarse stacks of blocks: up to a tenth more than the upper bound).
    pub raw: Option<f64>,
    /// How it went, the problem with associated friction included.
    pub run: FixedPointRun,
    /// Iterations of its solves.
    pub iterations: u32,
    /// Why there is no load factor, in words.
    pub trouble: Option<String>,
}

/// The kinematic program of limit analysis with the shift of its cones.
struct Sliding {
    program: Kinematic,
    slips: Slips,
}

impl Sliding {
    fn new(model: &AnalysisModel, velocities: Option<&[V3]>) -> Result<Self, ModelError> {
        let mut program = Kinematic::limit(model, Flow::Split)?;
        let slips = Slips::after(model, &program, velocities);
        program.program.h = slips.offsets();
        Ok(Self { program, slips })
    }
}

impl<'a> DiscreteProgram<'a> for Sliding {
    /// The load factor by the finer quadrature and the program's own, the steps that led there, and
    /// whether they have come to a fixed point.
    type Answer = ([f64; 2], FixedPointRun, bool);
    const PROGRAM: Program = Program::Kinematic;

    /// The load factor is of the stresses: they must balance.
    fn accuracy(&self, asked: &SolveOptions) -> SolveOptions {
        asked.for_resistance()
    }

    fn assemble(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        Self::new(model, None)
    }

    fn program(&self) -> &ConicProgram {
        &self.program.program
    }

    fn map(&self) -> &DofMap {
        &self.program.map
    }

    /// None: a mechanism is an answer here, not a fault.
    fn contact_modes(&self, _: &AnalysisModel) -> Vec<Vec<f64>> {
        Vec::new()
    }

    fn another(&self, model: &AnalysisModel, solution: &Solution) -> Option<Another> {
        self.slips.another(model, &self.program, solution)
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        _: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        let u = self.program.nodal(&solution.x);
        let friction = self.slips.friction(model, &self.program, solution, &u);
        let power = certify_upper(model, &velocity(DisplacementField { u }), SUBDIVISIONS);
        let (run, converged) = self.slips.ended();
        let raw = load_factor(&self.program, solution).unwrap_or(f64::NAN);
        Ok(([power.factor + friction / power.live_power, raw], run, converged))
    }

    fn motion(&self, model: &AnalysisModel, x: &[f64]) -> Vec<(u32, V3)> {
        self.program.motion(model, x)
    }

    fn contacts(&self) -> Vec<usize> {
        self.program.contacts()
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
    let build = || Sliding::new(model, associated.map(|v| &v.nodes.u[..]));
    let none: Option<fn() -> Result<Static<'static>, ModelError>> = None;
    let (kinematic, _): Both<<Sliding as DiscreteProgram>::Answer, _> =
        both_of::<Sliding, Static>(model, options, progress, Some(build), none)?;
    let Some(done) = kinematic else { return Ok(CoulombEstimate::default()) };
    let iterations = done.run.iterations;
    let Some(([factor, raw], run, converged)) = done.answer else {
        let words = match done.run.status {
            SolveStatus::TooLarge => "its problems do not fit into the memory".to_owned(),
            status => format!("one of its problems ended with status `{}`", status.words()),
        };
        return Ok(CoulombEstimate {
            trouble: Some(words),
            iterations,
            ..CoulombEstimate::default()
        });
    };
    if !converged {
        let words = format!("it was not reached in {} problems", run.solves);
        return Ok(CoulombEstimate {
            run,
            iterations,
            trouble: Some(words),
            ..CoulombEstimate::default()
        });
    }
    Ok(CoulombEstimate { factor: Some(factor), raw: Some(raw), run, iterations, trouble: None })
}
