//! Actions that are rounding, and load cases in which nothing acts.

use super::PLAIN;
use super::answer::Answer;
use crate::bench::Bench;
use serde_json::Value;

const NOISE: &str = "03-noise-in-torsion.yaml";
const ZERO: &str = "05-zero-load-case.yaml";

/// Case, end and action of what is neglected.
fn neglected(answer: &Answer) -> Vec<(&str, &str, &str)> {
    let all = answer.result["neglected"].as_array().map_or(&[][..], Vec::as_slice);
    let text = |n: &'static str| move |v: &'static str| (n, v);
    let _ = text;
    all.iter()
        .map(|n| {
            let of = |key: &str| n[key].as_str().expect("a text");
            (of("case"), of("end"), of("action"))
        })
        .collect()
}

fn checked(answer: &Answer) -> Vec<(String, Option<f64>)> {
    let of = |c: &Value| {
        let place = format!("{} {} {}", c["case"], c["subject"], c["title"]);
        (place, c["utilisation"].as_f64())
    };
    answer.checks().iter().map(of).collect()
}

/// Rounding in T, Mz, Vy or N is named once and changes nothing else.
#[test]
fn rounding_is_named_and_neglected() {
    let text = Answer::input(NOISE);
    let clean = Answer::to(&text.replace(", T: 0.0001 N m", ""));
    assert_eq!((clean.code, clean.verdict()), (0, "ok"), "{}", clean.said);
    assert!(neglected(&clean).is_empty());
    let with_t = Answer::of(NOISE);
    assert_eq!(neglected(&with_t), [("U", "beam_right", "T")]);
    // I_t/t_f f_y/√3 of an IPE400 in S355: 51.08 cm⁴/13.5 mm · 205 MPa = 7.76 kN m
    let entry = &with_t.result["neglected"][0];
    let number = |key: &str| entry[key].as_f64().expect("a number");
    assert!((number("value") - 0.1).abs() < 1e-12, "{entry}");
    assert!((number("resistance") / 7.755e6 - 1.0).abs() < 0.02, "{entry}");
    assert!((number("share") * number("resistance") / 0.1 - 1.0).abs() < 1e-12, "{entry}");
    let warnings = with_t.result["warnings"].as_array().expect("warnings");
    let named: Vec<&Value> = warnings
        .iter()
        .filter(|w| w.as_str().is_some_and(|w| w.contains("neglected") && w.contains("T =")))
        .collect();
    assert_eq!(named.len(), 1, "{warnings:?}");
    assert!(with_t.report.contains("neglected"), "the report names it");
    for noise in
        ["T: 0.0001 N m", "Vy: 1 N", "Mz: 1 N m", "Vy: -1 N, Mz: -1 N m, T: 5 N m", "N: 1 N"]
    {
        let noisy = Answer::to(&text.replace("T: 0.0001 N m", noise));
        assert_eq!((noisy.code, noisy.verdict()), (0, "ok"), "{noise}: {}", noisy.said);
        assert_eq!(neglected(&noisy).len(), noise.matches(':').count(), "{noise}");
        assert_eq!(checked(&noisy), checked(&clean), "{noise}");
    }
    // given at the node, a shear force of 1 N turns about the bolt plane with 150 mm
    let at_node =
        Answer::to(&text.replace("column_face", "node").replace("T: 0.0001 N m", "Vy: 1 N"));
    assert_eq!(neglected(&at_node), [("U", "beam_right", "Vy"), ("U", "beam_right", "Mz")]);
    assert_eq!(at_node.verdict(), "ok");
}

/// Torsion and weak-axis moments beyond 1 % have no method and are named; Vy has one.
#[test]
fn what_is_more_than_rounding_stays() {
    let text = Answer::input(NOISE);
    for (actions, words) in [("T: 160 N m", "torsion"), ("Mz: 1.2 kN m", "weak axis")] {
        let answer = Answer::to(&text.replace("T: 0.0001 N m", actions));
        assert_eq!((answer.code, answer.verdict()), (3, "undecided"), "{}", answer.said);
        assert!(neglected(&answer).is_empty());
        let reason = answer.result["judgement"]["reason"].as_str().expect("a reason");
        assert!(reason.contains(words), "{actions}: {reason}");
    }
    let answer = Answer::to(&text.replace("T: 0.0001 N m", "Vy: 20 kN"));
    assert_eq!((answer.code, answer.verdict()), (0, "ok"), "{}", answer.said);
}

/// Many cases with rounding give one sentence.
#[test]
fn rounding_of_many_cases_is_one_warning() {
    let load = |i: usize| {
        format!(
            "{{name: U{i}, end: beam_right, at: bolt_plane, My: {} kN m, T: {}e-4 N m, Vy: 2 N}}",
            i + 5,
            i + 1
        )
    };
    let loads: Vec<String> = (0..8).map(load).collect();
    let start = PLAIN.split_once("loads:").expect("loads").0;
    let answer = Answer::to(&format!("{start}loads: [{}]\n", loads.join(", ")));
    assert_eq!(answer.verdict(), "ok", "{}", answer.said);
    assert_eq!(neglected(&answer).len(), 16);
    let all = answer.result["warnings"].as_array().expect("warnings");
    let neglects = |w: &&Value| w.as_str().is_some_and(|w| w.contains("neglected"));
    let warnings: Vec<&Value> = all.iter().filter(neglects).collect();
    assert_eq!(warnings.len(), 1, "{all:?}");
    assert!(warnings[0].as_str().is_some_and(|w| w.contains("8 load cases")), "{warnings:?}");
}

