//! `bracket check` and `bracket watch`, and the verdict by code of `run`: verdicts and exit codes
//! without an analysis of the resistance.

use crate::bench::Bench;
use crate::bench::expect;
use serde_json::Value;
use std::io::{BufRead, BufReader};
use std::process::Stdio;

/// HEB140 and IPE270 with M16 under a moment [kN m].
fn joint(moment: f64, kind: &str) -> String {
    format!(
        "template: beam_to_column_end_plate\nmembers: {{column: {{profile: HEB140, steel: S235}}, \
         beam: {{profile: IPE270, steel: S235}}}}\nplate: {{thickness: 15}}\nbolts: {{size: M16, \
         grade: \"8.8\", rows: [-85, 85, 170]}}\nloads: [{{name: ULS1, end: beam_right, at: \
         column_face, My: {moment} kN m}}]\nanalysis: {{kind: {kind}, max_passes: 1, mesh: {{\
         layers: false}}}}\n"
    )
}

fn result(bench: &Bench, folder: &str) -> Value {
    serde_json::from_str(&bench.read(&format!("{folder}/result.json"))).expect("JSON")
}

/// The last line of standard error of a run.
fn last(err: &str) -> &str {
    err.lines().last().unwrap_or_default()
}

/// `check` refuses an overload without a mesher, and `run` refuses it whatever the elastic analysis
/// finds. Both accept a small load.
#[test]
fn a_demand_ends_with_a_verdict_by_check_and_by_an_elastic_run() {
    let bench = Bench::new()
        .file("over.yaml", joint(100.0, "elastic"))
        .file("well.yaml", joint(20.0, "elastic"));
    for (name, code, word, says) in [("over", 1, "not_ok", "NOT OK"), ("well", 0, "ok", "OK")] {
        let spec = format!("{name}.yaml");
        let proved = if code == 0 { "OK — by code" } else { says };
        // `check` needs no mesher: it does not notice that this one does not exist
        let mut command = bench.command(&["check", &spec]);
        command.env("BRACKET_GMSH", "/nowhere/gmsh");
        let ended = command.output().expect("the program starts");
        let err = String::from_utf8_lossy(&ended.stderr).into_owned();
        assert_eq!(ended.status.code(), Some(code), "{err}");
        let line = last(&err);
        assert!(
            line.starts_with(&format!("verdict: {proved} (by code {says}, by analysis none)")),
            "{line}"
        );
        assert!(
            line.contains("EN 1993-1-8") && line.contains(&format!("exit code {code}")),
            "{line}"
        );
        let checked = result(&bench, &format!("{name}_check"));
        assert_eq!(
            (&checked["verdict"], &checked["judgement"]["by_code"]),
            (&word.into(), &word.into())
        );
        assert_eq!(checked["cases"].as_array().map(Vec::len), Some(0));
        for file in [
            "report.md",
            "report.html",
            "drawing.svg",
            "actions.svg",
            "moment_axial.svg",
            "log.txt",
        ] {
            assert!(bench.path().join(format!("{name}_check/{file}")).is_file(), "{name}: {file}");
        }
        assert!(
            bench
                .read(&format!("{name}_check/report.md"))
                .contains(&format!("Verdict: **{proved}**"))
        );
        let (_, err) = expect(&bench, &["run", &spec, "--size-factor", "4"], code);
        assert!(
            last(&err)
                .starts_with(&format!("verdict: {proved} (by code {says}, by analysis none)")),
            "{err}"
        );
        // the verdict by code is printed before meshing starts
        let early =
            err.lines().position(|l| l.starts_with(&format!("by code alone: {says}: ULS1")));
        let meshed = err.lines().position(|l| l.contains("tets,"));
        assert!(early.is_some() && early < meshed, "{err}");
        let run = result(&bench, name);
        assert_eq!(run["verdict"], word);
        let demand = &run["cases"][0]["demand"];
        assert_eq!((&demand["verdict"], &demand["by_analysis"]), (&word.into(), &"none".into()));
        // `run` reports the same checks, digit by digit
        assert_eq!(run["checks"], checked["checks"]);
    }
}

/// A pressure is no demand and has no verdict. The verdict is undecided for a part of a joint that
/// neither the checks nor a limit analysis cover.
#[test]
fn what_is_no_demand_has_no_verdict_and_what_nothing_covers_is_undecided() {
    let bench = Bench::new().file("paper.yaml", crate::bench::JOINT).file(
        "tee.yaml",
        "template: t_stub\nmembers: {tee: {profile: IPE300, steel: S235}}\nbolts: {size: M16, \
         grade: \"8.8\", gauge: 100, rows: [0]}\nparameters: {length: 100}\nloads: [{name: ULS1, \
         end: top, at: bolt_plane, N: 20 kN}]\n",
    );
    let (_, err) = expect(&bench, &["check", "paper.yaml"], 0);
    assert!(last(&err).starts_with("verdict: none (no load is a demand)"), "{err}");
    let (_, err) = expect(&bench, &["check", "tee.yaml"], 3);
    assert!(last(&err).starts_with("verdict: UNDECIDED (by code none, by analysis none)"), "{err}");
    assert!(bench.read("tee_check/report.md").contains("no check of the code covers the load"));
}

