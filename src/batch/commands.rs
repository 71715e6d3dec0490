//! The steps of `bracket batch`: plan, run, status, merge.

use super::analysing::{Chain, Open, Work};
use super::cache::Cache;
use super::capacity::fill;
use super::checking::{check_all, runs_of};
use super::choice::{self, Decision};
use super::choice_table;
use super::chosen_joints;
use super::counts::Counts;
use super::forecast::{TimeLeft, seconds};
use super::merged::merged;
use super::part::Part;
use super::plan::Plan;
use super::results_table::{csv, jsonl, rows};
use super::row::{Outcome, Record};
use super::screen::Kit;
use super::shard::Shard;
use super::slurm::Array;
use super::summary;
use super::summary_sheet;
use super::sweep::CaseLimits;
use super::sweep_file::SweepFile;
use super::sweep_folder::{SweepFolder, write_whole};
use super::work_folder::clear_work;
use crate::driver::interrupt::Interrupt;
use crate::driver::meshing::find_mesher;
use crate::driver::printing;
use bracket_base::diag::{Diagnostic, Diagnostics, ExitStatus, visible};
use bracket_engine::analysis::memory::room;
use bracket_joint::spec::connection::Language;
use bracket_report::console::log::Log;
use bracket_report::console::pace::about;
use bracket_report::document::markdown::markdown;
use bracket_report::document::section;
use bracket_report::figures::bracket as bracket_of;
use bracket_report::pdf;
use bracket_report::sheet::sweep::SUMMARY_PDF;
use bracket_report::words::Words;
use serde::Deserialize;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

/// Effect of the first Ctrl-C, as the log announces it.
const WHEN_INTERRUPTED: &str =
    "the cases in work end now; what is finished stays, and the same command continues";

/// Cases with an unexpected verdict that are listed.
const SHOWN: usize = 20;

/// Cases of each outcome without a result that are listed with their reasons.
const SHOWN_WITHOUT_RESULT: usize = 3;

/// Memory of a case where neither the user nor the system gives a number \[bytes\].
const USUAL_MEMORY: u64 = 4 << 30;

/// Groups of a choice that are listed on the console.
const MOST_GROUPS: usize = 20;

/// The capacity tables and the chosen joints as Markdown.
const TABLES: &str = "tables.md";

/// The rows as a column file.
const COLUMNS: &str = "results.parquet";

/// The chosen joints.
const CHOSEN: &str = "chosen.csv";

/// How a sweep is run.
#[derive(Clone, Debug)]
pub struct RunOptions {
    /// The part to run.
    pub shard: Shard,
    /// Processes side by side; `None`: as many as the processors allow.
    pub jobs: Option<usize>,
    /// Folder of results that several sweeps share.
    pub cache: Option<PathBuf>,
}

/// Version of the mesher; empty if no case is meshed.
fn mesher_version(
    meshes: bool,
    interrupt: &Interrupt,
    log: &Arc<Log>,
) -> Result<String, Diagnostics> {
    Ok(if meshes { find_mesher(interrupt, None, log)?.version } else { String::new() })
}

/// Plans a sweep into a folder.
pub fn plan(
    sweep: &Path,
    catalog: Option<&Path>,
    folder: &SweepFolder,
    interrupt: &Interrupt,
    log: &Arc<Log>,
) -> Result<Plan, Diagnostics> {
    let start = Instant::now();
    let file = SweepFile::read(sweep, catalog)?;
    let mesher = mesher_version(file.meshes(), interrupt, log)?;
    file.catalog
        .warnings()
        .iter()
        .for_each(|w| log.line(crate::driver::spec_file::catalog_warning(w)));
    // conditions on the outcome are checked before hours of work
    let expect: Vec<String> =
        file.sweep.value.expect.iter().map(|e| e.text().to_string()).collect();
    Counts::default().broken(&expect)?;
    let place = file.sweep.index.place("choose.least");
    let plan = Plan::new(sweep, file, &mesher)?;
    if let Some(choose) = &plan.header.choose {
        choice::check(&plan, &plan.header.kit(&mesher)?, choose)
            .map_err(|d| Diagnostic { place, ..*d })?;
        choice::remark(&plan, choose).iter().for_each(|r| log.line(format!("remark: {r}")));
    }
    folder.write_plan(&plan)?;
    let dropped = match plan.header.dropped {
        0 => String::new(),
        n => format!(", {n} combinations dropped by `where`"),
    };
    log.line(format!(
        "plan: {}{dropped}, {:.1} s",
        Counts::cases(plan.cases.len()),
        start.elapsed().as_secs_f64()
    ));
    plan.remarks.iter().for_each(|r| log.line(format!("remark: {r}")));
    Ok(plan)
}

