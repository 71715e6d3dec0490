//! Specs that `bracket run` must refuse.

use crate::bench::{Bench, JOINT, Want, none_wrong, refusal};

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
    (
        ", rows: [-215, -125, 110]",
        "",
        "spec/missing",
        "joint.yaml:7:",
        "`bolts.rows` is missing",
        "bracket new",
    ),
    (
        "plate: {thickness: 15, width: 180, z: [-250, 200]}\n",
        "",
        "spec/missing",
        "joint.yaml",
        "`plate.thickness` is missing",
        "bracket new",
    ),
    (
        "plate: {thickness: 15,",
        "plate: {thickness: -15,",
        "spec/range",
        "joint.yaml:6:",
        "is -15 mm",
        "4 mm to 100 mm",
    ),
    (
        "plate: {thickness: 15,",
        "plate: {thickness: 0,",
        "spec/range",
        "joint.yaml:6:",
        "is 0 mm",
        "4 mm to 100 mm",
    ),
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
    (
        "plate: {thickness: 15,",
        "plate: {thickness: [15],",
        "yaml/type",
        "joint.yaml:6:",
        "plate.thickness",
        "",
    ),
    (
        "pressure: 45 MPa",
        "pressure: 45",
        "yaml/quantity",
        "joint.yaml:10:",
        "needs a unit",
        "45 MPa",
    ),
    (
        "plate: {thickness: 15,",
        "plate: {thickness: 15, thickness: 16,",
        "yaml/duplicate-key",
        "joint.yaml:6:",
        "`thickness`",
        "keep one",
    ),
    ("width: 180", "widht: 180", "yaml/unknown-key", "joint.yaml:6:", "did you mean `width`", ""),
    (
        "friction: ",
        "frictoin: ",
        "yaml/unknown-key",
        "joint.yaml:9:",
        "did you mean `friction`",
        "",
    ),
    (
        "template: double_sided_end_plate",
        "template: end_plate",
        "template/unknown",
        "joint.yaml:4:",
        "end_plate",
        "bracket templates",
    ),
    (
        "size: M18",
        "size: M21",
        "catalog/unknown-name",
        "joint.yaml:7:",
        "the nearest are `M20` and `M22`",
        "bracket catalog list",
    ),
    (
        "thickness: 15, width: 180",
        "thickness: 20,5 mm, width: 180",
        "yaml/comma",
        "joint.yaml:6:",
        "`5 mm` becomes a key of its own",
        "`20.5 mm`, not `20,5 mm`",
    ),
    (
        "plate: {thickness: 15, width: 180, z: [-250, 200]}\n",
        "plate:\n\tthickness: 15\n",
        "yaml/tab",
        "joint.yaml:7:",
        "indented with a tab",
        "blanks",
    ),
    (
        "loads: [{name: TOP, section: column_top, pressure: 45 MPa}]",
        "loads:",
        "spec/missing",
        "joint.yaml:10:",
        "`loads` is missing",
        "bracket new",
    ),
    (
        "size: M18",
        "size: M80",
        "catalog/unknown-name",
        "joint.yaml:7:",
        "`M80`",
        "bracket catalog list",
    ),
    (
        "kind: elastic",
        "kind: [elastoplastic, elastoplastic]",
        "spec/value",
        "joint.yaml:11:",
        "the same kind twice",
        "each kind once",
    ),
    (
        "kind: elastic",
        "kind: [limit, limit]",
        "spec/value",
        "joint.yaml:11:",
        "the same kind twice",
        "each kind once",
    ),
    ("law: associated", "law: columb", "yaml/unknown-value", "joint.yaml:9:", "columb", "coulomb"),
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
        "45 MPa}, {name: T P, section: column_top, pressure: 1 MPa}, {name: T/P, section: \
         column_top, pressure: 1 MPa}]",
        "spec/value",
        "joint.yaml:10:",
        "`T P` and `T/P` would write the same files",
        "letters and digits",
    ),
    (
        "{name: TOP,",
        "{name: \"\",",
        "spec/value",
        "joint.yaml:10:",
        "is empty",
        "letters and digits",
    ),
    ("plate: {", "plate: [", "yaml/syntax", "joint.yaml:6:", "", ""),
    ("target_gap: 0.05", "target_gap: 5", "spec/range", "joint.yaml:11:", "target_gap", "0.05"),
    (
        "45 MPa",
        "0 MPa",
        "model/no-load",
        "joint.yaml:10:",
        "nothing acts on the joint: every load is zero",
        "not zero",
    ),
    (
        "45 MPa",
        "1e300 MPa",
        "spec/range",
        "joint.yaml:10:",
        "`loads[0].pressure` is 1e300 MPa",
        "its unit",
    ),
    ("45 MPa", "1e-300 MPa", "spec/range", "joint.yaml:10:", "1e-9 MPa to 1e9 MPa", "its unit"),
    (
        ", pressure: 45 MPa",
        "",
        "spec/value",
        "joint.yaml:10:",
        "has `pressure` or `traction`, one of them",
        "pressure: 45 MPa",
    ),
    (
        "pressure: 45 MPa",
        "traction: [0 MPa, 0 MPa]",
        "yaml/type",
        "joint.yaml:10:",
        "array of length 3",
        "schema",
    ),
    (
        "pressure: 45 MPa",
        "pressure: 45 kN",
        "yaml/quantity",
        "joint.yaml:10:",
        "`45 kN` is not a stress",
        "schema",
    ),
    (
        "loads: [{name: TOP, section: column_top, pressure: 45 MPa}]",
        "loads: []",
        "spec/missing",
        "joint.yaml:10:",
        "`loads` is missing",
        "bracket new",
    ),
    (
        "column_stiffener_thickness: 12.7",
        "column_stiffener_thickness: \"12,7\"",
        "spec/value",
        "joint.yaml:8:",
        "has a point before its decimals",
        "a length",
    ),
    (
        "beam_length: 1000",
        "beam_length: 40 inch",
        "spec/value",
        "joint.yaml:8:",
        "`inch` is not one of its units",
        "mm, cm, m",
    ),
    (
        "beam_length: 1000",
        "beam_lenght: 1000",
        "spec/unknown-name",
        "joint.yaml:8:",
        "did you mean `beam_length`",
        "known here",
    ),
    (
        "support_distance: 900",
        "support_distance: 2000",
        "spec/rule",
        "joint.yaml:8:",
        "beyond the beam (1000 mm)",
        "at most 992.5 mm",
    ),
    (
        "hole_clearance: 0",
        "hole_clearance: -1",
        "spec/range",
        "joint.yaml:8:",
        "`hole_clearance` is -1 mm",
        "0 mm to 10 mm",
    ),
    (
        "hole_clearance: 0",
        "head_contact: maybe",
        "spec/value",
        "joint.yaml:8:",
        "`parameters.head_contact`",
        "true or false",
    ),
    (
        "gauge: 100",
        "gauge: 400",
        "spec/rule",
        "joint.yaml:7:",
        "leave the end plate (180 mm wide)",
        "at most 148 mm",
    ),
    (
        "size: M18",
        "size: M36",
        "spec/rule",
        "joint.yaml:7:",
        "nuts would sit in the root fillet",
        "at least 111 mm",
    ),
    (
        "rows: [-215, -125, 110]",
        "rows: 3",
        "yaml/type",
        "joint.yaml:7:",
        "expected a list",
        "schema",
    ),
    (
        "rows: [-215, -125, 110]",
        "rows: [-215, null, 110]",
        "yaml/type",
        "joint.yaml:7:",
        "nothing, expected a length",
        "schema",
    ),
    (
        ", beam: {profile: IPE360, steel: S235}",
        "",
        "spec/missing",
        "joint.yaml:5:",
        "`members.beam` is missing",
        "bracket new",
    ),
    ("mu: 0.3", "mu: -0.1", "spec/range", "joint.yaml:9:", "`friction.mu` is -0.1", "0 to 2"),
    (
        "mu: 0.3",
        "mu: 0.3, class: B",
        "spec/value",
        "joint.yaml:9:",
        "`mu` and `class` are both given",
        "keep one",
    ),
    (
        "target_gap: 0.05",
        "target_gap: 5 %",
        "yaml/type",
        "joint.yaml:11:",
        "expected a number without a unit",
        "schema",
    ),
    (
        "target_gap: 0.05",
        "max_passes: -1",
        "yaml/type",
        "joint.yaml:11:",
        "expected a whole number that is not negative",
        "schema",
    ),
    (
        "target_gap: 0.05",
        "coulomb_estimate: true",
        "spec/value",
        "joint.yaml:11:",
        "which `kind` does not ask for",
        "a list with `limit`",
    ),
    (
        "kind: elastic",
        "kind: limit, coulomb_estimate: true",
        "spec/value",
        "joint.yaml:11:",
        "the law of friction is `associated`",
        "law: coulomb",
    ),
    (
        "target_gap: 0.05",
        "combinations: covered",
        "spec/value",
        "joint.yaml:11:",
        "another kind of analysis than `limit`",
        "decide: false",
    ),
    (
        "target_gap: 0.05",
        "combinations: few",
        "yaml/unknown-value",
        "joint.yaml:11:",
        "`few`",
        "covered",
    ),
    (
        "target_gap: 0.05",
        "coulomb_estimate: 1",
        "yaml/type",
        "joint.yaml:11:",
        "coulomb_estimate",
        "schema",
    ),
    (
        "target_gap: 0.05",
        "coulomb_estimat: true",
        "yaml/unknown-key",
        "joint.yaml:11:",
        "did you mean `coulomb_estimate`",
        "",
    ),
    (
        "target_gap: 0.05",
        "time_limit: 20",
        "yaml/type",
        "joint.yaml:11:",
        "expected a time with a unit",
        "schema",
    ),
    (
        "target_gap: 0.05",
        "mesh: {segments: 13}",
        "spec/range",
        "joint.yaml:11:",
        "`analysis.mesh.segments` is 13",
        "even, 12 to 48",
    ),
    (
        "project: {title: Paper joint}",
        "code: {edition: EN 1993-1-8:2024}",
        "yaml/unknown-value",
        "joint.yaml:3:",
        "did you mean `EN 1993-1-8:2005`",
        "one of",
    ),
];

