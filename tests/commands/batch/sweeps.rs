//! Sweeps from the command line: the tables, shards, interruptions, processes that fail.

use super::SPLICE;
use crate::bench::Bench;
use crate::bench::expect;
use serde_json::Value;
use std::process::Stdio;
use std::time::Duration;

/// A sweep over profiles and plates, checks alone.
const CHECKS: &str = "base: joint.yaml\nfirst: checks\naxes:\n  members.beam.profile: \
                      IPE300..IPE400\n  plate.thickness: {from: 10, to: 25, step: 5}\nset:\n  \
                      bolts.rows: [60 mm - beam.h / 2, beam.h / 2 - 60 mm]\n";

fn bench(sweep: &str) -> Bench {
    Bench::new().file("joint.yaml", SPLICE).file("sweep.yaml", sweep)
}

pub fn rows(bench: &Bench, folder: &str) -> Vec<Value> {
    let text = bench.read(&format!("{folder}/results.jsonl"));
    text.lines().map(|l| serde_json::from_str(l).expect("JSON")).collect()
}

/// Files that a merge writes.
const MERGED: [&str; 4] = ["results.csv", "results.jsonl", "summary.html", "summary.pdf"];

fn merged(bench: &Bench, folder: &str) -> Vec<Vec<u8>> {
    let read = |f: &&str| std::fs::read(bench.path().join(folder).join(f)).expect("a merged file");
    MERGED.iter().map(read).collect()
}

/// The printed summary has the outcomes, every case, and texts of the user as texts.
#[test]
fn the_printed_summary_names_every_case() {
    let title = "project: {title: \"#panic(1) <b> $x$\", number: P-7, date: 2026-11-23}\n";
    let bench =
        Bench::new().file("joint.yaml", format!("{title}{SPLICE}")).file("sweep.yaml", CHECKS);
    bench.run(&["batch", "sweep.yaml"]);
    let pdf = bench.path().join("sweep/summary.pdf");
    let read = |program: &str, args: &[&str]| {
        let run = std::process::Command::new(program).arg(&pdf).args(args).output();
        let run = run.unwrap_or_else(|e| panic!("{program} (package poppler-utils): {e}"));
        String::from_utf8_lossy(&run.stdout).into_owned()
    };
    let letters = |text: &str| text.chars().filter(|c| c.is_alphanumeric()).collect::<String>();
    let text = letters(&read("pdftotext", &["-"]));
    let rows = rows(&bench, "sweep");
    let count = |outcome: &str| rows.iter().filter(|r| r["outcome"] == outcome).count();
    for words in [format!("ok {}", count("ok")), format!("not ok {}", count("not_ok"))] {
        assert!(text.contains(&letters(&words)), "{words}: {text}");
    }
    for words in ["#panic(1) <b> $x$", "P-7", "Cases by outcome", "page 1 of"] {
        assert!(text.contains(&letters(words)), "{words}: {text}");
    }
    for row in &rows {
        for key in ["case", "governing"] {
            assert!(text.contains(&letters(row[key].as_str().expect("text"))), "{row}");
        }
    }
    assert!(read("pdfinfo", &[]).contains("A4"));
}

