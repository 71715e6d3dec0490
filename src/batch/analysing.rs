//! The finite elements of the cases of a shard, several processes side by side.

use super::forecast::time_limit;
use super::plan::{Header, Plan};
use super::row::{Outcome, Record};
use super::screen::Kit;
use super::shard::Shard;
use super::sweep::Who;
use super::sweep_folder::SweepFolder;
use super::worker::{Job, ProcessLimits, analyse, found};
use crate::diag::{Diagnostic, Diagnostics};
use std::collections::{BTreeSet, VecDeque};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// Time limit of a case whose analysis has none \[s\].
const LONGEST: f64 = 7200.0;

/// Time beyond twice the time limit of the analysis \[s\]: meshing, pictures, report.
const SLACK: f64 = 300.0;

/// Whether the checks of a case ask for finite elements.
pub fn wanted(who: Who, record: &Record) -> bool {
    match (who, record.outcome) {
        (_, Outcome::BadInput | Outcome::Failed | Outcome::TimedOut) => false,
        (Who::All, _) => true,
        (Who::Passing, _) => !record.rejected,
        (Who::Undecided, outcome) => outcome != Outcome::Ok && !record.rejected,
    }
}

/// The cases of a shard that need finite elements and have no record yet, the longest first.
/// `memory`: the memory of each \[bytes\].
pub fn jobs(
    folder: &SweepFolder,
    plan: &Plan,
    kit: &Kit,
    shard: Shard,
    memory: u64,
) -> Result<Vec<Job>, Diagnostics> {
    let header = &plan.header;
    let mut seen = BTreeSet::new();
    let mut jobs: Vec<(f64, Job)> = Vec::new();
    let runs = folder.runs(&plan.cases);
    for run in shard.of(&runs) {
        let records = match header.first {
            Some(_) => folder.checked(run)?,
            None => None,
        };
        for (i, case) in run.iter().enumerate() {
            let checked = records.as_ref().map(|r| r[i].clone());
            let asked = match (&checked, header.then) {
                (Some(record), Some(then)) => wanted(then.limit, record),
                (None, _) => header.first.is_none(),
                (Some(_), None) => false,
            };
            if !asked || !seen.insert(&case.key) {
                continue;
            }
            // what gave no result is tried again: the machine or the limits may be others now
            if folder.analysed(&case.key)?.is_some_and(|r| r.is_final()) {
                continue;
            }
            let mut spec = kit.spec(&header.expansion, case.index)?;
            title(&mut spec, &case.name);
            let limits = process_limits(header, &spec, memory);
            let limit = header.then.is_some();
            let job = Job { key: case.key.clone(), spec, checked, limit, limits };
            jobs.push((limits.time.as_secs_f64(), job));
        }
    }
    // a stable sort: cases with equal limits keep the order of the plan
    jobs.sort_by(|a, b| b.0.total_cmp(&a.0));
    Ok(jobs.into_iter().map(|(_, job)| job).collect())
}

/// Adds the name of the case to the title of its report.
fn title(spec: &mut serde_json::Value, name: &str) {
    let title = spec["project"]["title"].as_str().map(str::to_owned);
    let title = title.map_or_else(|| name.to_string(), |t| format!("{t}: {name}"));
    if spec["project"].is_null() {
        spec["project"] = serde_json::json!({});
    }
    spec["project"]["title"] = title.into();
}

fn process_limits(header: &Header, spec: &serde_json::Value, memory: u64) -> ProcessLimits {
    let of_analysis = time_limit(spec).map_or(LONGEST, |t| 2.0 * t + SLACK);
    let time = Duration::try_from_secs_f64(header.limits.time.map_or(of_analysis, |t| t.0))
        .unwrap_or(Duration::MAX);
    ProcessLimits { time, memory, threads: header.limits.threads() }
}

/// Analyses the jobs, `workers` at once. `progress` gets every record.
pub fn analyse_all(
    jobs: Vec<Job>,
    header: &Header,
    folder: &SweepFolder,
    workers: usize,
    interrupt: &AtomicBool,
    progress: &(dyn Fn(&Record) + Sync),
) -> Result<(), Box<Diagnostic>> {
    let queue = Mutex::new(VecDeque::from(jobs));
    let fault: Mutex<Option<Box<Diagnostic>>> = Mutex::new(None);
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).pop_front();
    let work = || {
        while let Some(job) = next() {
            let stopped = || fault.lock().unwrap_or_else(PoisonError::into_inner).is_some();
            if interrupt.load(Ordering::Relaxed) || stopped() {
                return;
            }
            let record = match found(&job, folder) {
                Some(record) => Ok(Some(record)),
                None => analyse(&job, header, folder, interrupt),
            };
            let written = record.and_then(|r| match r {
                Some(record) => folder.write_analysed(&record).map(|()| progress(&record)),
                None => Ok(()),
            });
            if let Err(d) = written {
                *fault.lock().unwrap_or_else(PoisonError::into_inner) = Some(d);
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..workers.max(1) {
            scope.spawn(work);
        }
    });
    fault.into_inner().unwrap_or_else(PoisonError::into_inner).map_or(Ok(()), Err)
}
