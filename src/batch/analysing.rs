//! The finite elements of the cases of a shard, several processes side by side.

use super::cache::Cache;
use super::case::Case;
use super::choice::{self, Decider};
use super::chosen_joints::title;
use super::forecast::{TimeLeft, elements, time_limit};
use super::part::Part;
use super::plan::{Header, Plan};
use super::row::{Outcome, Record};
use super::screen::Kit;
use super::sweep::Choose;
use super::sweep_folder::SweepFolder;
use super::worker::{Job, ProcessLimits, analyse, found};
use bracket_base::diag::{Diagnostic, Diagnostics};
use std::collections::{BTreeSet, VecDeque};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Time limit of a case whose analysis has none \[s\].
const LONGEST: f64 = 7200.0;

/// Time beyond twice the time limit of the analysis \[s\]: meshing, pictures, report.
const SLACK: f64 = 300.0;

/// Jobs that are done one after another.
#[derive(Clone, Debug)]
pub struct Chain {
    /// The jobs.
    pub jobs: Vec<Job>,
    /// Whether the first joint that holds ends the chain: the dearer ones are not needed.
    pub first_that_holds: bool,
}

impl Chain {
    /// Forecast of the time that the chain takes at most \[s\].
    pub fn seconds(&self) -> f64 {
        self.jobs.iter().map(|j| j.forecast).sum()
    }
}

/// What a part of a sweep has to analyse.
pub struct Open<'a> {
    /// The folder of the sweep.
    pub folder: &'a SweepFolder,
    /// Its plan.
    pub plan: &'a Plan,
    /// Catalogue and templates.
    pub kit: &'a Kit,
    /// The part.
    pub part: &'a Part,
    /// Memory of each job \[bytes\].
    pub memory: u64,
}

impl Open<'_> {
    /// The work with finite elements that has no record yet, the longest chain first.
    pub fn chains(&self) -> Result<Vec<Chain>, Diagnostics> {
        let mut chains = match &self.plan.header.choose {
            Some(choose) => self.of_groups(choose)?,
            None => self.of_cases()?,
        };
        // a stable sort: equal chains keep the order of the plan
        chains.sort_by(|a, b| b.seconds().total_cmp(&a.seconds()));
        Ok(chains)
    }

    /// A chain of its own for every case.
    fn of_cases(&self) -> Result<Vec<Chain>, Diagnostics> {
        let header = &self.plan.header;
        let mut seen = BTreeSet::new();
        let mut chains = Vec::new();
        let runs = self.folder.runs(&self.plan.cases);
        for run in self.part.runs(&runs).into_iter().map(|k| runs[k]) {
            let records = match header.first {
                Some(_) => self.folder.checked(run)?,
                None => None,
            };
            for (i, case) in run.iter().enumerate() {
                let checked = records.as_ref().map(|r| &r[i]);
                let asked = checked.map_or(header.first.is_none(), |r| header.wants(r));
                if !asked || !seen.insert(&case.key) || self.answered(case)?.is_some() {
                    continue;
                }
                let jobs = vec![self.job(case, checked)?];
                chains.push(Chain { jobs, first_that_holds: false });
            }
        }
        Ok(chains)
    }

    /// A chain for every group of the choice: its candidates from the cheapest upward, up to the
    /// first that is known to hold.
    fn of_groups(&self, choose: &Choose) -> Result<Vec<Chain>, Diagnostics> {
        let plan = self.plan;
        let checked = self.folder.all_checked(&plan.cases)?;
        let mut chains = Vec::new();
        for group in &self.part.groups {
            let mut jobs = Vec::new();
            for c in choice::candidates(group, plan, self.kit, choose, &checked) {
                match c.decider {
                    Decider::Checks => break,
                    Decider::Nothing => continue,
                    Decider::Analysis => {}
                }
                let case = &plan.cases[c.case];
                match self.answered(case)? {
                    Some(record) if record.outcome == Outcome::Ok => break,
                    Some(_) => {}
                    None => jobs.push(self.job(case, checked[c.case].as_ref())?),
                }
            }
            if !jobs.is_empty() {
                chains.push(Chain { jobs, first_that_holds: true });
            }
        }
        Ok(chains)
    }

    /// The answer of finite elements to a case. What gave no result is tried again: the machine or
    /// the limits may be others now.
    fn answered(&self, case: &Case) -> Result<Option<Record>, Box<Diagnostic>> {
        Ok(self.folder.analysed(&case.key)?.filter(Record::is_final))
    }

    fn job(&self, case: &Case, checked: Option<&Record>) -> Result<Job, Box<Diagnostic>> {
        let header = &self.plan.header;
        let mut spec = self.kit.spec(&header.expansion, case.index)?;
        title(&mut spec, &case.name);
        let of_analysis = time_limit(&spec, &self.kit.file);
        let limits = process_limits(header, of_analysis, self.memory);
        Ok(Job {
            key: case.key.clone(),
            spec,
            checked: checked.cloned(),
            limit: header.then.is_some(),
            limits,
            forecast: elements(of_analysis).min(limits.time.as_secs_f64()),
        })
    }
}

