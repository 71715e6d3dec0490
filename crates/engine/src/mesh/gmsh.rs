//! Runs gmsh as a separate process: asks for its version, runs it under a time limit, reads its
//! log.
//!
//! gmsh may print errors, continue, and exit with success. The exit code alone is therefore no
//! evidence of success.

use super::mesher_command::find_gmsh;
use super::mesher_error::{MesherError, OLDEST};
pub use super::process::Until;
use super::process::{answer, run_logged};
use std::ffi::OsString;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

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
        Self::find_until(Until::default())
    }

    /// The same within limits.
    pub fn find_until(until: Until) -> Result<Self, MesherError> {
        Self::asked(find_gmsh()?, until)
    }

    /// Uses the given command, after asking for its version.
    pub fn with_command(command: Vec<OsString>) -> Result<Self, MesherError> {
        Self::asked(command, Until::default())
    }

    fn asked(command: Vec<OsString>, until: Until) -> Result<Self, MesherError> {
        let version = ask_version(&command, until)?;
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
        let (status, text) = run_logged(&self.command, arguments, dir, log_name, limit, interrupt)?;
        let errors = error_lines(&text);
        if !status.success() || !errors.is_empty() {
            return Err(MesherError::failed(status, &errors, &text));
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

fn ask_version(command: &[OsString], until: Until) -> Result<String, MesherError> {
    let text = answer(command, "--version", until)?;
    text.lines()
        .map(str::trim)
        .find(|l| l.starts_with(|c: char| c.is_ascii_digit()) && l.contains('.'))
        .map(str::to_string)
        .ok_or_else(|| MesherError::no_version(command, "--version", &text))
}