/// Runs the open cases of a shard; an interrupt leaves them open.
pub fn run(
    plan: &Plan,
    folder: &SweepFolder,
    options: RunOptions,
    interrupt: &Interrupt,
    log: &Arc<Log>,
) -> Result<(), Diagnostics> {
    let header = &plan.header;
    let kit = header.kit(&mesher_version(header.meshes(), interrupt, log)?)?;
    interrupt.begin(log, WHEN_INTERRUPTED, || {});
    let part = Part::new(plan, &kit, options.shard);
    if header.first.is_some() {
        let start = Instant::now();
        let mut done = 0;
        let mut progress = |records: &[Record]| {
            done += records.len();
            log.stage(format!("checks: {done} of {}", Counts::cases(plan.cases.len())));
        };
        let runs = runs_of(folder, plan, &part);
        check_all(folder, plan, &kit, &runs, &interrupt.flag(), &mut progress)?;
        let seconds = start.elapsed().as_secs_f64();
        log.line(format!("checks: {}, {seconds:.1} s", Counts::cases(done)));
    }
    if interrupt.asked() {
        return Ok(());
    }
    let (workers, memory) = side_by_side(&header.limits, options.jobs, log)?;
    let chains = Open { folder, plan, kit: &kit, part: &part, memory }.chains()?;
    if chains.is_empty() {
        return Ok(());
    }
    let total: usize = chains.iter().map(|c| c.jobs.len()).sum();
    // a chain may end before its last job
    let most = if header.choose.is_some() { "at most " } else { "" };
    let all = plan.cases.len();
    let workers = workers.min(chains.len());
    let forecasts = chains.iter().flat_map(|c| &c.jobs).map(|j| j.forecast);
    let longest = chains.iter().map(Chain::seconds).fold(0.0, f64::max);
    let time = about(TimeLeft::new(forecasts).seconds(workers).max(longest));
    log.line(format!(
        "finite elements: {most}{total} of {}, {workers} at once, {time}",
        Counts::cases(all)
    ));
    let done: Mutex<usize> = Mutex::default();
    let progress = |record: &Record, left: f64| {
        let mut done = done.lock().unwrap_or_else(PoisonError::into_inner);
        *done += 1;
        let name = plan.cases.iter().find(|c| c.key == record.key).map_or("", |c| c.name.as_str());
        let seconds = record.seconds.map_or_else(String::new, |s| format!(", {s:.0} s"));
        let bracket = record.loads.iter().filter_map(|l| Some((l.lower?, l.upper?)));
        let least = bracket.min_by(|a, b| a.0.total_cmp(&b.0));
        let bracket = least.map_or_else(String::new, |(l, u)| {
            let (low, up) = bracket_of(l, u, 3);
            format!(", load factor {low} to {up}")
        });
        let word = record.outcome.plain();
        let left = if left > 0.0 { format!("; {most}{} left", about(left)) } else { String::new() };
        log.line(format!("{} of {most}{total}: {name}: {word}{bracket}{seconds}{left}", *done));
    };
    clear_work(folder);
    let cache = options.cache.as_deref().map(|path| Cache::at(path, log)).transpose()?;
    let work = Work {
        header,
        folder,
        cache: cache.as_ref(),
        workers,
        interrupt: &interrupt.flag(),
        progress: &progress,
    };
    work.all(chains)?;
    Ok(())
}

/// How many cases with finite elements are done side by side, and the memory of each \[bytes\].
/// What the user gives each of them is added up: their sum must fit into the machine.
fn side_by_side(
    limits: &CaseLimits,
    asked: Option<usize>,
    log: &Log,
) -> Result<(usize, u64), Diagnostics> {
    let threads = limits.threads() as usize;
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let workers = asked.unwrap_or((processors / threads.max(1)).max(1));
    let machine = room(None).map(|r| r.bytes);
    let share = machine.map_or(USUAL_MEMORY, |m| m / workers as u64);
    let memory = limits.memory(share)?;
    let fit = machine.map_or(workers, |m| (m / memory.max(1)) as usize).clamp(1, workers);
    if fit < workers {
        let [each, all] = [memory, machine.unwrap_or(0)].map(|b| b >> 20);
        log.line(format!(
            "{fit} at once in place of {workers}: each may take {each} MiB, {all} MiB are free"
        ));
    }
    Ok((fit, memory))
}

