//! The one place that selects what runs for each kind of analysis.

use crate::analysis::energy_pass::EnergyPass;
use crate::analysis::event::Progress;
use crate::analysis::limit::LimitPass;
use crate::analysis::pass::{PassError, PassOptions};
use crate::analysis::program::Program;
use crate::analysis::program_outcome::ProgramOutcome;
use crate::analysis::{elastic, hencky, limit};
use crate::certify::contributions::Contributions;
use crate::certify::fields::StressField;
use crate::certify::velocity_field::VelocityField;
use crate::model::AnalysisKind;
use crate::model::AnalysisModel;
use crate::solve::SolveOptions;
use bracket_base::math::vec3::V3;

/// The pass of one kind of analysis.
pub enum AnalysisPass {
    /// Bounds of the energy.
    Energy(Box<EnergyPass>),
    /// Bounds of the load factor.
    Factor(Box<LimitPass>),
}

impl AnalysisPass {
    /// Runs the programs of the model's kind of analysis.
    pub fn run(
        model: &AnalysisModel,
        options: &PassOptions,
        progress: &Progress,
    ) -> Result<Self, PassError> {
        Ok(match model.analysis {
            AnalysisKind::Limit => {
                AnalysisPass::Factor(Box::new(limit::run(model, options, progress)?))
            }
            AnalysisKind::Elastoplastic => {
                AnalysisPass::Energy(Box::new(hencky::run(model, options, progress)?))
            }
            AnalysisKind::Elastic => {
                AnalysisPass::Energy(Box::new(elastic::run(model, options, progress)?))
            }
        })
    }

    /// True if a limit analysis has the lower bound alone of two that the model requests.
    pub fn wants_upper(&self, model: &AnalysisModel) -> bool {
        match self {
            AnalysisPass::Energy(_) => false,
            AnalysisPass::Factor(p) => limit::wants_upper(p, model),
        }
    }

    /// Adds the upper bound that [`AnalysisPass::wants_upper`] misses.
    pub fn add_upper(
        &mut self,
        model: &AnalysisModel,
        options: &PassOptions,
        progress: &Progress,
    ) -> Result<(), PassError> {
        match self {
            AnalysisPass::Factor(p) if limit::wants_upper(p, model) => {
                limit::add_upper(p, model, options, progress)
            }
            _ => Ok(()),
        }
    }

    /// Relative gap at which a solve ends; `asked`: the options of the user.
    pub fn tolerance(model: &AnalysisModel, asked: &SolveOptions) -> f64 {
        match model.analysis {
            AnalysisKind::Limit => asked.stop.limit_gap,
            AnalysisKind::Elastoplastic => asked.stop.for_yielding().gap,
            AnalysisKind::Elastic => asked.stop.gap,
        }
    }

    /// The programs that ran or were to run.
    pub fn runs(&self) -> Vec<(Program, &ProgramOutcome)> {
        match self {
            AnalysisPass::Energy(p) => p.runs().collect(),
            AnalysisPass::Factor(p) => p.runs().collect(),
        }
    }

    /// Contributions to the gap of the reported bracket, where there is one.
    pub fn contributions(&self) -> Option<&Contributions> {
        match self {
            AnalysisPass::Energy(p) => p.contributions.as_ref(),
            AnalysisPass::Factor(p) => p.contributions.as_ref(),
        }
    }

    /// Displacements or velocities of the kinematic program at vertices and mid-side nodes.
    pub fn kinematic_field(&self) -> Option<&[V3]> {
        let field = match self {
            AnalysisPass::Energy(p) => {
                p.displacement.as_ref().or(p.plastic.as_ref().map(|f| &f.nodes))
            }
            AnalysisPass::Factor(p) => p.velocity.as_ref().map(|v| &v.nodes),
        };
        field.map(|f| &f.u[..])
    }

    /// Limit analysis: the velocities of the mechanism.
    pub fn velocity(&self) -> Option<&VelocityField> {
        match self {
            AnalysisPass::Energy(_) => None,
            AnalysisPass::Factor(p) => p.velocity.as_ref(),
        }
    }

    /// Limit analysis: the velocities of the vertices in the static program's own mechanism; their
    /// sign and scale have no meaning.
    pub fn static_velocities(&self) -> Option<&[V3]> {
        match self {
            AnalysisPass::Energy(_) => None,
            AnalysisPass::Factor(p) => p.static_velocities.as_deref(),
        }
    }

    /// Limit analysis: the stress at the reported lower bound.
    pub fn stress(&self, coulomb: bool) -> Option<&StressField> {
        match self {
            AnalysisPass::Energy(_) => None,
            AnalysisPass::Factor(p) => p.carried(coulomb).map(|c| c.0),
        }
    }

    /// Limit analysis: share of the static load factor carried by each tet's yield multipliers.
    pub fn yield_multiplier_share(&self) -> Option<&[f64]> {
        match self {
            AnalysisPass::Energy(_) => None,
            AnalysisPass::Factor(p) => p.yield_multiplier_share.as_deref(),
        }
    }
}
