//! Welds of finite strength and rigid bodies by the compiled program: its answers, its files, and
//! what `verify` reports on them.
//!
//! ```text
//!  |[ A ]:[ B ]→ t     two bars of 10 × 12 mm², welded: 2 · 3 · 200/10 = 120 MPa
//! ```

use crate::bench::Bench;
use crate::bench::expect;
use crate::common::Block;
use bracket::mesh::msh_write;
use serde_json::Value;

const WELDED: &str = "\
mesh: m.msh
analysis: limit
materials: {steel: {E: 210000, nu: 0.3, fy: 235}, rigid: {E: 210000, nu: 0.3}}
bodies: {A: rigid, B: steel}
interfaces:
  - {between: [A, B], law: weld, throat: 3, thickness: 10, strength: 200}
supports:
  - {face: X0, fix: [x, y, z]}
loads:
  - {face: X1, traction: [100, 0, 0]}
";

fn bench(model: &str) -> Bench {
    bars(model, [30.0, 10.0, 12.0], 4)
}

/// Two bars of together this size, with `cells` along x.
fn bars(model: &str, max: [f64; 3], cells: usize) -> Bench {
    let shape = Block { cells: [cells, 2, 2], min: [0.0; 3], max, jitter: 0.2, seed: 3 };
    let middle = 0.5 * max[0];
    let mesh = shape.mesh(
        &["A", "B"],
        |c| usize::from(c[0] > middle),
        |d, x| d == 0 && (x - middle).abs() < 1e-9,
    );
    Bench::new().file("bars.yaml", model).file("m.msh", msh_write::text(&mesh))
}

fn case(bench: &Bench) -> Value {
    let result: Value = serde_json::from_str(&bench.read("bars/result.json")).expect("JSON");
    result["cases"][0].clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("a number, not {value}"))
}

#[test]
fn a_weld_on_a_rigid_body_gives_way() {
    let bench = bench(WELDED);
    expect(&bench, &["analyse", "bars.yaml"], 0);
    let case = case(&bench);
    let (low, up) = (number(&case["lower"]), number(&case["upper"]));
    assert!(low <= 1.2 && up >= 1.2 && up / low - 1.0 < 1e-3, "{low} {up}");
    assert_eq!(case["certificate"]["strict"], true);
    let weld = &case["welds"][0];
    assert_eq!(weld["weld"], "A-B");
    assert!(number(&weld["utilisation"]) > 0.999 && number(&weld["utilisation"]) <= 1.0, "{weld}");
    assert!(number(&weld["share"]) > 0.99, "{weld}");
    // the weld limits the load, not a body
    assert!(case.get("limiting_part").is_none(), "{case}");
    let report = bench.read("bars/report.md");
    for words in
        ["the body without `fy` is rigid: A", "| weld A-B |", "largest traction over strength"]
    {
        assert!(report.contains(words), "lacks {words}\n{report}");
    }
    let (out, _) = expect(&bench, &["verify", "bars"], 0);
    assert!(out.matches("confirmed").count() >= 2, "{out}");
    // a strength that the model does not give would turn utilisations into stresses
    let text = bench.read("bars/result.json");
    let mut forged: Value = serde_json::from_str(&text).expect("JSON");
    forged["cases"][0]["welds"][0]["throat_strength"] = 100.0.into();
    std::fs::write(bench.path().join("bars/result.json"), format!("{forged:#}")).expect("written");
    let (out, _) = expect(bench.sealed("bars"), &["verify", "bars"], 1);
    assert!(out.contains("welds is not what the fields give"), "{out}");
    std::fs::write(bench.path().join("bars/result.json"), text).expect("written");
    // a weaker weld than the analysed one: the stress exceeds its strength, and the mechanism
    // dissipates less
    let model = bench.read("bars/model.yaml");
    std::fs::write(bench.path().join("bars/model.yaml"), model.replace("200", "190"))
        .expect("written");
    let (out, _) = expect(bench.sealed("bars"), &["verify", "bars"], 1);
    assert!(out.matches("REFUTED").count() >= 2, "{out}");
}

#[test]
fn an_elastic_weld_is_certified_and_verified() {
    let elastic = WELDED.replace("analysis: limit", "analysis: elastic");
    let bench_of = bench(&elastic);
    expect(&bench_of, &["analyse", "bars.yaml"], 0);
    let found = case(&bench_of);
    assert_eq!(found["certificate"]["strict"], true);
    let used = number(&found["welds"][0]["utilisation"]);
    assert!(used > 0.8 && used <= 1.0, "{used}");
    assert!(number(&found["welds"][0]["work"]) >= 0.0);
    // no displacement of the load: the weld may have yielded
    assert!(found.get("load_displacement").is_none(), "{found}");
    let (out, _) = expect(&bench_of, &["verify", "bars"], 0);
    assert!(out.matches("confirmed").count() >= 2, "{out}");
    // above the strength of the weld there is no equilibrium
    let torn = bench(&elastic.replace("[100, 0, 0]", "[121, 0, 0]"));
    let (_, err) = expect(&torn, &["analyse", "bars.yaml"], 3);
    assert!(err.contains("part B moves along +x"), "{err}");
}

/// In limit analysis each bound has its own sequence of meshes. Whatever mesh each bound ends on,
/// the values that belong to its field are stored with it, and `verify` finds them again.
#[test]
fn bounds_of_two_meshes_keep_the_values_of_their_fields() {
    let model = WELDED
        .replace("A: rigid", "A: steel")
        .replace(
            "throat: 3, thickness: 10, strength: 200",
            "throat: 8, thickness: 10, strength: 235",
        )
        .replace("[100, 0, 0]", "[0, 0, -10]");
    let adapt = "adapt: {target_gap: 0.14, max_macro_tets: 800, max_passes: 2}";
    let bench = bars(&format!("{model}{adapt}\n"), [40.0, 10.0, 10.0], 8);
    expect(&bench, &["analyse", "bars.yaml", "-q"], 0);
    assert!(bench.path().join("bars/fields/bars_static.yaml").is_file(), "bounds of one mesh");
    let weld = &case(&bench)["welds"][0];
    assert!(number(&weld["utilisation"]) > 0.0 && number(&weld["share"]) >= 0.0, "{weld}");
    let (out, _) = expect(&bench, &["verify", "bars"], 0);
    assert!(!out.contains("REFUTED"), "{out}");
}