/// `verify` recomputes what is neglected and refutes another list.
#[test]
fn verify_knows_what_is_neglected() {
    let answer = Answer::of(NOISE);
    let run = answer.bench.run(&["verify", "out"]);
    assert_eq!(run.status.code(), Some(0), "{}", String::from_utf8_lossy(&run.stdout));
    let (code, said) = answer.bench.verify_after("out", &|bench: &Bench| {
        let text = bench.read("out/result.json").replace("\"action\": \"T\"", "\"action\": \"Mz\"");
        std::fs::write(bench.path().join("out/result.json"), text).expect("written");
    });
    assert!(code == Some(1) && said.contains("neglected"), "{code:?}: {said}");
}

/// A load case of zeros is reported with utilisation 0 beside the others.
#[test]
fn a_case_of_zeros_is_reported_with_0() {
    let text = Answer::input(ZERO);
    for zeros in ["My: 0 kN m, Vz: 0 kN", "My: 1e-9 N mm", "N: 0 kN, T: 0 kN m", "Vy: 0.01 N"] {
        let answer = Answer::to(&text.replace("My: 0 kN m, Vz: 0 kN", zeros));
        assert_eq!((answer.code, answer.verdict()), (0, "ok"), "{zeros}: {}", answer.said);
        let nothing = answer.titled("nothing acts");
        assert_eq!(nothing.len(), 1, "{zeros}");
        assert_eq!(
            (nothing[0]["case"].as_str(), nothing[0]["utilisation"].as_f64()),
            (Some("SNOW"), Some(0.0))
        );
        let dead = answer.titled("moment and axial force of the joint");
        assert!(dead.iter().any(|c| c["case"] == "DEAD" && c["status"] == "ok"), "{zeros}");
        let warnings = format!("{}", answer.result["warnings"]);
        assert!(warnings.contains("nothing acts in the load case `SNOW`"), "{warnings}");
    }
    // what DEAD asks of the joint decides, whatever SNOW does
    let failing = Answer::to(&text.replace("20 kN m", "200 kN m"));
    assert_eq!((failing.code, failing.verdict()), (1, "not_ok"), "{}", failing.said);
    // a case of zeros at serviceability is no demand at the ultimate limit state
    let service = Answer::to(&text.replace("Vz: 0 kN}", "Vz: 0 kN, state: SLS}"));
    assert_eq!(service.verdict(), "ok", "{}", service.said);
}

/// A spec whose cases are all zero has the answer that nothing acts; a run of it needs no mesher.
#[test]
fn a_spec_of_zeros_is_ok_with_0() {
    let text = Answer::input(ZERO).replace("20 kN m", "0 kN m");
    let answer = Answer::to(&text);
    assert_eq!((answer.code, answer.verdict()), (0, "ok"), "{}", answer.said);
    assert_eq!(answer.titled("nothing acts").len(), 2);
    let governing = &answer.result["judgement"]["governing"]["utilisation"];
    assert_eq!(governing, &serde_json::json!([0.0, 0.0]));
    let bench = Bench::new().file("joint.yaml", &text);
    let run = Answer::from(bench, &["run", "joint.yaml", "--out", "out"]);
    assert_eq!((run.code, run.verdict()), (0, "ok"), "{}", run.said);
    let verified = run.bench.run(&["verify", "out"]);
    assert_eq!(verified.status.code(), Some(0), "{}", String::from_utf8_lossy(&verified.stdout));
    // all at serviceability: no case at the ultimate limit state was given
    let service = Answer::to(
        &text.replace("kN}", "kN, state: SLS}").replace("0 kN m}", "0 kN m, state: SLS}"),
    );
    assert_eq!((service.code, service.verdict()), (3, "undecided"), "{}", service.said);
}

/// A row of zeros in a sweep is a row like others.
#[test]
fn a_sweep_with_a_row_of_zeros_is_complete() {
    let sweep =
        "base: joint.yaml\nfirst: checks\naxes:\n  loads[0].My: [0 kN m, 10 kN m, 500 kN m]\n";
    let bench = Bench::new().file("joint.yaml", PLAIN).file("sweep.yaml", sweep);
    let run = bench.run(&["batch", "sweep.yaml"]);
    let said = String::from_utf8_lossy(&run.stderr).into_owned();
    let outcomes: Vec<Value> = bench
        .read("sweep/results.jsonl")
        .lines()
        .map(|l| serde_json::from_str::<Value>(l).expect("JSON")["outcome"].clone())
        .collect();
    assert_eq!(outcomes, ["ok", "ok", "not_ok"], "{said}");
    assert_ne!(run.status.code(), Some(2), "{said}");
}
