//! Preloaded bolts by the compiled program: the result, the report, `bracket verify`, refined
//! meshes, limit analysis.

use crate::bench::Bench;
use crate::bench::expect;
use crate::common::{Block, beside, renamed, triangles_where};
use bracket::mesh::{NamedFaces, msh_write};
use serde_json::Value;

/// A bolt held at its foot and a sleeve on the ground, both under a rigid head.
const SLEEVE: &str = "\
mesh: sleeve.msh
analysis: elastic
materials: {steel: {E: 200000, nu: 0.3, fy: 640}}
bodies: {BOLT: steel, SLEEVE: steel}
supports:
  - {face: FOOT, fix: [x, y, z]}
  - {face: GROUND, law: contact, mu: 0.2, friction: associated}
rigid:
  - {face: Z1, components: [x, y, z], free: [ux, uz], force: [40, 0, 300]}
preload:
  - {body: BOLT, cut: CUT, axis: [0, 0, 1], force: 400}
";

fn bench(model: &str) -> Bench {
    let bolt =
        Block { cells: [1, 1, 4], min: [0.0; 3], max: [1.0, 1.0, 10.0], jitter: 0.2, seed: 3 };
    let bolt = bolt.mesh(&["BOLT"], |_| 0, |axis, x| axis == 2 && x == 5.0);
    let mut bolt = renamed(bolt, "Z0", "FOOT");
    let triangles = triangles_where(&bolt, |x| x[2] == 5.0);
    bolt.faces.push(NamedFaces { name: "CUT".into(), triangles });
    let sleeve = Block {
        cells: [2, 2, 3],
        min: [3.0, 0.0, 0.0],
        max: [5.0, 2.0, 10.0],
        jitter: 0.2,
        seed: 4,
    };
    let sleeve = renamed(sleeve.mesh(&["SLEEVE"], |_| 0, |_, _| false), "Z0", "GROUND");
    Bench::new()
        .file("sleeve.yaml", model)
        .file("sleeve.msh", msh_write::text(&beside(bolt, sleeve)))
}

fn solved(model: &str) -> Bench {
    let bench = bench(model);
    expect(&bench, &["analyse", "sleeve.yaml", "-q", "--threads", "1"], 0);
    bench
}

fn case(bench: &Bench) -> Value {
    let result: Value = serde_json::from_str(&bench.read("sleeve/result.json")).expect("JSON");
    result["cases"][0].clone()
}

#[test]
fn the_energy_is_bracketed_and_confirmed_from_the_files() {
    let bench = solved(SLEEVE);
    let c = case(&bench);
    assert_eq!(c["certificate"]["strict"], true, "{c}");
    let bolts = c["preload"].as_array().expect("bolts");
    let bolt = &bolts[0];
    assert_eq!(
        (bolts.len(), &bolt["body"], &bolt["cut"]),
        (1, &"BOLT".into(), &"CUT".into()),
        "{bolt}"
    );
    assert_eq!(bolt["force"], 400.0, "{bolt}");
    // the bolt carries a part of the load, and the sleeve stays in compression
    let tension = bolt["tension"].as_f64().expect("a number");
    assert!(
        tension > 400.0 && tension < 550.0 && bolt["closure"].as_f64().expect("a number") > 0.0,
        "{bolt}"
    );
    assert!(c.get("load_displacement").is_none() && c.get("load").is_none(), "{c}");
    let report = bench.read("sleeve/report.md");
    for words in [
        "The bracket applies to the energy only: with preload it does not bracket a displacement",
        "Bolt BOLT: the preload of 0.4000 kN closes the cut CUT by",
        "they bracket its energy only",
    ] {
        assert!(report.contains(words), "{words}: {report}");
    }
    let (out, _) = expect(&bench, &["verify", "sleeve"], 0);
    assert_eq!(out.matches("confirmed").count(), 2, "{out}");
}

#[test]
fn another_closure_or_another_preload_is_refuted() {
    for (key, factor, words) in [
        ("closure", 1.001, "REFUTED"),
        ("force", 2.0, "the preload of `BOLT` is not"),
        ("tension", 1.1, "preload"),
    ] {
        let bench = solved(SLEEVE);
        let mut result: Value =
            serde_json::from_str(&bench.read("sleeve/result.json")).expect("JSON");
        let stored = &mut result["cases"][0]["preload"][0][key];
        *stored = (factor * stored.as_f64().expect("a number")).into();
        let bench = bench.file("sleeve/result.json", result.to_string());
        let (out, _) = expect(bench.sealed("sleeve"), &["verify", "sleeve"], 1);
        assert!(out.contains(words), "{key}: {out}");
    }
}

/// The force of a bolt that no plane halves is not that of one half.
#[test]
fn a_bolt_called_halved_is_refuted() {
    let bench = solved(SLEEVE);
    let mut result: Value = serde_json::from_str(&bench.read("sleeve/result.json")).expect("JSON");
    result["cases"][0]["preload"][0]["halved"] = true.into();
    let bench = bench.file("sleeve/result.json", result.to_string());
    let (out, _) = expect(bench.sealed("sleeve"), &["verify", "sleeve"], 1);
    assert!(out.contains("preload is not what the fields give"), "{out}");
}

/// The closures differ from mesh to mesh, so bounds from two meshes would belong to two different
/// structures.
#[test]
fn both_bounds_of_refined_meshes_belong_to_one_mesh() {
    let bench = solved(&format!(
        "{SLEEVE}adapt: {{target_gap: 1.0e-6, max_passes: 2, max_macro_tets: 1500}}\n"
    ));
    let c = case(&bench);
    let history = c["history"].as_array().expect("rows");
    assert_eq!(history.len(), 2, "{c}");
    assert!(history.iter().any(|h| h["lower"] == c["lower"] && h["upper"] == c["upper"]), "{c}");
    let (out, _) = expect(&bench, &["verify", "sleeve"], 0);
    assert_eq!(out.matches("confirmed").count(), 2, "{out}");
}

/// B12: the load at collapse does not depend on the preload.
#[test]
fn in_limit_analysis_preload_drops_out() {
    let limit = SLEEVE.replace("analysis: elastic", "analysis: limit");
    let bench = solved(&limit);
    let tightened = case(&bench);
    let report = bench.read("sleeve/report.md");
    assert!(report.contains("limit analysis: the preload of BOLT drops out"), "{report}");
    assert!(tightened.get("preload").is_none(), "{tightened}");
    let (out, _) = expect(&bench, &["verify", "sleeve"], 0);
    assert!(out.contains("confirmed") && !out.contains("REFUTED"), "{out}");
    let without = limit.split("preload:").next().expect("the text before").to_string();
    let plain = case(&solved(&without));
    for key in ["lower", "upper"] {
        assert_eq!(tightened[key], plain[key], "{key}");
    }
}
