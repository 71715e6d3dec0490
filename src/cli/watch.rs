//! `bracket watch`: repeats the checks of a spec whenever a YAML or CSV file beside it or in the
//! folder of `--catalog` changes.

use super::check::{self, CheckArgs};
use super::common::{CommandResult, Common};
use crate::driver::interrupt::Interrupt;
use bracket_base::diag_render;
use bracket_report::console::out;
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Interval between two checks of the files, shorter than the time a user needs to look up.
const EVERY: Duration = Duration::from_millis(150);

/// Repeat the code's checks on every change of the spec.
#[derive(Debug, clap::Args)]
pub struct WatchArgs {
    /// The spec and the options of the checks.
    #[command(flatten)]
    pub check: CheckArgs,
}

/// State of the input files: name, time of last change, size.
type Stamps = Vec<(PathBuf, SystemTime, u64)>;

/// Runs `bracket watch` until Ctrl-C.
pub fn run(args: &WatchArgs, common: &Common) -> CommandResult {
    let interrupt = Interrupt::watch()?;
    let mut before: Option<Stamps> = None;
    loop {
        let now = stamps(&args.check);
        if before.as_ref() != Some(&now) {
            if before.is_some() && !common.quiet {
                out::remark("");
            }
            // a spec that is being edited may be wrong for a while: report the fault and wait for
            // the next change
            if let Err(faults) = check::check(&args.check, common, &interrupt) {
                let mut stderr = std::io::stderr();
                let text = diag_render::text(&faults, stderr.is_terminal());
                // nobody reads the messages any more if standard error is closed
                if stderr.write_all(text.as_bytes()).is_err() {
                    return Ok(faults.exit_status());
                }
            }
            interrupt.begin_short(|| {});
            before = Some(now);
        }
        std::thread::sleep(EVERY);
    }
}

/// Endings of files that a check may read.
const INPUTS: [&str; 8] = ["yaml", "yml", "csv", "txt", "tsv", "xlsx", "xls", "ods"];

/// State of the files that a check may read: those with the endings above beside the spec, and the
/// catalogue folder given on the command line.
fn stamps(args: &CheckArgs) -> Stamps {
    let beside = args.spec.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut out = Stamps::new();
    for folder in [Some(beside), args.catalog.folder()].into_iter().flatten() {
        let Ok(entries) = std::fs::read_dir(folder) else { continue };
        for path in entries.filter_map(|e| Some(e.ok()?.path())) {
            let input =
                path.extension().is_some_and(|e| INPUTS.iter().any(|x| e.eq_ignore_ascii_case(x)));
            if let Some(meta) =
                path.metadata().ok().filter(|m| (input || path == args.spec) && m.is_file())
            {
                out.push((path, meta.modified().unwrap_or(SystemTime::UNIX_EPOCH), meta.len()));
            }
        }
    }
    out.sort();
    out
}