#[test]
fn wrong_specs_are_refused_with_place_and_cure() {
    let mut results = Vec::new();
    for (old, new, code, place, message, cure) in ROWS {
        assert_eq!(JOINT.matches(old).count(), 1, "{old}");
        let bench = Bench::new().file("joint.yaml", JOINT.replace(old, new));
        let mesher = bench.mesher("exit 7");
        let want = Want { exit: 2, code, place, message, cure };
        let result = refusal(
            &bench,
            bench.command(&["run", "joint.yaml"]).env("BRACKET_GMSH", &mesher),
            &want,
        );
        results.push((format!("`{old}` -> `{new}`"), result));
    }
    none_wrong(results);
}

#[test]
fn files_that_are_no_specs_are_refused() {
    let latin: Vec<u8> = JOINT.replace("Paper joint", "Stoß").chars().map(|c| c as u8).collect();
    let cases: [(&str, Vec<u8>, &str, &str, &str); 6] = [
        ("nothing", Vec::new(), "yaml/empty", "joint.yaml", "bracket new"),
        ("no text", vec![0xff, 0xfe, 0x00, 0xd8], "file/encoding", "joint.yaml:1:1", "UTF-8"),
        ("Latin-1", latin, "file/encoding", "joint.yaml:3:", "save the file as UTF-8"),
        (
            "a folder's archive",
            b"PK\x03\x04\x00".to_vec(),
            "file/kind",
            "joint.yaml",
            "Bracket reads YAML",
        ),
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
        let want = Want { exit: 2, code, place, message: "", cure };
        results.push((
            name.to_string(),
            refusal(&bench, &mut bench.command(&["run", "joint.yaml"]), &want),
        ));
    }
    let bench = Bench::new();
    std::fs::create_dir(bench.path().join("joint.yaml")).expect("folder");
    let want = Want {
        exit: 2,
        code: "spec/read",
        place: "joint.yaml",
        message: "Is a directory",
        cure: "check the path",
    };
    results.push((
        "a folder".into(),
        refusal(&bench, &mut bench.command(&["run", "joint.yaml"]), &want),
    ));
    let want = Want {
        exit: 2,
        code: "spec/read",
        place: "joint.yml",
        message: "No such file",
        cure: "check the path",
    };
    results
        .push(("absent".into(), refusal(&bench, &mut bench.command(&["run", "joint.yml"]), &want)));
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
        let want = Want { exit: 2, code: "cli/value", place: "", message: words, cure: "" };
        let result = refusal(&bench, bench.command(&["run", "joint.yaml"]).args(args), &want);
        results.push((args.join(" "), result));
    }
    none_wrong(results);
}

