//! The hand checks of a connection spec, without mesher or solver.

use crate::driver::demands::demands;
use crate::driver::input_hash::checked_hash;
use crate::driver::interrupt::Interrupt;
use crate::driver::judge::Judged;
use crate::driver::present::{Drawn, Finished, present};
use crate::driver::solved::Solved;
use crate::driver::spec_checks::check_input;
use crate::driver::spec_context::{spec_checks, spec_context};
use crate::driver::spec_file::{SpecFile, catalog_warning};
use crate::driver::spec_input::SpecInput;
use bracket_base::diag::Diagnostics;
use bracket_base::words::Text;
use bracket_codes::check::Check;
use bracket_codes::verdict::Verdict;
use bracket_codes::{HandChecks, Judgement, Status, Topic};
use bracket_report::console::log::Log;
use bracket_report::result::folder::ResultFolder;
use bracket_report::result::result_file::ResultFile;
use std::path::Path;

/// A spec whose joint is checked by code.
pub struct Checked {
    /// The spec with its joint and its catalogue.
    pub input: SpecFile,
    /// The checks of the code, with the notes of the joint.
    pub checks: HandChecks,
    /// The result with the verdict by code, as `bracket check` writes it.
    pub judged: Judged,
}

impl Checked {
    /// The verdict by code.
    pub fn verdict(&self) -> Verdict {
        self.judged.result.verdict
    }

    /// The verdict with its reason and what governs; `None` if no load is a demand on the joint.
    pub fn judgement(&self) -> Option<&Judgement> {
        self.judged.result.judgement.as_ref()
    }

    /// Notes of the joint and of its checks, a sentence each.
    pub fn notes(&self) -> &[Text] {
        &self.checks.notes
    }
}

/// Checks the joint of a spec by code, without mesher or solver. It reads the templates and tables
/// that the spec names, writes no file and prints nothing.
///
/// ```
/// use bracket::SpecInput;
/// use bracket::checks::verdict::Verdict;
///
/// let spec = SpecInput::new(
///     "template: beam_splice
/// members: {beam: {profile: IPE300, steel: S235}}
/// plate: {thickness: 20, width: 160, z: [-170, 170]}
/// bolts: {size: M20, grade: \"8.8\", gauge: 90, rows: [-90, 90]}
/// loads: [{name: ULS1, end: beam_right, at: bolt_plane, My: 20 kN m, Vz: -20 kN}]
/// ",
/// );
/// let checked = bracket::check(&spec)?;
/// assert_eq!(checked.verdict(), Verdict::Ok);
/// let worst = checked.judgement().and_then(|j| j.governing.as_ref());
/// assert!(worst.is_some_and(|g| g.utilisation.is_some_and(|u| u[1] < 1.0)));
/// # Ok::<(), bracket::diag::Diagnostics>(())
/// ```
pub fn check(spec: &SpecInput) -> Result<Checked, Diagnostics> {
    let input = spec.open()?;
    check_input(&input, &[])?;
    let checks = spec_checks(&input);
    let judged =
        unanalysed(&input, &checks, 1)?.judge(&checks, None, &demands(&input.spec.value.loads));
    Ok(Checked { input, checks, judged })
}

/// A run of a spec without analyses. `symmetry`: how many copies of the meshed part make the joint.
pub fn unanalysed(
    input: &SpecFile,
    checks: &HandChecks,
    symmetry: u32,
) -> Result<Solved, Diagnostics> {
    let mut result = ResultFile::new(checked_hash(input)?, symmetry, Verdict::None);
    result.warnings.clone_from(&checks.notes);
    Ok(Solved::without_cases(result))
}

/// Checks a spec and writes report and drawings into `folder`. With `quiet`, nothing is written to
/// standard error. An interrupt ends the program at once and leaves nothing.
pub fn check_spec(
    spec: &SpecInput,
    folder: &Path,
    quiet: bool,
    interrupt: &Interrupt,
) -> Result<Finished, Diagnostics> {
    let Checked { input, judged, .. } = check(spec)?;
    let log = Log::new(quiet);
    input.catalog.warnings().iter().for_each(|w| log.line(catalog_warning(w)));
    report_detailing(&judged.result.checks, &log);
    if input.spec.value.polygon.is_some() {
        log.line("the capacity polygon is found by finite elements: `bracket run` draws it");
    }
    let folder = ResultFolder::begin(folder)?;
    interrupt.begin_short(folder.give_up());
    input.store(&folder)?;
    let context = spec_context(&spec.path, &input)?;
    present(judged, context, Drawn::default(), interrupt, folder, &log)
}

/// Says what is wrong with the detailing of a joint.
pub(super) fn report_detailing(checks: &[Check], log: &Log) {
    for c in checks.iter().filter(|c| c.topic == Topic::Detailing) {
        match c.status {
            Status::Failed => log.line(format!("check failed: {}", c.sentence())),
            Status::Warning => log.line(format!("detailing: {}", c.sentence())),
            Status::Ok | Status::Information | Status::Undecided => {}
        }
    }
}
