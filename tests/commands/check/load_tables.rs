//! Load cases from a table: what a frame program exports goes in, and one short printout comes out.

use crate::bench::{Bench, Want, expect, none_wrong, refusal};
use serde_json::Value;
use std::fmt::Write as _;

const JOINT: &str = "template: beam_to_column_end_plate\n\
                     members: {column: {profile: HEB180, steel: S235}, beam: {profile: IPE270, \
                     steel: S235}}\nplate: {thickness: 12, width: 150, z: [-150, 150]}\n\
                     bolts: {size: M16, grade: \"8.8\", gauge: 90, rows: [-80, 80]}\n\
                     parameters: {column_stiffeners: false}\n";

const TABLE: &str = "loads: {table: forces.csv, mapping: rfem, member: 12, station: start, end: \
                     beam_right, at: column_face, state: {SLS: \"*S\"}}\n";

/// A table of RFEM in a German system: member 12 with a row at each end, moments and forces from a
/// generator, a case without actions, rounding in the other three actions.
fn forces(cases: usize) -> (String, Vec<[f64; 3]>) {
    let mut text = "Member No.;Node No.;Location x [m];LC/CO;N [kN];V-y [kN];V-z [kN];M-T \
                    [kNm];M-y [kNm];M-z [kNm]\n"
        .to_string();
    let mut state = 88_172_645_463_325_252_u64;
    let mut random = |from: f64, to: f64| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        from + (to - from) * (state % 1000) as f64 / 1000.0
    };
    let comma = |x: f64| format!("{x:.3}").replace('.', ",");
    let mut actions = Vec::new();
    for k in 0..cases {
        let zero = k == cases / 2;
        let scale = if zero { 0.0 } else { 1.0 };
        let of = [random(-30.0, 30.0), random(5.0, 60.0), random(-24.0, 5.0)].map(|v| scale * v);
        let [n, v, m] = of;
        for (node, x) in [(3, 0.0), (9, 6.0)] {
            let name = if k % 50 == 2 { format!("CO{k}S") } else { format!("CO{k}") };
            let _ = writeln!(
                text,
                "12;{node};{};{name};{};{};{};{};{};{}",
                comma(x),
                comma(n),
                comma(0.01 * scale),
                comma(v + x),
                comma(0.0),
                comma(m - x),
                comma(-0.004 * scale)
            );
        }
        actions.push([n, -v, -m]);
    }
    (text, actions)
}

fn result(bench: &Bench, folder: &str) -> Value {
    serde_json::from_str(&bench.read(&format!("{folder}/result.json"))).expect("JSON")
}

/// 300 combinations: a verdict on each, the same as that of the combination alone, and a printout
/// of at most five pages.
#[test]
fn three_hundred_combinations_in_one_short_printout() {
    let (table, actions) = forces(300);
    let bench =
        Bench::new().file("joint.yaml", format!("{JOINT}{TABLE}")).file("forces.csv", table);
    expect(&bench, &["check", "joint.yaml", "--out", "r"], 0);
    let result = result(&bench, "r");
    let cases = result["load_cases"].as_array().expect("load cases");
    assert_eq!(cases.len(), 300);
    assert!(cases.iter().all(|c| c["verdict"] == "ok" || c["verdict"] == "none"));
    for k in [0, 77, 150, 211] {
        let [n, vz, my] = actions[k];
        let loads = format!(
            "loads: [{{name: A, end: beam_right, at: column_face, N: {n} kN, Vy: -0.01 kN, Vz: \
             {vz} kN, T: 0 kN m, My: {my} kN m, Mz: 0.004 kN m}}]\n"
        );
        let loads =
            if k == 150 { loads.replace("-0.01", "0").replace("0.004", "0") } else { loads };
        let alone = Bench::new().file("joint.yaml", format!("{JOINT}{loads}"));
        expect(&alone, &["check", "joint.yaml", "--out", "r"], 0);
        let alone = self::result(&alone, "r");
        let one = &alone["judgement"];
        let all = &cases[k];
        assert_eq!(all["case"], format!("CO{k}"));
        assert_eq!(all["verdict"], one["verdict"], "{k}");
        let used = |j: &Value| j["governing"]["utilisation"][1].as_f64();
        match (used(all), used(one)) {
            (Some(a), Some(b)) => assert!((a - b).abs() < 1e-9 * b.abs().max(1e-9), "{k}: {a} {b}"),
            (a, b) => assert_eq!(a, b, "{k}"),
        }
    }
    let csv = bench.read("r/cases.csv");
    assert_eq!(csv.lines().count(), 301);
    let line = csv.lines().find(|l| l.starts_with("CO77,")).expect("a row");
    assert!(line.starts_with("CO77,ok,ok,none,0.") && line.contains("beam_right,column_face,"));
    let report = bench.read("r/report.md");
    for words in ["largest My", "Each load case, the worst first", "Each check stands in its worst"]
    {
        assert!(report.contains(words), "{words}");
    }
    // one table of checks for all, not one for each
    assert!(report.lines().count() < 1000, "{}", report.lines().count());
    let page = bench.read("r/report.html");
    assert!((0..300).all(|k| page.contains(&format!("CO{k}"))));
    #[cfg(feature = "pdf")]
    assert!(pages(&bench, "r/report.pdf") <= 5, "{} pages", pages(&bench, "r/report.pdf"));
}