fn process_limits(header: &Header, of_analysis: Option<f64>, memory: u64) -> ProcessLimits {
    let of_analysis = of_analysis.map_or(LONGEST, |t| 2.0 * t + SLACK);
    let time = Duration::try_from_secs_f64(header.limits.time.map_or(of_analysis, |t| t.0))
        .unwrap_or(Duration::MAX);
    ProcessLimits { time, memory, threads: header.limits.threads() }
}

/// How chains are done.
pub struct Work<'a> {
    /// The sweep.
    pub header: &'a Header,
    /// Its folder.
    pub folder: &'a SweepFolder,
    /// Results that other sweeps have made.
    pub cache: Option<&'a Cache<'a>>,
    /// Cases side by side.
    pub workers: usize,
    /// Set when the user wants to stop.
    pub interrupt: &'a AtomicBool,
    /// Gets every record with the time left \[s\].
    pub progress: &'a (dyn Fn(&Record, f64) + Sync),
}

impl Work<'_> {
    /// Does the chains.
    pub fn all(&self, chains: Vec<Chain>) -> Result<(), Box<Diagnostic>> {
        let forecasts = chains.iter().flat_map(|c| &c.jobs).map(|j| j.forecast);
        let left = Mutex::new(TimeLeft::new(forecasts));
        let queue = Mutex::new(VecDeque::from(chains));
        let fault: Mutex<Option<Box<Diagnostic>>> = Mutex::new(None);
        // the guard must not live as long as the chain
        let next = || locked(&queue).pop_front();
        let work = || {
            while let Some(chain) = next() {
                let mut jobs = chain.jobs.iter();
                for job in jobs.by_ref() {
                    if self.interrupt.load(Ordering::Relaxed) || locked(&fault).is_some() {
                        return;
                    }
                    match self.one(job, &left) {
                        Ok(Some(Outcome::Ok)) if chain.first_that_holds => break,
                        Ok(_) => {}
                        Err(d) => *locked(&fault) = Some(d),
                    }
                }
                // the dearer joints of a group are not needed
                jobs.for_each(|j| locked(&left).ended(j.forecast, None));
            }
        };
        std::thread::scope(|scope| {
            for _ in 0..self.workers.max(1) {
                scope.spawn(work);
            }
        });
        fault.into_inner().unwrap_or_else(PoisonError::into_inner).map_or(Ok(()), Err)
    }

    /// Does a job; `None` if the user interrupted.
    fn one(&self, job: &Job, left: &Mutex<TimeLeft>) -> Result<Option<Outcome>, Box<Diagnostic>> {
        let there = found(job, self.folder)
            .or_else(|| self.cache.and_then(|cache| cache.fetch(job, self.folder)));
        let record = match there {
            Some(record) => record,
            None => {
                let made = analyse(job, self.header, self.folder, self.interrupt)?;
                let Some(record) = made else { return Ok(None) };
                if let Some(cache) = self.cache {
                    cache.store(job, &record, self.folder);
                }
                record
            }
        };
        self.folder.write_analysed(&record)?;
        let seconds = {
            let mut left = locked(left);
            left.ended(job.forecast, record.seconds);
            left.seconds(self.workers)
        };
        (self.progress)(&record, seconds);
        Ok(Some(record.outcome))
    }
}

/// What a mutex guards; a thread that panicked leaves nothing half done.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
