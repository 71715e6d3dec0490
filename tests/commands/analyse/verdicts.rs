//! Verdict by bounds and exit code of a joint whose demand lies below, above and within its
//! bracket.
//!
//! ```text
//!  #=====================  ⟳ My, ↓ Vz    an arm of 60 × 20 × 20 mm, S235, on a wall: by hand its
//!  #                                     hinge carries f_y b h²/4 = 470 N m, up to 2/√3 times
//!  #                                     that where the wall prevents lateral contraction
//! ```

use crate::bench::Bench;
use crate::bench::expect;
use serde_json::Value;

pub const TEMPLATE: &str = "\
name: arm
title: Arm on a wall
members:
  - {role: arm, about: steel of the arm, profile: IPE80, steel: S235}
parameters:
  - {name: side, kind: length, min: 5 mm, max: 1 m, default: 20 mm, about: side of the section}
parts:
  - name: ARM
    label: arm
    role: member
    steel: [arm]
    thickness: 10 mm
    size: side / 2
    solids:
      - box: {x: [0 mm, 3 * side], y: [-side / 2, side / 2], z: [-side / 2, side / 2]}
ends:
  - name: tip
    about: end of the arm
    part: ARM
    outward: 1
    depth: z
    face: {axis: x, at: 3 * side, y: [-side / 2, side / 2], z: [-side / 2, side / 2]}
    points: {node: [0 mm, 0 mm, 0 mm]}
supports:
  - name: WALL
    part: ARM
    fix: [x, y, z]
    face: {axis: x, at: 0 mm, y: [-side / 2, side / 2], z: [-side / 2, side / 2]}
";

/// The arm under `factor` times My = 400 N m and Vz = −1 kN at the wall.
fn spec(factor: f64) -> String {
    format!(
        "template: ./arm.yaml\nmembers: {{arm: {{profile: IPE80, steel: S235}}}}\nloads: [{{name: \
         ULS1, end: tip, at: node, My: {} kN m, Vz: {} kN}}]\nanalysis: {{kind: limit, \
         decide: false, max_passes: 1}}\n",
        0.4 * factor,
        -factor
    )
}

/// Verdict by bounds alone, and the bounds, of a run that must end with `code`.
fn answer(bench: &Bench, name: &str, factor: f64, code: i32) -> (String, [f64; 2]) {
    std::fs::write(bench.path().join(format!("{name}.yaml")), spec(factor)).expect("written");
    let (_, err) = expect(bench, &["run", &format!("{name}.yaml")], code);
    let result: Value =
        serde_json::from_str(&bench.read(&format!("{name}/result.json"))).expect("JSON");
    let case = &result["cases"][0];
    assert_eq!(case["certificate"]["strict"], true, "{err}");
    assert_eq!(case["demand"]["verdict"], result["verdict"]);
    let bound = |key: &str| case[key].as_f64().unwrap_or_else(|| panic!("{key}: {err}"));
    let by_bounds = case["demand"]["by_analysis"].as_str().unwrap_or_default();
    (by_bounds.into(), [bound("lower"), bound("upper")])
}

/// No code checks the arm: a lower bound that carries the load is one step of the route of
/// analysis, and no verdict.
#[test]
fn a_demand_below_above_and_within_the_bracket_ends_with_3_1_and_3() {
    let bench = Bench::new().file("arm.yaml", TEMPLATE);
    let (verdict, [lower, upper]) = answer(&bench, "once", 1.0, 3);
    assert_eq!(verdict, "ok");
    // the plastic hinge by hand; a clamped width may increase it
    let hand = 235.0 * 20.0 * 400.0 / 4.0 / 400e3;
    assert!(
        upper >= hand && lower <= 1.155 * hand && lower > 0.85 * hand,
        "{lower} {upper} {hand}"
    );
    let middle = 0.5 * (lower + upper);
    for (name, factor, code, word) in [
        ("below", 0.95 * lower, 3, "ok"),
        ("above", 1.05 * upper, 1, "not_ok"),
        ("within", middle, 3, "undecided"),
    ] {
        let (verdict, bounds) = answer(&bench, name, factor, code);
        assert_eq!(verdict, word, "{name} {bounds:?}");
        // scaling the load on the same mesh scales the bracket
        for (found, wanted) in bounds.into_iter().zip([lower / factor, upper / factor]) {
            assert!((found / wanted - 1.0).abs() < 1e-3, "{name}: {found} for {wanted}");
        }
        let report = bench.read(&format!("{name}/report.md"));
        let words = if word == "not_ok" { "**NOT OK**" } else { "**UNDECIDED**" };
        assert!(report.contains(words), "{name}: {report}");
    }
}

/// The load upside down breaks the arm at the same factor.
#[test]
fn a_mirrored_load_has_the_same_bracket() {
    let bench = Bench::new().file("arm.yaml", TEMPLATE);
    let (_, up) = answer(&bench, "up", 1.0, 3);
    let (_, down) = answer(&bench, "down", -1.0, 3);
    // the mesh is not symmetric: both brackets contain the exact factor, but their digits differ
    assert!(up[0] <= down[1] && down[0] <= up[1], "{up:?} {down:?}");
    assert!(
        (up[0] / down[0] - 1.0).abs() < 0.05 && (up[1] / down[1] - 1.0).abs() < 0.05,
        "{up:?} {down:?}"
    );
}
