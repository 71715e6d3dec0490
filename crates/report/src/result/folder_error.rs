//! Reasons why an output folder cannot be written, and what to do next.

use crate::result::result_file::RESULT_FILE;
use bracket_base::diag::Diagnostic;
use std::io;
use std::path::PathBuf;

/// Reason why a result folder cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum FolderError {
    /// The target exists and is not a result of this program.
    #[error(
        "`{}` exists and is not a result folder of this program ({why}); it was left as it is",
        path.display()
    )]
    NotOurs {
        /// The target.
        path: PathBuf,
        /// The reason.
        why: String,
    },
    /// The target exists and was not written by the subcommand that wants to replace it.
    #[error(
        "`{}` exists and was not written by `bracket {command}` ({why}); it was left as it is",
        path.display()
    )]
    NotOf {
        /// The target.
        path: PathBuf,
        /// The subcommand.
        command: &'static str,
        /// The reason.
        why: String,
    },
    /// The target is the current folder or contains it.
    #[error("`{}` is the current folder or holds it, and cannot be replaced", path.display())]
    StandingInside {
        /// The target.
        path: PathBuf,
    },
    /// Another run writes to the same target.
    #[error("another run is writing to `{}`", path.display())]
    Busy {
        /// The part folder.
        path: PathBuf,
    },
    /// A folder with the name of the part exists and is not of this program.
    #[error("`{}` is in the way and is not an unfinished result of this program", path.display())]
    InTheWay {
        /// The part folder.
        path: PathBuf,
    },
    /// A name inside the folder that would leave it.
    #[error("`{name}` is not the name of a file inside a result folder")]
    Name {
        /// The name.
        name: String,
    },
    /// The folder does not contain a valid `result.json` yet.
    #[error("the unfinished result has no usable {RESULT_FILE}: {why}")]
    Incomplete {
        /// The fault.
        why: String,
    },
    /// The operating system refused.
    #[error("cannot {action} `{}`: {source}", path.display())]
    Io {
        /// The attempted action.
        action: &'static str,
        /// Its path.
        path: PathBuf,
        /// Error of the operating system.
        source: io::Error,
    },
}

impl From<FolderError> for bracket_base::diag::Diagnostics {
    fn from(e: FolderError) -> Self {
        Diagnostic::from(e).into()
    }
}

impl From<FolderError> for Diagnostic {
    fn from(e: FolderError) -> Self {
        let text = e.to_string();
        match e {
            FolderError::NotOurs { path, .. } => Diagnostic::input("report/folder-exists", text)
                .file(path)
                .help("choose another folder with --out, or move this one away"),
            FolderError::NotOf { path, .. } => Diagnostic::input("cli/out-exists", text)
                .file(path)
                .help("choose another folder with `--out`, or move this one away"),
            FolderError::StandingInside { path } => {
                Diagnostic::input("report/folder-current", text)
                    .file(path)
                    .help("choose another folder with --out")
            }
            FolderError::Busy { path } => Diagnostic::input("report/folder-busy", text)
                .file(path)
                .help("wait for the other run, or choose another folder with --out"),
            FolderError::InTheWay { path } => Diagnostic::input("report/folder-in-the-way", text)
                .file(path)
                .help("move it away or choose another --out"),
            FolderError::Name { .. } => Diagnostic::input("report/file-name", text)
                .help("rename the load case: letters, digits, `-`, `_` and `.` make a file name"),
            FolderError::Incomplete { .. } => Diagnostic::undecided("report/incomplete", text)
                .help("no result was written; please report this fault"),
            FolderError::Io { path, source, .. } => {
                let (code, help) = match source.kind() {
                    io::ErrorKind::StorageFull
                    | io::ErrorKind::QuotaExceeded
                    | io::ErrorKind::FileTooLarge => (
                        "report/disk-full",
                        "free some space or choose a folder on another disk with --out; nothing \
                         was left behind",
                    ),
                    io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
                        ("report/read-only", "choose a folder you may write to with --out")
                    }
                    _ => (
                        "report/io",
                        "check the path and the disk, or choose another folder with --out",
                    ),
                };
                Diagnostic::environment(code, text).file(path).help(help)
            }
        }
    }
}
