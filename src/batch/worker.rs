//! One case with finite elements in a process of its own. A crash, a hanging mesher or an exhausted
//! memory limit ends that case and no other.

use super::plan::Header;
use super::row::{LoadRow, Outcome, Record};
use super::screen::first_end;
use super::sweep_folder::{SweepFolder, write_whole};
use super::work_folder::{own, work_folder};
use crate::driver::interrupt::END_WITH_PARENT;
use bracket_base::diag::Diagnostic;
use bracket_base::yaml;
use bracket_codes::judgement::Governing;
use bracket_engine::analysis::memory::resident_of;
use bracket_report::result::demand::{ActionValue, Demand};
use bracket_report::result::result_file::{Quantity, RESULT_FILE, ResultFile};
use serde_json::Value;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Time after the request to stop at which a process is killed.
const GRACE: Duration = Duration::from_secs(20);

/// Time within which a signal to a whole group has reached every process of it.
const ECHO: Duration = Duration::from_millis(200);

/// Interval at which a process is looked at.
const LOOK: Duration = Duration::from_millis(100);

/// Result folder in a folder of work.
pub const RESULT: &str = "result";

/// Limits of a process.
#[derive(Clone, Copy, Debug)]
pub struct ProcessLimits {
    /// Wall time.
    pub time: Duration,
    /// Memory \[bytes\].
    pub memory: u64,
    /// Threads.
    pub threads: u32,
}

/// A case to be analysed.
#[derive(Clone, Debug)]
pub struct Job {
    /// Key of the case.
    pub key: String,
    /// Its spec.
    pub spec: Value,
    /// The record of its checks; absent where the sweep has no checks.
    pub checked: Option<Record>,
    /// Only limit analysis, in place of `analysis.kind`.
    pub limit: bool,
    /// Limits of its process.
    pub limits: ProcessLimits,
    /// Forecast of its time \[s\].
    pub forecast: f64,
}

/// How a process ended.
enum End {
    Exit(ExitStatus),
    TimeLimit,
    Memory,
    Interrupted,
}

/// Analyses a case; `None` if the user interrupted.
pub fn analyse(
    job: &Job,
    header: &Header,
    folder: &SweepFolder,
    interrupt: &AtomicBool,
) -> Result<Option<Record>, Box<Diagnostic>> {
    let work = work_folder(folder, &job.key);
    let start = Instant::now();
    let found = run(job, header, &work, interrupt).and_then(|end| match end {
        End::Interrupted => Ok(None),
        end => {
            let mut record = outcome(job, &end, &work);
            record.seconds = Some(start.elapsed().as_secs_f64());
            let place = folder.case_folder(&job.key);
            keep(&work.join(RESULT), &place)?;
            // another process may have been faster: the record is that of the result that stays
            let whole = record.result && record.outcome != Outcome::TimedOut;
            if let (true, Some(kept)) = (whole, found(job, folder)) {
                record = Record { seconds: record.seconds, ..kept };
            }
            Ok(Some(record))
        }
    });
    let _ = fs::remove_dir_all(&work);
    found
}

/// The record of a case whose result is in its place already.
pub fn found(job: &Job, folder: &SweepFolder) -> Option<Record> {
    Some(finished(job, &read_result(&folder.case_folder(&job.key))?))
}

/// Moves a result into its place. Where another process was faster, its result stays.
pub fn keep(made: &Path, place: &Path) -> Result<(), Box<Diagnostic>> {
    if !made.join(RESULT_FILE).is_file() {
        return Ok(());
    }
    let fault = |e: std::io::Error| {
        let message = format!("cannot make `{}`: {e}", place.display());
        let help = "free the disk or the folder and run the same command again";
        Box::new(Diagnostic::environment("sweep/io", message).file(place).help(help))
    };
    if let Some(parent) = place.parent() {
        fs::create_dir_all(parent).map_err(fault)?;
    }
    match fs::rename(made, place) {
        Err(e) if !place.join(RESULT_FILE).is_file() => Err(fault(e)),
        _ => Ok(()),
    }
}

