//! Adaptive meshes from the command line: the target gap, every limit, the files in the result
//! folder, and `bracket study`.

use super::{MODEL, bench, opening};
use crate::bench::expect;
use crate::bench::{Bench, Want, refusal};
use serde_json::Value;

fn case(json: &str) -> Value {
    serde_json::from_str::<Value>(json).expect("JSON")["cases"][0].clone()
}

fn number(v: &Value) -> f64 {
    v.as_f64().unwrap_or_else(|| panic!("{v}"))
}

/// The run reaches a gap below that of the first mesh. Its answer is the best of its history, and
/// the history holds the predictions. `verify` confirms the answer on the refined mesh. The report
/// shows it.
#[test]
fn a_target_is_reached_and_verified() {
    for (name, model) in [("elastic", opening()), ("limit", limit())] {
        let first = bench(&model);
        expect(&first, &["analyse", "block.yaml", "--quiet"], 0);
        let gap = number(&case(&first.read("block/result.json"))["gap"]);
        let target = 0.6 * gap;
        let adaptive =
            bench(&format!("{model}adapt: {{target_gap: {target}, max_macro_tets: 4000}}\n"));
        let (_, talk) = expect(&adaptive, &["analyse", "block.yaml"], 0);
        let c = case(&adaptive.read("block/result.json"));
        assert!(number(&c["gap"]) <= target, "{name}: {talk}");
        let history = c["history"].as_array().expect("rows");
        // a first mesh that is to be refined is solved roughly in limit analysis
        let slack = if name == "limit" { 0.01 * gap } else { 0.0 };
        assert!(
            history.len() > 1
                && (number(&history[0]["gap"]) - gap).abs() <= slack
                && talk.contains("forecast for the next mesh"),
            "{talk}"
        );
        let best = |key: &str, better: fn(f64, f64) -> f64| {
            history.iter().filter_map(|h| h[key].as_f64()).reduce(better)
        };
        assert_eq!(
            (best("lower", f64::max), best("upper", f64::min)),
            (c["lower"].as_f64(), c["upper"].as_f64())
        );
        // in limit analysis each later mesh is made for one bound
        let bounds = if name == "limit" { 1 } else { 2 };
        for h in &history[1..] {
            assert_eq!([&h["lower"], &h["upper"]].iter().filter(|b| !b.is_null()).count(), bounds);
        }
        let so_far: Vec<f64> = history.iter().map(|h| number(&h["so_far"]["gap"])).collect();
        assert!(so_far.windows(2).all(|g| g[1] <= g[0]), "{name}: {so_far:?}");
        assert_eq!(so_far.last().copied(), c["gap"].as_f64());
        let before = &so_far[..so_far.len() - 1];
        assert!(before.iter().all(|g| *g > target), "{name}: a mesh after the target: {so_far:?}");
        for h in &history[1..] {
            let [found, want] = [&h["macro_tets"], &h["predicted"]["macro_tets"]].map(number);
            assert!((found / want - 1.0).abs() < 0.15, "{name}: {found} tets, {want} expected");
        }
        let (found, _) = expect(&adaptive, &["verify", "block"], 0);
        assert!(found.contains("confirmed") && !found.contains("REFUTED"), "{found}");
        let report = adaptive.read("block/report.md");
        assert!(
            report.contains("What was expected of each further mesh")
                && report.contains("convergence_"),
            "{report}"
        );
        // `verify` detects a changed bound in the history
        let text = adaptive.read("block/result.json").replace(&c["upper"].to_string(), "1.0e99");
        std::fs::write(adaptive.path().join("block/result.json"), text).expect("written");
        expect(adaptive.sealed("block"), &["verify", "block"], 1);
    }
}

/// [`MODEL`] loaded to its limit load.
fn limit() -> String {
    MODEL.replace("analysis: elastic", "analysis: limit").replace("nu: 0.3}", "nu: 0.3, fy: 235}")
}

