//! Coulomb friction in elastic and elastoplastic analysis by the compiled program: the result, the
//! report and `bracket verify`.

use super::{MODEL, bench};
use crate::bench::Bench;
use crate::bench::expect;
use bracket::result::fields::vtu::VtuGrid;
use serde_json::Value;

/// A block on a softer one. Under load it widens less than the block below, so the edges of the
/// joint slip.
fn solved() -> Bench {
    solved_as("elastic", "")
}

/// The same model with another kind of analysis and further keys for the softer block.
fn solved_as(kind: &str, keys: &str) -> Bench {
    let model = MODEL
        .replace("elastic", kind)
        .replace("associated", "coulomb")
        .replace("mu: 0.3", "mu: 0.1")
        .replace("materials: {", &format!("materials: {{soft: {{E: 70000, nu: 0.3{keys}}}, "))
        .replace("BASE: steel", "BASE: soft");
    let bench = bench(&model);
    expect(&bench, &["analyse", "block.yaml", "-q"], 0);
    bench
}

fn case(bench: &Bench) -> Value {
    let result: Value = serde_json::from_str(&bench.read("block/result.json")).expect("JSON");
    result["cases"][0].clone()
}

/// Multiplies the shift of the cones.
fn scale_shift(bench: &Bench, factor: f64) {
    let path = bench.path().join("block/fields/block_shift.vtu");
    let mut grid =
        VtuGrid::from_bytes(&std::fs::read(&path).expect("written")).expect("our own file");
    grid.cell_data[0].2.iter_mut().for_each(|s| *s *= factor);
    std::fs::write(&path, grid.to_bytes().expect("sound")).expect("written");
}

#[test]
fn the_bracket_is_one_of_shifted_cones_and_is_confirmed_from_the_files() {
    let bench = solved();
    let c = case(&bench);
    assert_eq!(c["problem"], "shifted_cones", "{c}");
    assert_eq!(c["certificate"]["strict"], true, "{c}");
    let run = &c["fixed_point"];
    assert!(
        run["solves"].as_u64().expect("a number") > 1
            && run["change"].as_f64().expect("a number") <= 1e-3,
        "{run}"
    );
    // the energy gives no rigorous bound of the displacement of the load
    assert!(c.get("load_displacement").is_none() && c.get("load").is_none(), "{c}");
    let report = bench.read("block/report.md");
    for words in [
        "Coulomb's law was reached through",
        "strict for this last problem",
        "they are not bounds of Coulomb's",
    ] {
        assert!(report.contains(words), "{words}: {report}");
    }
    assert!(
        report.contains("with Coulomb friction it does not bracket a displacement"),
        "{report}"
    );
    let (out, _) = expect(&bench, &["verify", "block"], 0);
    assert_eq!(out.matches("confirmed").count(), 2, "{out}");
}

/// The edges of the softer block yield.
#[test]
fn beside_yield_the_bracket_is_confirmed_from_the_files_too() {
    let bench = solved_as("elastoplastic", ", fy: 64");
    let c = case(&bench);
    assert_eq!(c["problem"], "shifted_cones", "{c}");
    assert_eq!(c["certificate"]["strict"], true, "{c}");
    assert!(c["fixed_point"]["solves"].as_u64().expect("a number") > 1, "{c}");
    assert!(c["yielding"][0]["yielded"].as_f64().expect("a number") > 0.0, "{c}");
    assert!(c.get("load_displacement_at_least").is_none(), "{c}");
    let (out, _) = expect(&bench, &["verify", "block"], 0);
    assert_eq!(out.matches("confirmed").count(), 2, "{out}");
    scale_shift(&bench, 0.9);
    let (out, _) = expect(bench.sealed("block"), &["verify", "block"], 1);
    assert!(out.contains("REFUTED"), "{out}");
}

#[test]
fn another_shift_is_refuted() {
    // a larger shift keeps the displacement admissible; a smaller one changes the energy of the
    // stress as well
    for factor in [1.1, 0.9, 0.0] {
        let bench = solved();
        scale_shift(&bench, factor);
        let (out, _) = expect(bench.sealed("block"), &["verify", "block"], 1);
        assert!(out.contains("REFUTED"), "{factor}: {out}");
        // without a shift its distance from the slips has no scale
        assert_eq!(out.contains("off the slips of Coulomb's law"), factor > 0.0, "{factor}: {out}");
    }
    let bench = solved();
    std::fs::remove_file(bench.path().join("block/fields/block_shift.vtu")).expect("written");
    let (_, err) = expect(&bench, &["verify", "block"], 2);
    assert!(err.contains("block_shift.vtu"), "{err}");
}
