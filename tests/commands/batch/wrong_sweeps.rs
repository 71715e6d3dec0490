//! Wrong sweeps: one message each, with place and cure, and nothing written.

use super::SPLICE;
use crate::bench::{Bench, Want, refusal};

/// A sweep, its table, and what the refusal must say: code, place, message, cure.
type Wrong = (&'static str, &'static str, [&'static str; 4]);

const AXES: &str = "base: joint.yaml\nfirst: checks\n";

const WRONG: [Wrong; 44] = [
    ("", "", ["yaml/empty", "sweep.yaml", "empty", "`bracket new`"]),
    ("AXES", "", ["sweep/value", "sweep.yaml:1", "varies nothing", "give `axes`"]),
    (
        "AXESaxis: {plate.thickness: [1]}",
        "",
        ["yaml/unknown-key", "sweep.yaml:3", "did you mean `axes`", "the keys known here"],
    ),
    (
        "base: nowhere.yaml\naxes: {plate.thickness: [10]}",
        "",
        ["sweep/base", "sweep.yaml:1", "cannot be read", "relative to the sweep file"],
    ),
    (
        "base: 5\naxes: {plate.thickness: [10]}",
        "",
        ["sweep/base", "sweep.yaml:1", "neither the path", "`base: joint.yaml`"],
    ),
    (
        "AXESaxes: {plate.thicknes: [10]}",
        "",
        ["yaml/unknown-key", "sweep.yaml:3", "did you mean `thickness`", "the keys known here"],
    ),
    (
        "AXESaxes: {plate.thickness: []}",
        "",
        ["sweep/axis", "sweep.yaml:3", "no values", "at least one"],
    ),
    (
        "AXESaxes: {plate.thickness: [10, 12 kN]}",
        "",
        ["yaml/quantity", "sweep.yaml:3", "12 kN", ""],
    ),
    (
        "AXESaxes: {plate.thickness: {from: 10, to: 5, step: 1}}",
        "",
        ["sweep/axis", "sweep.yaml:3", "away from", "{from: 10"],
    ),
    (
        "AXESaxes: {members.beam.profile: IPE200..HEB300}",
        "",
        ["sweep/axis", "sweep.yaml:3", "series", "IPE200..IPE400"],
    ),
    (
        "AXESaxes: {loads.ULS2.My: [1 kN m]}",
        "",
        ["sweep/path", "sweep.yaml:3", "did you mean `ULS1`", "as in the base spec"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nwhere: [\"plate.thickness > 20 mm\"]",
        "",
        ["sweep/empty", "sweep.yaml:4", "drops all 1", "loosen"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nwhere: [\"plate.thick > 2 mm\"]",
        "",
        ["sweep/where", "sweep.yaml:4", "unknown name `plate.thick`", "bracket templates"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nwhere: [\"plate.thickness + 2 mm\"]",
        "",
        ["sweep/where", "sweep.yaml:4", "true or false is wanted", "names of the template"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nset: {bolts.rows: [beam.x]}",
        "",
        ["sweep/set", "sweep.yaml:4", "unknown name `beam.x`", "`role.h`"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nexpect: [\"okay > 1\"]",
        "",
        ["sweep/expect", "expect", "unknown name `okay`", "failed == 0"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\ntables: [{title: T, rows: plate.width, columns: \
         plate.thickness, action: My}]",
        "",
        ["sweep/value", "sweep.yaml:4", "which nothing varies", "a path of `axes`"],
    ),
    (
        "AXESaxes: {plate.thickness: {from: 10, to: 20, step: 0.001}, plate.width: {from: 150, to: \
         250, step: 0.01}}",
        "",
        ["sweep/size", "sweep.yaml:3", "combinations", "fewer values"],
    ),
    (
        "base: joint.yaml\naxes: {plate.thickness: [10]}\nthen: {limit: all}",
        "",
        ["sweep/value", "sweep.yaml:3", "`then` needs the checks", "first: checks"],
    ),
    ("AXEStable: t.csv", "", ["sweep/table", "t.csv:1", "is empty", "paths of the spec"]),
    (
        "AXEStable: t.csv",
        "plate.thickness,plate.colour\n10,red\n",
        ["yaml/unknown-key", "t.csv:2", "unknown key `colour`", "the keys known here"],
    ),
    (
        "AXEStable: t.csv",
        "plate.thickness,loads.ULS1.My\n10,\"43,2 kN m\"\n",
        ["sweep/table", "t.csv:2", "`43.2 kN m`", "correct the cell"],
    ),
    (
        "AXEStable: t.csv",
        "name,plate.thickness [kN]\nA,10\n",
        ["yaml/quantity", "t.csv:2", "10 kN", ""],
    ),
    (
        "AXEStable: t.csv\naxes: {plate.thickness: [12]}",
        "plate.thickness\n10\n",
        ["sweep/value", "sweep.yaml:4", "varied by the table", "one place only"],
    ),
    (
        "AXESaxes: {plate.width: [180, 200]}\nset: {plate.width: 2 * beam.b}",
        "",
        ["sweep/value", "sweep.yaml:4", "is varied by the axis", "one place only"],
    ),
    (
        "AXESaxes: {loads.ULS1.My: [-20 kN m], \"loads[0].My\": [-30 kN m]}",
        "",
        ["sweep/value", "sweep.yaml:3", "is varied by the axis", "one place only"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nset: {plate.width: 2 * beam.b, bolts.gauge: \
         plate.width / 2}",
        "",
        ["sweep/value", "sweep.yaml:4", "which `set` changes", "expression of the other value"],
    ),
    (
        "AXESaxes: {catalog: [a, b]}",
        "",
        ["sweep/value", "sweep.yaml:3", "one folder for the whole sweep", "--catalog DIR"],
    ),
    (
        "AXESaxes: {plate.thickness: [10], plate.width: [180]}\ntables: [{title: T, rows: \
         plate.width, columns: plate.thickness, only: {plate.thickness: 12}, action: My}]",
        "",
        ["sweep/value", "sweep.yaml:4", "which no case has", "as the axis writes it"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nlimits: {memory: 8 bananas}",
        "",
        ["sweep/value", "sweep.yaml:4", "`limits.memory`", "8GiB"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nlimits: {threads: 0}",
        "",
        ["sweep/value", "sweep.yaml:4", "`limits.threads` is 0", "1 or more"],
    ),
    (
        "AXEStable: t.csv\naxes: {plate.width: [180, 200]}",
        "Plate.thickness\n10\n",
        ["yaml/unknown-key", "t.csv:2", "did you mean `plate`", "the keys known here"],
    ),
    (
        "AXEStable: t.csv",
        "plate.thickness,loads[1].My\n10,-20 kN m\n",
        ["yaml/missing-key", "t.csv:2", "`loads[1]` lacks the key `name`", "add `name"],
    ),
    (
        "AXEStable: t.csv",
        "plate.thickness,bolts.rows[3]\n10,100\n",
        ["sweep/path", "bolts.rows[3]", "the list has 2 entries", "as in the base spec"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nset: {plate.widht: 2 * beam.b}",
        "",
        ["yaml/unknown-key", "sweep.yaml:4", "did you mean `width`", "the keys known here"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nset: {plate.width: 20 kN}",
        "",
        ["yaml/quantity", "sweep.yaml:4", "is not a length", ""],
    ),
    (
        "base: joint.yaml\naxes: {plate.thickness: [10]}\nchoose: {least: mass}",
        "",
        ["sweep/value", "sweep.yaml:3", "`choose` needs the checks", "first: checks"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nchoose: {least: mas}",
        "",
        ["sweep/choose", "sweep.yaml:4", "unknown name `mas`", "`mass` (kg)"],
    ),
    (
        "AXEStable: t.csv\nchoose: {least: mass}",
        "plate.thickness,expect\n10,ok\n",
        ["sweep/value", "sweep.yaml:4", "expects verdicts", "chosen == groups"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nchoose: {least: plate.thickness}",
        "",
        ["sweep/choose", "sweep.yaml:4", "a number is wanted", "`plate.thickness / 1 mm`"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nchoose: {least: bolts, per: [plate.thicknes]}",
        "",
        ["sweep/value", "sweep.yaml:4", "did you mean `plate.thickness`", "paths of `axes`"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nchoose: {least: 5}",
        "",
        ["sweep/choose", "sweep.yaml:4", "the same for all", "`mass`, `bolts`"],
    ),
    (
        "AXESaxes: {loads.ULS1.My: [-20 kN m, -30 kN m]}\nchoose: {least: bolts}",
        "",
        ["sweep/choose", "sweep.yaml:4", "joints with different loads", "as load cases"],
    ),
    (
        "AXESaxes: {plate.thickness: [10]}\nchoose: {least: bolts, among: undecided}",
        "",
        ["yaml/unknown-value", "sweep.yaml:4", "undecided", "one of: ok"],
    ),
];

#[test]
fn wrong_sweeps_are_refused() {
    let mut faults = Vec::new();
    for (sweep, table, [code, place, message, cure]) in WRONG {
        let bench = Bench::new()
            .file("joint.yaml", SPLICE)
            .file("sweep.yaml", sweep.replace("AXES", AXES))
            .file("t.csv", table);
        let want = Want { exit: 2, code, place, message, cure };
        let mut command = bench.command(&["batch", "sweep.yaml"]);
        if let Err(e) = refusal(&bench, &mut command, &want) {
            faults.push(format!("{sweep}\n{table}\n{e}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n---\n"));
}

/// A byte-order mark and semicolons, as spreadsheets write them, are read.
#[test]
fn tables_of_spreadsheets_are_read() {
    let table = "\u{feff}name;plate.thickness;loads.ULS1.My [kN m]\r\nA;12;-20\r\nB;15;-30\r\n";
    let bench = Bench::new()
        .file("joint.yaml", SPLICE)
        .file("sweep.yaml", format!("{AXES}table: t.csv\n"))
        .file("t.csv", table);
    let run = bench.run(&["batch", "sweep.yaml"]);
    let text = bench.read("sweep/results.csv");
    assert!(
        text.contains("\nA,12,-20 kN m,ULS1,"),
        "{text}{}",
        String::from_utf8_lossy(&run.stderr)
    );
}

/// Folders that are not of this sweep are left alone.
#[test]
fn folders_of_others_are_refused() {
    let axes = format!("{AXES}axes: {{plate.thickness: [10, 12]}}\n");
    let bench =
        Bench::new().file("joint.yaml", SPLICE).file("sweep.yaml", &axes).file("other.yaml", &axes);
    bench.run(&["batch", "plan", "sweep.yaml", "-o", "mine"]);
    std::fs::create_dir(bench.path().join("full")).expect("made");
    std::fs::write(bench.path().join("full/letter.txt"), "dear").expect("written");
    for (args, [code, message, cure]) in [
        (
            vec!["batch", "plan", "other.yaml", "-o", "mine"],
            ["sweep/other-sweep", "another sweep", "-o"],
        ),
        (
            vec!["batch", "plan", "other.yaml", "-o", "full"],
            ["sweep/folder", "not the folder of a sweep", "-o"],
        ),
        (
            vec!["batch", "run", "full"],
            ["sweep/no-plan", "not the folder of a sweep", "batch plan"],
        ),
        (
            vec!["batch", "merge", "nowhere"],
            ["sweep/no-plan", "not the folder of a sweep", "batch plan"],
        ),
        (vec!["batch", "run", "mine", "--shard", "3/2"], ["cli/value", "shard 3 of 2", "2/5"]),
        (vec!["batch"], ["cli/value", "no sweep file", "plan, run"]),
    ] {
        let want = Want { exit: 2, code, place: "", message, cure };
        refusal(&bench, &mut bench.command(&args), &want)
            .unwrap_or_else(|e| panic!("{args:?}: {e}"));
    }
}