/// Starts the process and waits for its end.
fn run(
    job: &Job,
    header: &Header,
    work: &Path,
    interrupt: &AtomicBool,
) -> Result<End, Box<Diagnostic>> {
    let spec = work.join("joint.yaml");
    let text =
        yaml::to_string(&absolute(job.spec.clone(), &header.folder)).map_err(|f| f.into_first())?;
    write_whole(&spec, text.as_bytes())?;
    own(work, &[std::process::id()])?;
    let program = std::env::current_exe().map_err(|e| {
        Diagnostic::environment("sweep/program", format!("the program does not find itself: {e}"))
    })?;
    let start_fault = |e: std::io::Error| {
        let message = format!("a case cannot be started: {e}");
        let help = "run again: finished cases stay";
        Box::new(Diagnostic::environment("sweep/start", message).help(help))
    };
    let log = fs::File::create(work.join("stderr")).map_err(start_fault)?;
    let mut arguments: Vec<OsString> = vec!["run".into(), spec.into()];
    let mut option = |name: &str, value: OsString| arguments.extend([name.into(), value]);
    option("--out", work.join(RESULT).into());
    option("--threads", job.limits.threads.to_string().into());
    option("--memory-limit", format!("{}MiB", job.limits.memory >> 20).into());
    option("--format", "json".into());
    if job.limit {
        option("--kind", "limit".into());
    }
    if let Some(catalog) = &header.catalog {
        option("--catalog", catalog.into());
    }
    arguments.push("--quiet".into());
    let mut command = Command::new(program);
    command.args(arguments).env(END_WITH_PARENT, std::process::id().to_string());
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(log);
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    let mut child = command.spawn().map_err(start_fault)?;
    // without the second process the next one does not wait for its end
    let _ = own(work, &[std::process::id(), child.id()]);
    wait(&mut child, job.limits, interrupt).map_err(start_fault)
}

/// The spec with absolute paths of its template and catalogue, so that it may stand anywhere.
pub fn absolute(mut spec: Value, folder: &Path) -> Value {
    let is_path = bracket_joint::assembly::template_file::is_path;
    for (key, always) in [("template", false), ("catalog", true)] {
        if let Some(Value::String(path)) = spec.get_mut(key)
            && (always || is_path(path))
        {
            *path = folder.join(&*path).to_string_lossy().into_owned();
        }
    }
    spec
}

fn wait(child: &mut Child, limits: ProcessLimits, interrupt: &AtomicBool) -> std::io::Result<End> {
    let start = Instant::now();
    let mut asked: Option<(Instant, bool)> = None;
    let mut family = Vec::new();
    loop {
        if let Some(status) = child.try_wait()? {
            // the mesher of a process that crashed would work on
            kill_all(&family);
            if let Some((_, stop)) = asked {
                return Ok(if stop { End::Interrupted } else { End::TimeLimit });
            }
            // schedulers signal this process and its cases together
            std::thread::sleep(ECHO);
            let stop = interrupt.load(Ordering::Relaxed);
            return Ok(if stop { End::Interrupted } else { End::Exit(status) });
        }
        family = descendants(child.id());
        let memory =
            family.iter().map(|pid| resident_of(*pid)).sum::<u64>() + resident_of(child.id());
        if memory > limits.memory {
            kill(child, &family)?;
            return Ok(End::Memory);
        }
        let stop = interrupt.load(Ordering::Relaxed);
        match asked {
            None if stop || start.elapsed() >= limits.time => {
                ask(child);
                asked = Some((Instant::now(), stop));
            }
            Some((at, _)) if at.elapsed() >= GRACE => kill(child, &family)?,
            _ => {}
        }
        std::thread::sleep(LOOK);
    }
}

/// The processes that a process has started, and those that they have started.
fn descendants(pid: u32) -> Vec<u32> {
    let mut out = Vec::new();
    let mut open = vec![pid];
    while let Some(pid) = open.pop() {
        let Ok(tasks) = fs::read_dir(format!("/proc/{pid}/task")) else { continue };
        for task in tasks.flatten() {
            let text = fs::read_to_string(task.path().join("children")).unwrap_or_default();
            let children: Vec<u32> =
                text.split_whitespace().filter_map(|w| w.parse().ok()).collect();
            open.extend(&children);
            out.extend(children);
        }
    }
    out
}

/// Asks a process to end; it then writes what is certified.
fn ask(child: &mut Child) {
    #[cfg(unix)]
    {
        use nix::sys::signal::{Signal, kill};
        let _ = kill(nix::unistd::Pid::from_raw(child.id().cast_signed()), Signal::SIGTERM);
    }
    #[cfg(not(unix))]
    {
        let _ = child.kill();
    }
}

/// Kills a process and those that it has started.
fn kill(child: &mut Child, family: &[u32]) -> std::io::Result<()> {
    kill_all(family);
    child.kill()?;
    child.wait()?;
    kill_all(family);
    Ok(())
}

/// Kills processes that may have ended already.
fn kill_all(family: &[u32]) {
    #[cfg(unix)]
    for pid in family {
        use nix::sys::signal::{Signal, kill};
        let _ = kill(nix::unistd::Pid::from_raw(pid.cast_signed()), Signal::SIGKILL);
    }
}

