//! Folders of unfinished work. Each names the processes that work in it, so that what a killed
//! process leaves is removed by the next one.

use super::sweep_folder::{SweepFolder, unique, write_whole};
use bracket_base::diag::Diagnostic;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Folder of unfinished work in the folder of a sweep.
const WORK: &str = "work";

/// File in a folder of work with the processes that work in it, one a line.
const OWNERS: &str = "owner";

/// Time in which a case ends whose sweep was killed.
const ENDING: Duration = Duration::from_secs(20);

/// Interval at which it is looked at.
const LOOK: Duration = Duration::from_millis(100);

/// A new folder for the work on a case.
pub fn work_folder(folder: &SweepFolder, key: &str) -> PathBuf {
    folder.path().join(WORK).join(format!("{key}.{}", unique()))
}

/// Notes in a folder of work the processes that work in it.
pub fn own(work: &Path, processes: &[u32]) -> Result<(), Box<Diagnostic>> {
    let lines: Vec<String> = processes.iter().map(|p| process(*p)).collect();
    write_whole(&work.join(OWNERS), lines.join("\n").as_bytes())
}

/// Removes the work of processes of this machine that were killed. The case of a killed process
/// ends a moment after it, and writes until then.
pub fn clear_work(folder: &SweepFolder) {
    let Ok(entries) = fs::read_dir(folder.path().join(WORK)) else { return };
    let start = Instant::now();
    for work in entries.flatten().map(|e| e.path()) {
        let owners = fs::read_to_string(work.join(OWNERS)).unwrap_or_default();
        let (owner, cases) = owners.split_once('\n').unwrap_or((&owners, ""));
        if !has_ended(owner) {
            continue;
        }
        while !cases.lines().all(has_ended) && start.elapsed() < ENDING {
            std::thread::sleep(LOOK);
        }
        if cases.lines().all(has_ended) {
            let _ = fs::remove_dir_all(&work);
        }
    }
}

/// A process of this machine since it was started, as one line.
fn process(pid: u32) -> String {
    let boot = fs::read_to_string("/proc/sys/kernel/random/boot_id").unwrap_or_default();
    let names = fs::read_link("/proc/self/ns/pid").unwrap_or_default();
    format!("{} {} {pid}", boot.trim(), names.display())
}

/// True if a process of this machine, named by its line, has ended; false if that is not known.
fn has_ended(line: &str) -> bool {
    let pid = line.rsplit(' ').next().and_then(|p| p.parse::<u32>().ok());
    // without a name of the boot the process may be of another machine
    pid.is_some_and(|p| !line.starts_with(' ') && process(p) == line && is_gone(p))
}

/// True if no process with this number works. One that nobody has waited for keeps its number.
#[cfg(unix)]
fn is_gone(pid: u32) -> bool {
    use nix::errno::Errno;
    use nix::sys::signal::kill;
    let stat = fs::read_to_string(format!("/proc/{pid}/stat")).unwrap_or_default();
    let zombie = stat.rsplit(") ").next().is_some_and(|s| s.starts_with(['Z', 'X']));
    zombie || kill(nix::unistd::Pid::from_raw(pid.cast_signed()), None) == Err(Errno::ESRCH)
}

/// Whether a process lives is not known here.
#[cfg(not(unix))]
fn is_gone(_: u32) -> bool {
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(target_os = "linux")]
    fn ended_processes_are_known() {
        let mut child = std::process::Command::new("sleep").arg("60").spawn().expect("starts");
        let line = process(child.id());
        assert!(!has_ended(&line) && !has_ended(&process(std::process::id())));
        child.kill().expect("killed");
        // it keeps its number until it is waited for
        while !has_ended(&line) {
            std::thread::sleep(Duration::from_millis(5));
        }
        child.wait().expect("ended");
        assert!(has_ended(&line));
        assert!(!has_ended("") && !has_ended(&format!(" names {}", u32::MAX >> 1)));
        assert!(!has_ended(&line.replace(['a', '1'], "7")), "another machine");
    }
}
