//! What an import tells without refusing it, and the joints that it refuses before it writes.

use super::frame::{BASE, JOINTS, SAP2000_ARGS, SECTIONS, sap2000};
use crate::bench::{Bench, Want, expect, none_wrong, refusal};
use serde_json::Value;

fn bench(joints: &str) -> Bench {
    Bench::new()
        .file("forces.txt", sap2000(&SECTIONS))
        .file("joints.csv", joints)
        .file("base.yaml", BASE)
}

/// The warnings of an import that is written all the same.
fn warnings(bench: &Bench, args: &[&str]) -> Vec<String> {
    let (_, err) = expect(bench, args, 0);
    let told = err.lines().filter_map(|l| l.strip_prefix("warning: ")).map(str::to_owned);
    let told: Vec<String> = told.collect();
    let (json, _) = expect(bench, &[args, &["--format", "json"]].concat(), 0);
    let json: Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["warnings"], serde_json::json!(told));
    told
}

#[test]
fn a_sound_frame_has_no_warning() {
    assert!(warnings(&bench(JOINTS), &SAP2000_ARGS).is_empty());
}

#[test]
fn an_end_at_two_joints() {
    let joints = JOINTS.replace("beam_left,B1,end", "beam_left,B1,start");
    let told = warnings(&bench(&joints), &SAP2000_ARGS);
    let want = "joints.csv:3: joint `B`: the start of member `B1` is at joint `A` (line 2) too";
    assert!(told.iter().any(|t| t == want), "{told:?}");
}

/// The beam brings 30 kN m to A; B is in balance but for 5 kN m.
#[test]
fn a_column_that_takes_too_little() {
    let joints = JOINTS.replace("double_sided\n", "double_sided,members.column.M_Ed [kN m]\n");
    let joints = joints.replace("C2,false\n", "C2,false,5\n").replace("C4,true\n", "C4,true,5\n");
    let told = warnings(&bench(&joints), &SAP2000_ARGS);
    let want = "joints.csv:2: joint `A`: the beams bring 30.0 kN m to the node in `ULS1`, the \
                column takes at least half of them, and M_Ed of the column is 5.0 kN m";
    assert_eq!(told, [want]);
}

#[test]
fn moments_in_another_unit() {
    let forces = "member,station,case,N [kN],Vz [kN],My [kN m]\nB1,0,ULS1,0,-60,30000\n\
                  B1,6,ULS1,0,70,40000\n";
    let joints = "joint,end,member,station\nA,beam_right,B1,start\n";
    let bench = bench(joints).file("forces.csv", forces);
    let args = ["import", "forces.csv", "--joints", "joints.csv", "--base", "base.yaml"];
    let told = warnings(&bench, &[&args[..], &["-o", "out"]].concat());
    assert!(told[0].contains("more than 500 m times their shear forces"), "{told:?}");
}

/// `residuals.csv` has each joint in each load case, and nothing of the noise of sums.
#[test]
fn residuals_in_the_folder() {
    let mut sections = SECTIONS.to_vec();
    sections.iter_mut().filter(|s| s.member == "C1" && s.x == 4.0).for_each(|s| {
        s.actions[0] -= 0.3;
    });
    let bench = bench(JOINTS).file("forces.txt", sap2000(&sections));
    expect(&bench, &SAP2000_ARGS, 0);
    let table = bench.read("out/residuals.csv");
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!(rows.len(), 7, "{table}");
    assert_eq!(rows[1], "A,ULS1,0.3,1160.3,0,30");
    assert_eq!(rows[2], "A,ULS2,-0.12,464.12,0,12");
    assert_eq!(rows[4], "B,ULS1,0,485,0,40");
    // without members of the column there is nothing to add up
    let alone = "joint,end,member,station\nA,beam_right,B1,start\n";
    let bench = self::bench(alone);
    expect(&bench, &SAP2000_ARGS, 0);
    assert!(!bench.path().join("out/residuals.csv").exists());
}

