//! `--memory-limit`, the memory forecast, the trace of the iterations and the progress bar on a
//! terminal.

use super::{MODEL, bench, mesh_of, opening};
use crate::bench::expect;
use crate::bench::{Bench, JOINT, Want, none_wrong, refusal};
use serde_json::Value;
use std::process::Command;

/// A joint that opens, 2592 tets: enough that the memory of its two programs differs by more than
/// that of two runs does.
fn larger() -> Bench {
    Bench::new().file("block.yaml", opening()).file("m.msh", mesh_of([6, 6, 12], 60.0))
}

fn case(bench: &Bench) -> Value {
    serde_json::from_str::<Value>(&bench.read("block/result.json")).expect("JSON")["cases"][0]
        .clone()
}

#[test]
fn invalid_memory_sizes_are_refused() {
    let mut results = Vec::new();
    for (size, words) in [
        ("", "it has no unit"),
        ("8", "it has no unit"),
        ("GiB", "`` is not a number"),
        ("-8GiB", "`-8` is not a number"),
        ("8,5GiB", "`8,5` is not a number"),
        ("1e3 GiB", "`e3 GiB` is not a unit of memory"),
        ("8 GiBs", "`GiBs` is not a unit of memory"),
        ("8 KiB", "`KiB` is not a unit of memory"),
        ("nan", "`nan` is not a unit of memory"),
        ("0GiB", "between 64 MiB and 1024 TiB"),
        ("63 MiB", "between 64 MiB and 1024 TiB"),
        ("2000TiB", "between 64 MiB and 1024 TiB"),
        ("50%", "it has no unit"),
    ] {
        for command in [["analyse", "block.yaml"], ["run", "joint.yaml"]] {
            let bench = bench(MODEL).file("joint.yaml", JOINT);
            let cure = "--memory-limit 8GiB";
            let want = Want { exit: 2, code: "cli/value", place: "", message: words, cure };
            let mut run = bench.command(&command);
            results.push((
                format!("{} {size:?}", command[0]),
                refusal(&bench, run.args(["--memory-limit", size]), &want),
            ));
        }
    }
    none_wrong(results);
}

#[test]
fn a_model_that_does_not_fit_is_not_started() {
    let bench = larger();
    let want = Want {
        exit: 4,
        code: "run/memory",
        place: "",
        message: "left of the 0.0625 GiB that --memory-limit allows; the static program needs",
        cure: "a coarser mesh file, a larger --memory-limit or a machine with more memory",
    };
    let mut results = Vec::new();
    for extra in [&[][..], &["--quiet"]] {
        let mut run = bench.command(&["analyse", "block.yaml", "--memory-limit", "64MiB"]);
        results.push((format!("{extra:?}"), refusal(&bench, run.args(extra), &want)));
    }
    // an earlier result is kept
    expect(&bench, &["analyse", "block.yaml", "-q"], 0);
    let mut run = bench.command(&["analyse", "block.yaml", "--memory-limit", "64MiB"]);
    results.push(("earlier result".into(), refusal(&bench, &mut run, &want)));
    none_wrong(results);
}

/// If the memory suffices for the smaller program only, that one runs. Its bound is certified. The
/// other program is refused with a clear message.
#[test]
fn what_fits_alone_gives_its_bound() {
    let bench = larger();
    // only the process knows how much memory it holds before it solves: the limit rises by the
    // amount that it reports as missing
    let mut limit = 64.0;
    let run = loop {
        let run =
            bench.run(&["analyse", "block.yaml", "--memory-limit", &format!("{limit:.0}MiB")]);
        if run.status.code() != Some(4) {
            break run;
        }
        let err = String::from_utf8_lossy(&run.stderr).into_owned();
        let (_, text) =
            err.split_once("the kinematic program needs ").unwrap_or_else(|| panic!("{err}"));
        let words: Vec<&str> = text.split_whitespace().collect();
        // `0.053 GiB more memory, 0.041 GiB are left of …`
        let [needed, left] =
            [words[0], words[4]].map(|w| w.parse::<f64>().unwrap_or_else(|_| panic!("{text}")));
        limit += (1024.0 * (needed - left)).max(2.0);
        assert!(limit < 1024.0, "a GiB is enough: {err}");
    };
    let err = String::from_utf8_lossy(&run.stderr).into_owned();
    assert_eq!(run.status.code(), Some(3), "{limit:.0} MiB: {err}");
    for words in [
        "the static program is not started: it needs",
        "so there is no lower bound: it needs",
        "a coarser mesh file",
    ] {
        assert!(err.contains(words), "{words:?} in {err}");
    }
    let case = case(&bench);
    assert!(
        case["upper"].is_f64() && case.get("lower").is_none() && case.get("gap").is_none(),
        "{case:#}"
    );
    assert_eq!(case["certificate"]["strict"], true);
    let history = &case["history"][0];
    assert_eq!(
        (&history["static"]["status"], &history["static"]["iterations"]),
        (&"too large for the memory".into(), &0.into())
    );
    assert!(
        history["static"]["forecast_memory_mib"].as_u64()
            > history["kinematic"]["forecast_memory_mib"].as_u64()
    );
    assert!(history["static"].get("trace").is_none());
    let report = bench.read("block/report.md");
    assert!(
        report.contains("the static program was not started, so there is no lower bound"),
        "{report}"
    );
    let (out, _) = expect(&bench, &["verify", "block"], 0);
    assert!(out.contains("confirmed"), "{out}");
}

