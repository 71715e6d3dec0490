//! Coulomb's law in elastic analysis, perfectly plastic or not: a fixed point over problems with
//! associated friction and shifted cones.
//!
//! Slip under associated friction dilates by `μ‖g_T‖`. With the cones opened by a shift s,
//! `g_N + g₀ + s ≥ μ‖g_T‖`, it dilates by `μ‖g_T‖ − s`; where s is `μ‖g_T‖` of the solution itself,
//! not at all. The shift is read off the displacements, so the kinematic program alone is iterated:
//! its offsets change, all else is used again. The static program then solves the last of these
//! problems, with the very shift that program was solved with: both bounds are strict for one
//! problem.

use crate::analysis::engine::{Both, Pass, PassError, PassOptions, Progress, both};
use crate::analysis::fixed_point::FixedPoint;
use crate::analysis::program_run::{Another, DiscreteProgram, Program};
use crate::certify::bracket::UpperBound;
use crate::certify::certificate::certify_displacement;
use crate::certify::fields::DisplacementField;
use crate::math::Sum;
use crate::math::vec3::{self, V3};
use crate::model::file::Bounds;
use crate::model::opening::ConeShift;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::contact::control_points::ControlPoint;
use crate::programs::dofs::DofMap;
use crate::programs::{ConicProgram, Kinematic, Static};
use crate::recover::elastic::{self, RecoverError};
use crate::solve::{Patterns, Solution};
use serde::{Deserialize, Serialize};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// The shift is found when it changes by less than this part of the largest.
pub const TOLERANCE: f64 = 1e-3;
/// Problems solved at most.
const MOST_SOLVES: usize = 60;
/// The same in limit analysis, where a problem costs many times more and its answer is an estimate:
/// the slips change by less than this part of the largest, or what is missing to Coulomb's law
/// dissipates less than this part of the load factor.
const LIMIT_TOLERANCE: [f64; 2] = [1e-2, 1e-3];
/// Problems of limit analysis at most.
const MOST_LIMIT_SOLVES: usize = 10;
/// A contact point whose pressure is below this part of the largest is open: its slip means
/// nothing.
const PRESSED: f64 = 1e-6;
/// Changes below this part of the largest displacement are the solver's noise.
const NOISE: f64 = 1e-7;

/// How the fixed point went.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FixedPointRun {
    /// Problems solved, the one with associated friction included.
    pub solves: usize,
    /// Largest change of the shift at the last of them, part of the largest shift; 0 where all that
    /// slips is noise.
    pub change: f64,
    /// Part of the change that a plain step leaves, where two of them show it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contraction: Option<f64>,
    /// Limit analysis: `∫ r_N |s − μ‖g_T‖|`, what the last shift misses Coulomb's law by, part of
    /// the load factor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub missing: Option<f64>,
}

/// Where the fixed point of a program has come to.
#[derive(Clone, Debug)]
pub(crate) struct Slid {
    /// The shift that the program was solved with last.
    pub shift: ConeShift,
    /// Its values at the contact points of the program.
    pub values: Vec<f64>,
    /// How it went.
    pub run: FixedPointRun,
}

/// The slips of a kinematic program from solve to solve.
pub(crate) struct Slips {
    /// Offsets of the program's rows without a shift.
    offsets: Vec<f64>,
    /// First row of the cone of each contact point.
    rows: Vec<usize>,
    state: Mutex<State>,
}

/// Where the fixed point stands.
struct State {
    fixed_point: FixedPoint,
    /// Problems solved and contraction of earlier programs included.
    run: FixedPointRun,
    /// Solves of earlier programs.
    earlier: usize,
    converged: bool,
}

impl Slips {
    /// Of a program whose cones are not shifted yet; it starts with the shift that another one with
    /// the same contacts ended with.
    pub(crate) fn new(kinematic: &Kinematic, start: Option<&Slid>) -> Self {
        let points = kinematic.points.len();
        let (values, run) = match start {
            Some(slid) => (slid.values.clone(), slid.run.clone()),
            None => (vec![0.0; points], FixedPointRun::default()),
        };
        Self::with(kinematic, FixedPoint::starting_at(values), run)
    }