/// The program reports why it stopped and keeps the best result so far.
#[test]
fn limits_are_reported() {
    for (adapt, why) in [
        ("{target_gap: 0.0001, max_passes: 2, max_macro_tets: 2000}", "2 meshes were allowed"),
        ("{target_gap: 0.0001, max_macro_tets: 200}", "no mesh within `max_macro_tets`"),
        ("{target_gap: 0.0001, max_passes: 1}", "a finer mesh is needed"),
    ] {
        let b = bench(&format!("{}adapt: {adapt}\n", opening()));
        let (_, talk) = expect(&b, &["analyse", "block.yaml"], 0);
        assert!(talk.contains(why), "{adapt}: {talk}");
        let c = case(&b.read("block/result.json"));
        assert_eq!(c["certificate"]["strict"], true);
        assert!(
            c["history"]
                .as_array()
                .expect("rows")
                .iter()
                .all(|h| number(&h["gap"]) >= number(&c["gap"]))
        );
    }
}

/// A study with uniform and adaptive meshes and both solvers writes rows, CSV and plots. The gap
/// falls from mesh to mesh and does not depend on the solver.
#[test]
fn a_study_is_a_table_and_plots() {
    let b = bench(&opening());
    let args = [
        "study",
        "block.yaml",
        "--solver",
        "condensed,clarabel",
        "--uniform",
        "2",
        "--target-gap",
        "0.006",
    ];
    let (table, _) = expect(&b, &[&args[..], &["--max-macro-tets", "600"]].concat(), 0);
    assert!(
        table.contains("uniform, clarabel") && table.contains("adaptive, condensed"),
        "{table}"
    );
    let csv = b.read("block_study/study.csv");
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|l| l.split(',').collect()).collect();
    let gaps = |meshes: &str, solver: &str| -> Vec<f64> {
        let mine = rows.iter().filter(|r| r[2] == meshes && r[3] == solver);
        mine.map(|r| r[9].parse().unwrap_or_else(|_| panic!("{csv}"))).collect()
    };
    for meshes in ["uniform", "adaptive"] {
        let (a, b) = (gaps(meshes, "condensed"), gaps(meshes, "clarabel"));
        assert!(a.len() == b.len() && a.len() > 1 && a.windows(2).all(|g| g[1] < g[0]), "{csv}");
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-4), "{csv}");
    }
    for name in ["time", "tets", "dofs", "memory"] {
        assert!(b.read(&format!("block_study/{name}.svg")).ends_with("</svg>\n"));
        assert!(b.path().join(format!("block_study/{name}.png")).is_file());
    }
    // an earlier study is replaced; a folder that holds no study is kept
    expect(&b, &["study", "block.yaml", "--uniform", "1", "--max-passes", "1", "--quiet"], 0);
    std::fs::create_dir(b.path().join("other")).expect("folder");
    let b = b.file("other/notes.txt", "mine");
    let want = Want {
        exit: 2,
        code: "cli/out-exists",
        place: "",
        message: "was not written by",
        cure: "--out",
    };
    let mut run = b.command(&["study", "block.yaml", "--out", "other"]);
    refusal(&b, &mut run, &want).unwrap_or_else(|e| panic!("{e}"));
}

