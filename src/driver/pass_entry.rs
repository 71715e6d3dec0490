//! Converts a pass to an entry of the result.

use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::certify::fields::StressField;
use bracket_engine::model::AnalysisModel;
use bracket_report::result::bounds::CaseBounds;
use bracket_report::result::energy_case::case_result;
use bracket_report::result::energy_case::energy_bounds;
use bracket_report::result::limit_case::{factor_bounds, limit_case_result};
use bracket_report::result::result_file::CaseResult;
use bracket_report::result::result_file::FrictionModel;

/// The entry of the result for a pass.
pub fn pass_entry(
    pass: &AnalysisPass,
    name: &str,
    model: &AnalysisModel,
    mesh_seconds: Option<f64>,
) -> CaseResult {
    match pass {
        AnalysisPass::Energy(p) => case_result(name, model, p, mesh_seconds),
        AnalysisPass::Factor(p) => limit_case_result(name, model, p, mesh_seconds),
    }
}

/// The bounds that an entry of the result reports.
pub fn pass_bounds(pass: &AnalysisPass, entry: &CaseResult) -> CaseBounds {
    match pass {
        AnalysisPass::Energy(p) => energy_bounds(p),
        AnalysisPass::Factor(p) => factor_bounds(p, entry.problem),
    }
}

/// The stress field of the lower bound that an entry reports, and the load factor it carries.
pub fn lower_stress<'a>(
    pass: &'a AnalysisPass,
    entry: &CaseResult,
) -> Option<(&'a StressField, f64)> {
    match pass {
        AnalysisPass::Energy(p) => p.stress.as_ref().map(|s| (s, 1.0)),
        AnalysisPass::Factor(p) => p
            .carried(entry.problem == FrictionModel::Coulomb)
            .map(|(stress, bound)| (stress, bound.certificate().factor)),
    }
}
