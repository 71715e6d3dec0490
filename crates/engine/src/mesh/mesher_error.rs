//! Failures of the mesher gmsh and of the remesher Mmg: their processes and their files.

use bracket_base::diag::{Diagnostic, Diagnostics};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitStatus;

/// Environment variable with the mesher's command: words separated by blanks, or a JSON list of
/// words.
pub const VARIABLE: &str = "BRACKET_GMSH";

/// The same for the remesher.
pub const REMESHER_VARIABLE: &str = "BRACKET_MMG";

/// Oldest supported version of gmsh; the scripts are written for it.
pub const OLDEST: (u32, u32) = (4, 8);

/// Failure of the mesher's process or of its files.
#[derive(Debug, thiserror::Error)]
pub enum MesherError {
    /// No command was found.
    #[error(
        "the mesher gmsh was not found: {VARIABLE} is not set, no .venv with gmsh lies above the \
         current directory or the program, and there is no gmsh on PATH"
    )]
    Missing,
    /// No command of the remesher was found.
    #[error(
        "the remesher Mmg was not found: {REMESHER_VARIABLE} is not set, no .venv with mmgpy lies \
         above the current directory or the program, and there is no mmg3d_O3 on PATH"
    )]
    NoRemesher,
    /// The environment variable does not contain a valid command.
    #[error("{variable} is `{value}`, which is neither words nor a JSON list of words")]
    BadVariable {
        /// Its name.
        variable: &'static str,
        /// Its value.
        value: String,
    },
    /// The command does not start.
    #[error("the mesher `{command}` does not start: {source}")]
    Start {
        /// The command.
        command: String,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// The command starts but does not report its version.
    #[error("the mesher `{command}` does not answer `{question}`: {answer}")]
    NoVersion {
        /// The command.
        command: String,
        /// The argument that asks for the version.
        question: &'static str,
        /// Its answer.
        answer: String,
    },
    /// The version is too old.
    #[error("the mesher is gmsh {found}, at least {}.{} is needed", OLDEST.0, OLDEST.1)]
    TooOld {
        /// Its version.
        found: String,
    },
    /// The mesher exceeded the time limit and was stopped.
    #[error("meshing was stopped after {seconds:.0} s, the time limit")]
    TimeLimit {
        /// The limit \[s\].
        seconds: f64,
    },
    /// The user asked to stop.
    #[error(
        "interrupted while meshing: it was stopped after {seconds:.0} s and nothing was \
         written"
    )]
    Interrupted {
        /// Duration of the run \[s\].
        seconds: f64,
    },
    /// The mesher ended itself by a fault of its own.
    #[error("the mesher crashed on this geometry with these element sizes (signal {signal})")]
    Crashed {
        /// The signal.
        signal: i32,
    },
    /// A signal from outside killed the mesher.
    #[error(
        "the mesher was killed by signal {signal} after {seconds:.0} s{}",
        if *signal == 9 { " (out of memory?)" } else { "" }
    )]
    Killed {
        /// The signal.
        signal: i32,
        /// Duration of the run \[s\].
        seconds: f64,
    },
    /// The mesher reported errors, or ended with an exit code other than 0.
    #[error(
        "the mesher failed{}: {said}",
        code.map_or(String::new(), |c| format!(" (exit code {c})"))
    )]
    Failed {
        /// Its exit code, if not 0.
        code: Option<i32>,
        /// Its first error lines. They are quoted because the log is deleted with the working
        /// folder.
        said: String,
    },
    /// The mesher ended without an error but left no usable file.
    #[error("the mesher ended without error but left no usable {what}: {why}")]
    NoOutput {
        /// `mesh` or `STEP file`.
        what: &'static str,
        /// Reason: absent, empty or truncated.
        why: String,
    },
    /// The remesher's mesh does not fill the same bodies.
    #[error("the remesher changed the bodies: {why}")]
    OtherBody {
        /// What differs.
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
        /// Error of the operating system.
        source: std::io::Error,
    },
}

impl MesherError {
    /// The error for an answer without a version.
    pub(super) fn no_version(command: &[OsString], question: &'static str, answer: &str) -> Self {
        let answer = answer
            .lines()
            .last()
            .map_or("it printed nothing".into(), |l| format!("`{}`", l.trim()));
        MesherError::NoVersion { command: shown(command), question, answer }
    }

    /// The error for a run that failed: its first error lines, or the last line of its log.
    pub(super) fn failed(status: ExitStatus, errors: &[String], log: &str) -> Self {
        let said = match (errors.is_empty(), log.lines().rfind(|l| !l.trim().is_empty())) {
            (false, _) => errors[..errors.len().min(3)].join("; "),
            (true, Some(last)) => last.trim().to_string(),
            (true, None) => "it printed nothing".to_string(),
        };
        MesherError::Failed { code: status.code().filter(|c| *c != 0), said }
    }

    /// The error for a failed write; a full disk has its own variant.
    pub fn write(file: impl Into<PathBuf>, source: std::io::Error) -> Self {
        use std::io::ErrorKind as K;
        let file = final_path(&file.into());
        match source.kind() {
            K::StorageFull | K::QuotaExceeded | K::FileTooLarge => MesherError::DiskFull { file },
            _ => MesherError::Write { file, source },
        }
    }
}

/// The final path of a file: `joint/mesh.msh` for `joint.part/mesh.msh`, since folders are written
/// under a temporary name and then renamed.
pub(super) fn final_path(path: &Path) -> PathBuf {
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
        let doctor =
            "run `bracket doctor`: it reports what is found and how to install what is missing"
                .to_string();
        let (code, help) = match &error {
            E::Missing | E::NoRemesher => ("mesher/missing", doctor),
            E::BadVariable { variable, .. } => (
                "mesher/variable",
                format!(
                    "set {variable} to a command, for example `[\"python\", \"gmsh\"]`, or unset \
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
            E::Crashed { .. } => (
                "mesher/crashed",
                "choose other element sizes: `--size-factor 0.9`, or a smaller \
                 `analysis.mesh.size`"
                    .into(),
            ),
            E::Killed { .. } => (
                "mesher/killed",
                "free memory, or ask for a larger `analysis.mesh.size`; then run again".into(),
            ),
            E::Failed { .. } => (
                "mesher/failed",
                "try other element sizes (`--size-factor 0.9`, or `analysis.mesh.size`); if it \
                 fails again, `bracket doctor` reports what is wrong with the mesher"
                    .into(),
            ),
            E::NoOutput { .. } => (
                "mesher/no-output",
                "check that the disk is not full; then run `bracket doctor`".into(),
            ),
            E::OtherBody { .. } => (
                "mesher/other-body",
                "the meshes that were made before count; give other element sizes for better ones"
                    .into(),
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

/// A command as one line of text.
pub(super) fn shown(command: &[OsString]) -> String {
    command.iter().map(|w| w.to_string_lossy()).collect::<Vec<_>>().join(" ")
}
