//! The two programs of limit analysis.

use crate::analysis::discrete_program::DiscreteProgram;
use crate::certify::fields::{DisplacementField, StressField};
use crate::certify::velocity_field::VelocityField;
use crate::certify::{LowerFactor, UpperFactor};
use crate::elements::hencky_kinematic::Flow;
use crate::model::{AnalysisModel, ModelError};
use crate::programs::{Kinematic, Static};
use crate::recover::elastic::RecoverError;
use crate::recover::limit_lower::{self, ApproximateStress, LowerError};
use crate::recover::limit_upper::{self, UpperError};
use crate::solve::{self, Patterns, Solution, SolveOptions};
use bracket_base::math::vec3::V3;
use bracket_base::say;
use bracket_base::words::Text;

/// Halvings of the tets on which the dissipation of the final velocities is evaluated; a repetition
/// of the certificate must use the same number.
pub const SUBDIVISIONS: u32 = 1;

/// The message of an infeasible program of limit analysis.
pub const NO_LIMIT: &str =
    "no mechanism works against the live loads: the load factor has no limit";

/// The velocity field with the nodal values of a kinematic program without resultant limits.
pub fn velocity(nodes: DisplacementField) -> VelocityField {
    VelocityField { nodes, flow: Flow::Split, limit_motions: Vec::new() }
}

/// The velocity field of a solution of a kinematic program.
pub(super) fn velocity_of(program: &Kinematic, x: &[f64]) -> VelocityField {
    let nodes = DisplacementField { u: program.nodal(x) };
    VelocityField { limit_motions: program.limit_motions(x), ..velocity(nodes) }
}

/// The kinematic program of limit analysis.
pub(super) struct LimitKinematic(Kinematic);

/// The static program of limit analysis.
pub(super) struct LimitStatic<'a>(Static<'a>);

/// The lower bound of a static program with its field.
pub(super) struct LimitStress {
    pub(super) stress: StressField,
    pub(super) bound: LowerFactor,
    /// Share of the load factor carried by each tet's yield multipliers.
    pub(super) yield_multiplier_share: Vec<f64>,
    /// Velocities of the vertices, the multipliers of equilibrium.
    pub(super) velocities: Vec<V3>,
}

impl LimitKinematic {
    pub(super) fn new(model: &AnalysisModel) -> Result<Self, ModelError> {
        Kinematic::limit(model, Flow::Split).map(Self)
    }
}

impl DiscreteProgram for LimitKinematic {
    type Base = Kinematic;
    type Answer = (VelocityField, UpperFactor);

    fn base(&self) -> &Kinematic {
        &self.0
    }

    fn accuracy(&self, asked: &SolveOptions) -> SolveOptions {
        asked.with(asked.stop.for_mechanism())
    }

    /// None: a mechanism is a regular result here.
    fn contact_modes(&self, _: &AnalysisModel) -> Vec<Vec<f64>> {
        Vec::new()
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        let field = velocity_of(&self.0, &solution.x);
        let upper =
            limit_upper::project(model, &field, SUBDIVISIONS, patterns).map_err(|e| match e {
                UpperError::Recover(e) => e,
                e => RecoverError::Factor(e.text()),
            })?;
        Ok((upper.field, UpperFactor::new(upper.certificate)))
    }

    fn conflict(&self, _: &AnalysisModel, _: &[f64]) -> Option<Text> {
        Some(NO_LIMIT.into())
    }
}

impl<'a> LimitStatic<'a> {
    pub(super) fn new(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        Static::limit(model).map(Self)
    }
}

impl<'a> DiscreteProgram for LimitStatic<'a> {
    type Base = Static<'a>;
    type Answer = LimitStress;

    fn base(&self) -> &Static<'a> {
        &self.0
    }

    fn accuracy(&self, asked: &SolveOptions) -> SolveOptions {
        asked.with(asked.stop.for_resistance())
    }

    /// None, as in the kinematic program.
    fn contact_modes(&self, _: &AnalysisModel) -> Vec<Vec<f64>> {
        Vec::new()
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        let statics = &self.0;
        let parameters = statics.parameters(&solution.x)?;
        let contact = statics.spread_contact(&solution.z[..statics.program.g.nrows()]);
        let welds = statics.weld_tractions(&solution.x);
        let factor = solution.x.last().copied().unwrap_or(0.0);
        let approximate =
            ApproximateStress { parameters: &parameters, contact: &contact, welds: &welds, factor };
        let dead = dead_stress(model, patterns).transpose()?;
        let lower = limit_lower::project(model, &approximate, dead.as_ref(), patterns)
            .map_err(recover_error)?;
        let yield_multiplier_share = statics.yield_shares(&solution.z);
        Ok(LimitStress {
            stress: lower.field,
            bound: LowerFactor::new(lower.certificate),
            yield_multiplier_share,
            velocities: statics.vertex_velocities(&solution.x),
        })
    }

    fn conflict(&self, _: &AnalysisModel, _: &[f64]) -> Option<Text> {
        Some(NO_LIMIT.into())
    }
}

fn recover_error(e: LowerError) -> RecoverError {
    match e {
        LowerError::Recover(e) => e,
        e => RecoverError::Factor(e.text()),
    }
}

/// Parts of the strengths that the dead loads alone may use, tried in turn: a field well inside all
/// strengths serves the lower bound better than one that reaches some.
const DEAD_PARTS: [f64; 2] = [0.9, 1.0];

/// A stress field of the dead loads alone, from the elastic, perfectly plastic program under them;
/// `None` where there are none.
pub(super) fn dead_stress(
    model: &AnalysisModel,
    patterns: &Patterns,
) -> Option<Result<StressField, RecoverError>> {
    model.has_dead_loads().then(|| {
        let dead = model.without_live_loads();
        let [inner, full] = DEAD_PARTS.map(|part| dead.with_strengths_times(part));
        dead_stress_within(&inner, model, patterns)
            .or_else(|_| dead_stress_within(&full, model, patterns))
    })
}

/// A stress field of the loads of `dead`, strictly inside the strengths of `model`.
fn dead_stress_within(
    dead: &AnalysisModel,
    model: &AnalysisModel,
    patterns: &Patterns,
) -> Result<StressField, RecoverError> {
    let statics = Static::with_plasticity(dead)?;
    let options = SolveOptions { patterns: patterns.clone(), ..SolveOptions::default() };
    let solution = solve::solve(&statics.program, &statics.map.block, &options);
    if !solution.status.is_solution() {
        let status = solution.status.words();
        return Err(RecoverError::Factor(say!(
            "the dead loads alone have no certified equilibrium ({})",
            status
        )));
    }
    let parameters = statics.parameters(&solution.x)?;
    let contact = statics.spread_contact(&solution.z[..statics.program.g.nrows()]);
    let welds = statics.weld_tractions(&solution.x);
    let approximate = ApproximateStress {
        parameters: &parameters,
        contact: &contact,
        welds: &welds,
        factor: 0.0,
    };
    limit_lower::dead_field(model, &approximate, patterns).map_err(recover_error)
}