#[test]
fn wrong_options_of_a_study_are_refused() {
    let mut results = Vec::new();
    for (args, message, cure) in [
        (["--uniform", "11"], "at most 10 meshes", "3 to 5"),
        (["--uniform", "two"], "invalid value 'two'", "--uniform"),
        (["--target-gap", "0"], "--target-gap is 0", "0.02"),
        (["--target-gap", "1"], "--target-gap is 1", "0.02"),
        (["--target-gap", "nan"], "--target-gap is NaN", "0.02"),
        (["--max-macro-tets", "0"], "--max-macro-tets is 0", "leave the option out"),
        (["--max-passes", "0"], "--max-passes is 0", "leave the option out"),
        (["--size-factor", "0"], "--size-factor is 0", "1 is the usual size"),
        (["--size-factor", "inf"], "--size-factor is inf", "1 is the usual size"),
        (["--memory-limit", "8"], "it has no unit", "8GiB"),
        (["--solver", "fast"], "invalid value 'fast'", "condensed, clarabel"),
    ] {
        let b = bench(MODEL);
        let run = b.command(&["study", "block.yaml", args[0], args[1]]).output().expect("runs");
        let talk = String::from_utf8_lossy(&run.stderr).into_owned();
        let right = run.status.code() == Some(2) && talk.contains(message) && talk.contains(cure);
        results.push((args.join(" "), if right { None } else { Some(talk) }));
    }
    let wrong: Vec<_> =
        results.into_iter().filter_map(|(args, talk)| Some((args, talk?))).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// One body can be lifted off the other, and the load pulls both sideways: rounding in the lift is
/// no work of the load, and no mechanism at zero load.
#[test]
fn a_lift_without_work_is_no_mechanism() {
    let model = "mesh: m.msh\nanalysis: limit\nmaterials: {s: {E: 3490, nu: 0.09, fy: 321}, t: {E: \
                 184000, nu: 0.3, fy: 201}}\nbodies: {A: t, B: s}\ninterfaces: [{between: [A, B], \
                 law: contact, mu: 0, friction: coulomb}]\nsupports: [{face: X0, fix: [x]}, \
                 {face: Y0, fix: [y]}]\nrigid: [{face: Z0, components: [x, y, z]}]\nloads: \
                 [{face: X1, traction: [9.8541, 0, 0]}]\nadapt: {target_gap: 0.01, max_passes: 3, \
                 max_macro_tets: 400}\n";
    let mesh = include_str!("../../data/lift.msh");
    let b = Bench::new().file("block.yaml", model).file("m.msh", mesh);
    expect(&b, &["analyse", "block.yaml"], 0);
    let c = case(&b.read("block/result.json"));
    let (lower, upper) = (c["lower"].as_f64().expect("lower"), c["upper"].as_f64().expect("upper"));
    // not above the stronger body alone, held in its plane: at most 2/√3 of fy
    assert!(lower > 20.0 && lower < upper && upper < 321.0 / 9.8541 * 1.2, "{c}");
    expect(&b, &["verify", "block"], 0);
}

/// The load does no work on the motion that only an unloaded contact resists. Rounding of that work
/// must not draw the load factor to zero.
#[test]
fn unloaded_contacts_leave_the_load_factor_alone() {
    let model = "mesh: m.msh\nanalysis: limit\nmaterials: {s: {E: 10100, nu: 0.341, fy: 22.3}}\n\
                 bodies: {A: s, B: s, C: s}\ninterfaces: [{between: [A, B], law: contact, mu: 0}]\n\
                 supports: [{face: Z0, fix: [x, y, z]}, {face: X0, fix: [x]}, {face: Y0, fix: \
                 [y]}]\nloads: [{face: X1, traction: [1.2974, 0, 0]}]\nadapt: {target_gap: 0.01, \
                 max_passes: 3, max_macro_tets: 600}\n";
    let mesh = include_str!("../../data/open_gap.msh");
    let b = Bench::new().file("block.yaml", model).file("m.msh", mesh);
    let (_, talk) = expect(&b, &["analyse", "block.yaml"], 0);
    let c = case(&b.read("block/result.json"));
    // a bar in tension: fy over the traction
    let (lower, upper) = (c["lower"].as_f64().expect("lower"), c["upper"].as_f64().expect("upper"));
    let exact = 22.3 / 1.2974;
    assert!(lower <= exact && exact <= upper && upper - lower < 1e-3 * exact, "{c}");
    for text in [talk, b.read("block/report.md")] {
        let words = text.split(|l: char| !l.is_alphanumeric());
        assert!(words.into_iter().all(|w| w != "NaN" && w != "inf"), "{text}");
    }
    expect(&b, &["verify", "block"], 0);
}
