//! The checks of the cases of a shard.

use super::case::Case;
use super::plan::Plan;
use super::row::Record;
use super::screen::{Kit, screen};
use super::shard::Shard;
use super::sweep_folder::SweepFolder;
use crate::diag::Diagnostic;
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};

/// Checks the cases of a shard that are not checked yet. `progress` gets the records of every
/// finished run of cases. Ends early, without an error, when `interrupt` is set.
pub fn check_all(
    folder: &SweepFolder,
    plan: &Plan,
    kit: &Kit,
    shard: Shard,
    interrupt: &AtomicBool,
    progress: &mut dyn FnMut(&[Record]),
) -> Result<(), Box<Diagnostic>> {
    let runs = folder.runs(&plan.cases);
    for run in shard.of(&runs) {
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
