//! `bracket check`: the code's checks of a spec, without mesher or solver.

use super::catalog_options::CatalogOptions;
use super::common::{CommandResult, Common};
use crate::driver::check_spec::check_spec;
use crate::driver::interrupt::Interrupt;
use crate::driver::spec_input::SpecInput;
use std::path::{Path, PathBuf};

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
    /// The folder of the report. It differs from that of `run`, so that a quick check does not
    /// replace an analysis that took an hour.
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
    check(args, common, &Interrupt::watch()?)
}

/// One check, for `check` and `watch`.
pub(super) fn check(args: &CheckArgs, common: &Common, interrupt: &Interrupt) -> CommandResult {
    let folder = args.folder();
    let finished = SpecInput::read(&args.spec).and_then(|spec| {
        let catalog = args.catalog.folder().map(Path::to_path_buf);
        check_spec(&SpecInput { catalog, ..spec }, &folder, common.quiet, interrupt)
    });
    let finished = finished.map_err(|mut faults| {
        // a report of an earlier input must not be taken for one of this input
        let report = folder.join("report.md");
        if let Some(d) = Some(faults.last_mut()).filter(|_| report.is_file()) {
            let old = format!("`{}` is of an earlier input", report.display());
            d.help = Some(d.help.take().map_or(old.clone(), |help| format!("{help}; {old}")));
        }
        faults
    })?;
    common.print_result(&finished)
}
