//! The library calls beside the commands: `bracket::check` and `bracket::run` give the result that
//! `bracket check` and `bracket run` write, and leave no file.

use super::bench::{Bench, expect};
use bracket::model::AnalysisKind;
use bracket::{Limits, Overrides, SpecInput};
use serde_json::Value;
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::sync::{Arc, Mutex};

const SPLICE: &str = include_str!("../../examples/splice_flush/joint.yaml");
/// A T-stub whose analyses take seconds.
const STUB: &str = "template: t_stub\nmembers: {tee: {profile: IPE300, steel: S235}}\nbolts: \
                    {size: M16, grade: \"8.8\", gauge: 100, rows: [0]}\nparameters: {length: \
                    100, welded: true, flange_thickness: 12, flange_width: 160, web_height: 30}\n\
                    friction: {mu: 0}\nloads: [{name: ULS1, end: top, at: bolt_plane, N: 20 kN}]\n\
                    analysis: {kind: limit, mesh: {layers: false}}\n";

/// Names of the files in the current folder.
fn here() -> BTreeSet<OsString> {
    std::fs::read_dir(".").unwrap().map(|e| e.unwrap().file_name()).collect()
}

/// Removes times and memory, in which two runs differ.
fn without_times(value: &mut Value) {
    match value {
        Value::Object(map) => {
            map.retain(|k, _| !k.ends_with("seconds") && k != "peak_memory_mib");
            map.values_mut().for_each(without_times);
        }
        Value::Array(items) => items.iter_mut().for_each(without_times),
        _ => {}
    }
}

#[test]
fn a_check_is_that_of_the_command() {
    let bench = Bench::new().file("joint.yaml", SPLICE);
    let (files, around) = (bench.everything(), here());
    let checked = bracket::check(&SpecInput::new(SPLICE)).unwrap_or_else(|e| panic!("{e:#?}"));
    assert_eq!((bench.everything(), here()), (files, around));
    expect(&bench, &["check", "joint.yaml", "--quiet"], checked.judged.status().code().into());
    let written = bench.read("joint_check/result.json");
    assert_eq!(checked.judged.result.to_json().unwrap(), written);
    assert!(checked.judgement().is_some_and(|j| j.verdict == checked.verdict()));
}

#[test]
fn a_fault_of_a_text_names_its_place() {
    let input = SpecInput::new(SPLICE.replace("IPE", "IPX"));
    let fault = bracket::check(&input).map(drop).expect_err("no such profile").into_first();
    assert_eq!(fault.code, "catalog/unknown-name");
    assert_eq!(fault.place.path.as_deref(), Some("members.beam.profile"));
}

#[test]
fn a_run_is_that_of_the_command() {
    let bench = Bench::new().file("stub.yaml", STUB);
    let (files, around) = (bench.everything(), here());
    let mut spec = SpecInput::read(&bench.path().join("stub.yaml")).unwrap();
    spec.overrides = Overrides { max_passes: Some(1), ..Overrides::default() };
    spec.overrides.extent.size_factor = 5.0;
    let lines = Arc::new(Mutex::new(Vec::new()));
    let heard = lines.clone();
    let progress = move |line: &str| heard.lock().unwrap().push(line.to_owned());
    let ran =
        bracket::run(&spec, &Limits::default(), progress).unwrap_or_else(|e| panic!("{e:#?}"));
    assert_eq!((bench.everything(), here()), (files, around));
    let case = &ran.judged.result.cases[0];
    assert_eq!((case.analysis, case.is_strict()), (AnalysisKind::Limit, true));
    let options = ["run", "stub.yaml", "--quiet", "--size-factor", "5", "--max-passes", "1"];
    expect(&bench, &options, ran.judged.status().code().into());
    let texts = [bench.read("stub/result.json"), ran.judged.result.to_json().unwrap()];
    let [written, found] = texts.map(|text| {
        let mut value: Value = serde_json::from_str(&text).unwrap();
        without_times(&mut value);
        value
    });
    assert_eq!(found, written);
    let lines = lines.lock().unwrap();
    assert!(lines.iter().any(|l| l.starts_with("by code alone: ")), "{lines:#?}");
    // the lines of the log, up to the answer, which the command adds
    let log = bench.read("stub/log.txt");
    let told = log.lines().filter_map(|l| l.split_once(" s] ")).take(lines.len());
    let (told, heard): (Vec<&str>, Vec<&str>) =
        (told.map(|l| l.1).collect(), lines.iter().map(String::as_str).collect());
    assert_eq!(told[..3], heard[..3]);
}
