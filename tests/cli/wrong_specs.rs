//! Specs that `bracket run` must refuse.

use crate::bench::{Bench, JOINT, Told, none_wrong, refusal};

/// Old text, new text, code, place, words of the message, words of the cure.
type Row = (&'static str, &'static str, &'static str, &'static str, &'static str, &'static str);

const ROWS: &[Row] = &[
    (
        "profile: HEB200",
        "profile: HEB2O0",
        "catalog/unknown-name",
        "joint.yaml:5:",
        "did you mean `HEB200`",
        "bracket catalog list",
    ),
    (
        "steel: S235}, beam",
        "steel: S999}, beam",
        "catalog/unknown-name",
        "joint.yaml:5:",
        "`S999`",
        "bracket catalog list",
    ),
    (
        "rows: [-215, -125, 110]",
        "rows: [-125, -115, 110]",
        "spec/rule",
        "joint.yaml:7:",
        "overlap: 10 mm apart",
        "set rows at least",
    ),
    (
        "rows: [-215, -125, 110]",
        "rows: [-215, -125, 260]",
        "spec/rule",
        "joint.yaml:7:",
        "does not lie on the end plate",
        "move the row between",
    ),
    (
        "rows: [-215, -125, 110]",
        "rows: []",
        "spec/value",
        "joint.yaml:7:",
        "`bolts.rows`: the list is empty",
        "at least one",
    ),
    (", rows: [-215, -125, 110]", "", "spec/missing", "joint.yaml:7:", "`bolts.rows` is missing", "bracket new"),
    (
        "plate: {thickness: 15, width: 180, z: [-250, 200]}\n",
        "",
        "spec/missing",
        "joint.yaml",
        "`plate.thickness` is missing",
        "bracket new",
    ),
    ("plate: {thickness: 15,", "plate: {thickness: -15,", "spec/range", "joint.yaml:6:", "is -15 mm", "4 mm to 100 mm"),
    ("plate: {thickness: 15,", "plate: {thickness: 0,", "spec/range", "joint.yaml:6:", "is 0 mm", "4 mm to 100 mm"),
    (
        "plate: {thickness: 15,",
        "plate: {thickness: .nan,",
        "yaml/not-finite",
        "joint.yaml:6:",
        "plate.thickness",
        "finite",
    ),
    (
        "plate: {thickness: 15,",
        "plate: {thickness: .inf,",
        "yaml/not-finite",
        "joint.yaml:6:",
        "plate.thickness",
        "finite",
    ),
    (
        "plate: {thickness: 15,",
        "plate: {thickness: 1e999,",
        "yaml/quantity",
        "joint.yaml:6:",
        "plate.thickness",
        "finite",
    ),
    (
        "plate: {thickness: 15,",
        "plate: {thickness: 15 kN,",
        "yaml/quantity",
        "joint.yaml:6:",
        "`15 kN` is not a length",
        "mm, cm, m",
    ),
    (
        "plate: {thickness: 15,",
        "plate: {thickness: fifteen,",
        "yaml/quantity",
        "joint.yaml:6:",
        "`fifteen` is not a length",
        "a number and a unit (mm",
    ),
    ("plate: {thickness: 15,", "plate: {thickness: [15],", "yaml/type", "joint.yaml:6:", "plate.thickness", ""),
    ("pressure: 45 MPa", "pressure: 45", "yaml/quantity", "joint.yaml:10:", "needs a unit", "45 MPa"),
    (
        "plate: {thickness: 15,",
        "plate: {thickness: 15, thickness: 16,",
        "yaml/duplicate-key",
        "joint.yaml:6:",
        "`thickness`",
        "keep one",
    ),
    ("width: 180", "widht: 180", "yaml/unknown-key", "joint.yaml:6:", "did you mean `width`", ""),
    ("friction: ", "frictoin: ", "yaml/unknown-key", "joint.yaml:9:", "did you mean `friction`", ""),
    (
        "template: double_sided_end_plate",
        "template: end_plate",
        "template/unknown",
        "joint.yaml:4:",
        "end_plate",
        "bracket templates",
    ),
    ("size: M18", "size: M80", "catalog/unknown-name", "joint.yaml:7:", "`M80`", "bracket catalog list"),
    ("kind: elastic", "kind: limit", "spec/unavailable", "joint.yaml:11:", "`elastic` only", "kind: elastic"),
    ("law: associated", "law: coulomb", "spec/unavailable", "joint.yaml:9:", "not available yet", "law: associated"),
    (
        "section: column_top",
        "section: colunm_top",
        "spec/unknown-name",
        "joint.yaml:10:",
        "did you mean `column_top`",
        "",
    ),
    (
        "pressure: 45 MPa}]",
        "pressure: 45 MPa}, {name: TOP, section: column_top, pressure: 1 MPa}]",
        "spec/value",
        "joint.yaml:10:",
        "already loads `column_top`",
        "another name",
    ),
    (
        "45 MPa}]",
        "45 MPa}, {name: T P, section: column_top, pressure: 1 MPa}, {name: T/P, section: column_top, pressure: 1 MPa}]",
        "spec/value",
        "joint.yaml:10:",
        "`T P` and `T/P` would write the same files",
        "letters and digits",
    ),
    ("{name: TOP,", "{name: \"\",", "spec/value", "joint.yaml:10:", "is empty", "letters and digits"),
    ("plate: {", "plate: [", "yaml/syntax", "joint.yaml:6:", "", ""),
    ("target_gap: 0.05", "target_gap: 5", "spec/range", "joint.yaml:11:", "target_gap", "0.05"),
];