/// Every row has the verdict, M_j,Rd and governing check that `bracket check` gives for its spec.
#[test]
fn rows_agree_with_the_check_of_each_spec() {
    let bench = bench(CHECKS);
    let run = bench.run(&["batch", "sweep.yaml"]);
    let err = String::from_utf8_lossy(&run.stderr).into_owned();
    let rows = rows(&bench, "sweep");
    assert_eq!(rows.len(), 16, "{err}");
    let worst = if rows.iter().any(|r| r["outcome"] == "not_ok") { 1 } else { 0 };
    assert_eq!(run.status.code(), Some(worst), "{err}");
    let verdicts: Vec<&Value> = rows.iter().map(|r| &r["verdict"]).collect();
    assert!(
        verdicts.contains(&&"ok".into()) && verdicts.contains(&&"not_ok".into()),
        "{verdicts:?}"
    );
    for row in rows.iter().step_by(3) {
        let profile = row["members.beam.profile"].as_str().expect("a profile");
        let thickness = row["plate.thickness"].as_str().expect("a thickness");
        let z = profile[3..].parse::<f64>().expect("a depth") / 2.0 - 60.0;
        let spec = SPLICE
            .replace("IPE330", profile)
            .replace("thickness: 15", &format!("thickness: {thickness}"))
            .replace("[-105, 105]", &format!("[-{z}, {z}]"));
        std::fs::write(bench.path().join("one.yaml"), spec).expect("written");
        bench.run(&["check", "one.yaml", "--quiet"]);
        let one: Value = serde_json::from_str(&bench.read("one_check/result.json")).expect("JSON");
        assert_eq!(row["verdict"], one["verdict"], "{row}");
        let governing = &one["judgement"]["governing"];
        assert_eq!(row["governing"], governing["what"], "{row}");
        assert_eq!(row["governing_utilisation"], governing["utilisation"][1], "{row}");
        let resistance = one["checks"]
            .as_array()
            .expect("checks")
            .iter()
            .find(|c| {
                c["title"] == "moment resistance of the joint"
                    && c["subject"].as_str().is_some_and(|s| s.contains("bottom"))
            })
            .and_then(|c| c["resistance"].as_f64())
            .expect("M_j,Rd");
        let found = row["M_j_Rd_kNm"].as_f64().expect("M_j,Rd");
        assert!((found / (1e-6 * resistance) - 1.0).abs() < 1e-9, "{row}");
    }
}

/// The merged files have the same bytes for 1, 2 and 5 shards in any order, and for two runs of
/// the same shard at once.
#[test]
fn the_same_bytes_for_any_shards() {
    let bench = bench(CHECKS);
    let merge = |folder: &str| {
        bench.run(&["batch", "merge", folder, "--quiet"]);
        merged(&bench, folder)
    };
    expect(&bench, &["batch", "plan", "sweep.yaml", "-o", "one"], 0);
    let (_, err) = expect(&bench, &["batch", "status", "one"], 3);
    assert!(err.is_empty(), "{err}");
    expect(&bench, &["batch", "run", "one"], 0);
    let (out, _) = expect(&bench, &["batch", "status", "one"], 0);
    assert!(out.starts_with("16 cases: ") && !out.contains("not finished"), "{out}");
    let whole = merge("one");
    for (folder, shards) in
        [("two", vec!["2/2", "1/2"]), ("five", vec!["3/5", "1/5", "5/5", "2/5", "4/5"])]
    {
        expect(&bench, &["batch", "plan", "sweep.yaml", "-o", folder], 0);
        for shard in shards {
            expect(&bench, &["batch", "run", folder, "--shard", shard], 0);
        }
        assert!(merge(folder) == whole, "{folder}");
    }
    expect(&bench, &["batch", "plan", "sweep.yaml", "-o", "twice"], 0);
    let mut both: Vec<_> = (0..2)
        .map(|_| {
            bench.command(&["batch", "run", "twice"]).stderr(Stdio::null()).spawn().expect("starts")
        })
        .collect();
    for child in &mut both {
        assert_eq!(child.wait().expect("ends").code(), Some(0));
    }
    assert!(merge("twice") == whole);
    // an array index of Slurm
    expect(&bench, &["batch", "plan", "sweep.yaml", "-o", "array"], 0);
    for task in ["1", "2"] {
        let mut command = bench.command(&["batch", "run", "array", "--shard", "auto/2"]);
        let run = command.env("SLURM_ARRAY_TASK_ID", task).output().expect("starts");
        assert_eq!(run.status.code(), Some(0));
    }
    assert!(merge("array") == whole);
}

