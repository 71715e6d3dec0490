//! The pass of a limit analysis: fields and bounds of the load factor on one mesh.

use crate::analysis::engine::Finished;
use crate::analysis::limit::coulomb::CoulombEstimate;
use crate::analysis::limit::programs::SUBDIVISIONS;
use crate::analysis::pass::{PassError, check_identity};
use crate::analysis::program::Program;
use crate::analysis::program_outcome::{ProgramOutcome, outcomes};
use crate::certify::contributions::{Contributions, LimitPair, limit_contributions};
use crate::certify::fields::StressField;
use crate::certify::free_mechanism::FreeMechanism;
use crate::certify::unlimited::Unlimited;
use crate::certify::velocity_field::VelocityField;
use crate::certify::{FactorBracket, LowerFactor, UpperFactor};
use crate::model::AnalysisModel;
use bracket_base::math::vec3::V3;
use bracket_base::say;
use bracket_base::words::Text;

/// How far an estimate may lie beyond a bound, over the bound: the open error of the fixed point
/// and of the quadrature of the dissipation (measured on coarse stacks of blocks: up to 0.3 %).
const OPEN: f64 = 1e-2;

/// Fields and bounds of the load factor.
#[derive(Clone, Debug, Default)]
pub struct LimitPass {
    /// Outcome of the kinematic program.
    pub kinematic: Option<ProgramOutcome>,
    /// Outcome of the static program.
    pub statics: Option<ProgramOutcome>,
    /// Velocities of the mechanism.
    pub velocity: Option<VelocityField>,
    /// Stresses at the lower bound.
    pub stress: Option<StressField>,
    /// The upper bound of the load factor.
    pub upper: Option<UpperFactor>,
    /// The lower bound.
    pub lower: Option<LowerFactor>,
    /// Both bounds.
    pub bracket: Option<FactorBracket>,
    /// The lower bound without friction, where there is friction. It bounds the load factor under
    /// Coulomb's law, which the bound with associated friction does not.
    pub frictionless: Option<LowerFactor>,
    /// Outcome of the static program without friction.
    pub frictionless_run: Option<ProgramOutcome>,
    /// Stresses at the lower bound without friction.
    pub frictionless_stress: Option<StressField>,
    /// For a structure that only friction holds against its loads: the parts that slide. Its load
    /// factor without friction is 0.
    pub slides: Option<Text>,
    /// The lower bound without friction and the upper one with associated friction: the bracket
    /// under Coulomb's law.
    pub coulomb: Option<FactorBracket>,
    /// The estimate of the load factor under Coulomb's law, where the model requests it.
    pub coulomb_estimate: Option<CoulombEstimate>,
    /// A stress field that proves that the load factor has no limit. No program was solved then.
    pub unlimited: Option<Unlimited>,
    /// A mechanism at zero load. No program was solved then; `lower` is zero, with no stress at all
    /// or with that of the dead loads.
    pub free: Option<FreeMechanism>,
    /// The parts that the mechanism at zero load moves.
    pub moves: Option<Text>,
    /// Contributions to the gap of the reported bracket; under Coulomb's law that with the bound
    /// without friction.
    pub contributions: Option<Contributions>,
    /// Share of the load factor carried by each tet's yield multipliers, at the reported lower
    /// bound: the dissipation of the static program's own multipliers. Its place is not the
    /// mechanism of the kinematic program.
    pub yield_multiplier_share: Option<Vec<f64>>,
    /// The velocities of the vertices in that mechanism; their sign and scale have no meaning.
    pub static_velocities: Option<Vec<V3>>,
}

impl LimitPass {
    /// The programs that ran or were to run.
    pub fn runs(&self) -> impl Iterator<Item = (Program, &ProgramOutcome)> {
        outcomes(&self.kinematic, &self.statics)
    }

    /// Stress and bound of the reported lower bound: under Coulomb's law the one without friction.
    pub fn carried(&self, coulomb: bool) -> Option<(&StressField, &LowerFactor)> {
        let (stress, bound) = match coulomb {
            true => (&self.frictionless_stress, &self.frictionless),
            false => (&self.stress, &self.lower),
        };
        stress.as_ref().zip(bound.as_ref())
    }

    /// Adds a kinematic program after its solve.
    pub(super) fn add_kinematic(&mut self, k: Finished<(VelocityField, UpperFactor)>) {
        self.kinematic = Some(k.outcome);
        if let Some((field, bound)) = k.answer {
            self.velocity = Some(field);
            self.upper = Some(bound);
        }
    }

    /// Joins the bounds that are there to brackets.
    pub(super) fn join(&mut self) -> Result<(), PassError> {
        let bracket = |lower: &Option<LowerFactor>| match (lower, &self.upper) {
            (Some(l), Some(u)) => FactorBracket::new(l.clone(), u.clone()).map(Some),
            _ => Ok(None),
        };
        (self.bracket, self.coulomb) = (bracket(&self.lower)?, bracket(&self.frictionless)?);
        Ok(())
    }

    /// Adds the contributions to the gap of the reported bracket; where both fields are admissible,
    /// checks that they sum to the gap.
    pub(super) fn add_contributions(&mut self, model: &AnalysisModel) -> Result<(), PassError> {
        let smooth = model.has_coulomb_friction().then(|| model.without_friction());
        let (Some(velocity), Some(upper)) = (&self.velocity, &self.upper) else { return Ok(()) };
        let Some((stress, lower)) = self.carried(smooth.is_some()) else { return Ok(()) };
        let (low, up) = (lower.certificate().factor, upper.certificate());
        let pair = LimitPair {
            velocity,
            live_power: up.live_power,
            subdivisions: SUBDIVISIONS,
            stress,
            factor: low,
        };
        let c = limit_contributions(smooth.as_ref().unwrap_or(model), &pair);
        if lower.is_strict() && upper.is_strict() {
            check_identity([low, up.factor], 0.0, c.total())?;
        }
        self.contributions = Some(c);
        Ok(())
    }

    /// The estimate moved into the certified bounds under Coulomb's law; without a load factor
    /// where it lies far beyond them.
    pub(super) fn within_bounds(&self, found: CoulombEstimate) -> CoulombEstimate {
        let Some(factor) = found.factor else { return found };
        // only a certified bound corrects an estimate
        let low = self
            .frictionless
            .as_ref()
            .filter(|l| l.is_strict())
            .map_or(f64::NEG_INFINITY, LowerFactor::value);
        let up =
            self.upper.as_ref().filter(|u| u.is_strict()).map_or(f64::INFINITY, UpperFactor::value);
        let moved = factor.max(low).min(up);
        if (factor - moved).abs() > OPEN * moved.abs() {
            let [factor, moved] = [factor, moved].map(|f| format!("{f:.4}"));
            let trouble = say!("it ended at {}, beyond the bound {}", factor, moved);
            return CoulombEstimate { factor: None, trouble: Some(trouble), ..found };
        }
        CoulombEstimate { factor: Some(moved), ..found }
    }
}
