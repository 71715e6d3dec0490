//! One pass of limit analysis: both programs on one mesh, their strict bounds of the load factor.

use crate::analysis::coulomb_limit::{self, CoulombEstimate};
use crate::analysis::diagnosis;
use crate::analysis::engine::{
    Both, Event, PassError, PassOptions, ProgramRun, Progress, both, check_identity, runs,
};
use crate::analysis::program_run::{DiscreteProgram, Program};
use crate::certify::error::{Contributions, LimitPair, limit_contributions};
use crate::certify::fields::{DisplacementField, StressField};
use crate::certify::flow::VelocityField;
use crate::certify::limit_certificate::certify_lower;
use crate::certify::{FactorBracket, LowerFactor, UpperFactor};
use crate::elements::hencky_kinematic::Flow;
use crate::math::vec3::V3;
use crate::model::file::Bounds;
use crate::model::{AnalysisModel, ModelError, resolve};
use crate::programs::dofs::DofMap;
use crate::programs::{ConicProgram, Kinematic, Static};
use crate::recover::elastic::RecoverError;
use crate::recover::free_mechanism::{self, FreeMechanism};
use crate::recover::limit_lower::{self, ApproximateStress, LowerError};
use crate::recover::limit_upper::{self, UpperError};
use crate::recover::unlimited::{self, Unlimited};
use crate::solve::{self, Patterns, Solution, SolveOptions, SolveStatus};
use std::time::Instant;

/// Halvings of the tets on which the dissipation of the final velocities is evaluated, also by who
/// repeats the certificate.
pub const SUBDIVISIONS: u32 = 1;

/// How far beyond a bound an estimate may be, part of it: what the fixed point leaves open, and the
/// quadrature of the dissipation (measured on coarse stacks of blocks: up to 0.3 %).
const OPEN: f64 = 1e-2;

/// The kinematic program of limit analysis.
struct Collapse(Kinematic);

/// The static program of limit analysis.
struct Resistance<'a>(Static<'a>);

/// What a pass of limit analysis leaves.
#[derive(Clone, Debug, Default)]
pub struct LimitPass {
    /// The kinematic program.
    pub kinematic: Option<ProgramRun>,
    /// The static program.
    pub statics: Option<ProgramRun>,
    /// Velocities of the mechanism.
    pub velocity: Option<VelocityField>,
    /// Stresses at the lower bound.
    pub stress: Option<StressField>,
    /// The upper bound of the load factor.
    pub upper: Option<UpperFactor>,
    /// The lower bound.
    pub lower: Option<LowerFactor>,
    /// Both.
    pub bracket: Option<FactorBracket>,
    /// The lower bound without any friction, where there is friction: it bounds the load factor of
    /// a structure under Coulomb's law, which the bound with associated friction does not.
    pub frictionless: Option<LowerFactor>,
    /// The program it comes from.
    pub frictionless_run: Option<ProgramRun>,
    /// The stresses it comes from.
    pub frictionless_stress: Option<StressField>,
    /// For a structure that friction alone holds against its loads: which parts, in words. Its load
    /// factor without friction is 0.
    pub slides: Option<String>,
    /// The lower bound without friction and the upper one with associated friction: the bracket of
    /// the structure under Coulomb's law.
    pub coulomb: Option<FactorBracket>,
    /// What a fixed point finds for Coulomb's law, where the model asks for it.
    pub coulomb_estimate: Option<CoulombEstimate>,
    /// A stress field that proves that the load factor has no limit. No program was solved then.
    pub unlimited: Option<Unlimited>,
    /// A mechanism at zero load. No program was solved then; `lower` is zero, from no stress at all
    /// or that of the dead loads.
    pub free: Option<FreeMechanism>,
    /// Which parts it moves, in words.
    pub moves: Option<String>,
    /// Contributions to the gap of the bracket that answers: under Coulomb's law that with the
    /// bound without friction.
    pub contributions: Option<Contributions>,
    /// What each tet's yield conditions hold the lower bound that answers down by: shares of the
    /// load factor, the dissipation of the static program's own multipliers. Where they are is no
    /// mechanism of the kinematic program.
    pub yield_multiplier_share: Option<Vec<f64>>,
}

