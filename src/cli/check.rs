//! `bracket check`: the code's checks of a spec, without mesher or solver.

use super::run::{check_names, check_sizes, demanded_cases, run_context};
use super::spec_file::{self, CatalogOptions};
use super::{CommandResult, Common};
use crate::checks::hand_checks;
use crate::checks::verdict::Verdict;
use crate::diag::Diagnostic;
use crate::driver::conclude::{Analyses, conclude};
use crate::report::console::log::Log;
use crate::report::markdown::page::ModelTraits;
use crate::result::data::{ResultFile, input_hash};
use crate::result::folder::ResultFolder;
use std::path::PathBuf;

/// The code's checks, detailing, drawing and verdict by code, at once.
#[derive(Debug, clap::Args)]
pub struct CheckArgs {
    /// Connection spec (`bracket new TEMPLATE` writes a starter).
    #[arg(value_name = "SPEC")]
    pub spec: PathBuf,
    /// Folder for the report (default: named after the spec, with `_check`, beside it).
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Catalogue.
    #[command(flatten)]
    pub catalog: CatalogOptions,
}

impl CheckArgs {
    /// The folder of the report. Not the one of `run`: a look at the checks must not replace an
    /// analysis of an hour.
    fn folder(&self) -> PathBuf {
        self.out.clone().unwrap_or_else(|| {
            let mut name = self.spec.with_extension("").into_os_string();
            name.push("_check");
            name.into()
        })
    }
}

/// Runs `bracket check`.
pub fn run(args: &CheckArgs, common: &Common) -> CommandResult {
    judge(args, common).map_err(|mut faults| {
        // a report that stays must not be read as one of this input
        let report = args.folder().join("report.md");
        if let Some(d) = Some(faults.last_mut()).filter(|_| report.is_file()) {
            let old = format!("`{}` is of an earlier input", report.display());
            d.help = Some(d.help.take().map_or(old.clone(), |help| format!("{help}; {old}")));
        }
        faults
    })
}

fn judge(args: &CheckArgs, common: &Common) -> CommandResult {
    let input = spec_file::read(&args.spec, args.catalog.folder())?;
    check_names(&input, &[])?;
    check_sizes(&input)?;
    let mut checks = input.joint.end_plate.as_ref().map(hand_checks).unwrap_or_default();
    checks.notes.extend(input.joint.notes.iter().cloned());
    let log = Log::new(common.quiet);
    input.catalog.warnings().iter().for_each(|w| log.line(spec_file::catalog_warning(w)));
    let folder = ResultFolder::begin(&args.folder())?;
    let mut context = run_context(&args.spec, &input, checks)?;
    // what the checks see holds what the catalogue and the template gave
    let seen = serde_json::to_string(&input.joint.end_plate).map_err(|e| {
        Diagnostic::environment("cli/check", format!("the joint cannot be written: {e}"))
    })?;
    context.input_hash = input_hash(&[("spec", input.text.as_bytes()), ("joint", seen.as_bytes())]);
    let mut result = ResultFile::new(context.input_hash.clone(), 1, Verdict::None);
    result.warnings.clone_from(&context.checks.notes);
    let analyses = Analyses {
        demanded: demanded_cases(&input).into_iter().map(|case| (case, Vec::new())).collect(),
        complete: true,
        interrupted: false,
        pictures: Vec::new(),
        traits: ModelTraits::default(),
        notes: Vec::new(),
    };
    conclude(result, context, analyses, folder, &log, common)
}