#[test]
fn wrong_specs_are_refused_with_place_and_cure() {
    let mut results = Vec::new();
    for (old, new, code, place, message, cure) in ROWS {
        assert_eq!(JOINT.matches(old).count(), 1, "{old}");
        let bench = Bench::new().file("joint.yaml", JOINT.replace(old, new));
        let mesher = bench.mesher("exit 7");
        let told = Told { exit: 2, code, place, message, cure };
        let result = refusal(&bench, bench.command(&["run", "joint.yaml"]).env("BRACKET_GMSH", &mesher), &told);
        results.push((format!("`{old}` -> `{new}`"), result));
    }
    none_wrong(results);
}

#[test]
fn what_is_no_spec_at_all_is_refused() {
    let cases: [(&str, Vec<u8>, &str, &str, &str); 4] = [
        ("nothing", Vec::new(), "yaml/empty", "joint.yaml", "bracket new"),
        ("no text", vec![0xff, 0xfe, 0x00, 0x80], "spec/read", "joint.yaml", "UTF-8"),
        (
            "a model",
            b"mesh: block.msh\nanalysis: elastic\nmaterials: {}\nbodies: {}\n".to_vec(),
            "yaml/unknown-key",
            "joint.yaml:1:",
            "bracket analyse",
        ),
        ("one word", b"hello\n".to_vec(), "yaml/type", "joint.yaml:1:", ""),
    ];
    let mut results = Vec::new();
    for (name, bytes, code, place, cure) in cases {
        let bench = Bench::new().file("joint.yaml", bytes);
        let told = Told { exit: 2, code, place, message: "", cure };
        results.push((name.to_string(), refusal(&bench, &mut bench.command(&["run", "joint.yaml"]), &told)));
    }
    let bench = Bench::new();
    std::fs::create_dir(bench.path().join("joint.yaml")).expect("folder");
    let told =
        Told { exit: 2, code: "spec/read", place: "joint.yaml", message: "Is a directory", cure: "check the path" };
    results.push(("a folder".into(), refusal(&bench, &mut bench.command(&["run", "joint.yaml"]), &told)));
    let told = Told { exit: 2, code: "spec/read", place: "joint.yml", message: "No such file", cure: "check the path" };
    results.push(("absent".into(), refusal(&bench, &mut bench.command(&["run", "joint.yml"]), &told)));
    none_wrong(results);
}

#[test]
fn wrong_options_are_refused() {
    let mut results = Vec::new();
    for (args, words) in [
        (&["--size-factor", "0"][..], "--size-factor"),
        (&["--size-factor", "nan"], "--size-factor"),
        (&["--size-factor=-1"], "--size-factor"),
        (&["--threads", "0"], "--threads"),
        (&["--threads", "100000"], "--threads"),
    ] {
        let bench = Bench::new().file("joint.yaml", JOINT);
        let told = Told { exit: 2, code: "cli/value", place: "", message: words, cure: "" };
        let result = refusal(&bench, bench.command(&["run", "joint.yaml"]).args(args), &told);
        results.push((args.join(" "), result));
    }
    none_wrong(results);
}
