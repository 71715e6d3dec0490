//! Ctrl-C and the termination signals of batch systems, sent to the compiled program.

use super::{mesh, mesh_of, opening};
use crate::bench::expect;
use crate::bench::{Bench, JOINT};
use nix::sys::signal::{SigHandler, Signal, kill, signal};
use nix::unistd::Pid;
use serde_json::Value;
use std::io::{BufRead, BufReader, Read};
use std::os::unix::process::CommandExt;
use std::process::{Child, ChildStderr, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// A joint that opens and takes seconds to solve: 10 800 tets.
fn slow() -> Bench {
    Bench::new().file("block.yaml", opening()).file("m.msh", mesh_of([10, 10, 18], 60.0))
}

/// A running program.
struct Running {
    child: Child,
    err: BufReader<ChildStderr>,
    /// What it has written to standard error so far.
    said: String,
}

impl Running {
    fn start(command: &mut Command) -> Self {
        let default = || Ok(unsafe { signal(Signal::SIGHUP, SigHandler::SigDfl) }.map(drop)?);
        // tests that run under `nohup` ignore SIGHUP, and their children would inherit that
        let command = unsafe { command.pre_exec(default) };
        let mut child =
            command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("starts");
        let err = BufReader::new(child.stderr.take().expect("piped"));
        Self { child, err, said: String::new() }
    }

    /// Reads standard error up to a line that contains the words.
    fn until(&mut self, words: &str) {
        let seen = self.said.len();
        while !self.said[seen..].contains(words) {
            let read = self.err.read_line(&mut self.said).expect("UTF-8");
            assert!(read > 0, "{words:?} was never said: {}", self.said);
        }
    }

    fn send(&self, signal: Signal) {
        kill(Pid::from_raw(self.child.id().cast_signed()), signal).expect("it runs");
    }

    /// Waits for the program to end. Returns the exit status, the time, and all of standard error.
    fn end(mut self) -> (ExitStatus, Duration, String) {
        let start = Instant::now();
        self.err.read_to_string(&mut self.said).expect("UTF-8");
        let status = self.child.wait().expect("it ends");
        (status, start.elapsed(), self.said)
    }
}

/// A program that is solving: it prints both forecasts right before the solve.
fn solving(bench: &Bench, extra: &[&str]) -> Running {
    let mut running = Running::start(bench.command(&["analyse", "block.yaml"]).args(extra));
    running.until("static program: ");
    running
}

#[test]
fn an_interrupted_solve_ends_in_order() {
    for signal in [Signal::SIGINT, Signal::SIGTERM, Signal::SIGHUP] {
        let bench = slow();
        let running = solving(&bench, &["--format", "json"]);
        running.send(signal);
        let (status, _, err) = running.end();
        assert_eq!(status.code(), Some(3), "{signal}: {err}");
        for words in [
            "interrupted: the mesher stops now, the solvers after their current iteration, and \
             certified results are written",
            "the static program was interrupted",
            "result: block/report.md",
        ] {
            assert!(err.contains(words), "{words:?} in {err}");
        }
        let result: Value = serde_json::from_str(&bench.read("block/result.json")).expect("JSON");
        let case = &result["cases"][0];
        let history = &case["history"][0];
        assert_eq!(history["static"]["status"], "interrupted", "{history:#}");
        assert!(
            case.get("lower").is_none() && case.get("gap").is_none(),
            "no bound of an unfinished solve: {case:#}"
        );
        if history["kinematic"]["status"] == "interrupted" {
            assert!(case.get("upper").is_none() && case.get("certificate").is_none(), "{case:#}");
        }
        let report = bench.read("block/report.md");
        assert!(
            report.contains("the static program was interrupted")
                && report.contains("no lower bound"),
            "{report}"
        );
        assert!(bench.read("block/log.txt").contains("interrupted: the mesher stops now"));
        assert!(!bench.path().join("block.part").exists());
        expect(&bench, &["verify", "block"], 0);
    }
}

/// `timeout` signals the process and its group. The program must treat the two signals as one.
#[test]
fn a_signal_that_comes_twice_at_once_is_one() {
    let bench = slow();
    let running = solving(&bench, &[]);
    running.send(Signal::SIGTERM);
    std::thread::sleep(Duration::from_millis(20));
    running.send(Signal::SIGTERM);
    let (status, _, err) = running.end();
    assert_eq!(status.code(), Some(3), "{err}");
    assert!(bench.path().join("block/result.json").is_file(), "{err}");
}

/// If the first interrupt falls right before the end of an iteration, the run ends in order before
/// the second one. The test then tries another delay.
#[test]
fn a_second_interrupt_ends_at_once_and_leaves_what_was_there() {
    for delay in [500, 1000, 250, 1500, 100, 700] {
        let bench = slow();
        let before = bench.everything();
        let mut running = solving(&bench, &[]);
        std::thread::sleep(Duration::from_millis(delay));
        running.send(Signal::SIGINT);
        running.until("interrupt again");
        // longer than the time within which two signals count as one
        std::thread::sleep(Duration::from_millis(320));
        running.send(Signal::SIGINT);
        let (status, took, err) = running.end();
        assert_eq!(status.code(), Some(3), "{err}");
        assert!(took < Duration::from_secs(5), "{took:?}");
        if err.contains("result: ") {
            continue;
        }
        assert!(bench.everything() == before, "something is left: {:?}", bench.everything().keys());
        return;
    }
    panic!("every run was over before its second interrupt");
}

/// An interrupted run keeps an earlier result: it is worth more than a folder without any bound.
#[test]
fn an_earlier_result_outlives_an_interrupt() {
    let bench = Bench::new().file("block.yaml", opening()).file("m.msh", mesh(60.0));
    expect(&bench, &["analyse", "block.yaml", "-q"], 0);
    let bench = bench.file("m.msh", mesh_of([10, 10, 18], 60.0));
    let before = bench.everything();
    let running = solving(&bench, &[]);
    running.send(Signal::SIGINT);
    let (status, _, err) = running.end();
    assert_eq!(status.code(), Some(3), "{err}");
    assert!(
        err.contains("interrupted before anything was certified: block stays as it was"),
        "{err}"
    );
    assert!(bench.everything() == before, "{err}");
}

/// While the mesher is asked for its version, a signal ends the program and all processes that it
/// has started.
#[test]
fn the_probe_of_the_mesher_dies_with_the_run() {
    for command in [&["run", "joint.yaml"][..], &["mesh", "joint.yaml"], &["study", "joint.yaml"]] {
        let bench = Bench::new().file("joint.yaml", JOINT);
        let before = ["joint.yaml", "asked", "mesher.sh"];
        std::fs::write(
            bench.path().join("mesher.sh"),
            "sleep 600 & echo $$ $! > asked.part; mv asked.part asked; wait",
        )
        .expect("written");
        let mesher = serde_json::json!(["sh", bench.path().join("mesher.sh")]).to_string();
        let running = Running::start(bench.command(command).env("BRACKET_GMSH", mesher));
        let pids = appears(&bench, "asked");
        running.send(Signal::SIGINT);
        let (status, took, err) = running.end();
        assert!(took < Duration::from_secs(5), "{took:?}");
        assert_eq!(status.code(), Some(3), "{err}");
        assert!(err.contains("interrupted while looking for the mesher"), "{err}");
        all_end(&pids, "the probe");
        let left = bench.everything();
        assert!(left.keys().all(|k| before.iter().any(|b| k.ends_with(b))), "{:?}", left.keys());
    }
}

/// The time limit of the spec ends the probe too.
#[test]
fn a_mesher_that_does_not_answer_is_stopped_at_the_time_limit() {
    let spec = JOINT.replace("{kind: elastic,", "{kind: elastic, time_limit: 1 s,");
    let bench = Bench::new().file("joint.yaml", &spec);
    std::fs::write(bench.path().join("mesher.sh"), "sleep 600").expect("written");
    let mesher = serde_json::json!(["sh", bench.path().join("mesher.sh")]).to_string();
    let running = Running::start(bench.command(&["run", "joint.yaml"]).env("BRACKET_GMSH", mesher));
    let (status, took, err) = running.end();
    assert!(took < Duration::from_secs(20), "{took:?}");
    assert_eq!(status.code(), Some(4), "{err}");
    assert!(err.contains("no answer within 1 s"), "{err}");
}

/// After an interrupt the exit code is 3 even where the bounds so far are certified, and the last
/// line says why.
#[test]
fn a_certified_result_ends_with_3_after_an_interrupt() {
    let model = format!(
        "{}adapt: {{target_gap: 0.0001, max_passes: 12, max_macro_tets: 400000}}\n",
        opening()
    );
    let bench = || Bench::new().file("block.yaml", &model).file("m.msh", mesh_of([4, 4, 6], 60.0));
    let analysed = bench();
    let mut running = Running::start(&mut analysed.command(&["analyse", "block.yaml"]));
    // the second mesh: the first one has given its bounds
    (0..2).for_each(|_| running.until("static program: "));
    running.send(Signal::SIGTERM);
    let (status, _, err) = running.end();
    assert_eq!(status.code(), Some(3), "{err}");
    assert!(err.contains("(certified)"), "there are bounds: {err}");
    let last = err.lines().last().unwrap_or_default();
    assert!(last.contains("exit code 3: interrupted"), "{err}");
    expect(&analysed, &["verify", "block"], 0);
    let studied = bench();
    let args = ["study", "block.yaml", "--uniform", "4", "--max-macro-tets", "400000"];
    let mut running = Running::start(&mut studied.command(&args));
    (0..2).for_each(|_| running.until("static program: "));
    running.send(Signal::SIGTERM);
    let (status, _, err) = running.end();
    assert_eq!(status.code(), Some(3), "{err}");
    assert!(err.lines().last().is_some_and(|l| l.contains("exit code 3: interrupted")), "{err}");
    assert!(studied.read("block_study/study.csv").lines().count() > 1, "the rows so far");
}

/// A check ends at once. The signal comes while the folder is being written.
#[test]
fn a_check_ends_at_once_and_leaves_nothing() {
    let mut ended = 0;
    for signal in [Signal::SIGTERM, Signal::SIGINT, Signal::SIGTERM, Signal::SIGINT] {
        let bench = Bench::new().file("joint.yaml", JOINT);
        let before = bench.everything();
        let running = Running::start(&mut bench.command(&["check", "joint.yaml", "--out", "r"]));
        let start = Instant::now();
        while !bench.path().join("r.part").exists() && !bench.path().join("r").exists() {
            assert!(start.elapsed() < Duration::from_secs(60), "it never begins");
            std::thread::sleep(Duration::from_millis(1));
        }
        // between the folder and the watch over it lies a moment
        std::thread::sleep(Duration::from_millis(20));
        running.send(signal);
        let (status, _, err) = running.end();
        if bench.path().join("r").exists() {
            continue;
        }
        assert_eq!(status.code(), Some(3), "{err}");
        assert!(bench.everything() == before, "{:?}", bench.everything().keys());
        ended += 1;
    }
    assert!(ended > 0, "every check was over before its signal");
}

/// Commands that read a result end at once too.
#[test]
fn verify_and_report_end_at_once() {
    let bench = Bench::new().file("block.yaml", opening()).file("m.msh", mesh_of([6, 6, 8], 60.0));
    expect(&bench, &["analyse", "block.yaml", "-q"], 0);
    let before = bench.everything();
    for args in [&["verify", "block"][..], &["report", "block", "--full", "--out", "full.pdf"]] {
        let tried = [30, 60, 120, 15, 250, 500].into_iter().any(|delay| {
            let running = Running::start(&mut bench.command(args));
            std::thread::sleep(Duration::from_millis(delay));
            running.send(Signal::SIGTERM);
            let (status, _, err) = running.end();
            let _ = std::fs::remove_file(bench.path().join("full.pdf"));
            assert!(
                bench.everything() == before,
                "{args:?} leaves {:?}",
                bench.everything().keys()
            );
            // a program that has not begun dies of the signal, one that is over ends with 0
            match status.code() {
                Some(3) => true,
                Some(0) | None => false,
                code => panic!("{args:?}: {code:?} {err}"),
            }
        });
        assert!(tried, "{args:?} never ended by its signal");
    }
}

/// Waits until a file of the bench exists and holds a line.
fn appears(bench: &Bench, name: &str) -> String {
    let start = Instant::now();
    loop {
        match std::fs::read_to_string(bench.path().join(name)) {
            Ok(text) if text.ends_with('\n') => return text,
            _ => assert!(start.elapsed() < Duration::from_secs(60), "{name} never appeared"),
        }
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// When a run is interrupted, the mesher ends with all processes it has started, whether it is a
/// wrapper or the wrapped program.
#[test]
fn an_interrupted_mesher_dies_with_its_children() {
    for (command, signal) in
        [("run", Signal::SIGINT), ("mesh", Signal::SIGINT), ("run", Signal::SIGTERM)]
    {
        let bench = Bench::new().file("joint.yaml", JOINT);
        let pids = bench.path().join("pids");
        let mesher = bench.mesher(&format!("sleep 600 &\necho $$ $! > '{}'\nwait", pids.display()));
        let before: Vec<_> = bench.everything().into_keys().collect();
        let running =
            Running::start(bench.command(&[command, "joint.yaml"]).env("BRACKET_GMSH", mesher));
        let text = appears(&bench, "pids");
        running.send(signal);
        let (status, took, err) = running.end();
        assert_eq!(status.code(), Some(3), "{command}: {err}");
        assert!(took < Duration::from_secs(5), "{command}: {took:?}");
        assert!(err.contains("error[mesher/interrupted]: interrupted while meshing"), "{err}");
        all_end(&text, command);
        std::fs::remove_file(pids).expect("it is there");
        assert_eq!(
            bench.everything().into_keys().collect::<Vec<_>>(),
            before,
            "{command} left something"
        );
    }
}

/// Waits until the processes of a line have ended.
fn all_end(pids: &str, whose: &str) {
    for pid in pids.split_whitespace() {
        let pid = Pid::from_raw(pid.parse().expect("a number"));
        let start = Instant::now();
        // init reaps the grandchild some time later
        while alive(pid) {
            assert!(start.elapsed() < Duration::from_secs(10), "{whose}: process {pid} lives on");
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

/// Whether a process runs. A process that has ended and waits to be reaped does not.
fn alive(pid: Pid) -> bool {
    let stat = std::fs::read_to_string(format!("/proc/{pid}/stat"));
    match stat {
        Ok(text) => {
            !text.rsplit(')').next().is_some_and(|rest| rest.trim_start().starts_with(['Z', 'X']))
        }
        Err(_) => kill(pid, None).is_ok() && !std::path::Path::new("/proc/self/stat").exists(),
    }
}

/// Under nohup the program ignores the end of its terminal.
#[test]
#[cfg(target_os = "linux")]
fn a_run_under_nohup_outlives_its_terminal() {
    let bench = Bench::new().file("block.yaml", opening()).file("m.msh", mesh_of([6, 6, 6], 60.0));
    let script =
        format!("trap '' HUP; exec '{}' analyse block.yaml", env!("CARGO_BIN_EXE_bracket"));
    let mut running =
        Running::start(Command::new("sh").current_dir(bench.path()).args(["-c", &script]));
    running.until("static program: ");
    running.send(Signal::SIGHUP);
    let (status, _, err) = running.end();
    assert_eq!(status.code(), Some(0), "{err}");
    assert!(!err.contains("interrupted"), "{err}");
}
