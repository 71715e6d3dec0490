//! The two programs of elastic, perfectly plastic analysis with yield conditions on part of the
//! tets.

use crate::analysis::cone_shift::{ConeShiftIteration, ConvergedShift};
use crate::analysis::diagnosis;
use crate::analysis::discrete_program::{BaseProgram, DiscreteProgram, NextProblem};
use crate::certify::bracket::{LowerBound, UpperBound};
use crate::certify::fields::{DisplacementField, StressField};
use crate::certify::limit_certificate::hidden_utilisation;
use crate::certify::plastic_certificate::{
    certify_plastic_motion, certify_yielding_stress, dissipation, trial_utilisations, utilisations,
};
use crate::certify::plastic_field::PlasticField;
use crate::elements::hencky_kinematic::Flow;
use crate::elements::hencky_static::YIELD_POINTS;
use crate::elements::yielding_element::YIELD_ROWS;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::{Kinematic, Static};
use crate::recover::elastic::RecoverError;
use crate::recover::moving_parts::mechanism;
use crate::recover::plastic::{approximate_stress, plastic_motion, yielding_stress};
use crate::solve::{Patterns, Solution, SolveOptions};
use bracket_base::words::Text;

/// Residual of a stress in equilibrium up to rounding.
pub(super) const ROUNDING: f64 = 2e-13;

/// The kinematic program.
pub(super) struct HenckyKinematic {
    kinematic: Kinematic,
    rough: bool,
    /// Under Coulomb's law: the iteration of the cone shift.
    iteration: Option<ConeShiftIteration>,
}

/// The field of the kinematic program.
pub(super) struct Motion {
    pub(super) field: PlasticField,
    /// Under Coulomb's law: the cone shift of the problem.
    pub(super) shift: Option<ConvergedShift>,
}

/// The static program.
pub(super) struct HenckyStatic<'a> {
    statics: Static<'a>,
    rough: bool,
}

/// The result of a solve: a field `F` with its bound `B`, and where yield conditions are missing.
pub(super) struct Recovered<F, B> {
    /// `None` for a rough solve.
    pub(super) certified: Option<(F, B)>,
    /// Utilisation of every tet.
    pub(super) used: Vec<f64>,
    /// Dissipation of the tets without flow in the program, over the energy.
    pub(super) beyond: f64,
    /// Utilisation that a stress in equilibrium up to rounding may hide.
    pub(super) hidden: f64,
}

/// The bodies that flow along an unbounded direction, and the motion of the parts. `own`: index of
/// the first unknown of each element's own; `points`: number of yield points of an element that has
/// some.
fn collapse(
    model: &AnalysisModel,
    own: &[usize],
    points: impl Fn(usize) -> usize,
    multipliers: &[f64],
    motion: Text,
) -> Text {
    let mut flow = vec![0.0; model.mesh.bodies.len()];
    // the welds' own unknowns follow those of the tets
    let tets = model.mesh.tets.len();
    let mut dissipated = multipliers.chunks_exact(YIELD_ROWS).map(|z| z[0].max(0.0));
    for (e, _) in own.windows(2).take(tets).enumerate().filter(|(_, o)| o[1] > o[0]) {
        flow[model.mesh.tet_body[e] as usize] += dissipated.by_ref().take(points(e)).sum::<f64>();
    }
    match diagnosis::plastic_flow(model, &flow) {
        Some(flows) => Text::joined("; ", [flows, motion]),
        None => motion,
    }
}

/// Options of a solve; without yield conditions those of the elastic analysis.
fn accuracy(rough: bool, yielding: Option<usize>, asked: &SolveOptions) -> SolveOptions {
    asked.with(match yielding {
        _ if rough => asked.stop.for_rough(),
        Some(0) => asked.stop,
        _ => asked.stop.for_yielding(),
    })
}

/// Number of tets with unknowns of their own; those of weld faces follow behind the tets.
fn with_own(own: &[usize], tets: usize) -> usize {
    own.windows(2).take(tets).filter(|o| o[1] > o[0]).count()
}

impl HenckyKinematic {
    /// `start`: under Coulomb's law the cone shift of the solve before.
    pub(super) fn new(
        model: &AnalysisModel,
        flows: &[bool],
        rough: bool,
        start: Option<&ConvergedShift>,
    ) -> Result<Self, ModelError> {
        let flow: Vec<Option<Flow>> = flows.iter().map(|f| f.then_some(Flow::Split)).collect();
        let mut kinematic = Kinematic::with_plasticity_in(model, &flow)?;
        let iteration =
            model.has_coulomb_friction().then(|| ConeShiftIteration::new(&kinematic, start));
        if let Some(iteration) = &iteration {
            kinematic.program.h = iteration.offsets();
        }
        // without cones a solve is a linear system of equations, and accuracy costs nothing
        let rough = rough && !kinematic.program.cones.is_empty();
        Ok(Self { kinematic, rough, iteration })
    }
}

