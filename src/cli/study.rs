//! `bracket study`: speed against error, uniform and adaptive meshes and solvers side by side.

use super::analysis_options::SolverChoice;
use super::common::{CommandResult, Common, Format};
use crate::driver::limits::{Limits, use_threads};
use crate::driver::study::{StudyOptions, run_study};
use bracket_base::diag::ExitStatus;
use bracket_engine::solve::Solver;
use bracket_report::console::out;
use std::path::PathBuf;

/// Speed against error: a row for each mesh and solver, as table, CSV and plots.
#[derive(Debug, clap::Args)]
pub struct StudyArgs {
    /// Connection spec or model file.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Folder for the study (default: named after the input, with `_study`).
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Solvers to compare.
    #[arg(long, value_enum, value_delimiter = ',', default_values = ["condensed"])]
    pub solver: Vec<SolverChoice>,
    /// Uniform meshes, each about twice as large as the one before; 0: adaptive ones only.
    #[arg(long, value_name = "N", default_value_t = 3)]
    pub uniform: u32,
    /// Multiplies all element sizes of a spec's first mesh.
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    pub size_factor: f64,
    /// Gap at which adaptive meshes end, a fraction (default: as in the file).
    #[arg(long, value_name = "GAP")]
    pub target_gap: Option<f64>,
    /// Tets at most, uniform meshes too (default: as in the file).
    #[arg(long, value_name = "N")]
    pub max_macro_tets: Option<usize>,
    /// Adaptive meshes at most (default: as in the file).
    #[arg(long, value_name = "N")]
    pub max_passes: Option<u32>,
    /// Memory the study may use in all, for example 8GiB (default: what the machine has left).
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    pub memory_limit: Option<String>,
}

/// Runs `bracket study`.
pub fn run(args: &StudyArgs, common: &Common) -> CommandResult {
    let limits = Limits::new(Solver::Condensed, args.memory_limit.as_deref())?;
    use_threads(common.threads)?;
    let interrupt = limits.interrupt.clone();
    let options = StudyOptions {
        file: args.file.clone(),
        out: args.out.clone(),
        solvers: args.solver.iter().map(|s| (*s).into()).collect(),
        uniform: args.uniform,
        size_factor: args.size_factor,
        target_gap: args.target_gap,
        max_macro_tets: args.max_macro_tets,
        max_passes: args.max_passes,
        quiet: common.quiet,
    };
    let study = run_study(&options, limits)?;
    match common.format {
        Format::Text => out::text(&study.markdown())?,
        Format::Json => out::json(&study.rows)?,
    }
    let certified = study.rows.iter().any(|r| r.gap.is_some()) && !interrupt.asked();
    Ok(if certified { ExitStatus::Ok } else { ExitStatus::Undecided })
}
