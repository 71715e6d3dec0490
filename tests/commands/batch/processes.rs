//! The processes of the cases with finite elements: side by side, failing, killed.

use super::SPLICE;
use super::sweeps::{rows, t_stubs};
use crate::bench::Bench;
use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use std::time::Duration;

/// Waits until so many cases are analysed at once; the most that were within 40 s.
#[cfg(target_os = "linux")]
fn in_work(bench: &Bench, wanted: usize) -> usize {
    let owned = || {
        let entries = std::fs::read_dir(bench.path().join("sweep/work"));
        let folders = entries.map(|d| d.flatten().map(|e| e.path()).collect::<Vec<_>>());
        folders.unwrap_or_default().iter().filter(|w| w.join("owner").exists()).count()
    };
    let mut most = 0;
    for _ in 0..800 {
        most = most.max(owned());
        if most == wanted {
            break;
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    most
}

/// Two cases run at once where two are allowed.
#[cfg(target_os = "linux")]
#[test]
fn cases_run_side_by_side() {
    let bench = t_stubs("limits: {memory: 300 MiB}\n");
    let mesher = bench.mesher("sleep 60");
    let mut command = bench.command(&["batch", "sweep.yaml", "--jobs", "2", "--quiet"]);
    let mut run = command.env("BRACKET_GMSH", &mesher).spawn().expect("starts");
    let most = in_work(&bench, 2);
    run.kill().expect("killed");
    run.wait().expect("ended");
    assert_eq!(most, 2);
}

/// An interrupted sweep says by code what the checks found; what was to be analysed is open.
#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_sweep_has_its_checks() {
    let sweep = "base: joint.yaml\naxes: {loads.ULS1.My: [-20 kN m, -200 kN m]}\nfirst: \
                 checks\nthen: {limit: all}\n";
    let bench = Bench::new().file("joint.yaml", SPLICE).file("sweep.yaml", sweep);
    let mesher = bench.mesher("sleep 60");
    let mut command = bench.command(&["batch", "sweep.yaml", "--jobs", "1", "--quiet"]);
    let run = command.env("BRACKET_GMSH", &mesher).spawn().expect("starts");
    assert_eq!(in_work(&bench, 1), 1);
    kill(Pid::from_raw(run.id().cast_signed()), Signal::SIGINT).expect("it runs");
    let end = run.wait_with_output().expect("ended");
    assert_eq!(end.status.code(), Some(3));
    let rows = rows(&bench, "sweep");
    let of = |key: &str| rows.iter().map(|r| r[key].clone()).collect::<Vec<_>>();
    assert_eq!(of("outcome"), ["open"; 2]);
    assert_eq!(of("by_code"), ["ok", "not_ok"]);
    assert_eq!(of("by_analysis"), ["none"; 2]);
    assert_eq!(of("M_kNm"), [-20.0, -200.0]);
    assert!(rows.iter().all(|r| r["M_j_Rd_kNm"].as_f64().is_some_and(|m| m > 50.0)), "{rows:?}");
}

/// A mesher that hangs, crashes or fills the memory ends its case with a name and no other.
#[cfg(target_os = "linux")]
#[test]
fn a_failing_process_ends_its_case() {
    for (limits, script, outcome, cause, code) in [
        ("limits: {time: 1 s}", "sleep 60", "timed_out", "within its 1 s", 3),
        ("", "exit 7", "failed", "mesher", 4),
        ("", "kill -9 $PPID", "failed", "signal: 9", 4),
        // `tail` keeps the line without an end
        (
            "limits: {memory: 300 MiB}",
            "head -c 900m /dev/zero | tail; sleep 60",
            "failed",
            "more than its 300 MiB",
            4,
        ),
    ] {
        let bench = t_stubs(limits);
        let mesher = bench.mesher(script);
        let run = bench
            .command(&["batch", "sweep.yaml", "--jobs", "1"])
            .env("BRACKET_GMSH", &mesher)
            .output()
            .expect("starts");
        let err = String::from_utf8_lossy(&run.stderr);
        assert_eq!(run.status.code(), Some(code), "{script}: {err}");
        for row in rows(&bench, "sweep") {
            assert_eq!(row["outcome"], outcome, "{script}: {row} {err}");
            assert!(row["cause"].as_str().is_some_and(|c| c.contains(cause)), "{script}: {row}");
        }
        assert!(!bench.path().join("sweep/work").join("x").exists());
        let work = std::fs::read_dir(bench.path().join("sweep/work"));
        assert_eq!(work.map(|d| d.count()).unwrap_or(0), 0, "{script}: work is left");
    }
}

/// A process that is killed leaves its unfinished work; the next run removes it, but not that of a
/// process that lives.
#[cfg(target_os = "linux")]
#[test]
fn work_of_killed_processes_is_removed() {
    let bench = t_stubs("");
    let mesher = bench.mesher("sleep 60");
    let start = |jobs: &str| {
        let mut command = bench.command(&["batch", "sweep.yaml", "--jobs", jobs, "--quiet"]);
        command.env("BRACKET_GMSH", &mesher).spawn().expect("starts")
    };
    let work = || -> Vec<std::path::PathBuf> {
        let entries = std::fs::read_dir(bench.path().join("sweep/work"));
        entries.map(|d| d.flatten().map(|e| e.path()).collect()).unwrap_or_default()
    };
    let wait = |number: usize| {
        for _ in 0..800 {
            if work().iter().filter(|w| w.join("owner").exists()).count() == number {
                return;
            }
            std::thread::sleep(Duration::from_millis(50));
        }
        panic!("{:?}", work());
    };
    let mut killed = start("1");
    wait(1);
    killed.kill().expect("killed");
    killed.wait().expect("ended");
    let left = work();
    // another process removes what is left, and makes its own
    let mut other = start("1");
    for _ in 0..800 {
        if !left[0].exists() && work().len() == 1 {
            break;
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    assert!(!left[0].exists(), "{left:?}");
    // a third one leaves the work of the second alone
    let mut third = start("1");
    wait(2);
    for child in [&mut other, &mut third] {
        child.kill().expect("killed");
        child.wait().expect("ended");
    }
}
