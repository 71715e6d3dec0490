//! The shift of the contact cones that Coulomb's law asks for: a fixed point over problems with
//! associated friction.
//!
//! Slip under associated friction dilates by `μ‖g_T‖`. With the cones opened by a shift s,
//! `g_N + g₀ + s ≥ μ‖g_T‖`, it dilates by `μ‖g_T‖ − s`. Where s equals `μ‖g_T‖` of the solution
//! itself, slip does not dilate. The shift follows from the displacements, so only the kinematic
//! program is iterated: the offsets of its rows change, everything else is reused.

use crate::analysis::discrete_program::NextProblem;
use crate::analysis::fixed_point::FixedPoint;
use crate::model::AnalysisModel;
use crate::model::opening::ConeShift;
use crate::programs::Kinematic;
use crate::programs::contact::kinematic_contact::ControlPoint;
use crate::recover::elastic::RecoverError;
use crate::solve::Solution;
use bracket_base::math::Sum;
use bracket_base::math::vec3::{self, V3};
use serde::{Deserialize, Serialize};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The iteration has converged when the shift changes by less than this fraction of the largest
/// shift.
const TOLERANCE: f64 = 1e-3;
/// Largest number of problems solved.
const MOST_SOLVES: usize = 60;
/// Tolerances in limit analysis, where a problem costs many times more and the result is an
/// estimate: change of the shift over the largest shift, and dissipation by which the solution
/// misses Coulomb's law over the load factor. One of the two suffices.
const LIMIT_TOLERANCE: [f64; 2] = [1e-2, 1e-3];
/// Largest number of problems in limit analysis.
const MOST_LIMIT_SOLVES: usize = 10;
/// A contact point with a pressure below this fraction of the largest counts as open: its slip has
/// no meaning.
const PRESSED: f64 = 1e-6;
/// Changes below this fraction of the largest displacement are noise of the solver.
const NOISE: f64 = 1e-7;

/// Convergence of the fixed point.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FixedPointRun {
    /// Problems solved, including the one with associated friction.
    pub solves: usize,
    /// Largest change of the shift in the last solve, over the largest shift; 0 where all slips are
    /// noise.
    pub change: f64,
    /// Ratio of the changes of two successive plain steps, where there were two.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contraction: Option<f64>,
    /// Limit analysis: `∫ r_N |s − μ‖g_T‖|` over the load factor, the dissipation by which the last
    /// shift misses Coulomb's law.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub missing: Option<f64>,
}

/// The fixed point of a program.
#[derive(Clone, Debug)]
pub(crate) struct ConvergedShift {
    /// The shift in the last solve.
    pub shift: ConeShift,
    /// Its values at the contact points of the program.
    pub values: Vec<f64>,
    /// Convergence of the fixed point.
    pub run: FixedPointRun,
}

/// The iteration of the shift of a kinematic program, from solve to solve.
pub(crate) struct ConeShiftIteration {
    /// Offsets of the rows of the program without a shift.
    offsets: Vec<f64>,
    /// First row of the cone of each contact point.
    rows: Vec<usize>,
    state: Mutex<State>,
}

/// State after the solves so far.
struct State {
    fixed_point: FixedPoint,
    /// Includes the solves and the contraction of earlier programs.
    run: FixedPointRun,
    /// Solves of earlier programs.
    earlier: usize,
    converged: bool,
}

impl ConeShiftIteration {
    /// The iteration of a program without a shift. It starts from the shift of another program with
    /// the same contacts, or from zero.
    pub(crate) fn new(kinematic: &Kinematic, start: Option<&ConvergedShift>) -> Self {
        let points = kinematic.points.len();
        let (values, run) = match start {
            Some(start) => (start.values.clone(), start.run.clone()),
            None => (vec![0.0; points], FixedPointRun::default()),
        };
        Self::with(kinematic, FixedPoint::starting_at(values), run)
    }

    /// The iteration of a program of limit analysis. It starts after the problem with associated
    /// friction, whose solution has the given velocities.
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
    fn offsets_at(&self, shift: &[f64]) -> Vec<f64> {
        let mut h = self.offsets.clone();
        self.rows.iter().zip(shift).for_each(|(r, s)| h[*r] += s);
        h
    }

    /// Offsets of the rows at the present shift: that of the last problem, or of the first one
    /// before any is solved.
    pub(crate) fn offsets(&self) -> Vec<f64> {
        self.offsets_at(self.state().fixed_point.point())
    }

    /// The problem to solve after this solution; `None`: the solution is the last one.
    pub(crate) fn next_problem(
        &self,
        model: &AnalysisModel,
        of: &Kinematic,
        solution: &Solution,
    ) -> Option<NextProblem> {
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
        // the first one measured stays
        let contraction = state.run.contraction.or(state.fixed_point.contraction());
        // in a slow iteration the remaining error is larger than the last change
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
        let offsets = self.offsets_at(state.fixed_point.point());
        Some(NextProblem { offsets, solves: state.run.solves, change: state.run.change })
    }

    /// `∫ μ r_N ‖g_T‖` of a solution with the velocities u: the power of friction without dilation.
    pub(crate) fn friction(
        &self,
        model: &AnalysisModel,
        of: &Kinematic,
        solution: &Solution,
        u: &[V3],
    ) -> f64 {
        Sum::of(self.rows.iter().zip(slips(model, of, u)).map(|(r, slip)| solution.z[*r] * slip))
    }

    /// Convergence so far, and whether the fixed point is reached.
    pub(crate) fn progress(&self) -> (FixedPointRun, bool) {
        let state = self.state();
        (state.run.clone(), state.converged)
    }

    /// The fixed point; an error where it was not reached.
    pub(crate) fn converged(
        &self,
        model: &AnalysisModel,
        of: &Kinematic,
    ) -> Result<ConvergedShift, RecoverError> {
        let state = self.state();
        if !state.converged {
            return Err(RecoverError::NotConverged {
                solves: state.run.solves,
                change: state.run.change,
            });
        }
        let values = state.fixed_point.point().to_vec();
        Ok(ConvergedShift { shift: of.cone_shift(model, &values), values, run: state.run.clone() })
    }
}

/// `μ‖g_T‖` of nodal values at the contact points with Coulomb's law, zero at the others.
fn slips(model: &AnalysisModel, of: &Kinematic, u: &[V3]) -> Vec<f64> {
    let slip = |p: &ControlPoint| {
        if model.contact_law(p.contact).is_coulomb() { p.mu * p.slip(u) } else { 0.0 }
    };
    of.points.iter().map(slip).collect()
}

/// The load factor of a program of limit analysis, the multiplier of the unit power; `None` for
/// other kinds of analysis.
pub(crate) fn load_factor(of: &Kinematic, solution: &Solution) -> Option<f64> {
    solution.x.last().copied().filter(|_| !of.program.live.is_empty())
}

impl ConvergedShift {
    /// The model with its cones shifted.
    pub(crate) fn shifted(&self, model: &AnalysisModel) -> AnalysisModel {
        AnalysisModel { shift: self.shift.clone(), ..model.clone() }
    }
}
