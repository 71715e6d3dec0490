//! Runs a mesher as a separate process: under a time limit, stopped on request, its log kept for
//! messages.

use super::mesher_error::{MesherError, final_path, shown};
use std::ffi::OsString;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// Runs a command in `dir` with `arguments`; returns how it ended and its log, written to
/// `dir/log_name`.
///
/// The process and its children are killed when `limit` has passed or `interrupt` is set.
pub(super) fn run_logged(
    command: &[OsString],
    arguments: &[&str],
    dir: &Path,
    log_name: &str,
    limit: Duration,
    interrupt: Option<&AtomicBool>,
) -> Result<(ExitStatus, String), MesherError> {
    let log_path = dir.join(log_name);
    let log = File::create(&log_path).map_err(|e| MesherError::write(&log_path, e))?;
    let log_too = log.try_clone().map_err(|e| MesherError::write(&log_path, e))?;
    let mut child = alone(&mut process(command))
        .args(arguments)
        .current_dir(dir)
        .stdin(Stdio::null())
        .stdout(log)
        .stderr(log_too)
        .spawn()
        .map_err(|source| MesherError::Start { command: shown(command), source })?;
    let started = Instant::now();
    let end = wait(&mut child, limit, interrupt)
        .map_err(|source| MesherError::Start { command: shown(command), source })?;
    let status = match end {
        End::Exit(status) => status,
        End::TimeLimit => return Err(MesherError::TimeLimit { seconds: limit.as_secs_f64() }),
        End::Interrupted => {
            return Err(MesherError::Interrupted { seconds: started.elapsed().as_secs_f64() });
        }
    };
    let mut bytes = Vec::new();
    File::open(&log_path)
        .and_then(|mut f| f.read_to_end(&mut bytes))
        .map_err(|e| MesherError::write(&log_path, e))?;
    let text = String::from_utf8_lossy(&bytes).into_owned();
    if text.contains("No space left on device") {
        return Err(MesherError::DiskFull { file: final_path(dir) });
    }
    // a shell in front of the program reports its signal as exit code 128 + signal
    let reported = || status.code().map(|code| code - 128);
    if let Some(signal) = killed_by(&status).or_else(reported).filter(|s| FAULTS.contains(s)) {
        return Err(MesherError::Crashed { signal });
    }
    if let Some(signal) = killed_by(&status) {
        return Err(MesherError::Killed { signal, seconds: started.elapsed().as_secs_f64() });
    }
    Ok((status, text))
}

/// SIGABRT, SIGBUS, SIGFPE, SIGSEGV: they come from the program itself.
const FAULTS: [i32; 4] = [6, 7, 8, 11];

/// Longest time for an answer.
const PROBE: Duration = Duration::from_secs(60);

/// What ends a question early.
#[derive(Clone, Copy, Debug, Default)]
pub struct Until<'a> {
    /// Time limit; `None`: a minute, which is also the most.
    pub limit: Option<Duration>,
    /// Set once the user has asked to stop. The command is then in a process group of its own, and
    /// the whole group is killed.
    pub interrupt: Option<&'a AtomicBool>,
}

/// Longest answer that is read \[bytes\].
const LONGEST_ANSWER: u64 = 64 << 10;

/// What a command prints in answer to a question, on both outputs.
pub(super) fn answer(
    command: &[OsString],
    question: &'static str,
    until: Until,
) -> Result<String, MesherError> {
    let mut command_line = process(command);
    if until.interrupt.is_some() {
        alone(&mut command_line);
    }
    let started = Instant::now();
    let limit = until.limit.map_or(PROBE, |l| l.min(PROBE));
    let mut child = command_line
        .arg(question)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|source| MesherError::Start { command: shown(command), source })?;
    let fail =
        |answer: String| MesherError::NoVersion { command: shown(command), question, answer };
    // some versions answer on standard error
    let out = child.stdout.take().map(drained);
    let err = child.stderr.take().map(drained);
    match wait(&mut child, limit, until.interrupt).map_err(|e| fail(e.to_string()))? {
        End::Exit(_) => {}
        End::TimeLimit => {
            return Err(fail(format!("no answer within {} s", limit.as_secs_f64())));
        }
        End::Interrupted => {
            return Err(MesherError::Interrupted { seconds: started.elapsed().as_secs_f64() });
        }
    }
    // a child of the mesher may keep its pipes open
    let said = |text: Receiver<String>| text.recv_timeout(Duration::from_secs(2)).ok();
    Ok([out, err].into_iter().flatten().filter_map(said).collect())
}

