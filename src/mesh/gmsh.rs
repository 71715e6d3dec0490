//! gmsh as a separate process: finding it, running it under a time limit, reading its log.
//!
//! gmsh prints errors, goes on, and exits with success; nothing here trusts an exit code alone.

use crate::diag::{Diagnostic, Diagnostics};
use std::ffi::OsString;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Environment variable with the mesher's command: words separated by blanks, or a JSON list of
/// words.
pub const VARIABLE: &str = "BRACKET_GMSH";

/// Oldest version the scripts are written for.
pub const OLDEST: (u32, u32) = (4, 8);

/// What can go wrong with the mesher's process.
#[derive(Debug, thiserror::Error)]
pub enum MesherError {
    /// No command was found.
    #[error(
        "the mesher gmsh was not found: {VARIABLE} is not set, no .venv with gmsh lies above the \
         current directory or the program, and there is no gmsh on PATH"
    )]
    Missing,
    /// The environment variable cannot be read as a command.
    #[error("{VARIABLE} is `{value}`, which is neither words nor a JSON list of words")]
    BadVariable {
        /// Its value.
        value: String,
    },
    /// The command does not start.
    #[error("the mesher `{command}` does not start: {source}")]
    Start {
        /// The command.
        command: String,
        /// The system's reason.
        source: std::io::Error,
    },
    /// It starts but does not tell its version.
    #[error("the mesher `{command}` does not answer `--version`: {answer}")]
    NoVersion {
        /// The command.
        command: String,
        /// What it said.
        answer: String,
    },
    /// Too old.
    #[error("the mesher is gmsh {found}, at least {}.{} is needed", OLDEST.0, OLDEST.1)]
    TooOld {
        /// Its version.
        found: String,
    },
    /// It ran longer than allowed and was stopped.
    #[error("the mesher was stopped after {seconds:.0} s, the time limit")]
    TimeLimit {
        /// The limit \[s\].
        seconds: f64,
    },
    /// The user asked to stop.
    #[error(
        "interrupted while meshing: the mesher was stopped after {seconds:.0} s and nothing was \
         written"
    )]
    Interrupted {
        /// How long it ran \[s\].
        seconds: f64,
    },
    /// Something killed it.
    #[error("the mesher was killed by signal {signal} after {seconds:.0} s{}", if *signal == 9 { " (out of memory?)" } else { "" })]
    Killed {
        /// The signal.
        signal: i32,
        /// How long it ran \[s\].
        seconds: f64,
    },
    /// It reported errors, or ended with an exit code other than 0.
    #[error("the mesher failed{}: {said}", code.map_or(String::new(), |c| format!(" (exit code {c})")))]
    Failed {
        /// Its exit code, when it is not 0.
        code: Option<i32>,
        /// Its first error lines. The log itself goes with the working folder, so it is quoted, not
        /// named.
        said: String,
    },
    /// It ended well and left no usable file.
    #[error("the mesher ended without error but left no usable {what}: {why}")]
    NoOutput {
        /// `mesh` or `STEP file`.
        what: &'static str,
        /// Absent, empty or cut off.
        why: String,
    },
    /// The disk is full.
    #[error("no space is left on the disk for `{}`", file.display())]
    DiskFull {
        /// The file being written.
        file: PathBuf,
    },
    /// A file cannot be written.
    #[error("`{}` cannot be written: {source}", file.display())]
    Write {
        /// The file.
        file: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
}

impl MesherError {
    /// A failed write; a full disk is told apart.
    pub fn write(file: impl Into<PathBuf>, source: std::io::Error) -> Self {
        use std::io::ErrorKind as K;
        let file = whole(&file.into());
        match source.kind() {
            K::StorageFull | K::QuotaExceeded | K::FileTooLarge => MesherError::DiskFull { file },
            _ => MesherError::Write { file, source },
        }
    }
}

