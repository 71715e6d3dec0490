//! `bracket doctor`.

use super::common::{CommandResult, Common, Format};
use bracket_base::diag::ExitStatus;
use bracket_engine::mesh::gmsh::Mesher;
use bracket_engine::mesh::mesher_error::{REMESHER_VARIABLE, VARIABLE};
use bracket_engine::mesh::mmg::Remesher;
use bracket_joint::catalog::Catalog;
use bracket_report::console::out;
use serde::Serialize;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// Report what this machine has and what is missing.
#[derive(Debug, clap::Args)]
pub struct DoctorArgs {}

/// State of a requirement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
enum Status {
    /// Present and sufficient.
    Ok,
    /// Absent, but not needed on this machine.
    Optional,
    /// Absent or insufficient; a run would fail.
    Missing,
}

/// One line of the output.
#[derive(Debug, Serialize)]
struct Finding {
    item: &'static str,
    status: Status,
    /// What was found.
    found: String,
    /// The remedy, if one is needed.
    #[serde(skip_serializing_if = "Option::is_none")]
    cure: Option<String>,
}

impl Finding {
    fn ok(item: &'static str, found: impl Into<String>) -> Self {
        Self { item, status: Status::Ok, found: found.into(), cure: None }
    }

    fn lacking(
        item: &'static str,
        status: Status,
        found: impl Into<String>,
        cure: impl Into<String>,
    ) -> Self {
        Self { item, status, found: found.into(), cure: Some(cure.into()) }
    }
}

/// Least free memory for the smallest useful run \[MiB\].
const LEAST_MEMORY: u64 = 1024;

/// Least free disk space for one result folder \[MiB\].
const LEAST_DISK: u64 = 512;

/// Advice on installing the mesher.
const SETUP: &str = "run scripts/setup.sh in the project's folder";

/// Runs `bracket doctor`.
pub fn run(_args: &DoctorArgs, common: &Common) -> CommandResult {
    let here = std::env::current_dir().unwrap_or_else(|_| PathBuf::from("."));
    let mesher = mesher();
    let venv = venv(&here, mesher.status == Status::Ok);
    let threads = threads(common.threads);
    let findings = vec![mesher, remesher(), venv, threads, memory(), disk(&here), catalogue()];
    let healthy = findings.iter().all(|f| f.status != Status::Missing);
    match common.format {
        Format::Json => {
            let version = env!("CARGO_PKG_VERSION");
            out::json(
                &serde_json::json!({ "version": version, "ok": healthy, "findings": findings }),
            )?;
        }
        Format::Text => out::text(&page(&findings))?,
    }
    Ok(if healthy { ExitStatus::Ok } else { ExitStatus::Environment })
}

fn page(findings: &[Finding]) -> String {
    let rows: Vec<Vec<String>> = findings
        .iter()
        .map(|f| {
            let status = match f.status {
                Status::Ok => "ok",
                Status::Optional => "optional",
                Status::Missing => "MISSING",
            };
            vec![f.item.to_owned(), status.to_owned(), f.found.clone()]
        })
        .collect();
    let mut text = out::columns(&["item", "status", "found"], &rows);
    for f in findings {
        if let Some(cure) = &f.cure {
            text += &format!("{}: {cure}\n", f.item);
        }
    }
    text
}

fn mesher() -> Finding {
    match Mesher::find() {
        Ok(m) => Finding::ok("mesher", format!("gmsh {}: {}", m.version, words(&m.command))),
        Err(error) => {
            let cure = cure(VARIABLE, "gmsh");
            Finding::lacking("mesher", Status::Missing, error.to_string(), cure)
        }
    }
}

/// Without the remesher users' meshes are refined by bisection, so it may be absent.
fn remesher() -> Finding {
    match Remesher::find() {
        Ok(m) => Finding::ok("remesher", format!("Mmg {}: {}", m.version, words(&m.command))),
        Err(error) => {
            let cure = cure(REMESHER_VARIABLE, "mmg3d");
            Finding::lacking("remesher", Status::Optional, error.to_string(), cure)
        }
    }
}

fn words(command: &[OsString]) -> String {
    command.iter().map(|w| w.to_string_lossy()).collect::<Vec<_>>().join(" ")
}

/// Advice for a command that was not found.
fn cure(variable: &str, program: &str) -> String {
    match std::env::var_os(variable) {
        Some(_) => format!("correct or unset {variable}; without it, {SETUP}"),
        None => format!("{SETUP}, or set {variable} to the command of {program}"),
    }
}

/// The environment that `scripts/setup.sh` creates, searched in the folders above the current
/// folder or above the program.
fn venv(here: &Path, mesher_found: bool) -> Finding {
    let program = std::env::current_exe().unwrap_or_default();
    let folder = here
        .ancestors()
        .chain(program.ancestors())
        .map(|d| d.join(".venv"))
        .find(|v| v.join("bin").is_dir());
    match folder {
        Some(folder) => Finding::ok("venv", folder.display().to_string()),
        None if mesher_found => {
            Finding::lacking("venv", Status::Optional, "none; the mesher is found elsewhere", SETUP)
        }
        None => Finding::lacking(
            "venv",
            Status::Missing,
            "no .venv above the current folder or the program",
            SETUP,
        ),
    }
}