/// The record of an ended case.
fn outcome(job: &Job, end: &End, work: &Path) -> Record {
    let result = read_result(&work.join(RESULT));
    let message = message(&work.join("stderr"));
    let without = |outcome, cause: String| Record {
        loads: job.checked.as_ref().map_or_else(Vec::new, |c| c.loads.clone()),
        mass: job.checked.as_ref().and_then(|c| c.mass),
        bolts: job.checked.as_ref().and_then(|c| c.bolts),
        ..Record::without_result(&job.key, outcome, cause)
    };
    match (end, result) {
        (End::Memory, _) => {
            let limit = job.limits.memory >> 20;
            without(Outcome::Failed, format!("it needed more than its {limit} MiB of memory"))
        }
        (End::TimeLimit, None) => {
            let limit = job.limits.time.as_secs();
            without(Outcome::TimedOut, format!("no result within its {limit} s"))
        }
        (End::TimeLimit, Some(result)) => {
            let mut record = finished(job, &result);
            if record.outcome == Outcome::Undecided {
                record.outcome = Outcome::TimedOut;
            }
            record
        }
        (_, Some(result)) => finished(job, &result),
        (End::Exit(status), None) => match status.code() {
            Some(2) => without(Outcome::BadInput, message.unwrap_or_else(|| "bad input".into())),
            Some(3) => without(
                Outcome::Undecided,
                message.unwrap_or_else(|| "no certificate within the limits".into()),
            ),
            Some(code) => without(
                Outcome::Failed,
                message.unwrap_or_else(|| format!("the process ended with exit code {code}")),
            ),
            None => without(Outcome::Failed, format!("the process was ended: {status}")),
        },
        (End::Interrupted, None) => without(Outcome::Undecided, "interrupted".into()),
    }
}

fn read_result(folder: &Path) -> Option<ResultFile> {
    let text = fs::read_to_string(folder.join(RESULT_FILE)).ok()?;
    ResultFile::from_json(&text).ok()
}

/// The first fault that the process reported.
fn message(stderr: &PathBuf) -> Option<String> {
    let text = fs::read_to_string(stderr).ok()?;
    let fault = text.lines().find_map(|l| serde_json::from_str::<Value>(l).ok())?;
    let path = fault["place"]["path"].as_str().map(|p| format!("{p}: ")).unwrap_or_default();
    Some(format!("{path}{}", fault["message"].as_str()?))
}

/// The record of a case with a result.
fn finished(job: &Job, result: &ResultFile) -> Record {
    let mut record = job.checked.clone().unwrap_or_else(|| {
        let mut r = Record::without_result(&job.key, Outcome::Undecided, "");
        r.cause = None;
        r
    });
    record.result = true;
    record.outcome = Outcome::of(result.verdict);
    record.cause = result.judgement.as_ref().map(|j| j.reason.to_string());
    let factors = result.cases.iter().filter(|c| c.quantity == Quantity::LoadFactor);
    for c in factors {
        let Some(demand) = &c.demand else { continue };
        // those that the verdict is based on: strict, with friction the lower one without it
        let (lower, upper) = c.factor_bounds();
        let first = first_end(demand.component_method.iter());
        let at = record.loads.iter().position(|l| l.case == c.name);
        let judged = result.load_cases.iter().find(|l| l.case == c.name);
        let judgement = judged.map(|l| &l.judgement).or(result.judgement.as_ref());
        let row = LoadRow {
            case: c.name.clone(),
            verdict: demand.verdict,
            route: demand.route,
            by_code: demand.by_code,
            by_analysis: demand.by_analysis,
            lower,
            upper,
            brittle: demand.brittle.is_some(),
            governing: governing(result, &c.name),
            moment_resistance: first.map(|m| m.resistance),
            component_factor: first.and_then(|m| m.factor),
            component_stiffness: at.and_then(|i| record.loads[i].component_stiffness),
            actions: match at {
                Some(i) => record.loads[i].actions,
                None => first.and_then(|m| given(demand, &m.end)),
            },
            end: match at {
                Some(i) => record.loads[i].end.clone(),
                None => first.map(|m| m.end.clone()),
            },
            reason: judgement.and_then(LoadRow::reason),
        };
        match at {
            Some(i) => record.loads[i] = row,
            None => record.loads.push(row),
        }
    }
    record
}

/// N, V and M of a member end as the case gives them.
fn given(demand: &Demand, end: &str) -> Option<[f64; 3]> {
    let of = |name: &str| {
        let mine = demand.actions.iter().filter(|a| a.end == end && a.action == name);
        mine.map(|a| match a.value {
            ActionValue::Force(v) | ActionValue::Moment(v) => v,
        })
        .sum::<f64>()
    };
    demand.actions.iter().any(|a| a.end == end).then(|| ["N", "Vz", "My"].map(of))
}

/// What governs a result, if it is of this load case.
fn governing(result: &ResultFile, case: &str) -> Option<Governing> {
    let governing = result.judgement.as_ref()?.governing.clone()?;
    governing.case.as_ref().is_none_or(|c| c == case).then_some(governing)
}