/// The path as the user knows it: `joint/mesh.msh` for `joint.part/mesh.msh`, which is written
/// aside and renamed.
fn whole(path: &Path) -> PathBuf {
    let ours = |word: &str| {
        word.rfind(".part").filter(|i| word[i + 5..].bytes().all(|b| b.is_ascii_digit()))
    };
    path.components()
        .map(|c| match c.as_os_str().to_str().and_then(|w| Some((w, ours(w)?))) {
            Some((word, end)) => OsString::from(&word[..end]),
            None => c.as_os_str().to_os_string(),
        })
        .collect()
}

impl From<MesherError> for Diagnostic {
    fn from(error: MesherError) -> Self {
        use MesherError as E;
        let doctor = "run `bracket doctor`: it says what is found and how to get what is missing"
            .to_string();
        let (code, help) = match &error {
            E::Missing => ("mesher/missing", doctor),
            E::BadVariable { .. } => (
                "mesher/variable",
                format!(
                    "set {VARIABLE} to a command, for example `[\"python\", \"gmsh\"]`, or unset \
                     it"
                ),
            ),
            E::Start { .. } => ("mesher/start", doctor),
            E::NoVersion { .. } => ("mesher/version", doctor),
            E::TooOld { .. } => ("mesher/old", doctor),
            E::TimeLimit { .. } => (
                "mesher/time",
                "allow more time (`analysis.time_limit`), or a larger `analysis.mesh.size`".into(),
            ),
            E::Interrupted { .. } => {
                let help = "run the same command again when there is time for it";
                return Diagnostic::undecided("mesher/interrupted", error.to_string()).help(help);
            }
            E::Killed { .. } => (
                "mesher/killed",
                "free memory, or ask for a larger `analysis.mesh.size`; then run again".into(),
            ),
            E::Failed { .. } => (
                "mesher/failed",
                "try other element sizes (`--size-factor 0.9`, or `analysis.mesh.size`); if it \
                 fails again, `bracket doctor` tells what is wrong with the mesher"
                    .into(),
            ),
            E::NoOutput { .. } => (
                "mesher/no-output",
                "check that the disk is not full; then run `bracket doctor`".into(),
            ),
            E::DiskFull { .. } => {
                ("mesher/disk", "free some space, or write elsewhere with `--out`".into())
            }
            E::Write { .. } => (
                "mesher/write",
                "check the folder and the right to write there, or use `--out`".into(),
            ),
        };
        Diagnostic::environment(code, error.to_string()).help(help)
    }
}

impl From<MesherError> for Diagnostics {
    fn from(error: MesherError) -> Self {
        Diagnostic::from(error).into()
    }
}

/// The mesher: a command as a list of words, and the version it answered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mesher {
    /// Program and first arguments.
    pub command: Vec<OsString>,
    /// For example `4.15.2`.
    pub version: String,
}

impl Mesher {
    /// Looks for gmsh (environment variable, project-local venv, PATH) and asks its version.
    pub fn find() -> Result<Self, MesherError> {
        Self::with_command(find_command()?)
    }

    /// Uses this command, after asking its version.
    pub fn with_command(command: Vec<OsString>) -> Result<Self, MesherError> {
        let version = ask_version(&command)?;
        let mut numbers = version.split('.').map(|w| w.parse::<u32>().unwrap_or(0));
        if (numbers.next().unwrap_or(0), numbers.next().unwrap_or(0)) < OLDEST {
            return Err(MesherError::TooOld { found: version });
        }
        Ok(Self { command, version })
    }

    /// Runs it in `dir` with `arguments`, its talk going to `dir/log_name`; returns the log's text.
    ///
    /// The process is killed, with all it has started, when `limit` has passed or `interrupt` is
    /// set. Every error line of the log is a failure, whatever the exit code.
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
            return Err(MesherError::DiskFull { file: whole(dir) });
        }
        if let Some(signal) = killed_by(&status) {
            return Err(MesherError::Killed { signal, seconds: started.elapsed().as_secs_f64() });
        }
        let errors = error_lines(&text);
        if !status.success() || !errors.is_empty() {
            let said = match (errors.is_empty(), text.lines().rfind(|l| !l.trim().is_empty())) {
                (false, _) => errors.into_iter().take(3).collect::<Vec<_>>().join("; "),
                (true, Some(last)) => last.trim().to_string(),
                (true, None) => "it said nothing".to_string(),
            };
            let code = status.code().filter(|c| *c != 0);
            return Err(MesherError::Failed { code, said });
        }
        Ok(text)
    }
}