/// Reads a pipe to its end on a thread, so that it never fills up and stops the program behind it.
/// Gives the first part of the text.
fn drained(mut pipe: impl Read + Send + 'static) -> Receiver<String> {
    let (send, receive) = channel();
    std::thread::spawn(move || {
        let mut text = Vec::new();
        let _ = pipe.by_ref().take(LONGEST_ANSWER).read_to_end(&mut text);
        let _ = std::io::copy(&mut pipe, &mut std::io::sink());
        // nobody may wait for it any more
        let _ = send.send(String::from_utf8_lossy(&text).into_owned());
    });
    receive
}

fn process(command: &[OsString]) -> Command {
    let mut c = Command::new(command.first().map_or("gmsh".as_ref(), OsString::as_os_str));
    c.args(command.iter().skip(1));
    c
}

/// Puts the command in a process group of its own. Ctrl-C in the terminal then reaches only this
/// process, which ends the mesher and all its children (including the gmsh behind a wrapper). On
/// Linux the command is also killed when this process is, which nothing in this process can do.
/// Must be called on the thread that waits for the child: the kernel watches that thread.
#[cfg(unix)]
fn alone(command: &mut Command) -> &mut Command {
    use std::os::unix::process::CommandExt;
    #[cfg(target_os = "linux")]
    {
        let parent = nix::unistd::getpid();
        let end_with_parent = move || {
            nix::sys::prctl::set_pdeathsig(nix::sys::signal::Signal::SIGKILL)?;
            // no signal comes for a parent that died before it was asked for
            if nix::unistd::getppid() == parent { Ok(()) } else { Err(nix::Error::ESRCH.into()) }
        };
        // SAFETY: between `fork` and `exec` it makes two system calls and allocates nothing
        unsafe { command.pre_exec(end_with_parent) };
    }
    command.process_group(0)
}

#[cfg(not(unix))]
fn alone(command: &mut Command) -> &mut Command {
    command
}

/// Kills a child and, if it leads a process group, the whole group.
fn kill(child: &mut Child) -> std::io::Result<()> {
    #[cfg(unix)]
    {
        use nix::sys::signal::{Signal, killpg};
        use nix::unistd::{Pid, getpgid};
        let pid = Pid::from_raw(child.id().cast_signed());
        // only a child started by `alone` leads a group; any other child is in this process's group
        if getpgid(Some(pid)) == Ok(pid) {
            let _ = killpg(pid, Signal::SIGKILL);
        }
    }
    child.kill()?;
    child.wait().map(|_| ())
}

/// How a child ended.
enum End {
    Exit(ExitStatus),
    /// It was killed because the time limit had passed.
    TimeLimit,
    /// It was killed because the user asked to stop.
    Interrupted,
}

/// Waits until the child ends, `limit` has passed, or the user interrupts.
fn wait(
    child: &mut Child,
    limit: Duration,
    interrupt: Option<&AtomicBool>,
) -> std::io::Result<End> {
    let started = Instant::now();
    let mut pause = Duration::from_millis(2);
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(End::Exit(status));
        }
        if interrupt.is_some_and(|i| i.load(Ordering::Relaxed)) {
            kill(child)?;
            return Ok(End::Interrupted);
        }
        if started.elapsed() >= limit {
            kill(child)?;
            return Ok(End::TimeLimit);
        }
        std::thread::sleep(pause.min(limit.saturating_sub(started.elapsed())));
        pause = (pause * 2).min(Duration::from_millis(50));
    }
}

#[cfg(unix)]
fn killed_by(status: &ExitStatus) -> Option<i32> {
    std::os::unix::process::ExitStatusExt::signal(status)
}

#[cfg(not(unix))]
fn killed_by(_: &ExitStatus) -> Option<i32> {
    None
}
