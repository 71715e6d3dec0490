//! The sweep of an import, and sweeps whose rows name tables of load cases.

use super::container::{self, container, utf16};
use super::frame::{BASE, CASES, JOINTS, SAP2000_ARGS, SECTIONS, saf, sap2000};
use crate::bench::{Bench, expect};
use serde_json::Value;
use std::fmt::Write as _;

/// A joint of the frame, written by hand: the base spec, the forces of its column, and Vz and My of
/// its ends.
fn by_hand(base: &str, column: &str, ends: &[(&str, f64, f64)]) -> String {
    let spec = base.replace("column: {profile", &format!("column: {{{column}, profile"));
    let double = format!("parameters: {{double_sided: {}, ", ends.len() == 2);
    let mut spec = spec.replace("parameters: {", &double) + "loads:\n";
    for (case, f) in CASES {
        let state = if case.starts_with('S') { "SLS" } else { "ULS" };
        for (end, v, m) in ends {
            let _ = writeln!(
                spec,
                "  - {{name: {case}, state: {state}, end: {end}, at: node, Vz: {v} kN, My: {m} kN \
                 m}}",
                v = v * f,
                m = m * f
            );
        }
    }
    spec
}

/// Verdict and utilisation of each load case of the hand-written joint.
fn checked(bench: &Bench, name: &str) -> Vec<(String, String, Option<f64>)> {
    let run = bench.run(&["check", &format!("{name}.yaml"), "--out", name]);
    assert!(run.status.code().is_some_and(|c| c != 2), "{run:?}");
    let result: Value =
        serde_json::from_str(&bench.read(&format!("{name}/result.json"))).expect("JSON");
    let of = |case: &Value| {
        let text = |key: &str| case[key].as_str().expect("a text").to_owned();
        (text("case"), text("verdict"), case["governing"]["utilisation"][1].as_f64())
    };
    result["load_cases"].as_array().expect("load cases").iter().map(of).collect()
}

/// The same of a joint of the sweep.
fn swept(bench: &Bench, folder: &str, name: &str) -> Vec<(String, String, Option<f64>)> {
    let rows = bench.read(&format!("{folder}/results.jsonl"));
    let rows = rows.lines().map(|l| serde_json::from_str::<Value>(l).expect("JSON"));
    let text = |row: &Value, key: &str| row[key].as_str().unwrap_or("none").to_owned();
    rows.filter(|r| r["case"] == name)
        .map(|r| (text(&r, "load_case"), text(&r, "verdict"), r["governing_utilisation"].as_f64()))
        .collect()
}

fn hand_written(bench: Bench) -> Bench {
    let a = by_hand(BASE, "N_Ed: -1160 kN, M_Ed: 18 kN m", &[("beam_right", -60.0, 30.0)]);
    let ends = [("beam_right", -65.0, 35.0), ("beam_left", -70.0, 40.0)];
    let b = by_hand(BASE, "N_Ed: -485 kN, M_Ed: 3 kN m", &ends);
    bench.file("A.yaml", a).file("B.yaml", b)
}

/// The verdicts of all load cases are those of specs that are written by hand, and the column
/// governs in one of them: its forces count.
fn same_verdicts(bench: &Bench) {
    expect(bench, &["batch", "out/sweep.yaml", "-o", "s"], 1);
    for name in ["A", "B"] {
        let hand = checked(bench, name);
        assert_eq!(hand.len(), 3);
        let swept = swept(bench, "s", name);
        assert_eq!(swept.len(), 3, "{name}");
        for (h, s) in hand.iter().zip(&swept) {
            assert_eq!((&h.0, &h.1), (&s.0, &s.1), "{name}");
            match (h.2, s.2) {
                (Some(h), Some(s)) => assert!((h - s).abs() < 1e-9 * h, "{name}: {h} {s}"),
                (h, s) => assert_eq!(h, s, "{name}"),
            }
        }
    }
    let results = bench.read("s/results.csv");
    assert!(results.contains("axial force of the column"), "{results}");
    // under the names that came in
    let header = results.lines().next().unwrap_or_default();
    let notes = "case,note.end,note.member,note.end2,note.member2,note.column_below,";
    assert!(header.starts_with(notes), "{header}");
    assert!(results.lines().any(|l| l.starts_with("B,beam_right,B2,beam_left,B1,")), "{results}");
}

#[test]
fn a_table_of_sap2000() {
    let bench = hand_written(Bench::new())
        .file("forces.txt", sap2000(&SECTIONS))
        .file("joints.csv", JOINTS)
        .file("base.yaml", BASE);
    let (out, err) = expect(&bench, &[&SAP2000_ARGS[..], &["--sls", "SLS*"]].concat(), 0);
    assert!(err.is_empty(), "{err}");
    for words in ["A               3      -1160           18", "next: bracket batch out/sweep.yaml"]
    {
        assert!(out.contains(words), "{out}");
    }
    let loads = bench.read("out/loads/B.csv");
    assert_eq!(loads.lines().count(), 7, "{loads}");
    assert!(loads.contains("SLS1,SLS,beam_left,node,0,0,-49000,"), "{loads}");
    same_verdicts(&bench);
}

