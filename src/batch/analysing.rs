//! The finite elements of the cases of a shard, several processes side by side.

use super::case::Case;
use super::choice;
use super::forecast::time_limit;
use super::plan::{Header, Plan};
use super::row::{Outcome, Record};
use super::screen::Kit;
use super::shard::Shard;
use super::sweep::{Choose, Who};
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

/// Jobs that are done one after another.
#[derive(Clone, Debug)]
pub struct Chain {
    /// The jobs.
    pub jobs: Vec<Job>,
    /// Whether the first joint that holds ends the chain: the dearer ones are not needed.
    pub first_that_holds: bool,
}

impl Chain {
    /// The longest time that the chain can take \[s\].
    fn seconds(&self) -> f64 {
        self.jobs.iter().map(|j| j.limits.time.as_secs_f64()).sum()
    }
}

/// The work with finite elements of a shard that has no record yet, the longest chain first.
/// `memory`: the memory of each job \[bytes\].
pub fn chains(
    folder: &SweepFolder,
    plan: &Plan,
    kit: &Kit,
    shard: Shard,
    memory: u64,
) -> Result<Vec<Chain>, Diagnostics> {
    let mut chains = match &plan.header.choose {
        Some(choose) => of_groups(folder, plan, kit, choose, shard, memory)?,
        None => of_cases(folder, plan, kit, shard, memory)?,
    };
    // a stable sort: equal chains keep the order of the plan
    chains.sort_by(|a, b| b.seconds().total_cmp(&a.seconds()));
    Ok(chains)
}

/// A chain of its own for every case.
fn of_cases(
    folder: &SweepFolder,
    plan: &Plan,
    kit: &Kit,
    shard: Shard,
    memory: u64,
) -> Result<Vec<Chain>, Diagnostics> {
    let header = &plan.header;
    let mut seen = BTreeSet::new();
    let mut chains = Vec::new();
    let runs = folder.runs(&plan.cases);
    for run in shard.of(&runs) {
        let records = match header.first {
            Some(_) => folder.checked(run)?,
            None => None,
        };
        for (i, case) in run.iter().enumerate() {
            let checked = records.as_ref().map(|r| &r[i]);
            let asked = match (checked, header.then) {
                (Some(record), Some(then)) => wanted(then.limit, record),
                (None, _) => header.first.is_none(),
                (Some(_), None) => false,
            };
            if !asked || !seen.insert(&case.key) || answered(folder, case)?.is_some() {
                continue;
            }
            let jobs = vec![job(plan, kit, case, checked, memory)?];
            chains.push(Chain { jobs, first_that_holds: false });
        }
    }
    Ok(chains)
}

/// A chain for every group of the choice: its candidates from the cheapest upward, up to the first
/// that is known to hold.
fn of_groups(
    folder: &SweepFolder,
    plan: &Plan,
    kit: &Kit,
    choose: &Choose,
    shard: Shard,
    memory: u64,
) -> Result<Vec<Chain>, Diagnostics> {
    let checked = folder.all_checked(&plan.cases)?;
    let mut chains = Vec::new();
    for group in shard.of(&choice::groups(plan, choose)) {
        let mut jobs = Vec::new();
        for c in choice::candidates(group, plan, kit, choose, &checked) {
            if !c.analyse {
                break;
            }
            let case = &plan.cases[c.case];
            match answered(folder, case)? {
                Some(record) if record.outcome == Outcome::Ok => break,
                Some(_) => {}
                None => jobs.push(job(plan, kit, case, checked[c.case].as_ref(), memory)?),
            }
        }
        if !jobs.is_empty() {
            chains.push(Chain { jobs, first_that_holds: true });
        }
    }
    Ok(chains)
}

/// The answer of finite elements to a case. What gave no result is tried again: the machine or the
/// limits may be others now.
fn answered(folder: &SweepFolder, case: &Case) -> Result<Option<Record>, Box<Diagnostic>> {
    Ok(folder.analysed(&case.key)?.filter(Record::is_final))
}

fn job(
    plan: &Plan,
    kit: &Kit,
    case: &Case,
    checked: Option<&Record>,
    memory: u64,
) -> Result<Job, Box<Diagnostic>> {
    let header = &plan.header;
    let mut spec = kit.spec(&header.expansion, case.index)?;
    title(&mut spec, &case.name);
    let limits = process_limits(header, &spec, memory);
    let limit = header.then.is_some();
    Ok(Job { key: case.key.clone(), spec, checked: checked.cloned(), limit, limits })
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

/// Does the chains, `workers` at once. `progress` gets every record.
pub fn analyse_all(
    chains: Vec<Chain>,
    header: &Header,
    folder: &SweepFolder,
    workers: usize,
    interrupt: &AtomicBool,
    progress: &(dyn Fn(&Record) + Sync),
) -> Result<(), Box<Diagnostic>> {
    let queue = Mutex::new(VecDeque::from(chains));
    let fault: Mutex<Option<Box<Diagnostic>>> = Mutex::new(None);
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).pop_front();
    let stopped = || {
        let failed = || fault.lock().unwrap_or_else(PoisonError::into_inner).is_some();
        interrupt.load(Ordering::Relaxed) || failed()
    };
    let one = |job: &Job| -> Result<Option<Outcome>, Box<Diagnostic>> {
        let record = match found(job, folder) {
            Some(record) => Some(record),
            None => analyse(job, header, folder, interrupt)?,
        };
        let Some(record) = record else { return Ok(None) };
        folder.write_analysed(&record)?;
        progress(&record);
        Ok(Some(record.outcome))
    };
    let work = || {
        while let Some(chain) = next() {
            for job in &chain.jobs {
                if stopped() {
                    return;
                }
                match one(job) {
                    Ok(Some(Outcome::Ok)) if chain.first_that_holds => break,
                    Ok(_) => {}
                    Err(d) => {
                        *fault.lock().unwrap_or_else(PoisonError::into_inner) = Some(d);
                    }
                }
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