/// The catalogue and templates, where merging needs the names of the template.
fn naming_kit(plan: &Plan) -> Result<Option<Kit>, Diagnostics> {
    let header = &plan.header;
    let needed = header.choose.is_some()
        || !header.tables.is_empty()
        || !header.expansion.derived.is_empty();
    if needed { header.kit(&header.mesher).map(Some) } else { Ok(None) }
}

/// Counts what is finished.
pub fn status(plan: &Plan, folder: &SweepFolder) -> Result<Counts, Diagnostics> {
    Ok(Counts::of(&merged(folder, plan, naming_kit(plan)?.as_ref())?, plan))
}

/// The job array for the cases of a plan.
pub fn slurm_array(plan: &Plan, tasks: Option<usize>) -> Result<Array, Diagnostics> {
    let header = &plan.header;
    let kit = header.kit(&header.mesher)?;
    let cases = seconds(plan, &kit);
    let longest =
        header.limits.time.map_or_else(|| 2.0 * cases.iter().copied().fold(0.0, f64::max), |t| t.0);
    // a group of a choice is done by one task
    let parts = match &header.choose {
        Some(choose) => choice::groups(plan, choose)
            .iter()
            .map(|g| g.cases.iter().map(|i| cases[*i]).sum())
            .collect(),
        None => cases,
    };
    let memory = header.limits.memory(USUAL_MEMORY)?;
    Ok(Array::new(&parts, longest, tasks, memory, header.limits.threads()))
}

/// A merged sweep.
#[derive(Clone, Debug)]
pub struct Merge {
    /// Numbers of cases.
    pub counts: Counts,
    /// What the user expected and did not come true.
    pub broken: Vec<String>,
    /// The exit status of the sweep.
    pub status: ExitStatus,
}

/// Merges the records into the tables, and reports what became of the sweep.
pub fn merge(plan: &Plan, folder: &SweepFolder, log: &Log) -> Result<Merge, Diagnostics> {
    let kit = naming_kit(plan)?;
    let merged = merged(folder, plan, kit.as_ref())?;
    let records = &merged.records;
    let counts = Counts::of(&merged, plan);
    let conditions = counts.broken(&plan.header.expect)?.into_iter().map(str::to_owned);
    let broken: Vec<String> = conditions.chain(unexpected(plan, records)).collect();
    let header = &plan.header;
    let rows = rows(plan, &merged, kit.as_ref());
    let path = folder.path();
    write_whole(&path.join("results.csv"), &csv(&rows)?)?;
    write_whole(&path.join("results.jsonl"), jsonl(&rows).as_bytes())?;
    #[cfg(feature = "parquet")]
    write_whole(&path.join(COLUMNS), &super::parquet_table::parquet(&rows)?)?;
    // that of another build would be out of date
    #[cfg(not(feature = "parquet"))]
    let _ = std::fs::remove_file(path.join(COLUMNS));
    let mut tables = Vec::new();
    if let Some(kit) = &kit {
        tables.extend(header.tables.iter().map(|t| fill(t, plan, kit, records)));
    }
    let mut choice = None;
    if let Some(choose) = &plan.header.choose {
        let joints = match &kit {
            Some(kit) => chosen_joints::write(plan, &merged, kit, folder, log)?,
            None => vec![None; merged.decisions.len()],
        };
        let rows = choice_table::rows(plan, &merged, &joints);
        write_whole(&path.join(CHOSEN), &csv(&rows)?)?;
        let shown = choice_table::shown(&rows, choose.least.text(), plan.header.then.is_some());
        choice = Some(shown);
    }
    if choice.is_none() {
        chosen_joints::remove(folder);
    }
    // those of an earlier plan
    let no_tables = tables.is_empty() && choice.is_none();
    let stale = [(TABLES, no_tables), (CHOSEN, choice.is_none())];
    for (name, _) in stale.into_iter().filter(|(_, stale)| *stale) {
        let _ = std::fs::remove_file(path.join(name));
    }
    if !no_tables {
        let english = Words::default();
        let blocks = section(&english, |doc| {
            choice.iter().for_each(|c| c.write(doc));
            tables.iter().for_each(|t| t.write(doc));
        });
        write_whole(&path.join(TABLES), visible(&markdown(&blocks)).as_bytes())?;
    }
    let of_base = plan.header.expansion.base["project"]["title"].as_str();
    let sweep = &plan.header.sweep;
    let of_file = || sweep.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let title = of_base.map_or_else(of_file, str::to_owned);
    let project = &header.expansion.base["project"];
    let language = Language::deserialize(&project["language"]).unwrap_or_default();
    let words = Words::new(language);
    let page = summary::page((&title, &words), &counts, &broken, choice.as_ref(), &tables, &rows);
    write_whole(&path.join("summary.html"), page.as_bytes())?;
    if cfg!(feature = "pdf") {
        let sheet = summary_sheet::sheet(
            &title,
            project,
            &words,
            &counts,
            &broken,
            (choice.as_ref(), &tables),
            &rows,
        );
        match pdf::summary(sheet, &words).and_then(printing::pdf) {
            Ok(bytes) => write_whole(&path.join(SUMMARY_PDF), &bytes)?,
            Err(fault) => log.line(format!("warning: {}", fault.message)),
        }
    }
    tables.iter().filter(|t| t.is_empty()).for_each(|t| {
        let (title, what) = (&t.title, &t.what);
        log.line(format!("the table `{title}` is empty: no load case has a capacity of {what}"));
    });
    without_result(plan, records).iter().for_each(|l| log.line(l.clone()));
    log.line(format!("{}: {}", Counts::cases(counts.all()), counts.words()));
    if let Some(shown) = &choice {
        shown.lines(MOST_GROUPS).iter().for_each(|l| log.line(l.clone()));
    }
    for condition in &broken {
        log.line(format!("expected, and not so: {condition}"));
    }
    log.line(format!("result: {}", path.join("summary.html").display()));
    // conditions on the groups replace the rule that every group has its joint
    let of_groups = |e: &String| e.contains("chosen") || e.contains("groups");
    let expects = match &plan.header.choose {
        Some(_) => plan.header.expect.iter().any(of_groups),
        None => !plan.header.expect.is_empty() || expected(plan).next().is_some(),
    };
    let status = match broken.is_empty() {
        false => ExitStatus::NotOk,
        // what the user expects replaces the verdicts, but no case may be without one
        true if expects => counts.without_verdict(),
        // of a group only the chosen joint must hold
        true if plan.header.choose.is_some() => {
            counts.with_verdicts(merged.decisions.iter().map(Decision::outcome))
        }
        true => counts.status(),
    };
    Ok(Merge { counts, broken, status })
}