/// Profiles and steel come from the workbook, in the names of the catalogue; the base spec has
/// others.
#[test]
fn a_workbook_of_saf() {
    let base =
        BASE.replace("IPE270", "IPE200").replace("HEB180, steel: S235", "HEA300, steel: S355");
    let bench = hand_written(Bench::new())
        .file("frame.xlsx", saf(&SECTIONS, "1|ipe 270", "1|HE 180 B"))
        .file("joints.csv", JOINTS)
        .file("base.yaml", base);
    let args = ["import", "frame.xlsx", "--joints", "joints.csv", "--base", "base.yaml"];
    let more = ["--mapping", "saf", "--sls", "SLS1", "-o", "out"];
    let (out, _) = expect(&bench, &[&args[..], &more].concat(), 0);
    assert!(out.contains("profiles and steels from the model: 2 joints"), "{out}");
    let joints = bench.read("out/joints.csv");
    assert!(joints.contains("IPE270,S235,HEB180,S235,-485.000 kN,3.000 kN m"), "{joints}");
    same_verdicts(&bench);
}

/// The program, profiles, steel and limit states come from the container, in UTF-16 as well.
#[test]
fn a_container_of_iom() {
    let base =
        BASE.replace("IPE270", "IPE200").replace("HEB180, steel: S235", "HEA300, steel: S355");
    let text = container("IPE 270", "HE180B");
    for bytes in [text.as_bytes(), &utf16(&text)] {
        let bench = hand_written(Bench::new())
            .file("frame.xml", bytes)
            .file("joints.csv", JOINTS)
            .file("base.yaml", &base);
        let (out, _) = expect(&bench, &container::ARGS, 0);
        assert!(out.contains("profiles and steels from the model: 2 joints"), "{out}");
        let joints = bench.read("out/joints.csv");
        assert!(joints.contains("IPE270,S235,HEB180,S235,-485.000 kN,3.000 kN m"), "{joints}");
        assert!(bench.read("out/loads/A.csv").contains("SLS1,SLS,beam_right,node,0,0,-42000,"));
        same_verdicts(&bench);
    }
}

/// What the table of joints gives wins over the workbook and over the forces of the column.
#[test]
fn the_table_of_joints_wins() {
    let joints = "joint;end;member;station;column_below;members.beam.profile;members.column.N_Ed \
                  [kN];plate.thickness;bolts.rows\nA;beam_right;B1;start;C1;IPE240;-12,5;12,5;\
                  \"[-70,5; 70,5]\"\n";
    let bench = Bench::new()
        .file("frame.xlsx", saf(&SECTIONS, "1|IPE270", "1|HEB180"))
        .file("joints.csv", joints)
        .file("base.yaml", BASE);
    let args = ["import", "frame.xlsx", "--joints", "joints.csv", "--base", "base.yaml"];
    expect(&bench, &[&args[..], &["--mapping", "saf", "-o", "out"]].concat(), 0);
    let table = bench.read("out/joints.csv");
    assert!(
        table.contains("IPE240,-12.5,12.5,[-70.5; 70.5],S235,HEB180,S235,18.000 kN m"),
        "{table}"
    );
    let run = bench.run(&["batch", "out/sweep.yaml", "-o", "s"]);
    let row = &swept(&bench, "s", "A")[0];
    assert!(row.2.is_some(), "{run:?}");
}

/// Results in the folder and files of the user stay when the forces are imported again; names of
/// joints that make the same file name get files of their own.
#[test]
fn an_import_is_repeated() {
    let joints = JOINTS.replace("\nA,", "\nx/1,").replace("\nB,", "\nX:1,");
    let bench = Bench::new()
        .file("forces.txt", sap2000(&SECTIONS))
        .file("joints.csv", joints)
        .file("base.yaml", BASE);
    expect(&bench, &SAP2000_ARGS, 0);
    expect(&bench, &["batch", "out/sweep.yaml"], 1);
    let bench = bench.file("out/notes.txt", "mine").file("joints.csv", JOINTS);
    assert!(bench.path().join("out/loads/X_1-2.csv").is_file());
    let (json, _) = expect(&bench, &[&SAP2000_ARGS[..], &["--format", "json"]].concat(), 0);
    let json: Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["joints"][1]["load_cases"], 3);
    assert!(bench.path().join("out/sweep/results.csv").is_file());
    assert_eq!(bench.read("out/notes.txt"), "mine");
    assert!(!bench.path().join("out/loads/X_1-2.csv").exists());
    assert!(bench.path().join("out/loads/B.csv").is_file());
}