#[test]
fn costs_are_reported_before_and_stored_after() {
    let bench = bench(MODEL);
    let (_, err) = expect(&bench, &["analyse", "block.yaml", "--memory-limit", "64 GiB"], 0);
    for program in ["kinematic", "static"] {
        let line = err
            .lines()
            .find(|l| l.contains(&format!("{program} program: ")))
            .unwrap_or_else(|| panic!("{err}"));
        for words in ["unknowns", "million factor entries", "GiB of memory", "under 1 s"] {
            assert!(line.contains(words), "{words:?} in {line}");
        }
        let run = &case(&bench)["history"][0][program];
        assert!(
            run["forecast_memory_mib"].as_u64() >= Some(1)
                && run["factor_entries"].as_u64() > Some(1000),
            "{run:#}"
        );
        assert!(run["forecast_seconds"].as_f64() > Some(0.0));
    }
    // the general solver has no memory forecast
    let (_, err) = expect(&bench, &["analyse", "block.yaml", "--solver", "clarabel"], 0);
    assert!(err.contains("unknowns") && !err.contains("GiB"), "{err}");
    let run = &case(&bench)["history"][0]["static"];
    assert!(run.get("forecast_memory_mib").is_none() && run["trace"].is_array(), "{run:#}");
}

#[test]
fn every_iteration_is_in_the_result_and_in_the_log() {
    let bench = bench(&opening());
    let (out, _) = expect(&bench, &["analyse", "block.yaml", "--format", "json"], 0);
    let result: Value = serde_json::from_str(&out).expect("JSON");
    let log = bench.read("block/log.txt");
    for program in ["kinematic", "static"] {
        let run = &result["cases"][0]["history"][0][program];
        let trace = run["trace"].as_array().expect("a trace");
        // the numbers restart at 0 where another solver took over; the iteration count is that of
        // the solver that gave the answer
        let last = trace.iter().rposition(|row| row["number"] == 0).expect("a start");
        assert_eq!(
            (trace.len() - last) as u64,
            run["iterations"].as_u64().expect("a count") + 1,
            "{run:#}"
        );
        for (k, row) in trace.iter().enumerate() {
            assert!(k < last || row["number"] == k - last, "{row}");
            for key in ["gap", "residual", "step", "seconds"] {
                assert!(row[key].as_f64().is_some_and(|x| x >= 0.0), "{key} in {row}");
            }
        }
        assert!(trace[trace.len() - 1]["gap"].as_f64() < Some(1e-7));
        let lines =
            log.lines().filter(|l| l.contains(&format!("block: {program} iteration "))).count();
        assert_eq!(lines, trace.len(), "{log}");
    }
}

/// If standard error is no terminal, the program prints lines and no progress bar.
#[test]
fn without_a_terminal_there_is_no_bar() {
    let bench = bench(MODEL);
    let (out, err) = expect(&bench, &["analyse", "block.yaml"], 0);
    assert!(
        out.is_empty() && !err.contains(['\r', '\u{1b}']) && !err.contains("iteration"),
        "{err:?}"
    );
    assert_eq!(err.lines().count(), 6, "{err}");
}

/// The same on a terminal made by `script` (util-linux): the bar shows iteration, gap, residual and
/// remaining time.
#[test]
#[cfg(target_os = "linux")]
fn on_a_terminal_the_solve_shows_how_far_it_is() {
    let bench = larger();
    let on_terminal = |extra: &str| {
        let command = format!("{} analyse block.yaml {extra}", env!("CARGO_BIN_EXE_bracket"));
        let mut run = Command::new("script");
        run.current_dir(bench.path()).env("TERM", "xterm").args([
            "-qec",
            &format!("stty rows 40 cols 80; {command}"),
            "typescript",
        ]);
        run.output()
    };
    let run = on_terminal("").expect("`script` of util-linux, which makes the terminal");
    let text = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(run.status.success(), "{text}");
    for words in ["kinematic", "static", "iteration ", "gap ", "residual ", " left", "["] {
        assert!(text.contains(words), "{words:?} in {text:?}");
    }
    // the bar leaves no text: the line is empty after it was cleared for the last time
    assert!(
        text.contains("result: block/report.md\r\n") && text.contains("exit code 0: certified\r\n"),
        "{text:?}"
    );
    assert_eq!(text.rsplit("\u{1b}[2K").next().map(str::trim), Some(""), "{text:?}");
    let run = on_terminal("--quiet").expect("`script` as before");
    assert!(run.stdout.is_empty(), "{:?}", String::from_utf8_lossy(&run.stdout));
}
