//! A capacity polygon by the compiled program: the arm of [`super::verdicts`] under moment and
//! axial force.

use super::verdicts::TEMPLATE;
use crate::bench::expect;
use crate::bench::{Bench, Edit, Want, none_wrong, refusal};
use serde_json::Value;

const HEAD: &str = "template: ./arm.yaml\nmembers: {arm: {profile: IPE80, steel: S235}}\n";
/// By hand, the section carries f_y b h²/4 = 0.47 kN m or f_y b h = 94 kN.
const POLYGON: &str = "polygon: {end: tip, at: node, My: 0.47 kN m, N: 94 kN, directions: 4}\n";

#[test]
fn inner_and_outer_hull_hold_the_hinge_by_hand() {
    let load = "loads: [{name: ULS1, end: tip, at: node, My: 0.1 kN m}]\n";
    let text =
        format!("{HEAD}{load}{POLYGON}analysis: {{kind: limit, decide: false, max_passes: 1}}\n");
    let bench = Bench::new().file("arm.yaml", TEMPLATE).file("joint.yaml", text);
    let (_, err) = expect(&bench, &["run", "joint.yaml"], 3);
    let result: Value = serde_json::from_str(&bench.read("joint/result.json")).expect("JSON");
    let cases = result["cases"].as_array().expect("cases");
    assert_eq!(cases.len(), 5, "{err}");
    // the directions of the polygon are no demand: the verdict is that of the load
    assert!(cases[1..].iter().all(|c| c.get("demand").is_none()));
    assert_eq!(cases[0]["demand"]["by_analysis"], "ok");
    let polygon = &result["polygon"];
    assert_eq!((&polygon["end"], &polygon["at"]), (&"tip".into(), &"node".into()));
    assert_eq!(polygon["axes"][0]["action"], "My");
    assert_eq!(polygon["outer_bounded"], true);
    let number = |v: &Value| v.as_f64().expect("a number");
    let pair = |v: &Value| [number(&v[0]), number(&v[1])];
    for (point, case) in polygon["points"].as_array().expect("points").iter().zip(&cases[1..]) {
        assert_eq!(
            (&point["case"], &point["lower"], &point["upper"]),
            (&case["name"], &case["lower"], &case["upper"])
        );
        assert_eq!(case["certificate"]["strict"], true);
        let ([a, b], offset) =
            (pair(&point["half_plane"]["normal"]), number(&point["half_plane"]["offset"]));
        let direction = pair(&point["direction"]);
        assert!((a * direction[0] + b * direction[1] - 1.0).abs() < 1e-6);
        // the fibre model with uniaxial stress is admissible: |m| + n² = 1 lies within every half
        // plane
        for k in 0..=40 {
            let n = -1.0 + f64::from(k) / 20.0;
            for m in [1.0 - n * n, n * n - 1.0] {
                assert!(a * m + b * n <= offset * (1.0 + 1e-9), "{point} cuts ({m}, {n})");
            }
        }
    }
    // the inner polygon exceeds this curve by at most the support of the wall
    for corner in polygon["inner"].as_array().expect("corners") {
        let [m, n] = pair(corner);
        let (m, n) = (m / 0.47e6 / 1.155, n / 94e3 / 1.155);
        assert!(m.abs() + n * n <= 1.0 + 1e-6, "{corner}");
    }
    assert_eq!(polygon["inner"].as_array().map(Vec::len), Some(4));
    let report = bench.read("joint/report.md");
    assert!(
        report.contains("## Capacity in My and N") && report.contains("](polygon.svg)"),
        "{report}"
    );
    assert!(bench.read("joint/polygon.svg").contains("N [kN]"));
    let (out, _) = expect(&bench, &["verify", "joint"], 0);
    assert!(out.contains("polygon_90"), "{out}");
    refutes_every_change(&bench, &result);
}