    /// Of a program of limit analysis; it starts after the problem with associated friction, which
    /// has these velocities.
    pub(crate) fn after(
        model: &AnalysisModel,
        kinematic: &Kinematic,
        velocities: Option<&[V3]>,
    ) -> Self {
        let mut fixed_point = FixedPoint::new(kinematic.points.len());
        if let Some(u) = velocities {
            let all = vec![true; kinematic.points.len()];
            fixed_point.image(&slips(model, kinematic, u), &all);
            fixed_point.step(&all);
        }
        Self::with(kinematic, fixed_point, FixedPointRun::default())
    }

    fn with(kinematic: &Kinematic, fixed_point: FixedPoint, run: FixedPointRun) -> Self {
        let program = &kinematic.program;
        let earlier = run.solves;
        let state = State { fixed_point, run, earlier, converged: false };
        let rows = program.cone_starts().into_iter().take(kinematic.points.len()).collect();
        Self { offsets: program.h.clone(), rows, state: Mutex::new(state) }
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Offsets of the rows at the given shift of each contact point.
    fn at(&self, shift: &[f64]) -> Vec<f64> {
        let mut h = self.offsets.clone();
        self.rows.iter().zip(shift).for_each(|(r, s)| h[*r] += s);
        h
    }

    /// Offsets of the rows at the shift of the problem that was solved last, or is to be solved
    /// first.
    pub(crate) fn offsets(&self) -> Vec<f64> {
        self.at(self.state().fixed_point.point())
    }

    /// What to solve after this solution; `None`: it was the last.
    pub(crate) fn another(
        &self,
        model: &AnalysisModel,
        of: &Kinematic,
        solution: &Solution,
    ) -> Option<Another> {
        let u = of.nodal(&solution.x);
        let image = slips(model, of, &u);
        let force: Vec<f64> = self.rows.iter().map(|r| solution.z[*r]).collect();
        let largest = force.iter().fold(0.0, |m: f64, f| m.max(*f));
        let pressed: Vec<bool> = force.iter().map(|f| *f > PRESSED * largest).collect();
        let shift =
            image.iter().zip(&pressed).filter(|(_, p)| **p).fold(0.0, |m: f64, (s, _)| m.max(*s));
        let moved = u.iter().fold(0.0, |m: f64, u| m.max(vec3::norm(*u)));
        let mut state = self.state();
        let missing = load_factor(of, solution).map(|factor| {
            let points = force.iter().zip(image.iter().zip(state.fixed_point.point()));
            Sum::of(points.map(|(f, (g, s))| f * (g - s).abs()))
                / factor.abs().max(f64::MIN_POSITIVE)
        });
        let change = state.fixed_point.image(&image, &pressed);
        // the first that was measured
        let contraction = state.run.contraction.or(state.fixed_point.contraction());
        // of a slow iteration the last change is only a part of what is left
        let slow = contraction.unwrap_or(0.0).clamp(0.0, 0.99);
        let solves = state.fixed_point.changes().len();
        state.run = FixedPointRun {
            solves: state.earlier + solves,
            change: if change > NOISE * moved { change / shift.max(change) } else { 0.0 },
            contraction,
            missing,
        };
        let (tolerance, most) = match missing {
            Some(_) => (LIMIT_TOLERANCE[0], MOST_LIMIT_SOLVES),
            None => (TOLERANCE, MOST_SOLVES),
        };
        state.converged = change <= tolerance * (1.0 - slow) * shift
            || change <= NOISE * moved
            || missing.is_some_and(|m| m <= LIMIT_TOLERANCE[1]);
        if state.converged || solves >= most {
            return None;
        }
        state.fixed_point.step(&pressed);
        let offsets = self.at(state.fixed_point.point());
        Some(Another { offsets, number: state.run.solves, change: state.run.change })
    }

    /// `∫ μ r_N ‖g_T‖` of a solution with the velocities u, the power of friction without dilation.
    pub(crate) fn friction(
        &self,
        model: &AnalysisModel,
        of: &Kinematic,
        solution: &Solution,
        u: &[V3],
    ) -> f64 {
        Sum::of(self.rows.iter().zip(slips(model, of, u)).map(|(r, slip)| solution.z[*r] * slip))
    }

    /// How it went, and whether it has come to a fixed point.
    pub(crate) fn ended(&self) -> (FixedPointRun, bool) {
        let state = self.state();
        (state.run.clone(), state.converged)
    }

    /// Where it has come to; an error where that is no fixed point.
    pub(crate) fn found(
        &self,
        model: &AnalysisModel,
        of: &Kinematic,
    ) -> Result<Slid, RecoverError> {
        let state = self.state();
        if !state.converged {
            return Err(RecoverError::NotConverged {
                solves: state.run.solves,
                change: state.run.change,
            });
        }
        let values = state.fixed_point.point().to_vec();
        Ok(Slid { shift: of.cone_shift(model, &values), values, run: state.run.clone() })
    }
}

/// `μ‖g_T‖` of nodal values at the contact points with Coulomb's law, zero at the others.
fn slips(model: &AnalysisModel, of: &Kinematic, u: &[V3]) -> Vec<f64> {
    let slip = |p: &ControlPoint| {
        if model.contact_law(p.contact).is_coulomb() { p.mu * p.slip(u) } else { 0.0 }
    };
    of.points.iter().map(slip).collect()
}

/// The load factor of a program of limit analysis, the multiplier of the unit power; `None`:
/// another kind.
pub(crate) fn load_factor(of: &Kinematic, solution: &Solution) -> Option<f64> {
    solution.x.last().copied().filter(|_| !of.program.live.is_empty())
}

impl Slid {
    /// The model whose cones it has shifted.
    pub(crate) fn shifted(&self, model: &AnalysisModel) -> AnalysisModel {
        AnalysisModel { shift: self.shift.clone(), ..model.clone() }
    }
}

/// The kinematic program with the shift of its cones.
struct Sliding {
    program: Kinematic,
    slips: Slips,
}

impl<'a> DiscreteProgram<'a> for Sliding {
    type Answer = (DisplacementField, UpperBound, Slid);
    const PROGRAM: Program = Program::Kinematic;

