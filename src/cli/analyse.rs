//! `bracket analyse`: the engine on a mesh the user brings.

use super::analysis_options::AnalysisOptions;
use super::common::{CommandResult, Common};
use crate::driver::analyse_model::analyse_model;
use crate::driver::limits::use_threads;
use std::path::PathBuf;

/// The same engine on a mesh you bring.
#[derive(Debug, clap::Args)]
pub struct AnalyseArgs {
    /// Model file (`bracket schema model` describes it).
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    /// Options of the analysis.
    #[command(flatten)]
    pub options: AnalysisOptions,
}

/// Runs `bracket analyse`.
pub fn run(args: &AnalyseArgs, common: &Common) -> CommandResult {
    let limits = args.options.limits()?;
    use_threads(common.threads)?;
    let folder = args.options.folder(&args.model);
    common.print_result(&analyse_model(&args.model, &folder, limits, common.quiet)?)
}