/// Number of pages of a printout.
#[cfg(feature = "pdf")]
fn pages(bench: &Bench, file: &str) -> u32 {
    let info = std::process::Command::new("pdfinfo")
        .current_dir(bench.path())
        .arg(file)
        .output()
        .expect("poppler-utils");
    let info = String::from_utf8_lossy(&info.stdout).into_owned();
    let pages = info.lines().find_map(|l| l.strip_prefix("Pages:")).expect("pages").trim();
    pages.parse().expect("a number")
}

/// Each load case of a double-sided joint has a β of its own: one diagram and two sets of numbers
/// of the component method a sense, not one for each β.
#[test]
fn many_values_of_beta_in_one_diagram() {
    let mut table = String::from("case,end,N [kN],Vz [kN],My [kN m]\n");
    for k in 0..40 {
        for (end, turn) in [("beam_right", 7), ("beam_left", 11)] {
            let my = -20.0 + f64::from((13 + turn * k) % 80);
            let _ = writeln!(table, "LC{k},{end},{},-{},{my}", (turn * k) % 19 - 9, 10 + k);
        }
    }
    let joint = "template: beam_to_column_end_plate\nmembers: {column: {profile: HEB240, steel: \
                 S235}, beam: {profile: IPE330, steel: S235}}\nplate: {thickness: 15, width: 180, \
                 z: [-180, 250]}\nbolts: {size: M20, grade: \"8.8\", gauge: 100, rows: [-105, 105, \
                 210]}\nparameters: {double_sided: true, column_stiffeners: false}\nfriction: {mu: \
                 0}\nloads: {table: forces.csv, at: column_face}\n";
    let bench = Bench::new().file("joint.yaml", joint).file("forces.csv", table);
    expect(&bench, &["check", "joint.yaml", "--out", "r"], 0);
    let result = result(&bench, "r");
    assert!(result["component_method"].as_array().expect("a list").len() > 20);
    assert!(!bench.path().join("r/moment_axial_2.svg").exists());
    let svg = bench.read("r/moment_axial.svg");
    assert!(svg.contains("80 load cases inside"), "{svg}");
    let report = bench.read("r/report.md");
    let methods = report.matches("γ_M0 = 1; β = ").count();
    assert!((2..=4).contains(&methods), "{methods} sets of numbers");
    #[cfg(feature = "pdf")]
    assert!(pages(&bench, "r/report.pdf") <= 8, "{} pages", pages(&bench, "r/report.pdf"));
}

/// The result folder keeps the load cases: its report is printed again without the table, and the
/// hash of the input depends on them.
#[test]
fn a_result_keeps_its_load_cases() {
    let (table, _) = forces(14);
    let other = table.replace("CO3;", "CO33;");
    assert_ne!(table, other);
    let spec = format!("{JOINT}{TABLE}");
    let bench = Bench::new().file("joint.yaml", &spec).file("forces.csv", &table);
    expect(&bench, &["check", "joint.yaml", "--out", "r"], 0);
    assert!(bench.read("r/input/loads.csv").starts_with("case,state,end,at,N [N]"));
    std::fs::remove_file(bench.path().join("forces.csv")).expect("removed");
    #[cfg(feature = "pdf")]
    expect(&bench, &["report", "r", "--full", "--out", "full.pdf"], 0);
    let hash = result(&bench, "r")["input_hash"].clone();
    let bench = bench.file("forces.csv", other);
    expect(&bench, &["check", "joint.yaml", "--out", "r"], 0);
    assert_ne!(result(&bench, "r")["input_hash"], hash);
}

/// A sweep over a joint with a table has a row for each joint and load case.
#[test]
fn a_sweep_of_a_joint_with_a_table() {
    let (table, _) = forces(3);
    let sweep = "base: joint.yaml\naxes: {plate.thickness: [12, 15]}\nfirst: checks\n";
    let bench = Bench::new()
        .file("joint.yaml", format!("{JOINT}{TABLE}"))
        .file("forces.csv", table)
        .file("sweep.yaml", sweep);
    expect(&bench, &["batch", "sweep.yaml", "-o", "s"], 0);
    let rows = bench.read("s/results.csv");
    assert_eq!(rows.lines().filter(|l| l.contains(",CO")).count(), 6, "{rows}");
}

/// A fault of a row names the file and its line; nothing is written.
#[test]
fn a_fault_of_the_table_names_its_line() {
    let (table, _) = forces(3);
    let mut wrong = Vec::new();
    for (old, new, place, message, cure) in [
        ("12;3;0,000;CO1;", "12;3;0,000;;", "forces.csv:4", "no name of a load case", "columns"),
        (
            "12;3;0,000;CO1;",
            "12;3;0,000;CO1;x",
            "forces.csv:4",
            "is not a number",
            "write a number",
        ),
        ("CO1;", "max My;", "forces.csv:4", "envelope", "single combinations"),
        ("12;", "13;", "joint.yaml:6", "no member `12`", "`13`"),
        ("V-z [kN]", "V-z", "forces.csv:1", "no unit", "V-z [kN]"),
    ] {
        let bench = Bench::new()
            .file("joint.yaml", format!("{JOINT}{TABLE}"))
            .file("forces.csv", table.replace(old, new));
        let want = Want { exit: 2, code: "loads/table", place, message, cure };
        let run =
            refusal(&bench, &mut bench.command(&["check", "joint.yaml", "--out", "r"]), &want);
        wrong.push((format!("{old} -> {new}"), run));
    }
    none_wrong(wrong);
}
