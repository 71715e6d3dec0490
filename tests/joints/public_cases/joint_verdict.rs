//! The joint verdict: what the complete routes prove, beside analyses that are wide, cut off, or of
//! no use because no rule of rotation capacity holds.

use super::answer::Answer;
use crate::bench::Bench;
use serde_json::Value;
use std::time::Instant;

/// The answer of `bracket run` to a spec, with further options.
fn run(text: &str, options: &[&str]) -> Answer {
    let bench = Bench::new().file("joint.yaml", text);
    Answer::from(bench, &[&["run", "joint.yaml", "--out", "out"], options].concat())
}

/// What `verify` says about the result, which it must confirm.
fn confirmed(answer: &Answer) {
    let verified = answer.bench.run(&["verify", "out"]);
    let said = String::from_utf8_lossy(&verified.stdout).into_owned();
    assert_eq!(verified.status.code(), Some(0), "{said}");
}

/// A text of the judgement.
fn judged<'a>(answer: &'a Answer, key: &str) -> &'a str {
    answer.result["judgement"][key].as_str().unwrap_or("absent")
}

/// Warnings of the whole result as one text.
fn warnings(answer: &Answer) -> String {
    let all = answer.result["warnings"].as_array().cloned().unwrap_or_default();
    all.iter().filter_map(Value::as_str).collect::<Vec<_>>().join("\n")
}

/// M_j,Rd of the splice by hand, its row below the flange cut by 6.2.7.2(9): 172.0 kN m, of which
/// 150 kN m are 0.872.
const USED: f64 = 150.0 / 172.0;

/// The largest utilisation by the component method.
fn used(answer: &Answer) -> f64 {
    let of = |c: &&Value| c["utilisation"].as_f64();
    let all = answer.titled("moment and axial force of the joint");
    all.iter().filter_map(of).fold(0.0, f64::max)
}

#[test]
fn a_thick_plate_is_ok_by_code_whatever_the_lower_bound_is_worth() {
    let name = "06-run-worse-than-check.yaml";
    let checked = Answer::of(name);
    assert_eq!((checked.code, checked.verdict()), (0, "ok"), "{}", checked.said);
    assert_eq!((judged(&checked, "route"), judged(&checked, "by_analysis")), ("code", "none"));
    assert!((used(&checked) / USED - 1.0).abs() < 0.002, "{}", used(&checked));
    assert!(checked.said.contains("verdict: OK — by code"), "{}", checked.said);
    // what OK by code does not permit is said without any analysis
    let rule = "no rule of rotation capacity holds: plastic global analysis may not rely";
    assert!(checked.said.contains(rule) && checked.report.contains(rule), "{}", checked.said);
    assert!(warnings(&checked).contains(rule));
    let text = Answer::input(name).replace("kind: limit", "kind: limit, mesh: {layers: false}");
    let coarse = run(&text, &["--size-factor", "4", "--max-passes", "1"]);
    assert_eq!((coarse.code, coarse.verdict()), (0, "ok"), "{}", coarse.said);
    let three = ["route", "by_code", "by_analysis"].map(|k| judged(&coarse, k));
    assert_eq!(three, ["code", "ok", "undecided"], "{}", coarse.said);
    assert!(judged(&coarse, "reason").contains("beside it"), "{}", judged(&coarse, "reason"));
    assert!(!coarse.report.contains("leave out limit analysis"), "{}", coarse.report);
    assert!(coarse.report.contains("Verdict: **OK — by code**"), "{}", coarse.report);
    // what the missing rule limits is said, and is no part of the verdict
    let demand = &coarse.result["cases"][0]["demand"];
    assert_eq!((&demand["verdict"], &demand["route"]), (&"ok".into(), &"code".into()));
    assert!(demand["brittle"].as_str().is_some_and(|b| b.contains("plastic global analysis")));
    assert!(coarse.report.contains("The lower bound alone decides nothing"), "{}", coarse.report);
    assert!(coarse.said.contains("warning: no rule of rotation capacity holds"), "{}", coarse.said);
    confirmed(&coarse);
    // a route that is claimed otherwise is refuted
    let forged = |text: String| text.replacen("\"route\": \"code\"", "\"route\": \"analysis\"", 1);
    let (code, said) = coarse.bench.verify_after("out", &|bench| {
        let text = forged(bench.read("out/result.json"));
        std::fs::write(bench.path().join("out/result.json"), text).expect("written");
    });
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("route"), "{said}");
}

