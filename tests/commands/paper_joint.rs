//! The paper's joint from its spec, as a user runs it: finer meshes and the whole joint. Each test
//! takes minutes and belongs to the heavy tier.
use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// Runs the example with further options and returns its `result.json`.
fn run(options: &[&str]) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let output = Command::new(env!("CARGO_BIN_EXE_bracket"))
        .current_dir(root)
        .args(["run", "examples/paper_joint/joint.yaml", "--format", "json", "--quiet", "--out"])
        .arg(folder.path().join("result"))
        .args(options)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    let case = &result["cases"][0];
    println!(
        "{options:?}: {} tets, [{}, {}], gap {}",
        case["history"][0]["macro_tets"], case["lower"], case["upper"], case["gap"]
    );
    assert_eq!(case["certificate"]["strict"], true);
    for residual in ["equilibrium", "traction_jump", "contact", "compatibility"] {
        assert!(case["certificate"][residual].as_f64().unwrap() <= 1e-9, "{residual}: {case}");
    }
    result
}

fn bounds(result: &Value) -> (f64, f64) {
    let case = &result["cases"][0];
    (case["lower"].as_f64().unwrap(), case["upper"].as_f64().unwrap())
}

/// The whole joint and its quarter are different meshes of the same body. Both brackets contain the
/// exact energy, so they must overlap.
#[test]
#[ignore = "heavy: about ten minutes"]
fn full_agrees_with_the_quarter() {
    let quarter = run(&["--size-factor", "1.8"]);
    let full = run(&["--size-factor", "1.8", "--full"]);
    assert_eq!((quarter["symmetry"].as_u64(), full["symmetry"].as_u64()), (Some(4), Some(1)));
    let ((l1, u1), (l2, u2)) = (bounds(&quarter), bounds(&full));
    assert!(l1.max(l2) <= u1.min(u2), "[{l1}, {u1}] and [{l2}, {u2}] share nothing");
}

/// About 33 000 tets in the quarter: the gap is at most 2.6 %.
#[test]
#[ignore = "heavy: about ten minutes"]
fn thirty_three_thousand() {
    let result = run(&["--size-factor", "0.49"]);
    let tets = result["cases"][0]["history"][0]["macro_tets"].as_u64().unwrap();
    assert!((30_000..36_000).contains(&tets), "{tets} tets");
    assert!(result["cases"][0]["gap"].as_f64().unwrap() <= 0.026);
}
