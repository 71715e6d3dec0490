//! A pass of either kind of analysis, and its entry in the result.

use crate::analysis::engine::{self, Pass, PassError, PassOptions, ProgramRun, Progress};
use crate::analysis::hencky;
use crate::analysis::limit::{self, LimitPass};
use crate::analysis::program_run::Program;
use crate::certify::error::Contributions;
use crate::certify::fields::StressField;
use crate::model::AnalysisModel;
use crate::result::case::case_result;
use crate::result::data::{CaseResult, FrictionModel};
use crate::result::limit_case::limit_case_result;
use crate::solve::SolveOptions;
use crate::spec::analysis::AnalysisKind;

/// A pass of one kind of analysis.
pub enum AnalysisPass {
    /// Bounds of the energy.
    Energy(Box<Pass>),
    /// Bounds of the load factor.
    Factor(Box<LimitPass>),
}

impl AnalysisPass {
    /// Runs the programs that the model's kind of analysis asks for.
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
                AnalysisPass::Energy(Box::new(engine::run(model, options, progress)?))
            }
        })
    }

    /// The gap at which a solve ends.
    pub fn tolerance(model: &AnalysisModel, asked: &SolveOptions) -> f64 {
        match model.analysis {
            AnalysisKind::Limit => asked.limit_gap,
            AnalysisKind::Elastoplastic => asked.gap.max(hencky::GAP),
            AnalysisKind::Elastic => asked.gap,
        }
    }

    /// The programs that ran or were to run.
    pub fn runs(&self) -> Vec<(Program, &ProgramRun)> {
        match self {
            AnalysisPass::Energy(p) => p.runs().collect(),
            AnalysisPass::Factor(p) => p.runs().collect(),
        }
    }

    /// Contributions to the gap of the bracket that answers, where there is one.
    pub fn contributions(&self) -> Option<&Contributions> {
        match self {
            AnalysisPass::Energy(p) => p.contributions.as_ref(),
            AnalysisPass::Factor(p) => p.contributions.as_ref(),
        }
    }

    /// What each tet holds the lower bound of a load factor down by.
    pub fn yield_multiplier_share(&self) -> Option<&[f64]> {
        match self {
            AnalysisPass::Energy(_) => None,
            AnalysisPass::Factor(p) => p.yield_multiplier_share.as_deref(),
        }
    }

    /// The stress behind the lower bound of the answer, and the load factor it carries.
    pub fn stress(&self, entry: &CaseResult) -> Option<(&StressField, f64)> {
        match self {
            AnalysisPass::Energy(p) => p.stress.as_ref().map(|s| (s, 1.0)),
            AnalysisPass::Factor(p) => p
                .carried(entry.problem == FrictionModel::Coulomb)
                .map(|(stress, bound)| (stress, bound.certificate().factor)),
        }
    }

    /// The entry of the result.
    pub fn entry(
        &self,
        name: &str,
        model: &AnalysisModel,
        mesh_seconds: Option<f64>,
    ) -> CaseResult {
        match self {
            AnalysisPass::Energy(p) => case_result(name, model, p, mesh_seconds),
            AnalysisPass::Factor(p) => limit_case_result(name, model, p, mesh_seconds),
        }
    }
}