/// A run that is killed at twenty moments loses nothing and computes nothing twice: the folder
/// holds whole files only, and the last run completes it.
#[test]
fn a_killed_run_continues() {
    let sweep = CHECKS.replace("step: 5", "step: 0.01");
    let bench = bench(&sweep);
    expect(&bench, &["batch", "plan", "sweep.yaml", "-o", "whole"], 0);
    expect(&bench, &["batch", "run", "whole", "--quiet"], 0);
    expect(&bench, &["batch", "plan", "sweep.yaml", "-o", "killed"], 0);
    let done = |folder: &str| -> Vec<(String, std::time::SystemTime)> {
        let Ok(dir) = std::fs::read_dir(bench.path().join(folder).join("checks")) else {
            return Vec::new();
        };
        let files = dir.map(|e| e.expect("an entry"));
        let mut files: Vec<_> = files
            .filter(|e| e.file_name().to_string_lossy().ends_with(".jsonl"))
            .map(|e| {
                let time = e.metadata().and_then(|m| m.modified()).expect("a time");
                (e.file_name().to_string_lossy().into_owned(), time)
            })
            .collect();
        files.sort();
        files
    };
    let mut grown = 0;
    for moment in 0..20u64 {
        let before = done("killed");
        let mut child =
            bench.command(&["batch", "run", "killed", "--quiet"]).spawn().expect("starts");
        std::thread::sleep(Duration::from_millis(20 + 13 * (moment * 7 % 11)));
        child.kill().expect("killed");
        child.wait().expect("ended");
        let after = done("killed");
        // what was finished stays as it was
        assert!(before.iter().all(|f| after.contains(f)), "a finished file changed");
        grown += usize::from(after.len() > before.len());
    }
    assert!(grown > 1, "the moments lie before or after all work: {grown}");
    expect(&bench, &["batch", "run", "killed", "--quiet"], 0);
    for folder in ["whole", "killed"] {
        bench.run(&["batch", "merge", folder, "--quiet"]);
    }
    assert!(merged(&bench, "whole") == merged(&bench, "killed"));
}

/// A sweep of T-stubs with finite elements; `limits` are added to it.
pub fn t_stubs(limits: &str) -> Bench {
    let base = "template: t_stub\nmembers: {tee: {profile: IPE300, steel: S235}}\nbolts: {size: \
                M16, grade: \"8.8\", gauge: 100, rows: [0]}\nparameters: {length: 100, welded: \
                true, flange_width: 160, flange_thickness: 12, web_thickness: 10, web_height: \
                30}\nfriction: {mu: 0}\nloads: [{name: PULL, end: top, at: bolt_plane, N: 60 \
                kN}]\nanalysis: {kind: limit, decide: false, max_passes: 1, mesh: {size: 30 mm}}\n";
    let sweep =
        format!("base: joint.yaml\naxes: {{\"loads.PULL.N\": [60 kN, 150 kN, 60 kN]}}\n{limits}");
    Bench::new().file("joint.yaml", base).file("sweep.yaml", sweep)
}

/// Limit analysis of each load: strict bounds, verdicts and exit code; the case that stands twice
/// is computed once, and a second run computes nothing.
#[test]
fn finite_elements_of_every_case() {
    let bench = t_stubs("");
    let (_, err) = expect(&bench, &["batch", "sweep.yaml"], 1);
    assert!(err.contains("the same joint, computed once"), "{err}");
    let rows = rows(&bench, "sweep");
    let outcomes: Vec<&str> = rows.iter().map(|r| r["outcome"].as_str().expect("a word")).collect();
    // the lower bound alone is no complete route
    assert_eq!(outcomes, ["undecided", "not_ok", "undecided"], "{err}");
    for row in &rows {
        let [low, up] = ["lambda_low", "lambda_up"].map(|k| row[k].as_f64().expect("a bound"));
        let load = row["loads.PULL.N"].as_str().expect("a load");
        let load: f64 = load.trim_end_matches(" kN").parse().expect("a number");
        // the beam model gives 75.2 kN; solids carry up to 1.35 times as much
        assert!(low < up && low * load > 60.0 && up * load < 130.0, "{row}");
        let folder = row["result"].as_str().expect("a folder");
        expect(&bench, &["verify", &format!("sweep/{folder}")], 0);
    }
    assert_eq!(rows[0]["result"], rows[2]["result"]);
    let before = bench.everything();
    let (_, err) = expect(&bench, &["batch", "sweep.yaml"], 1);
    assert!(!err.contains("finite elements"), "{err}");
    assert!(bench.everything() == before, "the second run changed a file");
}

