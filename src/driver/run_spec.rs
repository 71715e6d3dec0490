//! The analysis of a connection spec with its result folder.

use crate::driver::limits::{Limits, WHEN_INTERRUPTED};
use crate::driver::present::{Finished, present};
use crate::driver::run_files::RunFiles;
use crate::driver::spec_context::spec_context;
use crate::driver::spec_input::SpecInput;
use crate::driver::spec_run::SpecRun;
use bracket_base::diag::Diagnostics;
use bracket_report::console::log::Log;
use bracket_report::result::folder::ResultFolder;
use std::path::Path;
use std::sync::Arc;

/// Analyses a spec and writes its result into `folder`. `keep`: also write the assembly and the
/// mesher's script; `quiet`: show nothing on standard error.
pub fn run_spec(
    spec: &SpecInput,
    folder: &Path,
    keep: bool,
    quiet: bool,
    limits: &Limits,
) -> Result<Finished, Diagnostics> {
    let input = spec.open()?;
    let log = Arc::new(Log::new(quiet));
    let run = SpecRun::new(&spec.overrides, input, limits, &log)?;
    let folder = ResultFolder::begin(folder)?;
    if run.is_idle() {
        limits.interrupt.begin_short(folder.give_up());
    } else {
        limits.interrupt.begin(&log, WHEN_INTERRUPTED, folder.give_up());
    }
    run.input.store(&folder)?;
    let mut context = spec_context(&spec.path, &run.input)?;
    let mut files = RunFiles::new(&folder, context.input.language, &limits.interrupt);
    files.keep = keep;
    let ran = run.end(folder.path(), &mut files, &log)?;
    let drawn = files.drawn();
    context.input.project.extend(ran.mesher.map(|v| ("mesher".into(), format!("gmsh {v}"))));
    if !ran.judged.result.asked.is_empty() {
        context.input.resolved.extend(spec.overrides.resolved());
    }
    present(ran.judged, context, drawn, &limits.interrupt, folder, &log)
}
