//! `bracket run`: connection spec → geometry → mesh → dual analyses → bracket and report.

use super::analysis_options::AnalysisOptions;
use super::catalog_options::CatalogOptions;
use super::common::{CommandResult, Common};
use crate::driver::limits::use_threads;
use crate::driver::meshing::Extent;
use crate::driver::overrides::Overrides;
use crate::driver::run_spec::run_spec;
use crate::driver::spec_input::SpecInput;
use bracket_engine::model::AnalysisKind;
use std::path::PathBuf;

/// Connection spec → geometry → mesh → dual analyses → bracket and report.
#[derive(Debug, clap::Args)]
pub struct RunArgs {
    /// Connection spec (`bracket new TEMPLATE` writes a starter).
    #[arg(value_name = "SPEC")]
    pub spec: PathBuf,
    /// Analyse the whole joint, even if it is symmetric.
    #[arg(long)]
    pub full: bool,
    /// Multiplies all element sizes: 0.5 gives about five times the elements.
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    pub size_factor: f64,
    /// Kind of analysis, in place of `analysis.kind`.
    #[arg(long, value_enum)]
    pub kind: Option<KindArg>,
    /// Meshes at most, in place of `analysis.max_passes`: 1 is a quick look.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=50))]
    pub max_passes: Option<u32>,
    /// Catalogue of the user's own.
    #[command(flatten)]
    pub catalog: CatalogOptions,
    /// Options of the analysis.
    #[command(flatten)]
    pub options: AnalysisOptions,
    /// Also write the assembly (`joint.json`) and the mesher's script (`joint.geo`).
    #[arg(long)]
    pub keep: bool,
}

/// The kinds of analysis as words of the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum KindArg {
    /// Energy and displacement of the elastic joint
    Elastic,
    /// Energy of the elastic, perfectly plastic joint under the given load
    Elastoplastic,
    /// Load at collapse
    Limit,
}

impl From<KindArg> for AnalysisKind {
    fn from(kind: KindArg) -> Self {
        match kind {
            KindArg::Elastic => AnalysisKind::Elastic,
            KindArg::Elastoplastic => AnalysisKind::Elastoplastic,
            KindArg::Limit => AnalysisKind::Limit,
        }
    }
}

/// Runs `bracket run`.
pub fn run(args: &RunArgs, common: &Common) -> CommandResult {
    let extent = Extent { full: args.full, size_factor: args.size_factor };
    extent.check()?;
    let limits = args.options.limits()?;
    use_threads(common.threads)?;
    let kind = args.kind.map(AnalysisKind::from);
    let spec = SpecInput {
        catalog: args.catalog.catalog.clone(),
        overrides: Overrides { extent, kind, max_passes: args.max_passes },
        ..SpecInput::read(&args.spec)?
    };
    let folder = args.options.folder(&args.spec);
    common.print_result(&run_spec(&spec, &folder, args.keep, common.quiet, &limits)?)
}