/// Templates of the user's are found from the folder, whether the base spec or a joint names them.
#[test]
fn templates_of_the_user_are_found() {
    let own = "extends: beam_to_column_end_plate\nname: mine\n";
    let joints = JOINTS
        .replace("parameters.double_sided", "template")
        .replace("C1,C2,false", "C1,C2,t/a.yaml");
    let joints = joints.replace("C3,C4,true", "C3,C4,").replace(",beam_left,B1,end,", ",,,,");
    let bench = Bench::new().file("joints.csv", joints).file("forces.txt", sap2000(&SECTIONS));
    std::fs::create_dir_all(bench.path().join("b/t")).expect("folders");
    let bench = bench
        .file("b/base.yaml", BASE.replace("beam_to_column_end_plate", "./t/b.yaml"))
        .file("b/t/a.yaml", own)
        .file("b/t/b.yaml", own.replace("mine", "other"));
    let mut args = SAP2000_ARGS;
    args[5] = "b/base.yaml";
    expect(&bench, &args, 0);
    let run = bench.run(&["batch", "out/sweep.yaml", "-o", "s"]);
    assert!(run.status.code().is_some_and(|c| c != 2), "{run:?}");
    assert_eq!(["A", "B"].map(|n| swept(&bench, "s", n).len()), [3, 3]);
}

/// Load cases are chosen by name; a table without stations is read by its nodes.
#[test]
fn chosen_load_cases_and_nodes() {
    let forces = "member,node,case,N [kN],Vz [kN],My [kN m]\nB1,7,ULS1,0,-60,30\n\
                  B1,8,ULS1,0,70,40\nB1,7,X,0,-1,1\nB1,8,X,0,1,1\n";
    let joints = "joint,end,member,station,node,at\nA,beam_right,B1,end,8,column_face\n";
    let bench =
        Bench::new().file("forces.csv", forces).file("joints.csv", joints).file("base.yaml", BASE);
    let args = ["import", "forces.csv", "--joints", "joints.csv", "--base", "base.yaml"];
    expect(&bench, &[&args[..], &["--cases", "ULS*", "-o", "out"]].concat(), 0);
    let want = "case,state,end,at,N [N],Vz [N],My [N mm]\nULS1,ULS,beam_right,column_face,0,\
                -70000,40000000\n";
    assert_eq!(bench.read("out/loads/A.csv"), want);
}

/// Rows of any sweep may say which member of a table they are about; an axis chooses load cases.
#[test]
fn rows_name_members_of_one_table() {
    let base = format!(
        "{BASE}loads: {{table: forces.txt, mapping: sap2000, end: beam_right, at: node, station: \
         start}}\n"
    );
    let sweep = "base: base.yaml\ntable: rows.csv\naxes: {loads.cases: [ULS1, \"ULS*\"]}\nfirst: \
                 checks\n";
    let rows = "name,loads.member,plate.thickness\none,B1,12\ntwo,B2,12\n";
    let bench = Bench::new()
        .file("forces.txt", sap2000(&SECTIONS))
        .file("base.yaml", base)
        .file("rows.csv", rows)
        .file("sweep.yaml", sweep);
    let run = bench.run(&["batch", "sweep.yaml", "-o", "s"]);
    let results = bench.read("s/results.csv");
    let of = |name: &str| swept(&bench, "s", name).len();
    assert_eq!(["one ULS1", "one ULS*", "two ULS1", "two ULS*"].map(of), [1, 2, 1, 2], "{run:?}");
    assert!(results.contains(",-60") && results.contains(",-65"), "{results}");
    // the plan keeps the load cases: the parts of a sweep do not read the table again
    let bench = bench.file("forces.txt", "other");
    let (_, err) = expect(&bench, &["batch", "merge", "s"], run.status.code().expect("a code"));
    assert!(err.contains("forces.txt` has changed since the plan"), "{err}");
    assert_eq!(bench.read("s/results.csv"), results);
    std::fs::remove_file(bench.path().join("forces.txt")).expect("removed");
    let (_, err) = expect(&bench, &["batch", "sweep.yaml", "-o", "t"], 2);
    assert!(err.contains("there is no table") && err.contains("base.yaml:6"), "{err}");
    let bench =
        bench.file("forces.txt", sap2000(&SECTIONS)).file("rows.csv", rows.replace("B2", "B3"));
    let (_, err) = expect(&bench, &["batch", "sweep.yaml", "-o", "t"], 2);
    assert!(err.contains("no member `B3`") && err.contains("rows.csv:3"), "{err}");
}
