//! `bracket batch`: catalogues of joints.

use super::catalog_options::CatalogOptions;
use super::common::{CommandResult, Common, Format};
use crate::batch::commands::{
    Merge, RunOptions, merge, plan, run as run_sweep, slurm_array, status,
};
use crate::batch::counts::Counts;
use crate::batch::plan::Plan;
use crate::batch::shard::Shard;
use crate::batch::slurm;
use crate::batch::sweep_folder::SweepFolder;
use crate::driver::interrupt::Interrupt;
use crate::driver::limits::use_threads;
use bracket_base::diag::{Diagnostic, Diagnostics, ExitStatus};
use bracket_report::console::log::Log;
use bracket_report::console::out;
use clap::Subcommand;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Catalogues of joints: every row or combination checked and analysed.
#[derive(Debug, clap::Args)]
#[command(args_conflicts_with_subcommands = true)]
pub struct BatchArgs {
    /// One step; without it the sweep is planned, run and merged on this machine.
    #[command(subcommand)]
    pub step: Option<Step>,
    /// Sweep file.
    #[arg(value_name = "SWEEP")]
    pub sweep: Option<PathBuf>,
    /// Folder of the sweep (default: named after the sweep file).
    #[arg(long, short, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Processes with finite elements side by side (default: one a processor).
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
    /// Folder of results that several sweeps share: what it holds is not computed again.
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
    /// Catalogue.
    #[command(flatten)]
    pub catalog: CatalogOptions,
}

/// The steps of a sweep.
#[derive(Debug, Subcommand)]
pub enum Step {
    /// Expand a sweep file into cases.
    Plan {
        /// Sweep file.
        #[arg(value_name = "SWEEP")]
        sweep: PathBuf,
        /// Folder of the sweep (default: named after the sweep file).
        #[arg(long, short, value_name = "DIR")]
        out: Option<PathBuf>,
        /// Catalogue.
        #[command(flatten)]
        catalog: CatalogOptions,
    },
    /// Run the cases that are not finished, or a part of them.
    Run {
        /// Folder of a planned sweep.
        #[arg(value_name = "DIR")]
        folder: PathBuf,
        /// Part of the sweep: `2/5`, or `auto/5` in a job array (Slurm, Kubernetes, AWS Batch).
        #[arg(long, value_name = "I/N")]
        shard: Option<String>,
        /// Processes with finite elements side by side (default: one a processor).
        #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
        jobs: Option<u16>,
        /// Folder of results that several sweeps share: what it holds is not computed again.
        #[arg(long, value_name = "DIR")]
        cache: Option<PathBuf>,
    },
    /// Report what is finished.
    Status {
        /// Folder of a planned sweep.
        #[arg(value_name = "DIR")]
        folder: PathBuf,
    },
    /// Print a script for Slurm: a job array with a shard in each task.
    Slurm {
        /// Folder of a planned sweep, on a disk that all nodes see.
        #[arg(value_name = "DIR")]
        folder: PathBuf,
        /// Tasks of the array (default: about an hour of forecast work in each).
        #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=10000))]
        tasks: Option<u16>,
        /// Folder of results that several sweeps share, on a disk that all nodes see.
        #[arg(long, value_name = "DIR")]
        cache: Option<PathBuf>,
        /// Hand the array to `sbatch`, and a job that merges after it.
        #[arg(long)]
        submit: bool,
    },
    /// Merge the finished cases into tables and a page.
    Merge {
        /// Folder of a planned sweep.
        #[arg(value_name = "DIR")]
        folder: PathBuf,
    },
}

/// Folder named after a sweep file.
fn folder_of(sweep: &Path, out: Option<&PathBuf>) -> SweepFolder {
    let named = sweep.with_extension("");
    let fallback = if named == sweep { sweep.with_extension("batch") } else { named };
    SweepFolder::at(out.unwrap_or(&fallback))
}

/// The plan in a folder, with a word about files that changed since.
fn planned(folder: &SweepFolder, log: &Log) -> Result<Plan, Diagnostics> {
    let plan = folder.plan()?;
    for file in plan.header.changed() {
        let file = file.display();
        log.line(format!("remark: `{file}` has changed since the plan; plan the sweep again"));
    }
    Ok(plan)
}

/// Prints what became of a sweep as JSON if the user asked for it; returns its exit status.
fn ended(
    merge: &Merge,
    folder: &SweepFolder,
    common: &Common,
    (interrupt, log): (&Interrupt, &Log),
) -> CommandResult {
    let status = after(merge.status, interrupt, log);
    if common.format == Format::Json {
        let mut all = merge.counts.json();
        all.insert("expected_and_not_so".into(), json!(merge.broken));
        all.insert("folder".into(), json!(folder.path()));
        all.insert("exit_code".into(), json!(status.code()));
        out::json(&all)?;
    }
    Ok(status)
}