/// A result that another sweep left in the cache is not computed again, and the tables are the
/// same.
#[test]
fn sweeps_share_a_cache() {
    let bench = t_stubs("");
    expect(&bench, &["batch", "sweep.yaml", "-o", "first", "--cache", "cache"], 1);
    // a mesher that ends at once: whatever is computed fails
    let mesher = bench.mesher("exit 7");
    let mut second = bench.command(&["batch", "sweep.yaml", "-o", "second", "--cache", "cache"]);
    let run = second.env("BRACKET_GMSH", &mesher).output().expect("starts");
    assert_eq!(run.status.code(), Some(1), "{}", String::from_utf8_lossy(&run.stderr));
    let plain = |folder: &str| -> Vec<Value> {
        let mut rows = rows(&bench, folder);
        for row in &mut rows {
            row.as_object_mut().expect("a row").remove("seconds");
        }
        rows
    };
    assert_eq!(plain("first"), plain("second"));
    let folder = plain("second")[0]["result"].as_str().expect("a folder").to_owned();
    expect(&bench, &["verify", &format!("second/{folder}")], 0);
    for folder in ["cache/work", "second/work"] {
        let left = std::fs::read_dir(bench.path().join(folder)).map(|d| d.count()).unwrap_or(0);
        assert_eq!(left, 0, "{folder}");
    }
}

/// What each case may take is added up: fewer run side by side where it exceeds the machine.
#[test]
fn memory_limits_are_added_up() {
    let bench = t_stubs("limits: {memory: 100000 GiB}\n");
    // a mesher that ends at once: nothing needs to be solved
    let mesher = bench.mesher("exit 7");
    let mut command = bench.command(&["batch", "sweep.yaml", "--jobs", "2"]);
    let run = command.env("BRACKET_GMSH", &mesher).output().expect("starts");
    let err = String::from_utf8_lossy(&run.stderr);
    assert_eq!(run.status.code(), Some(4), "{err}");
    assert!(err.contains("1 at once in place of 2"), "{err}");
}

/// A case that waits for limit analysis is open, whatever its checks say.
#[test]
fn checks_are_no_answer_where_limit_analysis_follows() {
    let bench = bench(&format!("{CHECKS}then: {{limit: passing}}\n"));
    expect(&bench, &["batch", "plan", "sweep.yaml", "-o", "x"], 0);
    // a mesher that ends at once: the checks are done, no case has limit analysis
    let mesher = bench.mesher("exit 7");
    let run = |args: &[&str]| {
        let run = bench.command(args).env("BRACKET_GMSH", &mesher).output().expect("starts");
        String::from_utf8_lossy(&run.stdout).into_owned()
    };
    run(&["batch", "run", "x"]);
    std::fs::remove_dir_all(bench.path().join("x/records")).expect("removed");
    let out = run(&["batch", "status", "x"]);
    let open = out.split(", ").last().unwrap_or_default();
    assert!(open.contains("not finished") && !out.contains(" ok"), "{out}");
}

/// A disk that is full in the middle: a named error, no half-written file, and the same tables as
/// without it once there is room. The limit of the size of a file stands for the disk.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_ends_a_run_in_order() {
    let sweep = CHECKS.replace("step: 5", "step: 0.01");
    let bench = bench(&sweep);
    for folder in ["whole", "full"] {
        expect(&bench, &["batch", "plan", "sweep.yaml", "-o", folder, "--quiet"], 0);
    }
    expect(&bench, &["batch", "run", "whole", "--quiet"], 0);
    expect(&bench, &["batch", "run", "full", "--shard", "1/3", "--quiet"], 0);
    let program = env!("CARGO_BIN_EXE_bracket");
    for (blocks, args) in [(1, "run full"), (20, "merge whole")] {
        let line = format!("trap '' XFSZ; ulimit -f {blocks}; exec {program} batch {args} --quiet");
        let mut command = std::process::Command::new("sh");
        let run = command.args(["-c", &line]).current_dir(bench.path()).output().expect("starts");
        let err = String::from_utf8_lossy(&run.stderr);
        assert_eq!(run.status.code(), Some(4), "{args}: {err}");
        assert!(err.contains("sweep/io") || err.contains("sweep/disk-full"), "{args}: {err}");
        assert_eq!(err.matches("error[").count(), 1, "{err}");
        for file in bench.everything().keys() {
            assert!(!file.to_string_lossy().ends_with(".part"), "{file:?}");
        }
    }
    expect(&bench, &["batch", "run", "full", "--quiet"], 0);
    for folder in ["whole", "full"] {
        bench.run(&["batch", "merge", folder, "--quiet"]);
    }
    assert!(merged(&bench, "whole") == merged(&bench, "full"));
}

