//! Coulomb's law in elastic analysis: a fixed point over problems with associated friction and shifted cones.
//!
//! Slip under associated friction dilates by `μ‖g_T‖`. With the cones opened by a shift s, `g_N + g₀ + s ≥ μ‖g_T‖`, it
//! dilates by `μ‖g_T‖ − s`; where s is `μ‖g_T‖` of the solution itself, not at all. The shift is read off the displacements, so
//! the kinematic program alone is iterated: its offsets change, all else is used again. The static program then solves the
//! last of these problems, with the very shift that program was solved with: both bounds are strict for one problem.

use super::fixed_point::FixedPoint;
use super::pass::{Both, Pass, PassError, PassOptions, Progress, both};
use super::problem::{Another, Problem, Program};
use crate::bounds::bracket::UpperBound;
use crate::bounds::certificate::certify_displacement;
use crate::bounds::fields::DisplacementField;
use crate::bounds::recover::{self, RecoverError};
use crate::math::vec3::{self, V3};
use crate::model::dofs::DofMap;
use crate::model::file::Bounds;
use crate::model::holds::ModelError;
use crate::model::opening::ConeShift;
use crate::model::{AnalysisModel, ConicProgram, Kinematic, Static};
use crate::solve::Solution;
use serde::{Deserialize, Serialize};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// The shift is found when it changes by less than this part of the largest.
pub const TOLERANCE: f64 = 1e-3;
/// Problems solved at most.
const MOST_SOLVES: usize = 60;
/// A contact point whose pressure is below this part of the largest is open: its slip means nothing.
const PRESSED: f64 = 1e-6;
/// Changes below this part of the largest displacement are the solver's noise.
const NOISE: f64 = 1e-7;

/// How the fixed point went.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FixedPointRun {
    /// Problems solved, the one with associated friction included.
    pub solves: usize,
    /// Largest change of the shift at the last of them, part of the largest shift; 0 where all that slips is noise.
    pub change: f64,
    /// Part of the change that a plain step leaves, where two of them show it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contraction: Option<f64>,
}

/// A displacement under Coulomb's law.
struct Slid {
    field: DisplacementField,
    bound: UpperBound,
    shift: ConeShift,
    run: FixedPointRun,
}

/// The kinematic program with the shift of its cones.
struct Sliding {
    program: Kinematic,
    state: Mutex<State>,
}

/// Where the fixed point stands.
struct State {
    fixed_point: FixedPoint,
    run: FixedPointRun,
    /// First measured contraction.
    contraction: Option<f64>,
    converged: bool,
}

impl Sliding {
    /// Offsets of the rows at the given shift of each contact point.
    fn offsets(&self, shift: &[f64]) -> Vec<f64> {
        let program = &self.program.program;
        let mut h = program.h.clone();
        program.cone_starts().into_iter().zip(shift).for_each(|(r, s)| h[r] += s);
        h
    }
}

impl<'a> Problem<'a> for Sliding {
    type Answer = Slid;
    const PROGRAM: Program = Program::Kinematic;

    fn assemble(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        let program = Kinematic::new(model)?;
        let fixed_point = FixedPoint::new(program.points.len());
        let state = State { fixed_point, run: FixedPointRun::default(), contraction: None, converged: false };
        Ok(Self { program, state: Mutex::new(state) })
    }

    fn program(&self) -> &ConicProgram {
        &self.program.program
    }

    fn map(&self) -> &DofMap {
        &self.program.map
    }

    fn contact_modes(&self, model: &AnalysisModel) -> Vec<Vec<f64>> {
        Problem::contact_modes(&self.program, model)
    }

    fn motion(&self, model: &AnalysisModel, x: &[f64]) -> Vec<(u32, V3)> {
        self.program.motion(model, x)
    }

    fn contacts(&self) -> Vec<usize> {
        self.program.contacts()
    }

    fn another(&self, model: &AnalysisModel, solution: &Solution) -> Option<Another> {
        let (program, points) = (&self.program.program, &self.program.points);
        let u: Vec<V3> = self.program.map.expand(&solution.x).chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
        let image: Vec<f64> = points
            .iter()
            .map(|p| if model.contact_law(p.contact).is_coulomb() { p.mu * p.slip(&u) } else { 0.0 })
            .collect();
        let force: Vec<f64> = program.cone_starts().into_iter().map(|r| solution.z[r]).collect();
        let largest = force.iter().fold(0.0, |m: f64, f| m.max(*f));
        let pressed: Vec<bool> = force.iter().map(|f| *f > PRESSED * largest).collect();
        let shift = image.iter().zip(&pressed).filter(|(_, p)| **p).fold(0.0, |m: f64, (s, _)| m.max(*s));
        let moved = u.iter().fold(0.0, |m: f64, u| m.max(vec3::norm(*u)));
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let change = state.fixed_point.image(&image, &pressed);
        let contraction = state.fixed_point.contraction();
        state.contraction = state.contraction.or(contraction);
        // of a slow iteration the last change is only a part of what is left
        let slow = state.contraction.unwrap_or(0.0).clamp(0.0, 0.99);
        state.run = FixedPointRun {
            solves: state.fixed_point.changes().len(),
            change: if change > NOISE * moved { change / shift.max(change) } else { 0.0 },
            contraction: state.contraction,
        };
        state.converged = change <= TOLERANCE * (1.0 - slow) * shift || change <= NOISE * moved;
        if state.converged || state.run.solves >= MOST_SOLVES {
            return None;
        }
        state.fixed_point.step(&pressed);
        Some(Another {
            offsets: self.offsets(state.fixed_point.point()),
            number: state.run.solves,
            change: state.run.change,
        })
    }

    fn recover(&self, model: &AnalysisModel, solution: &Solution) -> Result<Slid, RecoverError> {
        let state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        if !state.converged {
            return Err(RecoverError::NotConverged { solves: state.run.solves, change: state.run.change });
        }
        let values = state.fixed_point.point();
        let field = recover::displacement_at(model, &self.program, &self.offsets(values), solution)?;
        let shift = self.program.cone_shift(model, values);
        let shifted = AnalysisModel { shift: shift.clone(), ..model.clone() };
        let bound = UpperBound::new(certify_displacement(&shifted, &field), model.symmetry);
        Ok(Slid { field, bound, shift, run: state.run.clone() })
    }
}

/// Runs the fixed point on the kinematic program, then the static program of the problem it ends with.
pub(super) fn run(model: &AnalysisModel, options: &PassOptions, progress: &Progress) -> Result<Pass, PassError> {
    let start = Instant::now();
    let mut pass = Pass::default();
    let alone = AnalysisModel { bounds: Bounds::Kinematic, ..model.clone() };
    let (kinematic, _): Both<Slid, <Static as Problem>::Answer> = both::<Sliding, Static>(&alone, options, progress)?;
    let Some(kinematic) = kinematic else { return Ok(pass) };
    pass.kinematic = Some(kinematic.run);
    let Some(slid) = kinematic.answer else { return Ok(pass) };
    pass.displacement = Some(slid.field);
    pass.upper = Some(slid.bound);
    pass.fixed_point = Some(slid.run);
    let shifted = AnalysisModel { bounds: Bounds::Static, shift: slid.shift, ..alone };
    if model.bounds != Bounds::Kinematic {
        let mut options = options.clone();
        options.solve.time_limit = (options.solve.time_limit - start.elapsed().as_secs_f64()).max(0.0);
        let (_, statics) = both::<Kinematic, Static>(&shifted, &options, progress)?;
        pass.add_static(statics);
    }
    pass.join(&shifted)?;
    pass.shift = shifted.shift;
    Ok(pass)
}
