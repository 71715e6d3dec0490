//! What an import refuses: each with one message that names the place and the cure, and nothing
//! left behind.

use super::frame::{BASE, JOINTS, SAP2000_ARGS, SECTIONS, saf_sheets, sap2000};
use super::workbook::workbook;
use crate::bench::{Bench, Want, none_wrong, refusal};

/// A file, what is replaced in it and by what; code, place, message, cure.
type Wrong<'a> = (&'a str, &'a str, &'a str, &'a str, &'a str, &'a str, &'a str);

/// The rows of the joints.
const ROWS: &str = "A,beam_right,B1,start,,,,C1,C2,false\nB,beam_right,B2,start,beam_left,B1,\
                    end,C3,C4,true\n";

const JOINTS_FAULT: &str = "import/joints";
const FORCES_FAULT: &str = "import/forces";
const MODEL_FAULT: &str = "import/model";

const WRONG: [Wrong<'_>; 23] = [
    (
        "base.yaml",
        "beam_to_column_end_plate",
        "beam_to_colum",
        "template/unknown",
        "base.yaml:1",
        "no template `beam_to_colum`",
        "bracket templates",
    ),
    (
        "joints.csv",
        "parameters.double_sided",
        "template",
        "import/base",
        "joints.csv:2",
        "joint `A` has no template",
        "bracket templates",
    ),
    (
        "base.yaml",
        "template: ",
        "# ",
        "import/base",
        "base.yaml",
        "has no template",
        "bracket templates",
    ),
    (
        "joints.csv",
        "member2",
        "membr2",
        JOINTS_FAULT,
        "joints.csv:1",
        "did you mean `member2`",
        "columns are",
    ),
    (
        "joints.csv",
        "parameters.",
        "loads.",
        JOINTS_FAULT,
        "joints.csv:1",
        "the loads come from the forces",
        "--cases",
    ),
    ("joints.csv", "joint,", "end,", JOINTS_FAULT, "joints.csv:1", "there twice", "delete one"),
    (
        "joints.csv",
        ",station,",
        ",node,",
        JOINTS_FAULT,
        "joints.csv:1",
        "no column `station`",
        "`start` or `end`",
    ),
    (
        "joints.csv",
        "\nB,",
        "\nA,",
        JOINTS_FAULT,
        "joints.csv:3",
        "`A` stands in line 2 too",
        "name of its own",
    ),
    ("joints.csv", "\nB,", "\n,", JOINTS_FAULT, "joints.csv:3", "has no name", "name of its own"),
    (
        "joints.csv",
        "B1,start",
        ",start",
        JOINTS_FAULT,
        "joints.csv:2",
        "`station` belongs to `member`",
        "name the member",
    ),
    (
        "joints.csv",
        "B1,start",
        "B1,",
        JOINTS_FAULT,
        "joints.csv:2",
        "which end of `B1`",
        "`start` or `end`",
    ),
    (
        "joints.csv",
        "B1,start",
        "B1,left",
        JOINTS_FAULT,
        "joints.csv:2",
        "`left` is no end",
        "`start` or `end`",
    ),
    (
        "joints.csv",
        "A,beam_right",
        "A,beam_rigth",
        JOINTS_FAULT,
        "joints.csv:2",
        "did you mean `beam_right`",
        "it has `beam_right`",
    ),
    (
        "joints.csv",
        "beam_left",
        "beam_right",
        JOINTS_FAULT,
        "joints.csv:3",
        "both members are at the end `beam_right`",
        "the other end",
    ),
    (
        "joints.csv",
        "C2,false",
        "C2,false,1",
        JOINTS_FAULT,
        "joints.csv:2",
        "has 11 cells, the header 10",
        "quotes",
    ),
    (
        "joints.csv",
        "parameters.double_sided",
        "members.beam.profil",
        "yaml/unknown-key",
        "joints.csv:2",
        "profil",
        "profile",
    ),
    (
        "joints.csv",
        ",C3,",
        ",C9,",
        "loads/table",
        "joints.csv:3",
        "joint `B`: the table has no member `C9`",
        "`C1`",
    ),
    ("joints.csv", ROWS, "", JOINTS_FAULT, "joints.csv:1", "no rows", "a row for each joint"),
    (
        "base.yaml",
        "beam_to_column_end_plate",
        "beam_splice",
        JOINTS_FAULT,
        "joints.csv:2",
        "has no column, and the row names `C1`",
        "column_below",
    ),
    (
        "base.yaml",
        "HEB180, steel: S235",
        "HEB180",
        "yaml/missing-key",
        "base.yaml:2",
        "steel",
        "steel",
    ),
    (
        "forces.txt",
        "C4\t0\tULS2",
        "C5\t0\tULS2",
        "loads/table",
        "forces.txt",
        "ULS2",
        "same sections",
    ),
    (
        "forces.txt",
        "KN\tKN\tKN\t",
        "\tKN\tKN\t",
        "loads/table",
        "forces.txt:2",
        "the column `P` has no unit",
        "P [kN]",
    ),
    (
        "forces.txt",
        "C4\t3\tULS2\tCombination",
        "C4\t3\tULS2\tmax",
        "loads/table",
        "forces.txt",
        "envelope",
        "single combinations",
    ),
];