/// The first cases without a result, with the reason, and how many more there are.
fn without_result(plan: &Plan, records: &[Option<Record>]) -> Vec<String> {
    let mut left = Outcome::ALL.map(|_| 0usize);
    let mut out = Vec::new();
    for (case, record) in plan.cases.iter().zip(records) {
        let Some(record) = record.as_ref().filter(|r| r.outcome >= Outcome::TimedOut) else {
            continue;
        };
        let seen = &mut left[record.outcome as usize];
        *seen += 1;
        if *seen <= SHOWN_WITHOUT_RESULT {
            let word = record.outcome.plain();
            let cause = record.cause.as_deref().unwrap_or("no reason is known");
            out.push(format!("{word}: {}: {cause}", case.name));
        }
    }
    for outcome in Outcome::ALL {
        let more = left[outcome as usize].saturating_sub(SHOWN_WITHOUT_RESULT);
        if more > 0 {
            let word = outcome.plain();
            out.push(format!("{word}: {more} more, see results.csv"));
        }
    }
    out
}

/// The cases with an expected verdict, by their position in the plan.
fn expected(plan: &Plan) -> impl Iterator<Item = (usize, Outcome)> {
    plan.cases.iter().enumerate().filter_map(|(i, case)| {
        let steps = plan.header.expansion.steps(case.index);
        Some((i, Outcome::of(steps.iter().find_map(|s| s.expect)?)))
    })
}

/// The cases whose verdict is not the expected one, as sentences; the first ones and their number.
fn unexpected(plan: &Plan, records: &[Option<Record>]) -> Vec<String> {
    let found = |i: usize| records[i].as_ref().map(|r| r.outcome);
    let wrong = expected(plan).filter(|(i, want)| found(*i).is_some_and(|f| f != *want));
    let mut out: Vec<String> = wrong
        .map(|(i, want)| {
            let found = found(i).map_or("open", Outcome::word);
            format!("{}: {}, found {found}", plan.cases[i].name, want.word())
        })
        .collect();
    let more = out.len().saturating_sub(SHOWN);
    if more > 0 {
        out.truncate(SHOWN);
        out.push(format!("{more} more cases"));
    }
    out
}