/// A capacity is the load factor times the load of the case, also where `set` gives the load.
#[test]
fn capacities_do_not_depend_on_how_the_load_is_written() {
    let capacity = |load: &str| {
        let tables = "tables: [{title: T, rows: members.beam.profile, columns: plate.thickness, \
                      action: My}]\n";
        let sweep = CHECKS.replace("set:\n", &format!("set:\n{load}"));
        let bench = bench(&format!("{sweep}{tables}expect: [bad_input == 0]\n"));
        expect(&bench, &["batch", "sweep.yaml"], 0);
        let rows = rows(&bench, "sweep");
        let table = bench.read("sweep/tables.md");
        for row in &rows {
            let moment = row["M_j_Rd_kNm"].as_f64().expect("M_j,Rd");
            let shown = format!("({:.1})", (10.0 * moment).floor() / 10.0);
            assert!(table.contains(&shown), "{shown} in {table}");
        }
        table
    };
    // without axial force the capacity is M_j,Rd, whatever the load
    let [given, set] = ["", "  loads.ULS1.My: -20 kN m\n"].map(capacity);
    assert_eq!(given.replace(" (a check fails)", ""), set.replace(" (a check fails)", ""));
}

/// What changed since the plan, and a plan that was cut off, are refused: results would stand under
/// the wrong keys.
#[test]
fn a_plan_of_other_inputs_is_refused() {
    let template = include_str!("../../../templates/beam_splice.yaml");
    let base = SPLICE.replace("template: beam_splice", "template: ./mine.yaml");
    let bench = Bench::new()
        .file("joint.yaml", base)
        .file("mine.yaml", template)
        .file("sweep.yaml", CHECKS);
    expect(&bench, &["batch", "plan", "sweep.yaml", "-o", "x"], 0);
    std::fs::write(bench.path().join("mine.yaml"), format!("{template}# a remark\n")).expect("ok");
    // the plan knows where the template is, from any folder
    let mut elsewhere = bench.command(&["batch", "run", &bench.path().join("x").to_string_lossy()]);
    assert!(elsewhere.current_dir("/").status().expect("starts").success());
    let changed = template.replace("plate.thickness, about", "plate.thickness, about: x, about");
    let changed = if changed == template {
        template.replacen("title:", "title: Other; was", 1)
    } else {
        changed
    };
    std::fs::write(bench.path().join("mine.yaml"), changed).expect("written");
    let (_, err) = expect(&bench, &["batch", "run", "x"], 2);
    assert!(err.contains("sweep/changed"), "{err}");
    std::fs::write(bench.path().join("mine.yaml"), template).expect("written");
    let cases = bench.read("x/cases.jsonl");
    let fewer: String = cases.lines().take(3).map(|l| format!("{l}\n")).collect();
    std::fs::write(bench.path().join("x/cases.jsonl"), fewer).expect("written");
    let (_, err) = expect(&bench, &["batch", "run", "x"], 2);
    assert!(err.contains("sweep/torn"), "{err}");
    // the help holds: planning again mends it, also where the plan itself is damaged
    std::fs::write(bench.path().join("x/plan.json"), "{").expect("written");
    expect(&bench, &["batch", "plan", "sweep.yaml", "-o", "x"], 0);
    expect(&bench, &["batch", "run", "x"], 0);
}

/// A table may say which verdict each joint has; a joint with another one is named.
#[test]
fn expected_verdicts_of_a_table() {
    let table = "name,loads.ULS1.My [kN m],expect\nA,-20,ok\nB,-200,not ok\nC,-20,\n";
    let sweep = "base: joint.yaml\nfirst: checks\ntable: t.csv\n";
    let right = bench(sweep).file("t.csv", table);
    expect(&right, &["batch", "sweep.yaml"], 0);
    let wrong = bench(sweep).file("t.csv", table.replace("not ok", "ok"));
    let (_, err) = expect(&wrong, &["batch", "sweep.yaml"], 1);
    assert!(err.contains("expected, and not so: B: ok, found not_ok"), "{err}");
}

/// Conditions on the outcome replace the rule of the worst case.
#[test]
fn expected_outcomes_decide_the_exit_code() {
    for (expected, code) in [("[\"failed == 0\"]", 0), ("[\"ok == cases\"]", 1)] {
        let bench = bench(&format!("{CHECKS}expect: {expected}\n"));
        let (_, err) = expect(&bench, &["batch", "sweep.yaml"], code);
        assert_eq!(err.contains("expected, and not so: ok == cases"), code == 1, "{err}");
    }
}