/// Changes the numbers of the polygon one by one. `verify` detects each change from the stored
/// mechanisms and models.
fn refutes_every_change(bench: &Bench, result: &Value) {
    let scale = |v: &mut Value| *v = (v.as_f64().expect("a number") * 1.001).into();
    let write = |value: &Value| {
        std::fs::write(bench.path().join("joint/result.json"), format!("{value:#}"))
            .expect("written")
    };
    for (pointer, words) in [
        ("/inner/0/0", "inner is not the hull"),
        ("/outer/1/0", "outer is not the intersection"),
        ("/points/0/lower", "is not the bound of its case"),
        ("/points/2/upper", "is not the bound of its case"),
        ("/points/1/half_plane/normal/1", "half_plane is not what the mechanism bounds"),
        ("/points/3/half_plane/offset", "half_plane is not what the mechanism bounds"),
        ("/axes/0/unit/moment", "the unit of My"),
        ("/axes/1/unit/force", "the unit of N"),
        ("/points/1/direction/1", "the cases of its two axes"),
        ("/points/2/direction/0", "not loaded in its direction"),
    ] {
        let mut changed = result.clone();
        scale(
            changed
                .pointer_mut(&format!("/polygon{pointer}"))
                .unwrap_or_else(|| panic!("no {pointer}")),
        );
        write(&changed);
        let (out, _) = expect(bench.sealed("joint"), &["verify", "joint"], 1);
        assert!(out.contains("REFUTED: polygon") && out.contains(words), "{pointer}: {out}");
    }
    let mut changed = result.clone();
    changed["polygon"]["outer_bounded"] = false.into();
    changed["polygon"]["inner"].as_array_mut().expect("corners").pop();
    changed["polygon"]["points"][0]["case"] = "polygon_45".into();
    write(&changed);
    let (out, _) = expect(bench.sealed("joint"), &["verify", "joint"], 1);
    assert!(out.contains("REFUTED: polygon"), "{out}");
    // what the spec asks for, and half planes that the mechanisms prove, cannot be left out
    let edits: [Edit<'_>; 7] = [
        ("polygon is missing", &|r| drop(r.as_object_mut().expect("keys").remove("polygon"))),
        ("polygon.points: case and direction", &|r| {
            drop(r["polygon"]["points"].as_array_mut().expect("points").remove(1));
        }),
        ("half_plane is not what", &|r| {
            let point = r["polygon"]["points"][2].as_object_mut().expect("a point");
            drop(point.remove("half_plane").expect("was there"));
        }),
        ("polygon.end", &|r| r["polygon"]["end"] = "foot".into()),
        ("polygon.at", &|r| r["polygon"]["at"] = "column_face".into()),
        ("polygon.axes[0].action", &|r| r["polygon"]["axes"][0]["action"] = "Mz".into()),
        ("polygon.axes[1].unit", &|r| {
            r["polygon"]["axes"][1]["unit"] = serde_json::json!({"force": 1.0e3});
        }),
    ];
    for (words, edit) in edits {
        let mut changed = result.clone();
        edit(&mut changed);
        write(&changed);
        let (out, _) = expect(bench.sealed("joint"), &["verify", "joint"], 1);
        assert!(out.contains("REFUTED: polygon") && out.contains(words), "{words}: {out}");
    }
    write(result);
    expect(bench.sealed("joint"), &["verify", "joint"], 0);
}

#[test]
fn wrong_polygons_are_refused_with_place_and_cure() {
    let mut results = Vec::new();
    for (old, new, code, message, cure) in [
        ("end: tip", "end: tipp", "spec/unknown-name", "`tipp`", "tip"),
        ("at: node", "at: column_face", "spec/unknown-name", "no point `column_face`", "node"),
        ("at: node", "at: middle", "yaml/unknown-value", "middle", ""),
        ("end: tip, ", "", "yaml/missing-key", "end", ""),
        (
            ", N: 94 kN",
            "",
            "spec/value",
            "a polygon is of two actions, 1 are given",
            "My: 100 kN m, N: 200 kN",
        ),
        ("N: 94 kN", "My: 1 kN m", "yaml/duplicate-key", "`My`", "keep one"),
        ("N: 94 kN", "N: 94 kN, Vz: 1 kN", "spec/value", "3 are given", "give two"),
        ("N: 94 kN", "N: 0 kN", "spec/value", "`N` is 0e0 N", "of this action alone"),
        ("N: 94 kN", "N: 94", "yaml/quantity", "needs a unit", "kN"),
        ("directions: 4", "directions: 6", "spec/value", "multiple of 4 from 4 to 32", "8 shows"),
        ("directions: 4", "directions: 64", "spec/value", "multiple of 4 from 4 to 32", "8 shows"),
        ("directions: 4", "direction: 4", "yaml/unknown-key", "did you mean `directions`", ""),
    ] {
        let text = format!("{HEAD}{}", POLYGON.replace(old, new));
        let bench = Bench::new().file("arm.yaml", TEMPLATE).file("joint.yaml", text);
        let want = Want { exit: 2, code, place: "joint.yaml:3:", message, cure };
        results.push((
            format!("`{old}` -> `{new}`"),
            refusal(&bench, &mut bench.command(&["run", "joint.yaml"]), &want),
        ));
    }
    none_wrong(results);
}