impl DiscreteProgram for HenckyKinematic {
    type Base = Kinematic;
    type Answer = Recovered<Motion, UpperBound>;

    fn base(&self) -> &Kinematic {
        &self.kinematic
    }

    fn accuracy(&self, asked: &SolveOptions) -> SolveOptions {
        accuracy(self.rough, self.yielding(), asked)
    }

    fn origin(&self, model: &AnalysisModel) -> Vec<f64> {
        self.base().closed_cuts(model)
    }

    fn next_problem(&self, model: &AnalysisModel, solution: &Solution) -> Option<NextProblem> {
        // a rough solution needs no shift
        let iteration = self.iteration.as_ref().filter(|_| !self.rough)?;
        iteration.next_problem(model, &self.kinematic, solution)
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        let k = &self.kinematic;
        if self.rough {
            let u = k.nodal(&solution.x);
            let field = PlasticField::elastic(DisplacementField { u }, model.mesh.tets.len());
            return Ok(Recovered {
                certified: None,
                used: trial_utilisations(model, &field),
                beyond: f64::INFINITY,
                hidden: 0.0,
            });
        }
        let iteration = self.iteration.as_ref();
        let shift = iteration.map(|i| i.converged(model, k)).transpose()?;
        let shifted = shift.as_ref().map(|s| s.shifted(model));
        let model = shifted.as_ref().unwrap_or(model);
        let offsets = iteration.map_or_else(|| k.program.h.clone(), ConeShiftIteration::offsets);
        let field = plastic_motion(model, k, &offsets, solution, patterns)?;
        let bound = UpperBound::new(certify_plastic_motion(model, &field), model.symmetry);
        let without_flow = |e: usize| k.own.get(e..e + 2).is_none_or(|o| o[1] == o[0]);
        let beyond = dissipation(model, &field, without_flow)
            / bound.certificate().energy.abs().max(f64::MIN_POSITIVE);
        let used = trial_utilisations(model, &field);
        let certified = Some((Motion { field, shift }, bound));
        Ok(Recovered { certified, used, beyond, hidden: 0.0 })
    }

    fn mechanism(&self, model: &AnalysisModel, solution: &Solution) -> Text {
        let k = &self.kinematic;
        let points = |e: usize| if k.split[e] { 16 } else { 4 };
        let rest = solution.z.get(k.program.g.nrows()..).unwrap_or_default();
        let motion = mechanism(model, k.motion(model, &solution.x));
        collapse(model, &k.own, points, rest, motion)
    }

    fn yielding(&self) -> Option<usize> {
        Some(with_own(&self.kinematic.own, self.kinematic.split.len()))
    }
}

impl<'a> HenckyStatic<'a> {
    pub(super) fn new(
        model: &'a AnalysisModel,
        yields: &[bool],
        margin: f64,
        rough: bool,
    ) -> Result<Self, ModelError> {
        let statics = Static::with_plasticity_in(model, yields, margin)?;
        let rough = rough && !statics.program.cones.is_empty();
        Ok(Self { statics, rough })
    }
}

impl<'a> DiscreteProgram for HenckyStatic<'a> {
    type Base = Static<'a>;
    type Answer = Recovered<StressField, LowerBound>;

    fn base(&self) -> &Static<'a> {
        &self.statics
    }

    fn accuracy(&self, asked: &SolveOptions) -> SolveOptions {
        accuracy(self.rough, self.yielding(), asked)
    }

    fn origin(&self, model: &AnalysisModel) -> Vec<f64> {
        self.base().closed_cuts(model)
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        if self.rough {
            let field = approximate_stress(&self.statics, solution)?;
            let used = utilisations(model, &field);
            let hidden = hidden_utilisation(model, &field, ROUNDING);
            return Ok(Recovered { certified: None, used, beyond: f64::INFINITY, hidden });
        }
        let field = yielding_stress(model, &self.statics, solution, patterns)?;
        let bound = LowerBound::new(certify_yielding_stress(model, &field), model.symmetry);
        let used = utilisations(model, &field);
        Ok(Recovered { certified: Some((field, bound)), used, beyond: 0.0, hidden: 0.0 })
    }

    fn mechanism(&self, model: &AnalysisModel, solution: &Solution) -> Text {
        let s = &self.statics;
        let rest = solution.z.get(s.program.g.nrows()..).unwrap_or_default();
        let motion = mechanism(model, s.motion(model, &solution.x));
        collapse(model, &s.own, |_| YIELD_POINTS, rest, motion)
    }

    fn yielding(&self) -> Option<usize> {
        Some(with_own(&self.statics.own, self.statics.elements.model().mesh.tets.len()))
    }
}