/// The error lines of a log, and the warning that bodies got lost.
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

/// In a process group of its own: a Ctrl-C in the terminal reaches us alone, and we end the mesher
/// with all it has started (a wrapper's gmsh too).
#[cfg(unix)]
fn alone(command: &mut Command) -> &mut Command {
    std::os::unix::process::CommandExt::process_group(command, 0)
}

#[cfg(not(unix))]
fn alone(command: &mut Command) -> &mut Command {
    command
}

/// Kills a child and, where it leads a group of its own, the group.
fn kill(child: &mut Child) -> std::io::Result<()> {
    #[cfg(unix)]
    {
        use nix::sys::signal::{Signal, killpg};
        use nix::unistd::{Pid, getpgid};
        let pid = Pid::from_raw(child.id().cast_signed());
        // only the child of `alone` leads a group: another's is our own
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
    /// It was killed because the time was over.
    TimeLimit,
    /// It was killed because the user asked to stop.
    Interrupted,
}

/// Waits at most `limit`, and no longer than the user wants.
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
    // 4.8 answers on standard error, later versions on standard output. The answer is short: the
    // pipes cannot fill.
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
                text.lines().last().map_or("it said nothing".into(), |l| format!("`{}`", l.trim())),
            )
        })
}

/// Environment variable, then a project-local venv, then PATH.
fn find_command() -> Result<Vec<OsString>, MesherError> {
    if let Some(value) = std::env::var_os(VARIABLE).filter(|v| !v.is_empty()) {
        return parse_command(&value.to_string_lossy());
    }
    let exe = std::env::current_exe().ok();
    let starts = [
        std::env::current_dir().ok(),
        exe.as_deref().and_then(Path::parent).map(Path::to_path_buf),
    ];
    for start in starts.into_iter().flatten() {
        for dir in start.ancestors() {
            let bin = dir.join(".venv").join("bin");
            let (python, gmsh) = (bin.join("python"), bin.join("gmsh"));
            if python.exists() && gmsh.exists() {
                return Ok(vec![python.into(), gmsh.into()]);
            }
        }
    }
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path)
        .map(|dir| dir.join("gmsh"))
        .find(|p| p.is_file())
        .map(|p| command_of_file(&p))
        .ok_or(MesherError::Missing)
}

/// The words of the environment variable.
fn parse_command(value: &str) -> Result<Vec<OsString>, MesherError> {
    let bad = || MesherError::BadVariable { value: value.to_string() };
    let words: Vec<String> = if value.trim_start().starts_with('[') {
        serde_json::from_str(value).map_err(|_| bad())?
    } else {
        value.split_whitespace().map(str::to_string).collect()
    };
    if words.first().is_none_or(|w| w.is_empty()) {
        return Err(bad());
    }
    Ok(words.into_iter().map(OsString::from).collect())
}

/// The wheel's `gmsh` is a Python script that asks `env` for a Python: without an activated venv it
/// gets the wrong one. The Python beside it is the right one.
fn command_of_file(gmsh: &Path) -> Vec<OsString> {
    let mut head = [0u8; 64];
    let n = File::open(gmsh).and_then(|mut f| f.read(&mut head)).unwrap_or(0);
    let first = String::from_utf8_lossy(&head[..n]);
    let python = gmsh.with_file_name("python3");
    if first.starts_with("#!")
        && first.lines().next().is_some_and(|l| l.contains("python"))
        && python.exists()
    {
        vec![python.into(), gmsh.into()]
    } else {
        vec![gmsh.into()]
    }
}