fn threads(asked: Option<usize>) -> Finding {
    let have = std::thread::available_parallelism().map_or(1, usize::from);
    match asked {
        Some(n) if n > have => Finding::lacking(
            "threads",
            Status::Optional,
            format!("{have}, fewer than the {n} asked for"),
            format!("use --threads {have}; more threads than processors do not help"),
        ),
        _ => Finding::ok("threads", have.to_string()),
    }
}

fn memory() -> Finding {
    let info = std::fs::read_to_string("/proc/meminfo").unwrap_or_default();
    let limit = ["/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"]
        .iter()
        .find_map(|f| std::fs::read_to_string(f).ok()?.trim().parse::<u64>().ok());
    judge_memory(&info, limit.map(|bytes| bytes >> 20))
}

/// Judges the memory from the text of `/proc/meminfo` and the container's limit \[MiB\].
fn judge_memory(info: &str, limit: Option<u64>) -> Finding {
    let mib = |key: &str| {
        let line = info.lines().find(|l| l.starts_with(key))?;
        line.split_whitespace().nth(1)?.parse::<u64>().ok().map(|kib| kib >> 10)
    };
    let (Some(total), Some(free)) = (mib("MemTotal:"), mib("MemAvailable:")) else {
        let cure = format!(
            "make sure that about {LEAST_MEMORY} MiB are free for small models, 8 GiB for fine \
             ones"
        );
        return Finding::lacking("memory", Status::Optional, "unknown (no /proc/meminfo)", cure);
    };
    let total = limit.map_or(total, |l| l.min(total));
    let free = free.min(total);
    let found = format!("{free} MiB free of {total} MiB");
    if free < LEAST_MEMORY {
        let cure = format!(
            "close programs or use a larger machine: at least {LEAST_MEMORY} MiB must be free"
        );
        return Finding::lacking("memory", Status::Missing, found, cure);
    }
    Finding::ok("memory", found)
}

fn disk(here: &Path) -> Finding {
    let answer = std::process::Command::new("df").arg("-Pk").arg("--").arg(here).output();
    judge_disk(&answer.map(|a| String::from_utf8_lossy(&a.stdout).into_owned()).unwrap_or_default())
}

/// Judges the disk space from the output of `df -Pk FOLDER`.
fn judge_disk(answer: &str) -> Finding {
    // the mount point may contain blanks; the free space is the fourth word and comes before it
    let free = answer
        .lines()
        .nth(1)
        .and_then(|l| l.split_whitespace().nth(3)?.parse::<u64>().ok())
        .map(|kib| kib >> 10);
    let Some(free) = free else {
        let cure =
            format!("make sure that at least {LEAST_DISK} MiB are free where results are written");
        return Finding::lacking("disk", Status::Optional, "unknown (df gave no answer)", cure);
    };
    let found = format!("{free} MiB free in the current folder");
    if free < LEAST_DISK {
        let cure = format!("free {LEAST_DISK} MiB, or write to another disk with --out");
        return Finding::lacking("disk", Status::Missing, found, cure);
    }
    Finding::ok("disk", found)
}

fn catalogue() -> Finding {
    match Catalog::builtin() {
        Ok(c) => Finding::ok(
            "catalogue",
            format!(
                "{} profiles, {} bolts, {} steels",
                c.profiles().len(),
                c.bolts().len(),
                c.steels().len()
            ),
        ),
        Err(error) => Finding::lacking(
            "catalogue",
            Status::Missing,
            error.to_string(),
            "the program is damaged: install it again",
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_judged_by_what_is_free_and_by_the_container() {
        let info = "MemTotal:       16000000 kB\nMemFree:  1 kB\nMemAvailable:    8000000 kB\n";
        let f = judge_memory(info, None);
        assert_eq!((f.status, f.found.as_str()), (Status::Ok, "7812 MiB free of 15625 MiB"));
        let f = judge_memory(info, Some(900));
        assert_eq!((f.status, f.found.as_str()), (Status::Missing, "900 MiB free of 900 MiB"));
        assert!(f.cure.is_some());
        assert_eq!(judge_memory("", None).status, Status::Optional);
    }

    #[test]
    fn disk_is_judged_by_df() {
        let answer = |free: &str| {
            format!(
                "Filesystem 1024-blocks Used Available Capacity Mounted on\n/dev/x 9 8 {free} 1% \
                 /a b\n"
            )
        };
        assert_eq!(judge_disk(&answer("1048576")).found, "1024 MiB free in the current folder");
        assert_eq!(judge_disk(&answer("1048576")).status, Status::Ok);
        assert_eq!(judge_disk(&answer("100")).status, Status::Missing);
        assert_eq!(judge_disk("").status, Status::Optional);
    }

    #[test]
    fn a_missing_venv_matters_only_without_mesher() {
        let nowhere = Path::new("/nonexistent/folder");
        // the test program lies below the project, which may have its own .venv
        if std::env::current_exe()
            .is_ok_and(|p| p.ancestors().any(|d| d.join(".venv/bin").is_dir()))
        {
            assert_eq!(venv(nowhere, false).status, Status::Ok);
        } else {
            assert_eq!(venv(nowhere, false).status, Status::Missing);
            assert_eq!(venv(nowhere, true).status, Status::Optional);
        }
    }

    #[test]
    fn too_many_threads_are_reported() {
        assert_eq!(threads(Some(1)).status, Status::Ok);
        assert_eq!(threads(Some(1_000_000)).status, Status::Optional);
    }
}
