//! The checks of cases.

use super::case::Case;
use super::part::Part;
use super::plan::Plan;
use super::row::Record;
use super::screen::{Kit, screen};
use super::sweep_folder::SweepFolder;
use bracket_base::diag::Diagnostic;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicBool, Ordering};

/// Checks the cases of runs that are not checked yet. `progress` gets the records of every finished
/// run. Ends early, without an error, when `interrupt` is set.
pub fn check_all(
    folder: &SweepFolder,
    plan: &Plan,
    kit: &Kit,
    runs: &[&[Case]],
    interrupt: &AtomicBool,
    progress: &mut dyn FnMut(&[Record]),
) -> Result<(), Box<Diagnostic>> {
    for run in runs {
        if interrupt.load(Ordering::Relaxed) {
            return Ok(());
        }
        if let Some(records) = folder.checked(run)? {
            progress(&records);
            continue;
        }
        let one = |case: &Case| screen(case, &plan.header.expansion, kit);
        let records: Vec<Record> = run.par_iter().map(one).collect();
        folder.write_checked(run, &records)?;
        progress(&records);
    }
    Ok(())
}

/// The runs of cases that a part of a sweep checks: its own, or those of the groups that it chooses
/// from.
pub fn runs_of<'a>(folder: &SweepFolder, plan: &'a Plan, part: &Part) -> Vec<&'a [Case]> {
    let runs = folder.runs(&plan.cases);
    if plan.header.choose.is_none() || plan.header.then.is_none() {
        return part.runs(&runs).into_iter().map(|k| runs[k]).collect();
    }
    let length = runs.first().map_or(1, |r| r.len());
    let wanted = part.groups.iter().flat_map(|g| g.cases.iter().map(|i| i / length));
    wanted.collect::<BTreeSet<_>>().into_iter().map(|k| runs[k]).collect()
}