/// Notepad writes a byte-order mark and spreadsheets write UTF-16. Both are valid.
#[test]
fn specs_and_tables_in_utf_16_are_read() {
    let utf16 = |text: &str| -> Vec<u8> {
        [0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect()
    };
    let spec = JOINT.replace("profile: HEB200", "profile: HEB2O0");
    let marked = [b"\xef\xbb\xbf", spec.as_bytes()].concat();
    let mut results = Vec::new();
    for (name, bytes) in [("UTF-16", utf16(&spec)), ("UTF-8 with a mark", marked)] {
        // the file is read to its end: the error reported is that of the profile
        let (code, message) = ("catalog/unknown-name", "did you mean `HEB200`");
        let want =
            Want { exit: 2, code, place: "joint.yaml:5:", message, cure: "bracket catalog list" };
        let bench = Bench::new().file("joint.yaml", bytes);
        results.push((
            name.into(),
            refusal(&bench, &mut bench.command(&["run", "joint.yaml"]), &want),
        ));
    }
    let bench = Bench::new().file("joint.yaml", JOINT);
    std::fs::create_dir(bench.path().join("mine")).expect("folder");
    std::fs::write(
        bench.path().join("mine/f.csv"),
        b"class,slip_factor_mu,surface_treatment\nM,0.4,ges\xe4ubert\n",
    )
    .expect("table");
    let want = Want {
        exit: 2,
        code: "file/encoding",
        place: "f.csv:2:",
        message: "Latin-1",
        cure: "UTF-8",
    };
    let mut command = bench.command(&["run", "joint.yaml", "--catalog", "mine"]);
    results.push(("a table in Latin-1".into(), refusal(&bench, &mut command, &want)));
    none_wrong(results);
}