/// What the static program leaves: an admissible field, its load factor, and what holds it down.
struct Carried {
    stress: StressField,
    bound: LowerFactor,
    yield_multiplier_share: Vec<f64>,
}

impl LimitPass {
    /// The programs that ran or were to run.
    pub fn runs(&self) -> impl Iterator<Item = (Program, &ProgramRun)> {
        runs(&self.kinematic, &self.statics)
    }

    /// The stress of the lower bound that answers, and that bound: under Coulomb's law the one
    /// without friction.
    pub fn carried(&self, coulomb: bool) -> Option<(&StressField, &LowerFactor)> {
        let (stress, bound) = match coulomb {
            true => (&self.frictionless_stress, &self.frictionless),
            false => (&self.stress, &self.lower),
        };
        stress.as_ref().zip(bound.as_ref())
    }

    /// Contributions to the gap of the bracket that answers; their sum is asserted where both
    /// fields are admissible.
    fn add_contributions(&mut self, model: &AnalysisModel) -> Result<(), PassError> {
        let smooth = model.has_coulomb().then(|| model.without_friction());
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

    /// The estimate within the certified bounds of the structure under Coulomb's law; one that is
    /// far beyond them is none.
    fn inside_bounds(&self, found: CoulombEstimate) -> CoulombEstimate {
        let Some(factor) = found.factor else { return found };
        // only a bound with its certificate corrects an estimate
        let low = self
            .frictionless
            .as_ref()
            .filter(|l| l.is_strict())
            .map_or(f64::NEG_INFINITY, LowerFactor::value);
        let up =
            self.upper.as_ref().filter(|u| u.is_strict()).map_or(f64::INFINITY, UpperFactor::value);
        let drawn = factor.max(low).min(up);
        if (factor - drawn).abs() > OPEN * drawn.abs() {
            let trouble = format!("it ended at {factor:.4}, beyond the bound {drawn:.4}");
            return CoulombEstimate { factor: None, trouble: Some(trouble), ..found };
        }
        CoulombEstimate { factor: Some(drawn), ..found }
    }

    /// The lower bound of the model without friction; what holds it down.
    fn add_frictionless(
        &mut self,
        smooth: &AnalysisModel,
        options: &PassOptions,
        progress: &Progress,
    ) -> Result<Option<Vec<f64>>, PassError> {
        if let Ok(Some(free)) = free_mechanism::find(smooth) {
            self.slides = Some(moves(smooth, &free.field));
            return Ok(None);
        }
        progress(Program::Static, Event::Frictionless);
        let (_, statics): Both<<Collapse as DiscreteProgram>::Answer, _> =
            both::<Collapse, Resistance>(smooth, options, progress)?;
        let mut yield_multiplier_share = None;
        if let Some(s) = statics {
            self.frictionless_run = Some(s.run);
            if let Some(carried) = s.answer {
                self.frictionless_stress = Some(carried.stress);
                self.frictionless = Some(carried.bound);
                yield_multiplier_share = Some(carried.yield_multiplier_share);
            }
        }
        if let (Some(l), Some(u)) = (&self.frictionless, &self.upper) {
            self.coulomb = Some(FactorBracket::new(l.clone(), u.clone())?);
        }
        Ok(yield_multiplier_share)
    }
}

/// The velocities that a kinematic program's nodal values stand for.
pub fn velocity(nodes: DisplacementField) -> VelocityField {
    VelocityField { nodes, flow: Flow::Split }
}

/// Which parts velocities move, in words.
fn moves(model: &AnalysisModel, field: &VelocityField) -> String {
    diagnosis::mechanism(model, model.node_parts().into_iter().zip(field.nodes.u.iter().copied()))
}

/// What can be told of a load factor without limit or of zero without any program; `None` where
/// neither can be proved.
fn extreme(model: &AnalysisModel, patterns: &Patterns) -> Result<Option<LimitPass>, PassError> {
    model.check_limit_analysis()?;
    let dead = || dead_stress(model, patterns).transpose();
    // what cannot be proved is left to the programs
    let proved = |e: RecoverError| match e {
        RecoverError::Model(e) => Err(PassError::from(e)),
        _ => Ok(None),
    };
    if let Some(unlimited) =
        unlimited::find(model, dead).or_else(|e| proved(e).map(|_: Option<()>| None))?
    {
        return Ok(Some(LimitPass { unlimited: Some(unlimited), ..LimitPass::default() }));
    }
    let Some(free) =
        free_mechanism::find(model).or_else(|e| proved(e).map(|_: Option<()>| None))?
    else {
        return Ok(None);
    };
    let mut pass = LimitPass {
        moves: Some(moves(model, &free.field)),
        free: Some(free),
        ..LimitPass::default()
    };
    let rest = || StressField::none(model.mesh.tets.len());
    let stress = if model.has_dead_loads() { dead().unwrap_or(None) } else { Some(rest()) };
    if let Some(stress) = stress {
        let lower = LowerFactor::new(certify_lower(model, &stress, 0.0));
        if lower.is_strict() {
            // without any stress friction makes no difference
            if model.has_friction() && !model.has_dead_loads() {
                (pass.frictionless, pass.frictionless_stress) =
                    (Some(lower.clone()), Some(stress.clone()));
            }
            (pass.lower, pass.stress) = (Some(lower), Some(stress));
        }
    }
    Ok(Some(pass))
}

/// Runs both programs of limit analysis, and the static one without friction where there is
/// friction; none where a load factor without limit or of zero can be proved without them.
pub fn run(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<LimitPass, PassError> {
    let start = Instant::now();
    if let Some(pass) = extreme(model, &options.solve.patterns)? {
        return Ok(pass);
    }
    let (kinematic, statics): Both<_, _> = both::<Collapse, Resistance>(model, options, progress)?;
    let mut pass = LimitPass::default();
    if let Some(k) = kinematic {
        pass.kinematic = Some(k.run);
        if let Some((field, bound)) = k.answer {
            pass.velocity = Some(field);
            pass.upper = Some(bound);
        }
    }
    let wants_frictionless =
        model.has_friction() && statics.as_ref().is_some_and(|s| s.run.refusal.is_none());
    if let Some(s) = statics {
        pass.statics = Some(s.run);
        if let Some(carried) = s.answer {
            pass.stress = Some(carried.stress);
            pass.lower = Some(carried.bound);
            pass.yield_multiplier_share = Some(carried.yield_multiplier_share);
        }
    }
    if let (Some(l), Some(u)) = (&pass.lower, &pass.upper) {
        pass.bracket = Some(FactorBracket::new(l.clone(), u.clone())?);
    }
    let rest = || {
        let mut options = options.clone();
        options.solve.time_limit =
            (options.solve.time_limit - start.elapsed().as_secs_f64()).max(0.0);
        options
    };
    if wants_frictionless && !options.solve.interrupted() {
        match resolve::without_friction(model) {
            Ok(smooth) => {
                let smooth = AnalysisModel { bounds: Bounds::Static, ..smooth };
                let yield_multiplier_share = pass.add_frictionless(&smooth, &rest(), progress)?;
                if model.has_coulomb() && yield_multiplier_share.is_some() {
                    pass.yield_multiplier_share = yield_multiplier_share;
                }
            }
            Err(e) => pass.slides = Some(e.into_first().message),
        }
    }
    // there is nothing to estimate where the problem with associated friction has no answer
    let failed = pass.kinematic.is_some() && pass.velocity.is_none();
    if model.coulomb_estimate
        && model.has_coulomb_friction()
        && !failed
        && !options.solve.interrupted()
    {
        let found = coulomb_limit::estimate(model, pass.velocity.as_ref(), &rest(), progress)?;
        pass.coulomb_estimate = Some(pass.inside_bounds(found));
    }
    pass.add_contributions(model)?;
    Ok(pass)
}

impl<'a> DiscreteProgram<'a> for Collapse {
    type Answer = (VelocityField, UpperFactor);
    const PROGRAM: Program = Program::Kinematic;

    fn accuracy(&self, asked: &SolveOptions) -> SolveOptions {
        asked.for_mechanism()
    }

    fn assemble(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        Kinematic::limit(model, Flow::Split).map(Self)
    }

    fn program(&self) -> &ConicProgram {
        &self.0.program
    }

    fn map(&self) -> &DofMap {
        &self.0.map
    }

    /// None: a mechanism is an answer here, not a fault.
    fn contact_modes(&self, _: &AnalysisModel) -> Vec<Vec<f64>> {
        Vec::new()
    }

    fn recover(
        &self,
        model: &AnalysisModel,
        solution: &Solution,
        patterns: &Patterns,
    ) -> Result<Self::Answer, RecoverError> {
        let field = velocity(DisplacementField { u: self.0.nodal(&solution.x) });
        let upper =
            limit_upper::project(model, &field, SUBDIVISIONS, patterns).map_err(|e| match e {
                UpperError::Recover(e) => e,
                e => RecoverError::Factor(e.to_string()),
            })?;
        Ok((upper.field, UpperFactor::new(upper.certificate)))
    }

    fn motion(&self, model: &AnalysisModel, x: &[f64]) -> Vec<(u32, V3)> {
        self.0.motion(model, x)
    }

    fn contacts(&self) -> Vec<usize> {
        self.0.contacts()
    }

    fn conflict(&self, _: &AnalysisModel, _: &[f64]) -> Option<String> {
        Some(NO_LIMIT.into())
    }
}

impl<'a> DiscreteProgram<'a> for Resistance<'a> {
    type Answer = Carried;
    const PROGRAM: Program = Program::Static;

    fn accuracy(&self, asked: &SolveOptions) -> SolveOptions {
        asked.for_resistance()
    }

    fn assemble(model: &'a AnalysisModel) -> Result<Self, ModelError> {
        Static::limit(model).map(Self)
    }

    fn program(&self) -> &ConicProgram {
        &self.0.program
    }

    fn map(&self) -> &DofMap {
        &self.0.map
    }

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
        let lower =
            limit_lower::project(model, &approximate, dead.as_ref(), patterns).map_err(in_words)?;
        let yield_multiplier_share = statics.yield_shares(&solution.z);
        Ok(Carried {
            stress: lower.field,
            bound: LowerFactor::new(lower.certificate),
            yield_multiplier_share,
        })
    }