/// `--out` names the folder. `--format json` prints the result. A folder that the program did not
/// write is kept. A second check replaces the first.
#[test]
fn check_writes_its_own_folder_and_nothing_else() {
    let bench = Bench::new().file("well.yaml", joint(20.0, "limit"));
    std::fs::create_dir(bench.path().join("mine")).expect("a folder");
    let bench = bench.file("mine/notes.txt", "mine");
    let ended = bench.run(&["check", "well.yaml", "--out", "looked", "--format", "json", "-q"]);
    assert_eq!(ended.status.code(), Some(0));
    let json: Value = serde_json::from_slice(&ended.stdout).expect("JSON on standard output");
    assert_eq!(json, result(&bench, "looked"));
    assert!(ended.stderr.is_empty(), "{}", String::from_utf8_lossy(&ended.stderr));
    expect(&bench, &["check", "well.yaml", "--out", "looked"], 0);
    let before = bench.everything();
    let (_, err) = expect(&bench, &["check", "well.yaml", "--out", "mine"], 2);
    assert!(err.contains("is not a result folder"), "{err}");
    assert_eq!(bench.everything(), before);
    // the folder named after the spec is reserved for `run`
    assert!(!bench.path().join("well").exists() && !bench.path().join("well_check").exists());
}

/// `watch` repeats the checks when the spec changes, also after a wrong spec.
#[test]
fn watch_repeats_on_every_change() {
    let bench = Bench::new().file("joint.yaml", joint(20.0, "limit"));
    let mut watching = bench
        .command(&["watch", "joint.yaml"])
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut lines =
        BufReader::new(watching.stderr.take().expect("a pipe")).lines().map_while(Result::ok);
    let mut next = |words: &str| lines.by_ref().any(|l| l.contains(words));
    assert!(next("verdict: OK"));
    for (text, words) in [
        (joint(100.0, "limit"), "verdict: NOT OK"),
        ("template: [".into(), "error"),
        (joint(20.0, "limit"), "verdict: OK"),
    ] {
        // the file is replaced in one step, as editors do
        std::fs::write(bench.path().join("new"), text).expect("written");
        std::fs::rename(bench.path().join("new"), bench.path().join("joint.yaml"))
            .expect("renamed");
        assert!(next(words), "{words}");
    }
    watching.kill().expect("it runs");
    watching.wait().expect("it ended");
}

/// Wrong keys and options of `check` are refused with one message each, and nothing is written.
#[test]
fn wrong_inputs_of_check_are_refused_with_place_and_cure() {
    let sound = joint(20.0, "limit");
    let with = |old: &str, new: &str| sound.replacen(old, new, 1);
    let wrong = [
        (with("column: {profile", "column: {N_Ed: 800, profile"), "members.column.N_Ed", "kN"),
        (with("beam: {profile", "beam: {N_Ed: -80 kN, profile"), "members.beam.N_Ed", "loads"),
        (with("beam: {profile", "beam: {V_Ed: 80 kN, profile"), "members.beam.V_Ed", "loads"),
        (format!("code: {{prying: never}}\n{sound}"), "code.prying", "by_length"),
        (format!("code: {{gamma_M1: 9}}\n{sound}"), "code.gamma_M1", "0.5 to 3"),
        (format!("code: {{annex: XX}}\n{sound}"), "annex", "bracket catalog list annexes"),
        (with("profile: IPE270", "profile: IPE275"), "IPE275", "IPE270"),
        (format!("catalog: ./nowhere\n{sound}"), "catalog", "nowhere"),
        (with("My: 20 kN m", "My: 20"), "My", "kN m"),
    ];
    for (text, place, cure) in wrong {
        let bench = Bench::new().file("joint.yaml", &text);
        let before = bench.everything();
        let (_, err) = expect(&bench, &["check", "joint.yaml"], 2);
        assert!(err.contains(place) && err.contains(cure), "{place}, {cure}: {err}");
        assert_eq!(bench.everything(), before, "{place}");
    }
}

/// A column pressed beyond its own strength is judged, and a warning asks for the number.
#[test]
fn forces_beyond_the_column_are_not_ok_with_a_warning() {
    for (given, name) in [("N_Ed: -8000 kN", "N_Ed"), ("M_Ed: 500 kN m", "M_Ed")] {
        let text = joint(20.0, "limit").replacen(
            "column: {profile",
            &format!("column: {{{given}, profile"),
            1,
        );
        let bench = Bench::new().file("joint.yaml", &text);
        let (_, err) = expect(&bench, &["check", "joint.yaml"], 1);
        assert!(err.contains(&format!("members.column.{name}")), "{err}");
        assert!(err.contains("check the number and its unit"), "{err}");
    }
}
