//! The hand checks of a connection spec, without mesher or solver.

use crate::driver::finish::{Analyses, Finished, finish};
use crate::driver::input_hash::checked_hash;
use crate::driver::interrupt::Interrupt;
use crate::driver::spec_checks;
use crate::driver::spec_context::{self, spec_context};
use crate::driver::spec_file::{self, SpecFile};
use bracket_base::diag::Diagnostics;
use bracket_codes::HandChecks;
use bracket_codes::verdict::Verdict;
use bracket_report::console::log::Log;
use bracket_report::result::folder::ResultFolder;
use bracket_report::result::result_file::ResultFile;
use std::path::Path;

/// Checks a spec and writes report and drawings into `folder`. `catalog` is a catalogue folder that
/// takes precedence over that of the spec. With `quiet`, nothing is written to standard error.
/// An interrupt ends the program at once and leaves nothing.
pub fn check_spec(
    spec: &Path,
    catalog: Option<&Path>,
    folder: &Path,
    quiet: bool,
    interrupt: &Interrupt,
) -> Result<Finished, Diagnostics> {
    let input = spec_file::read(spec, catalog)?;
    spec_checks::check_input(&input, &[])?;
    let checks = spec_context::spec_checks(&input);
    let log = Log::new(quiet);
    input.catalog.warnings().iter().for_each(|w| log.line(spec_file::catalog_warning(w)));
    let folder = ResultFolder::begin(folder)?;
    interrupt.begin_short(folder.give_up());
    input.store(&folder)?;
    checks_alone(spec, &input, checks, folder, &log)
}

/// The result of the hand checks, without any analysis.
pub fn checks_alone(
    spec: &Path,
    input: &SpecFile,
    checks: HandChecks,
    folder: ResultFolder,
    log: &Log,
) -> Result<Finished, Diagnostics> {
    let mut context = spec_context(spec, input, checks)?;
    context.input_hash = checked_hash(input)?;
    let mut result = ResultFile::new(context.input_hash.clone(), 1, Verdict::None);
    result.warnings.clone_from(&context.checks.notes);
    finish(result, context, Analyses::default(), folder, log)
}