    fn assemble(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        let program = Kinematic::new(model)?;
        let slips = Slips::new(&program, None);
        Ok(Self { program, slips })
    }

    fn program(&self) -> &ConicProgram {
        &self.program.program
    }

    fn map(&self) -> &DofMap {
        &self.program.map
    }

    fn measured_from(&self, model: &AnalysisModel) -> Vec<f64> {
        self.program.closed(model)
    }

    fn contact_modes(&self, model: &AnalysisModel) -> Vec<Vec<f64>> {
        DiscreteProgram::contact_modes(&self.program, model)
    }

    fn motion(&self, model: &AnalysisModel, x: &[f64]) -> Vec<(u32, V3)> {
        self.program.motion(model, x)
    }

    fn contacts(&self) -> Vec<usize> {
        self.program.contacts()
    }

    fn another(&self, model: &AnalysisModel, solution: &Solution) -> Option<Another> {
        self.slips.another(model, &self.program, solution)
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        let slid = self.slips.found(model, &self.program)?;
        let field = elastic::displacement_at(
            model,
            &self.program,
            &self.slips.offsets(),
            solution,
            patterns,
        )?;
        let bound =
            UpperBound::new(certify_displacement(&slid.shifted(model), &field), model.symmetry);
        Ok((field, bound, slid))
    }
}

/// Runs the fixed point on the kinematic program, then the static program of the problem it ends
/// with.
pub(crate) fn run(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<Pass, PassError> {
    let start = Instant::now();
    let mut pass = Pass::default();
    let alone = AnalysisModel { bounds: Bounds::Kinematic, ..model.clone() };
    let (kinematic, _): Both<
        <Sliding as DiscreteProgram>::Answer,
        <Static as DiscreteProgram>::Answer,
    > = both::<Sliding, Static>(&alone, options, progress)?;
    let Some(kinematic) = kinematic else { return Ok(pass) };
    pass.kinematic = Some(kinematic.run);
    let Some((field, bound, slid)) = kinematic.answer else { return Ok(pass) };
    pass.displacement = Some(field);
    pass.upper = Some(bound);
    pass.fixed_point = Some(slid.run);
    let shifted = AnalysisModel { bounds: Bounds::Static, shift: slid.shift, ..alone };
    if model.bounds != Bounds::Kinematic {
        let mut options = options.clone();
        options.solve.time_limit =
            (options.solve.time_limit - start.elapsed().as_secs_f64()).max(0.0);
        let (_, statics) = both::<Kinematic, Static>(&shifted, &options, progress)?;
        pass.add_static(statics);
    }
    pass.join(&shifted)?;
    pass.shift = shifted.shift;
    Ok(pass)
}
