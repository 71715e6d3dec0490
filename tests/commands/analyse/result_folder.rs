//! The files that `bracket analyse` writes.

use super::{MODEL, bench};
use crate::bench::expect;
use crate::bench::{Bench, Want, refusal};
use serde_json::Value;
use std::path::Path;

fn json(bench: &Bench, name: &str) -> Value {
    serde_json::from_str(&bench.read(name)).expect("JSON")
}

/// Removes seconds and memory, which differ from run to run. Everything else must be the same.
fn without_costs(value: &mut Value) {
    match value {
        Value::Object(fields) => {
            fields.retain(|key, _| !key.ends_with("seconds") && !key.ends_with("memory_mib"));
            fields.iter_mut().for_each(|(_, v)| without_costs(v));
        }
        Value::Array(items) => items.iter_mut().for_each(without_costs),
        _ => {}
    }
}

/// The report without the history table, which has columns of seconds and memory.
fn report_without_costs(text: &str, heading: &str) -> String {
    let (head, rest) = text.split_once(&format!("{heading}Mesh and history")).expect("the section");
    let (_, tail) = rest.split_once(&format!("\n{heading}Certificate")).expect("the next section");
    format!("{head}{tail}")
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("a number, not {value}"))
}

#[test]
fn the_result_holds_what_the_contract_promises() {
    let bench = bench(MODEL);
    let (out, err) = expect(&bench, &["analyse", "block.yaml"], 0);
    assert_eq!(out, "");
    assert!(err.contains("potential energy between") && err.contains("(certified)"), "{err}");

    let files: Vec<String> =
        bench.everything().keys().map(|p| p.to_string_lossy().into_owned()).collect();
    let expected = [
        "block",
        "block/deformed_block.png",
        "block/digests.b3",
        "block/fields",
        "block/fields/block_kinematic.vtu",
        "block/fields/block_static.vtu",
        "block/log.txt",
        "block/mesh.msh",
        "block/mesh.png",
        "block/mesh_front.png",
        "block/mesh_side.png",
        "block/model.yaml",
        "block/report.html",
        "block/report.json",
        "block/report.md",
        "block/report.pdf",
        "block/result.json",
        "block.yaml",
        "m.msh",
    ];
    assert_eq!(files, expected);
    assert_eq!(bench.read("block/mesh.msh"), bench.read("m.msh"));

    let result = json(&bench, "block/result.json");
    assert_eq!(result["schema"], 1);
    assert_eq!(result["tool"]["name"], "bracket");
    assert_eq!(result["tool"]["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(result["input_hash"].as_str().map(str::len), Some(64));
    assert_eq!((&result["symmetry"], &result["verdict"]), (&1.into(), &"none".into()));
    let case = &result["cases"][0];
    assert_eq!(result["cases"].as_array().map(Vec::len), Some(1));
    for (key, value) in [
        ("name", "block"),
        ("analysis", "elastic"),
        ("quantity", "potential_energy"),
        ("problem", "associated"),
    ] {
        assert_eq!(case[key], value);
    }
    let (lower, upper) = (number(&case["lower"]), number(&case["upper"]));
    // 40 MPa on 400 mm² shorten 60 mm by 11 µm: −Π is about ½ · 16 kN · 11 µm = 91 N mm; the side
    // push adds to it
    assert!(lower < upper && upper < -85.0 && lower > -110.0, "{lower} {upper}");
    // the gap: (Π_p + Π_c) over the larger magnitude (docs/theory.md)
    let gap = number(&case["gap"]);
    assert!(
        gap > 0.0
            && gap < 0.15
            && (gap - (upper - lower) / lower.abs().max(upper.abs())).abs() < 0.01,
        "{gap}"
    );
    let [soft, stiff] = [1, 0].map(|i| number(&case["load_displacement"][i]));
    let force = 400.0 * 40.0f64.hypot(2.0);
    assert!((number(&case["load"]["force"]) - force).abs() < 1e-9);
    assert!(
        (soft + 2.0 * lower / force).abs() < 1e-12 && (stiff + 2.0 * upper / force).abs() < 1e-12
    );
    let certificate = &case["certificate"];
    assert_eq!(certificate["strict"], true);
    for residual in ["equilibrium", "traction_jump", "contact", "compatibility"] {
        assert!(
            (0.0..=1e-9).contains(&number(&certificate[residual])),
            "{residual}: {certificate}"
        );
    }
    assert!(
        certificate.get("yield").is_none(),
        "nothing yields in an elastic analysis: absent is absent"
    );
    let history = &case["history"][0];
    assert_eq!((&history["macro_tets"], &history["lower"]), (&144.into(), &case["lower"]));
    for program in ["kinematic", "static"] {
        assert_eq!(history[program]["status"], "optimal");
        assert!(
            number(&history[program]["seconds"]) > 0.0
                && number(&history[program]["iterations"]) > 0.0
        );
        assert!(number(&history[format!("{program}_dofs")]) > 100.0);
    }
    assert!(!bench.read("block/result.json").contains("null"), "absent is absent");

    let report = bench.read("block/report.md");
    for words in [
        "# block",
        "## Answer",
        "gap **",
        "The load of the whole structure is 16.02 kN. Its displacement",
        " mm.",
        "Peak contact pressure",
        "## Input",
        MODEL,
        "## Mesh and history",
        "| BASE | 72 |",
        "## Certificate",
        "| block | strict |",
        "## Assumptions and limits",
        "associated",
    ] {
        assert!(report.contains(words), "{words:?} in\n{report}");
    }
    for (_, rest) in report.match_indices("](").map(|(i, _)| report.split_at(i + 2)) {
        let file = rest.split(')').next().unwrap_or("");
        assert!(bench.path().join("block").join(file).is_file(), "the report shows `{file}`");
    }
    let model = bench.read("block/model.yaml");
    assert!(model.contains("mesh: mesh.msh") && model.contains("friction: associated"), "{model}");
}

#[test]
fn two_runs_differ_in_seconds_and_memory_only() {
    let bench = bench(MODEL);
    expect(&bench, &["analyse", "block.yaml", "--out", "one"], 0);
    expect(&bench, &["analyse", "block.yaml", "--out", "two", "--quiet"], 0);
    let everything = bench.everything();
    let of = |folder: &str| -> Vec<(&Path, &Vec<u8>)> {
        everything.iter().filter_map(|(p, b)| Some((p.strip_prefix(folder).ok()?, b))).collect()
    };
    let (one, two) = (of("one"), of("two"));
    assert_eq!(one.len(), two.len());
    let mut alike = 0;
    for ((name, a), (other, b)) in one.iter().zip(&two) {
        assert_eq!(name, other);
        match name.to_string_lossy().as_ref() {
            "log.txt" | "digests.b3" => {}
            "result.json" => {
                let [a, b] = [a, b].map(|bytes| {
                    let mut v: Value = serde_json::from_slice(bytes).expect("JSON");
                    without_costs(&mut v);
                    v
                });
                assert_eq!(a, b);
            }
            name @ ("report.md" | "report.html") => {
                let heading = if name == "report.md" { "## " } else { "<summary><h2>" };
                let [a, b] = [a, b]
                    .map(|bytes| report_without_costs(&String::from_utf8_lossy(bytes), heading));
                assert_eq!(a, b);
            }
            name => {
                assert!(a == b, "{name} differs");
                alike += usize::from(name.ends_with(".vtu") || name.ends_with(".png"));
            }
        }
    }
    assert_eq!(alike, 6);
}

#[test]
fn json_goes_to_standard_output_and_nothing_else() {
    let bench = bench(MODEL);
    let (out, _) = expect(&bench, &["analyse", "block.yaml", "--format", "json"], 0);
    assert_eq!(out, bench.read("block/result.json"));
    let (out, err) = expect(&bench, &["--format", "json", "--quiet", "analyse", "block.yaml"], 0);
    assert_eq!((out, err.as_str()), (bench.read("block/result.json"), ""));
    // errors are JSON too: one object per line on standard error
    std::fs::write(bench.path().join("block.yaml"), MODEL.replace("Z1", "Z9")).expect("written");
    let (out, err) = expect(&bench, &["analyse", "block.yaml", "--format", "json"], 2);
    let fault: Value = serde_json::from_str(&err).expect("one object");
    assert_eq!(
        (out.as_str(), &fault["code"], &fault["place"]["line"]),
        ("", &"model/unknown-face".into(), &10.into())
    );
}

#[test]
fn an_earlier_result_is_replaced_and_a_foreign_folder_is_not() {
    let bench = bench(MODEL);
    expect(&bench, &["analyse", "block.yaml", "-q"], 0);
    let before = bench.everything();
    std::fs::write(bench.path().join("block/fields/mine.txt"), "view").expect("written");
    std::fs::write(bench.path().join("block.yaml"), MODEL.replace("-40", "-20")).expect("written");
    expect(&bench, &["analyse", "block.yaml", "-q"], 0);
    let mut after = bench.everything();
    assert_eq!(after.remove(Path::new("block/fields/mine.txt")).as_deref(), Some(&b"view"[..]));
    assert!(after.keys().eq(before.keys()), "{:?}", after.keys());
    assert!(after[Path::new("block/result.json")] != before[Path::new("block/result.json")]);
    // a wrong model leaves the earlier result unchanged
    std::fs::write(bench.path().join("block.yaml"), MODEL.replace("Z1", "Z9")).expect("written");
    let want = Want {
        exit: 2,
        code: "model/unknown-face",
        place: "block.yaml:10:",
        message: "`Z9`",
        cure: "Z0, Z1",
    };
    if let Err(e) = refusal(&bench, &mut bench.command(&["analyse", "block.yaml"]), &want) {
        panic!("{e}");
    }
    // a folder without a result.json of this program belongs to someone else
    std::fs::write(bench.path().join("block.yaml"), MODEL).expect("written");
    std::fs::remove_file(bench.path().join("block/result.json")).expect("removed");
    let want = Want {
        exit: 2,
        code: "report/folder-exists",
        place: "block",
        message: "holds no result.json",
        cure: "choose another folder with --out",
    };
    if let Err(e) = refusal(&bench, &mut bench.command(&["analyse", "block.yaml"]), &want) {
        panic!("{e}");
    }
}

/// Friction holds the block against a push of 0.999 μN. No equilibrium exists at 1.001 μN.
#[test]
fn without_equilibrium_there_is_no_bound() {
    for (push, code) in [(0.3 * 0.999, 0), (0.3 * 1.001, 3)] {
        // the block is pressed at its top, so a push at the height of the lower layer would tilt
        // it: the push acts as a body force on the block
        let (p, height) = (1.0, 30.0);
        let model = MODEL.replace("  - {face: Z1, traction: [2, 0, -40]}\n", &{
            let weight = p / height;
            format!("  - {{body: BLOCK, force: [{}, 0, -{weight}]}}\n", push * weight)
        });
        let bench = bench(&model);
        let (out, err) = expect(&bench, &["analyse", "block.yaml", "--format", "json"], code);
        let case = &serde_json::from_str::<Value>(&out).expect("JSON")["cases"][0];
        if code == 0 {
            assert_eq!(case["certificate"]["strict"], true, "{err}");
            assert!(number(&case["lower"]) <= number(&case["upper"]));
            continue;
        }
        for absent in ["lower", "upper", "gap", "certificate", "load_displacement"] {
            assert!(case.get(absent).is_none(), "{absent} in {case:#}");
        }
        let warnings = case["warnings"].as_array().expect("warnings");
        assert_eq!(warnings.len(), 1, "{warnings:?}");
        let warn = warnings[0].as_str().unwrap_or("");
        assert!(
            warn.starts_with("no equilibrium exists under these loads: part BLOCK moves along +x"),
            "{warn}"
        );
        assert!(err.contains(warn), "{err}");
        assert!(bench.read("block/report.md").contains(warn));
        // a result without claims cannot be refuted
        let (out, _) = expect(&bench, &["verify", "block"], 0);
        assert!(out.contains("claims no bound"), "{out}");
    }
}

#[test]
fn a_name_longer_than_a_file_may_be_called_is_cut() {
    // file names may have 255 bytes; `fields/NAME_kinematic.vtu` needs 14 more than the name
    let name = "n".repeat(245);
    let bench = bench(MODEL).file(&format!("{name}.yaml"), MODEL);
    expect(&bench, &["analyse", &format!("{name}.yaml"), "--out", "result", "-q"], 0);
    assert_eq!(json(&bench, "result/result.json")["cases"][0]["name"], name[..100]);
    assert!(bench.path().join(format!("result/fields/{}_static.vtu", &name[..100])).is_file());
    expect(&bench, &["verify", "result"], 0);
}