/// The exit status of a step: undecided after an interrupt, whatever is finished.
fn after(status: ExitStatus, interrupt: &Interrupt, log: &Log) -> ExitStatus {
    if !interrupt.asked() {
        return status;
    }
    let status = ExitStatus::Undecided;
    log.line(format!("exit code {}: interrupted; the same command continues", status.code()));
    status
}

/// Runs `bracket batch`.
pub fn run(args: &BatchArgs, common: &Common) -> CommandResult {
    // before any thread starts, so that every thread inherits the blocked signals
    let interrupt = Interrupt::watch()?;
    use_threads(common.threads)?;
    let log = Arc::new(Log::new(common.quiet));
    let jobs = |n: Option<u16>| n.map(usize::from);
    match (&args.step, &args.sweep) {
        (None, None) => Err(Diagnostic::input("cli/value", "no sweep file is given")
            .help("`bracket batch SWEEP.yaml`, or a step: plan, run, status, merge")
            .into()),
        (None, Some(sweep)) => {
            let folder = folder_of(sweep, args.out.as_ref());
            let plan = plan(sweep, args.catalog.folder(), &folder, &interrupt, &log)?;
            let options = RunOptions {
                shard: Shard::WHOLE,
                jobs: jobs(args.jobs),
                cache: args.cache.clone(),
            };
            run_sweep(&plan, &folder, options, &interrupt, &log)?;
            ended(&merge(&plan, &folder, &log)?, &folder, common, (&interrupt, &log))
        }
        (Some(Step::Plan { sweep, out, catalog }), _) => {
            let folder = folder_of(sweep, out.as_ref());
            plan(sweep, catalog.folder(), &folder, &interrupt, &log)?;
            log.line(format!("next: bracket batch run {}", folder.path().display()));
            Ok(ExitStatus::Ok)
        }
        (Some(Step::Run { folder, shard, jobs: n, cache }), _) => {
            let folder = SweepFolder::at(folder);
            let plan = planned(&folder, &log)?;
            let shard = match shard {
                Some(text) => Shard::parse(text, |name| std::env::var(name).ok())?,
                None => Shard::WHOLE,
            };
            let options = RunOptions { shard, jobs: jobs(*n), cache: cache.clone() };
            run_sweep(&plan, &folder, options, &interrupt, &log)?;
            Ok(after(ExitStatus::Ok, &interrupt, &log))
        }
        (Some(Step::Status { folder }), _) => {
            let folder = SweepFolder::at(folder);
            let counts = status(&planned(&folder, &log)?, &folder)?;
            match common.format {
                Format::Text => {
                    out::text(&format!("{}: {}\n", Counts::cases(counts.all()), counts.words()))?
                }
                Format::Json => out::json(&counts.json())?,
            }
            Ok(if counts.open == 0 { ExitStatus::Ok } else { ExitStatus::Undecided })
        }
        (Some(Step::Slurm { folder, tasks, cache, submit }), _) => {
            let folder = SweepFolder::at(folder);
            let mut array = slurm_array(&folder.plan()?, tasks.map(usize::from))?;
            // the script runs in a folder of its own
            array.cache = cache.as_ref().map(|c| std::path::absolute(c).unwrap_or(c.clone()));
            let program = std::env::current_exe().unwrap_or_else(|_| "bracket".into());
            if *submit {
                let [array, merge] = slurm::submit(&array, &program, &folder)?;
                log.line(format!("submitted: array {array}, merge {merge}"));
            } else {
                let dir = std::path::absolute(folder.path())
                    .unwrap_or_else(|_| folder.path().to_path_buf());
                out::data(&array.script(&program, &dir))?;
            }
            Ok(ExitStatus::Ok)
        }
        (Some(Step::Merge { folder }), _) => {
            let folder = SweepFolder::at(folder);
            let merged = merge(&planned(&folder, &log)?, &folder, &log)?;
            ended(&merged, &folder, common, (&interrupt, &log))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::Ordering;

    /// A finished case that is not OK, or one that failed, does not decide an interrupted sweep.
    #[test]
    fn an_interrupted_sweep_ends_with_3() {
        for status in [ExitStatus::Ok, ExitStatus::NotOk, ExitStatus::Environment] {
            let (interrupt, log) = (Interrupt::default(), Log::new(true));
            assert_eq!(after(status, &interrupt, &log), status);
            interrupt.flag().store(true, Ordering::Relaxed);
            assert_eq!(after(status, &interrupt, &log), ExitStatus::Undecided);
            assert!(log.text().ends_with("exit code 3: interrupted; the same command continues\n"));
        }
    }
}
