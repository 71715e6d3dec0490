//! Machines that lack something: the mesher, space on the disk, a free folder.

use crate::bench::{Bench, JOINT, Want, none_wrong, refusal};
use crate::common::Block;
use bracket::mesh::msh_write;
use std::process::Command;

#[test]
fn each_failure_of_a_mesher_has_its_own_message() {
    // the order of the arguments may change: a fake mesher writes to the file after `-o`
    let cases = [
        ("killed", "kill -9 $$", "mesher/killed", "killed by signal 9", "free memory"),
        ("silent", "exit 0", "mesher/no-output", "left no usable", "bracket doctor"),
        (
            "error line",
            "echo 'Error   : PLC Error:  A segment and a facet intersect at point'",
            "mesher/failed",
            "PLC Error",
            "",
        ),
        ("exit code", "echo out of luck; exit 3", "mesher/failed", "exit code 3", ""),
        (
            "full disk",
            "echo 'Error: No space left on device'",
            "mesher/disk",
            "no space is left",
            "--out",
        ),
        (
            "for ever",
            "exec sleep 60",
            "mesher/time",
            "after 1 s, the time limit",
            "analysis.time_limit",
        ),
    ];
    let spec = JOINT.replace("target_gap: 0.05", "target_gap: 0.05, time_limit: 1 s");
    let mut results = Vec::new();
    for (name, script, code, message, cure) in cases {
        for command in ["run", "mesh"] {
            let bench = Bench::new().file("joint.yaml", &spec);
            let mesher = bench.mesher(script);
            let mut run = bench.command(&[command, "joint.yaml", "--quiet"]);
            if command == "mesh" {
                run.args(["--time-limit", "1"]);
            }
            let want = Want { exit: 4, code, place: "", message, cure };
            results.push((
                format!("{command}, {name}"),
                refusal(&bench, run.env("BRACKET_GMSH", &mesher), &want),
            ));
        }
    }
    none_wrong(results);
}

#[test]
fn a_mesher_that_is_missing_or_odd_is_reported() {
    let cases = [
        ("/nonexistent", "mesher/start", "`/nonexistent` does not start", "bracket doctor"),
        ("sh -c :", "mesher/version", "does not answer `--version`", "bracket doctor"),
        ("echo 2.1.0", "mesher/old", "gmsh 2.1.0", "bracket doctor"),
        ("[1, 2]", "mesher/variable", "BRACKET_GMSH is `[1, 2]`", "unset it"),
    ];
    let mut results = Vec::new();
    for (mesher, code, message, cure) in cases {
        let bench = Bench::new().file("joint.yaml", JOINT);
        let want = Want { exit: 4, code, place: "", message, cure };
        let mut run = bench.command(&["run", "joint.yaml"]);
        results.push((mesher.to_string(), refusal(&bench, run.env("BRACKET_GMSH", mesher), &want)));
    }
    none_wrong(results);
}

#[test]
fn an_output_folder_of_someone_else_stays_as_it_is() {
    let mut results = Vec::new();
    for (name, prepare, place) in [
        (
            "a folder with other files",
            "mkdir joint && echo 'years of work' > joint/thesis.txt",
            "joint",
        ),
        ("a file", "echo 'years of work' > joint", "joint"),
        (
            "another's result.json",
            "mkdir joint && echo '{\"schema\": 1}' > joint/result.json",
            "joint",
        ),
    ] {
        let bench = Bench::new().file("joint.yaml", JOINT);
        let mesher = bench.mesher("exit 7");
        let made = Command::new("sh")
            .current_dir(bench.path())
            .args(["-c", prepare])
            .status()
            .expect("sh starts");
        assert!(made.success());
        let want = Want {
            exit: 2,
            code: "report/folder-exists",
            place,
            message: "is not a result folder of this program",
            cure: "choose another folder with --out",
        };
        let mut run = bench.command(&["run", "joint.yaml"]);
        results.push((name.to_string(), refusal(&bench, run.env("BRACKET_GMSH", &mesher), &want)));
    }
    none_wrong(results);
}

/// A block that takes a second to analyse and writes several hundred kilobytes.
#[cfg(unix)]
fn block() -> Bench {
    let mesh = Block::new([4, 2, 2], [40.0, 20.0, 20.0]).mesh(&["BLOCK"], |_| 0, |_, _| false);
    let model = "mesh: m.msh\nanalysis: elastic\nmaterials: {s: {E: 210000, nu: 0.3}}\nbodies: \
                 {BLOCK: s}\nsupports: [{face: X0, fix: [x, y, z]}]\nloads: [{face: X1, traction: \
                 [0, 0, -1]}]\n";
    Bench::new().file("block.yaml", model).file("m.msh", msh_write::text(&mesh))
}