fn bench() -> Bench {
    Bench::new()
        .file("forces.txt", sap2000(&SECTIONS))
        .file("joints.csv", JOINTS)
        .file("base.yaml", BASE)
}

#[test]
fn wrong_tables_are_refused_in_words() {
    let mut results = Vec::new();
    for (file, old, new, code, place, message, cure) in WRONG {
        let bench = bench();
        let text = bench.read(file);
        assert!(text.contains(old), "{file} has no {old}");
        let bench = bench.file(file, text.replacen(old, new, 1));
        let want = Want { exit: 2, code, place, message, cure };
        let run = refusal(&bench, &mut bench.command(&SAP2000_ARGS), &want);
        results.push((format!("{file}: {old} -> {new}"), run));
    }
    none_wrong(results);
}

/// A load case that one member has and another lacks.
#[test]
fn other_load_cases_are_refused_in_words() {
    let all = sap2000(&SECTIONS);
    let without = |member: &str| -> String {
        let lost = |l: &&str| !(l.starts_with(member) && l.contains("ULS2"));
        all.lines().filter(lost).flat_map(|l| [l, "\n"]).collect()
    };
    let mut results = Vec::new();
    for (member, place, message) in [
        ("B1", "joints.csv:3", "`ULS2` has forces of `B2` and none of `B1`"),
        ("C4", "joints.csv:3", "`ULS2` has forces of `B2` and none of `C4`"),
        ("B2", "joints.csv:3", "`ULS2` has forces of `B1` and none of `B2`"),
    ] {
        let bench = bench().file("forces.txt", without(member));
        let joints = bench.read("joints.csv");
        let alone: String =
            joints.lines().filter(|l| !l.starts_with('A')).flat_map(|l| [l, "\n"]).collect();
        let bench = bench.file("joints.csv", format!("# joint B\n{alone}"));
        let want = Want { exit: 2, code: FORCES_FAULT, place, message, cure: "--cases" };
        results.push((member.into(), refusal(&bench, &mut bench.command(&SAP2000_ARGS), &want)));
    }
    none_wrong(results);
}

#[test]
fn wrong_files_and_options_are_refused_in_words() {
    let mut results = Vec::new();
    for (at, new, code, place, message, cure) in [
        (1, "no.csv", FORCES_FAULT, "no.csv", "no such table", "check the path"),
        (3, "no.csv", JOINTS_FAULT, "no.csv", "cannot be read", "--joints"),
        (5, "no.yaml", "import/base", "no.yaml", "cannot be read", "--base"),
        (5, "list.yaml", "import/base", "list.yaml", "no spec", "bracket new"),
        (9, "full", "cli/out-exists", "full", "was not written by `bracket import`", "--out"),
    ] {
        let bench = bench().file("list.yaml", "[1]\n");
        std::fs::create_dir(bench.path().join("full")).expect("a folder");
        let bench = bench.file("full/mine.txt", "mine");
        let mut args = SAP2000_ARGS;
        args[at] = new;
        let want = Want { exit: 2, code, place, message, cure };
        results.push((args.join(" "), refusal(&bench, &mut bench.command(&args), &want)));
    }
    for (option, pattern, message) in
        [("--cases", "XX*", "no load case of the table is `XX*`"), ("--sls", "S*X", "`S*X`")]
    {
        let bench = bench();
        let args = [&SAP2000_ARGS[..], &[option, pattern]].concat();
        let want =
            Want { exit: 2, code: "loads/table", place: option, message, cure: "any letters" };
        results.push((args.join(" "), refusal(&bench, &mut bench.command(&args), &want)));
    }
    none_wrong(results);
}

#[test]
fn wrong_models_are_refused_in_words() {
    let mut results = Vec::new();
    for (beam, column, members, place, message, cure) in [
        ("1|IPE275", "1|HEB180", "", "frame.xlsx:2", "`IPE270`", "members.beam.profile"),
        ("4|L100X10", "1|HEB180", "", "frame.xlsx:2", "L100X10", "members.beam.profile"),
        ("16 - Z|IPE270", "1|HEB180", "", "frame.xlsx:2", "principal axes are turned", "I and H"),
        ("1|IPE270", "1|HEB180", "B1", "joints.csv:2", "no member `B1`", "whole model"),
        ("1|IPE270", "1|HEB180", "C2", "joints.csv:2", "`C2` IPE270", "members.column.profile"),
    ] {
        let mut sheets = saf_sheets(&SECTIONS, beam, column);
        for row in &mut sheets[3].1 {
            *row = match members {
                "B1" => row.replace("|B1|", "|B9|"),
                "C2" => row.replace("|C2|CS2|", "|C2|CS1|"),
                _ => row.clone(),
            };
        }
        let bench = bench().file("frame.xlsx", workbook(&sheets));
        let mut args = SAP2000_ARGS;
        (args[1], args[7]) = ("frame.xlsx", "saf");
        let want = Want { exit: 2, code: MODEL_FAULT, place, message, cure };
        let run = refusal(&bench, &mut bench.command(&args), &want);
        results.push((format!("{beam} {column} {members}"), run));
    }
    none_wrong(results);
}