    fn motion(&self, model: &AnalysisModel, x: &[f64]) -> Vec<(u32, V3)> {
        self.0.motion(model, x)
    }

    fn contacts(&self) -> Vec<usize> {
        self.0.contacts()
    }

    fn conflict(&self, _: &AnalysisModel, _: &[f64]) -> Option<String> {
        Some(NO_LIMIT.into())
    }
}

/// What an infeasible program of limit analysis says.
pub const NO_LIMIT: &str =
    "no mechanism works against the live loads: the load factor has no limit";

fn in_words(e: LowerError) -> RecoverError {
    match e {
        LowerError::Recover(e) => e,
        e => RecoverError::Factor(e.to_string()),
    }
}

/// A stress field of the dead loads alone, from the elastic, perfectly plastic program under them;
/// `None` without any.
fn dead_stress(
    model: &AnalysisModel,
    patterns: &Patterns,
) -> Option<Result<StressField, RecoverError>> {
    model.has_dead_loads().then(|| {
        let dead = model.without_live_loads();
        let statics = Static::with_plasticity(&dead)?;
        let options = SolveOptions { patterns: patterns.clone(), ..SolveOptions::default() };
        let solution = solve::solve(&statics.program, &statics.map.block, &options);
        if solution.status != SolveStatus::Optimal {
            let status = solution.status.words();
            return Err(RecoverError::Factor(format!(
                "the dead loads alone have no certified equilibrium ({status})"
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
        limit_lower::dead_field(model, &approximate, patterns).map_err(in_words)
    })
}