/// Load cases and results have the digits of the table.
#[test]
fn digits_of_the_table() {
    let forces = "member,station,case,N [kN],Vz [kN],My [kN m]\nB1,0,ULS1,4.35,-1.005,8.1\n";
    let joints = "joint,end,member,station\nA,beam_right,B1,start\n";
    let bench = bench(joints).file("forces.csv", forces);
    let args = ["import", "forces.csv", "--joints", "joints.csv", "--base", "base.yaml"];
    expect(&bench, &[&args[..], &["-o", "out"]].concat(), 0);
    assert!(bench.read("out/loads/A.csv").ends_with(",4350,-1005,8100000\n"));
    let run = bench.run(&["batch", "out/sweep.yaml", "-o", "s"]);
    let results = bench.read("s/results.csv");
    assert!(results.contains(",ULS1,4.35,-1.005,"), "{results}\n{run:?}");
    let long = results.split([',', '\n']).find(|c| c.contains("00000000") && c.len() > 15);
    assert_eq!(long, None, "{results}");
}

/// A joint that cannot be built is a fault of its line, and nothing is written.
#[test]
fn joints_are_built_before_they_are_written() {
    let mut results = Vec::new();
    for (header, good, bad, code, message, cure) in [
        ("bolts.gauge", "90", "900", "spec/rule", "`B`: with the gauge 900 mm", "at most 122 mm"),
        ("plate.thickness", "12", "0.1", "spec/range", "`B`: `plate.thickness` is 0.1", "4 mm to"),
        (
            "members.beam.profile",
            "IPE270",
            "IPE275",
            "catalog/unknown-name",
            "`B`: profile `IPE275` is not",
            "catalog list",
        ),
        (
            "parameters.doubble",
            "",
            "1",
            "spec/unknown-name",
            "`B`: template `beam_to_column_end_plate` has no parameter",
            "known here",
        ),
    ] {
        let joints = JOINTS.replace("double_sided\n", &format!("double_sided,{header}\n"));
        let joints = joints.replace("C2,false\n", &format!("C2,false,{good}\n"));
        let bench = bench(&joints.replace("C4,true\n", &format!("C4,true,{bad}\n")));
        let want = Want { exit: 2, code, place: "joints.csv:3", message, cure };
        results.push((header.into(), refusal(&bench, &mut bench.command(&SAP2000_ARGS), &want)));
    }
    // a fault of the base spec is told once
    let bench = bench(JOINTS).file("base.yaml", BASE.replace("gauge: 90", "gauge: 900"));
    let (place, message) = ("joints.csv:2", "joint `A` (and 1 more): with the gauge 900 mm");
    let want = Want { exit: 2, code: "spec/rule", place, message, cure: "at most" };
    results.push(("base".into(), refusal(&bench, &mut bench.command(&SAP2000_ARGS), &want)));
    none_wrong(results);
}

/// A command has no `columns`: its helps name what the user can change.
#[test]
fn helps_of_the_import() {
    let mut results = Vec::new();
    for (old, new, message, cure) in [
        ("KN\tKN\tKN\t", "\tKN\tKN\t", "the column `P` has no unit", "header, `P [kN]`"),
        ("\tKN-m\n", "\tKN-n\n", "column `M3`: `KN-n` is no unit of a moment", "kN m"),
        ("\tM3\n", "\tMM\n", "`MM` has a unit of actions", "the `--mapping` that knows it"),
    ] {
        let text = sap2000(&SECTIONS);
        assert!(text.contains(old), "{old}");
        let bench = bench(JOINTS).file("forces.txt", text.replacen(old, new, 1));
        let want = Want { exit: 2, code: "loads/table", place: "forces.txt:2", message, cure };
        let run = refusal(&bench, &mut bench.command(&SAP2000_ARGS), &want);
        let spec = run.as_ref().is_ok_and(|text| text.contains("columns:"));
        results.push((new.to_owned(), if spec { Err("names a key of specs".into()) } else { run }));
    }
    none_wrong(results);
}
