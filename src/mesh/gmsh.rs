//! Runs gmsh as a separate process: asks for its version, runs it under a time limit, reads its
//! log.
//!
//! gmsh may print errors, continue, and exit with success. The exit code alone is therefore no
//! evidence of success.

use super::mesher_command::find_command;
use super::mesher_error::{MesherError, OLDEST, final_path};
use std::ffi::OsString;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// The mesher: its command as a list of words, and its version.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mesher {
    /// Program and first arguments.
    pub command: Vec<OsString>,
    /// For example `4.15.2`.
    pub version: String,
}

impl Mesher {
    /// Searches for gmsh (environment variable, project-local venv, PATH) and asks for its version.
    pub fn find() -> Result<Self, MesherError> {
        Self::with_command(find_command()?)
    }

    /// Uses the given command, after asking for its version.
    pub fn with_command(command: Vec<OsString>) -> Result<Self, MesherError> {
        let version = ask_version(&command)?;
        let mut numbers = version.split('.').map(|w| w.parse::<u32>().unwrap_or(0));
        if (numbers.next().unwrap_or(0), numbers.next().unwrap_or(0)) < OLDEST {
            return Err(MesherError::TooOld { found: version });
        }
        Ok(Self { command, version })
    }

    /// Runs the mesher in `dir` with `arguments` and returns its log, written to `dir/log_name`.
    ///
    /// The process and its children are killed when `limit` has passed or `interrupt` is set. Any
    /// error line in the log is a failure, whatever the exit code.
    pub fn run(
        &self,
        arguments: &[&str],
        dir: &Path,
        log_name: &str,
        limit: Duration,
        interrupt: Option<&AtomicBool>,
    ) -> Result<String, MesherError> {
        let log_path = dir.join(log_name);
        let log = File::create(&log_path).map_err(|e| MesherError::write(&log_path, e))?;
        let log_too = log.try_clone().map_err(|e| MesherError::write(&log_path, e))?;
        let mut child = alone(&mut process(&self.command))
            .args(arguments)
            .current_dir(dir)
            .stdin(Stdio::null())
            .stdout(log)
            .stderr(log_too)
            .spawn()
            .map_err(|source| MesherError::Start { command: shown(&self.command), source })?;
        let started = Instant::now();
        let end = wait(&mut child, limit, interrupt)
            .map_err(|source| MesherError::Start { command: shown(&self.command), source })?;
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
        if let Some(signal) = killed_by(&status) {
            return Err(MesherError::Killed { signal, seconds: started.elapsed().as_secs_f64() });
        }
        let errors = error_lines(&text);
        if !status.success() || !errors.is_empty() {
            let said = match (errors.is_empty(), text.lines().rfind(|l| !l.trim().is_empty())) {
                (false, _) => errors.into_iter().take(3).collect::<Vec<_>>().join("; "),
                (true, Some(last)) => last.trim().to_string(),
                (true, None) => "it printed nothing".to_string(),
            };
            let code = status.code().filter(|c| *c != 0);
            return Err(MesherError::Failed { code, said });
        }
        Ok(text)
    }
}

/// The error lines of a log, and its warnings of lost bodies.
fn error_lines(log: &str) -> Vec<String> {
    log.split(['\n', '\r'])
        .map(str::trim)
        .filter(|l| l.starts_with("Error") || l.contains("Skipping unknown volume"))
        .map(|l| l.trim_start_matches("Error").trim_start_matches([' ', ':']).to_string())
        .collect()
}

fn process(command: &[OsString]) -> Command {
    let mut c = Command::new(command.first().map_or("gmsh".as_ref(), OsString::as_os_str));
    c.args(command.iter().skip(1));
    c
}

fn shown(command: &[OsString]) -> String {
    command.iter().map(|w| w.to_string_lossy()).collect::<Vec<_>>().join(" ")
}

/// Puts the command in a process group of its own. Ctrl-C in the terminal then reaches only this
/// process, which ends the mesher and all its children (including the gmsh behind a wrapper).
#[cfg(unix)]
fn alone(command: &mut Command) -> &mut Command {
    std::os::unix::process::CommandExt::process_group(command, 0)
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

fn ask_version(command: &[OsString]) -> Result<String, MesherError> {
    let mut child = process(command)
        .arg("--version")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|source| MesherError::Start { command: shown(command), source })?;
    let fail = |answer: String| MesherError::NoVersion { command: shown(command), answer };
    let end = wait(&mut child, Duration::from_secs(60), None).map_err(|e| fail(e.to_string()))?;
    if !matches!(end, End::Exit(_)) {
        return Err(fail("no answer within 60 s".into()));
    }
    // version 4.8 answers on standard error, later versions on standard output; the answer is too
    // short to fill the pipes
    let mut text = String::new();
    if let Some(mut out) = child.stdout.take() {
        let _ = out.read_to_string(&mut text);
    }
    if let Some(mut err) = child.stderr.take() {
        let _ = err.read_to_string(&mut text);
    }
    text.lines()
        .map(str::trim)
        .find(|l| l.starts_with(|c: char| c.is_ascii_digit()) && l.contains('.'))
        .map(str::to_string)
        .ok_or_else(|| {
            fail(
                text.lines()
                    .last()
                    .map_or("it printed nothing".into(), |l| format!("`{}`", l.trim())),
            )
        })
}