/// A limit on the size of files simulates a full disk. The system refuses the write in the same
/// way, and the test needs no root.
#[test]
#[cfg(unix)]
fn a_disk_that_fills_up_is_exit_4_and_leaves_nothing() {
    let mut results = Vec::new();
    let program = env!("CARGO_BIN_EXE_bracket");
    for blocks in [0, 1, 4, 16, 64] {
        let bench = block();
        let script = format!(
            "ulimit -f {blocks}; trap '' XFSZ; exec '{program}' analyse block.yaml --quiet"
        );
        let want = Want {
            exit: 4,
            code: "report/disk-full",
            place: "block/",
            message: "cannot write `block/",
            cure: "free some space or choose a folder on another disk with --out",
        };
        let mut run = Command::new("sh");
        run.current_dir(bench.path()).args(["-c", &script]);
        results
            .push((format!("files of at most {blocks} blocks"), refusal(&bench, &mut run, &want)));
    }
    for blocks in [0, 2] {
        let bench = Bench::new().file("joint.yaml", JOINT);
        let mesher = bench.mesher("exit 7");
        let script =
            format!("ulimit -f {blocks}; trap '' XFSZ; exec '{program}' mesh joint.yaml --quiet");
        let want = Want {
            exit: 4,
            code: "mesher/disk",
            place: "joint/",
            message: "no space is left",
            cure: "--out",
        };
        let mut run = Command::new("sh");
        run.current_dir(bench.path()).env("BRACKET_GMSH", &mesher).args(["-c", &script]);
        results.push((
            format!("mesh, files of at most {blocks} blocks"),
            refusal(&bench, &mut run, &want),
        ));
    }
    none_wrong(results);
}

/// A real file system of a few kilobytes, if this machine allows the test to mount one.
#[test]
#[cfg(target_os = "linux")]
fn a_full_file_system_is_exit_4_and_leaves_nothing() {
    let bench = block();
    let disk = bench.path().join("disk");
    std::fs::create_dir(&disk).expect("folder");
    let mounted =
        Command::new("mount").args(["-t", "tmpfs", "-o", "size=64k", "tmpfs"]).arg(&disk).output();
    if !mounted.is_ok_and(|o| o.status.success()) {
        eprintln!(
            "not run: this user may not mount a file system (the limit on file sizes stands for \
             it)"
        );
        return;
    }
    let want = Want {
        exit: 4,
        code: "report/disk-full",
        place: "disk/result/",
        message: "No space left on device",
        cure: "free some space or choose a folder on another disk with --out",
    };
    let result = refusal(
        &bench,
        &mut bench.command(&["analyse", "block.yaml", "--out", "disk/result", "-q"]),
        &want,
    );
    let unmounted = Command::new("umount").arg(&disk).status().expect("umount starts");
    assert!(unmounted.success());
    if let Err(e) = result {
        panic!("{e}");
    }
}

/// Messages that nobody can read are no fault.
#[test]
#[cfg(target_os = "linux")]
fn a_standard_error_that_takes_nothing_is_no_fault() {
    let bench = Bench::new().file("joint.yaml", JOINT);
    std::fs::create_dir(bench.path().join("own")).expect("made");
    let steels = "standard,grade,fy_t_le_40_MPa,fu_t_le_40_MPa,fy_t_40_to_80_MPa,\
                  fu_t_40_to_80_MPa,E_MPa,nu,density_kg_per_m3,\
                  beta_w\nmine,S999,230,360,215,360,210000,0.3,7850,0.8\n";
    let sweep = "base: joint.yaml\nfirst: checks\naxes: {plate.thickness: [15, 16]}\n";
    let bench = bench.file("own/steel_grades.csv", steels).file("sweep.yaml", sweep);
    for (command, code) in [
        ("new t_stub -o t.yaml", 0),
        ("catalog --dir own list steels", 0),
        ("check joint.yaml --catalog own --out r", 0),
        ("check nothing.yaml", 2),
        ("batch sweep.yaml", 3),
        ("watch nothing.yaml", 2),
    ] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("Linux has it");
        let arguments: Vec<&str> = command.split(' ').collect();
        let run = bench.command(&arguments).stderr(full).output().expect("starts");
        assert_eq!(run.status.code(), Some(code), "{command}");
    }
    assert!(bench.path().join("t.yaml").is_file() && bench.path().join("r/report.md").is_file());
}

/// If standard output cannot be written, the result is kept and the exit code reports the error.
#[test]
#[cfg(target_os = "linux")]
fn a_full_standard_output_is_exit_4() {
    let bench = block();
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("Linux has it");
    let mut run = bench.command(&["analyse", "block.yaml", "--quiet", "--format", "json"]);
    let output = run.stdout(full).output().expect("starts");
    assert_eq!(output.status.code(), Some(4));
    assert!(String::from_utf8_lossy(&output.stderr).contains("cli/stdout"));
    assert!(bench.path().join("block/result.json").is_file());
}

#[test]
#[cfg(target_os = "linux")]
fn places_that_cannot_be_written_are_exit_4() {
    let mut results = Vec::new();
    for (out, message) in
        [("/proc/bracket", "cannot create"), ("joint.yaml/result", "Not a directory")]
    {
        let bench = Bench::new().file("joint.yaml", JOINT);
        let mesher = bench.mesher("exit 7");
        let want = Want { exit: 4, code: "report/io", place: out, message, cure: "--out" };
        let mut run = bench.command(&["run", "joint.yaml", "--out", out]);
        results.push((out.to_string(), refusal(&bench, run.env("BRACKET_GMSH", &mesher), &want)));
    }
    none_wrong(results);
}