/// The verdict of a run is that of the checks, whatever its time limit leaves of the analyses; it
/// ends in time, and names what was not analysed. `started`: the verdict by an analysis that was
/// started.
fn as_checked(text: &str, seconds: f64, started: &str) -> Answer {
    let checked = Answer::to(text);
    assert_eq!(checked.verdict(), "ok", "{}", checked.said);
    let start = Instant::now();
    let answer = run(text, &[]);
    // the report is written after the limit
    assert!(start.elapsed().as_secs_f64() < 2.0 * seconds + 60.0, "{}", answer.said);
    assert_eq!((answer.code, answer.verdict()), (0, "ok"), "{}", answer.said);
    assert_eq!(judged(&answer, "route"), "code", "{}", answer.said);
    let cases = answer.result["cases"].as_array().expect("cases");
    // the mesher may need all of the time, so that nothing is started
    let by_analysis = if cases.is_empty() { "none" } else { started };
    assert_eq!(judged(&answer, "by_analysis"), by_analysis, "{}", answer.said);
    let bare = |c: &&Value| c["lower"].is_null() && c["upper"].is_null();
    for c in cases.iter().filter(bare) {
        let name = c["name"].as_str().expect("a name");
        assert!(
            warnings(&answer)
                .split("without any bound: ")
                .nth(1)
                .is_some_and(|listed| listed.contains(name)),
            "{}",
            answer.said
        );
        assert!(answer.report.contains("**not analysed**"), "{}", answer.report);
    }
    let asked = answer.result["asked"].as_array().expect("asked").len();
    if cases.len() < asked {
        assert!(warnings(&answer).contains("not analysed were"), "{}", answer.said);
    }
    assert!(!answer.report.contains("history below says why"), "{}", answer.report);
    confirmed(&answer);
    answer
}

/// Stiffeners are asked for, so that the joint holds whatever the default is.
fn stiffened(name: &str) -> String {
    let text = Answer::input(name);
    match text.contains("column_stiffeners:") {
        true => text,
        false => text.replace("parameters:\n", "parameters:\n  column_stiffeners: true\n"),
    }
}

#[test]
fn an_elastic_analysis_that_is_cut_off_brackets_no_resistance() {
    let text = stiffened("23-elastic-cut-off.yaml");
    let text = text.replace("time_limit: 12 s", "time_limit: 6 s");
    as_checked(&text, 6.0, "none");
    // the same of the other kind that brackets energies
    as_checked(&text.replace("kind: elastic", "kind: elastoplastic"), 6.0, "none");
}

#[test]
fn a_time_limit_takes_nothing_from_two_cases_that_hold_by_code() {
    let text = stiffened("24-time-for-two-cases.yaml");
    let text = text.replace("time_limit: 3 min", "time_limit: 8 s");
    let answer = as_checked(&text, 8.0, "undecided");
    assert!(answer.said.contains("ULS2"), "{}", answer.said);
}

/// A mesher that the time limit stops leaves the verdict of the checks; without checks of the load
/// the verdict is undecided and says what is missing.
#[test]
fn without_a_mesh_the_checks_keep_their_verdict() {
    let slow = |bench: &Bench, [out, spec, mesher]: [&str; 3]| {
        let mut command = bench.command(&["run", spec, "--out", out]);
        let run = command.env("BRACKET_GMSH", mesher).output().expect("the program starts");
        let said = String::from_utf8_lossy(&run.stderr).into_owned();
        let path = bench.path().join(out).join("result.json");
        let result = std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{e}: {said}"));
        let result: Value = serde_json::from_str(&result).expect("JSON");
        (run.status.code(), result["judgement"].clone(), said)
    };
    let splice = Answer::input("06-run-worse-than-check.yaml").replace("3 min", "2 s");
    let stub = "template: t_stub\nmembers: {tee: {profile: IPE300, steel: S235}}\nbolts: {size: \
                M16, grade: \"8.8\", gauge: 100, rows: [0]}\nloads: [{name: U, end: top, at: \
                bolt_plane, N: 20 kN}]\nanalysis: {kind: limit, time_limit: 2 s}\n";
    let bench = Bench::new().file("splice.yaml", splice).file("stub.yaml", stub);
    // one mesher does not even give its version, the other gives it and makes no mesh
    let mute = "[\"sh\", \"-c\", \"exec sleep 60\"]";
    let idle = &bench.mesher("exec sleep 60");
    for (out, mesher) in [("mute", mute), ("idle", idle)] {
        let (code, judgement, said) = slow(&bench, [out, "splice.yaml", mesher]);
        assert_eq!((code, &judgement["route"]), (Some(0), &"code".into()), "{said}");
        assert!(said.contains("not analysed were U"), "{said}");
    }
    let (code, judgement, said) = slow(&bench, ["stub", "stub.yaml", idle]);
    assert_eq!((code, &judgement["verdict"]), (Some(3), &"undecided".into()), "{said}");
    let reason = judgement["reason"].as_str().expect("a reason");
    for words in ["no check of the code covers the load", "was not run", "`time_limit`"] {
        assert!(reason.contains(words), "{reason}");
    }
    for folder in ["mute", "idle", "stub"] {
        let verified = bench.run(&["verify", folder]);
        let text = String::from_utf8_lossy(&verified.stdout).into_owned();
        assert_eq!(verified.status.code(), Some(0), "{text}");
    }
}
