//! `analysis: elastoplastic` through the real program: its answers, its files, what `verify`
//! reports on them, and the inputs that it refuses.
//!
//! ```text
//!    ↓→↓→↓→↓
//!   +-------+    a cube of 100 mm, clamped at its foot, pressed and sheared at its top by two
//!   |       |    thirds of its limit load: the edges of the foot yield
//!   +-------+
//!   /////////
//! ```

use crate::bench::expect;
use crate::bench::{Bench, Want, none_wrong, refusal};
use crate::common::Block;
use bracket::mesh::msh_write;
use bracket::result::fields::vtu::VtuGrid;
use serde_json::Value;

const CUBE: &str = "\
mesh: m.msh
analysis: elastoplastic
materials: {steel: {E: 210000, nu: 0.3, fy: 235}}
bodies: {B: steel}
supports:
  - {face: Z0, fix: [x, y, z]}
loads:
  - {face: Z1, traction: [31.5, 0, -125.8]}
";

fn cube(model: &str) -> Bench {
    let mesh = Block::new([3; 3], [100.0; 3]).jittered(1).mesh(&["B"], |_| 0, |_, _| false);
    Bench::new().file("cube.yaml", model).file("m.msh", msh_write::text(&mesh))
}

fn case(bench: &Bench) -> Value {
    serde_json::from_str::<Value>(&bench.read("cube/result.json")).expect("JSON")["cases"][0]
        .clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("a number, not {value}"))
}

fn grid(bench: &Bench, kind: &str) -> VtuGrid {
    let bytes =
        std::fs::read(bench.path().join(format!("cube/fields/cube_{kind}.vtu"))).expect("field");
    VtuGrid::from_bytes(&bytes).expect("our own file")
}

#[test]
fn a_clamped_cube_yields_at_its_foot() {
    let bench = cube(CUBE);
    let (_, err) = expect(&bench, &["analyse", "cube.yaml"], 0);
    assert!(err.contains("cube: potential energy between") && err.contains("(certified)"), "{err}");
    let case = case(&bench);
    for (key, value) in [
        ("analysis", "elastoplastic"),
        ("quantity", "potential_energy"),
        ("problem", "frictionless"),
    ] {
        assert_eq!(case[key], value);
    }
    let (lower, upper) = (number(&case["lower"]), number(&case["upper"]));
    assert!(
        lower < upper && upper < 0.0 && (upper - lower) / lower.abs() < 0.05,
        "{lower} {upper}"
    );
    let certificate = &case["certificate"];
    assert_eq!(certificate["strict"], true);
    for key in ["equilibrium", "traction_jump", "compatibility"] {
        assert!((0.0..=1e-9).contains(&number(&certificate[key])), "{key}");
    }
    let inside = number(&certificate["yield"]);
    assert!(inside <= 0.0 && inside > -1e-4, "{inside}");
    // −2Π/F bounds the displacement from below only
    assert!(case.get("load_displacement").is_none());
    let least = number(&case["load_displacement_at_least"]);
    let force = number(&case["load"]["force"]);
    assert!((force / (31.5f64.hypot(125.8) * 1e4) - 1.0).abs() < 1e-9, "{force}");
    assert!((least + 2.0 * upper / force).abs() < 1e-9 * least, "{least}");
    let body = &case["yielding"][0];
    assert_eq!(body["part"], "B");
    let (used, yielded) = (number(&body["utilisation"]), number(&body["yielded"]));
    assert!(used <= 1.0 && used > 0.9999 && yielded > 0.0 && yielded < 0.5, "{used} {yielded}");
    let row = &case["history"][0];
    for program in ["kinematic", "static"] {
        assert_eq!(row[program]["status"], "optimal");
        let tets = number(&row[program]["yielding_tets"]);
        assert!(
            tets > 0.0 && tets < 162.0 && number(&row[program]["solves"]) >= 2.0,
            "{program} {tets}"
        );
    }
    let report = bench.read("cube/report.md");
    for words in [
        "**cube** (elastic, perfectly plastic)",
        "Its displacement (along the load, the mean over its face) is at least",
        "## Yielding of cube",
        "Yield conditions were needed in ",
        "nothing that has yielded unloads",
        "| cube | yield |",
    ] {
        assert!(report.contains(words), "lacks {words}\n{report}");
    }
    let (kinematic, stress) = (grid(&bench, "kinematic"), grid(&bench, "static"));
    let flow = &kinematic.cell_array("equivalent_plastic_strain").expect("plastic strain").2;
    assert!(flow.iter().any(|p| *p > 1e-6) && flow.contains(&0.0));
    let gap: f64 =
        kinematic.cell_array("gap_contribution_N_mm").expect("contributions").2.iter().sum();
    assert!((gap - (upper - lower)).abs() < 1e-8 * upper.abs(), "{gap}");
    let used = &stress.cell_array("utilisation").expect("utilisations").2;
    assert!(used.iter().all(|u| *u <= 1.0) && used.iter().any(|u| *u > 0.9999));
}

#[test]
fn beyond_its_strength_nothing_balances_and_the_body_is_named() {
    let bench = cube(&CUBE.replace("31.5", "94.5").replace("125.8", "377.4"));
    let (_, err) = expect(&bench, &["analyse", "cube.yaml"], 3);
    for words in [
        "cube: no bound",
        "no equilibrium exists under these loads",
        "body `B` (100 % of the dissipation) yields without end",
    ] {
        assert!(err.contains(words), "lacks {words}: {err}");
    }
    let case = case(&bench);
    assert!(
        case.get("lower").is_none()
            && case.get("upper").is_none()
            && case.get("certificate").is_none()
    );
    for program in ["kinematic", "static"] {
        assert_eq!(case["history"][0][program]["status"], "unbounded");
    }
    let (out, _) = expect(&bench, &["verify", "cube"], 0);
    assert!(out.contains("no bound"), "{out}");
}

#[test]
fn without_a_yield_strength_it_is_elastic_and_says_so() {
    let bench = cube(&CUBE.replace(", fy: 235", ""));
    expect(&bench, &["analyse", "cube.yaml"], 0);
    assert!(bench.read("cube/report.md").contains("no material has a yield strength"));
    let plastic = case(&bench);
    let bench = cube(&CUBE.replace(", fy: 235", "").replace("elastoplastic", "elastic"));
    expect(&bench, &["analyse", "cube.yaml"], 0);
    let elastic = case(&bench);
    for key in ["lower", "upper"] {
        let (a, b) = (number(&plastic[key]), number(&elastic[key]));
        assert!((a - b).abs() <= 1e-8 * b.abs(), "{key}: {a} {b}");
    }
    assert!(plastic.get("yielding").is_none());
}

/// The gap narrows from mesh to mesh. `verify` computes the values of the result from the fields of
/// the best bounds.
#[test]
fn meshes_follow_the_gap() {
    let bench =
        cube(&format!("{CUBE}adapt: {{target_gap: 0.005, max_passes: 2, max_macro_tets: 1500}}\n"));
    expect(&bench, &["analyse", "cube.yaml"], 0);
    let case = case(&bench);
    let rows = case["history"].as_array().expect("rows");
    let gaps: Vec<f64> = rows.iter().map(|r| number(&r["gap"])).collect();
    assert!(
        gaps.len() == 2 && gaps[1] < 0.8 * gaps[0] && case["certificate"]["strict"] == true,
        "{gaps:?}"
    );
    assert!(rows.iter().all(|r| number(&r["static"]["yielding_tets"]) > 0.0));
    assert!(
        number(&case["yielding"][0]["utilisation"]) > 0.999
            && number(&case["yielding"][0]["yielded"]) > 0.0
    );
    let (out, _) = expect(&bench, &["verify", "cube"], 0);
    assert_eq!(out.matches("confirmed").count(), 2, "{out}");
}

fn edit_result(bench: &Bench, edit: impl Fn(&mut Value)) {
    let mut all: Value = serde_json::from_str(&bench.read("cube/result.json")).expect("JSON");
    edit(&mut all["cases"][0]);
    std::fs::write(bench.path().join("cube/result.json"), format!("{all:#}\n")).expect("written");
}

/// Multiplies an array in a field file.
fn edit_field(bench: &Bench, kind: &str, name: &str, factor: f64) {
    let mut grid = grid(bench, kind);
    let arrays = grid.point_data.iter_mut().chain(&mut grid.cell_data);
    let array =
        arrays.into_iter().find(|a| a.0 == name).unwrap_or_else(|| panic!("no array {name}"));
    array.2.iter_mut().for_each(|x| *x *= factor);
    let path = bench.path().join(format!("cube/fields/cube_{kind}.vtu"));
    std::fs::write(path, grid.to_bytes().expect("writes")).expect("written");
}

#[test]
fn verify_confirms_what_is_true_and_refutes_the_rest() {
    let solved = cube(CUBE);
    expect(&solved, &["analyse", "cube.yaml", "-q"], 0);
    let after = |tamper: &dyn Fn(&Bench)| solved.verify_after("cube", tamper);
    let (code, text) = after(&|_| {});
    assert_eq!((code, text.matches("confirmed").count()), (Some(0), 2), "{text}");
    for bound in ["lower", "upper"] {
        let (code, text) =
            after(&|b| edit_result(b, |c| c[bound] = (0.999_999 * number(&c[bound])).into()));
        assert_eq!((code, text.contains("REFUTED")), (Some(1), true), "{bound}: {text}");
    }
    for (kind, array, factor) in [
        ("static", "stress_mandel", 1.0001),
        ("kinematic", "displacement", 1.0001),
        ("kinematic", "plastic_strain_deviators", 1.01),
        ("kinematic", "plastic_strain_deviators", f64::NAN),
    ] {
        let (code, text) = after(&|b| edit_field(b, kind, array, factor));
        assert_eq!((code, text.contains("REFUTED")), (Some(1), true), "{array} × {factor}: {text}");
    }
    // tets in another order do not belong to this mesh
    let (code, text) = after(&|b| edit_field(b, "kinematic", "tet", -1.0));
    assert_eq!(code, Some(2), "{text}");
    let edits: [&dyn Fn(&mut Value); 7] = [
        &|c| c["yielding"][0]["plastic_strain"] = 0.9.into(),
        &|c| c["yielding"][0]["strain_at"][2] = 50.0.into(),
        &|c| {
            let still = [0.0; 3];
            c["face_motions"] =
                serde_json::json!([{"face": "Z1", "displacement": still, "rotation": still}]);
        },
        &|c| c["yielding"][0]["yielded"] = 0.9.into(),
        &|c| c["yielding"][0]["utilisation"] = 0.5.into(),
        &|c| c["load_displacement_at_least"] = 1.0.into(),
        &|c| c["gap"] = 0.5.into(),
    ];
    for edit in edits {
        let (code, text) = after(&|b| edit_result(b, edit));
        assert_eq!((code, text.contains("is not what the fields give")), (Some(1), true), "{text}");
    }
    // a weaker steel: the stresses leave its yield surface, and the plastic strain dissipates less
    let (code, text) = after(&|b| {
        let model = b.read("cube/model.yaml");
        std::fs::write(b.path().join("cube/model.yaml"), model.replace("235", "230"))
            .expect("written");
    });
    assert_eq!((code, text.matches("REFUTED").count() >= 2), (Some(1), true), "{text}");
}

#[test]
fn wrong_inputs_are_refused_with_place_and_cure() {
    let contact = "interfaces:\n  - {between: [B, B], law: contact, mu: 0.3}\n";
    let rows = [
        (
            CUBE.replace("elastoplastic", "elastoplastik"),
            "yaml/unknown-value",
            "cube.yaml:2",
            "did you mean",
            "elastoplastic",
        ),
        (
            CUBE.replace("fy: 235", "fy: -235"),
            "model/value",
            "cube.yaml:3",
            "`fy` of material `steel` is -235",
            "nothing yields",
        ),
        (
            CUBE.replace("fy: 235", "fy: 0"),
            "model/value",
            "cube.yaml:3",
            "must be 1e-9 MPa to 1e9 MPa",
            "nothing yields",
        ),
        (CUBE.replace("fy: 235", "fy: .inf"), "yaml/not-finite", "cube.yaml:3", "fy", "finite"),
        (CUBE.replace("fy: 235", "fy: 235 MPa"), "yaml/type", "cube.yaml:3", "without a unit", ""),
        (CUBE.replace("fix: [x, y, z]", "fix: [x, y]"), "model/loose-part", "", "can", "support"),
        (
            CUBE.replace("[31.5, 0, -125.8]", "[0, 0, 0]"),
            "model/no-load",
            "",
            "every load is zero",
            "not zero",
        ),
        (
            CUBE.replace("supports:", &format!("{contact}supports:")),
            "model/interface",
            "cube.yaml:6",
            "`B` is named twice",
            "two different",
        ),
        (
            format!("{CUBE}preload:\n  - {{body: B, cut: X0, axis: [1, 0, 0], force: 1}}\n"),
            "model/unavailable",
            "cube.yaml:9",
            "`B` is preloaded and may yield",
            "`bolts: elastic`",
        ),
    ];
    let results = rows.map(|(model, code, place, message, cure)| {
        let bench = cube(&model);
        let want = Want { exit: 2, code, place, message, cure };
        (message.to_string(), refusal(&bench, &mut bench.command(&["analyse", "cube.yaml"]), &want))
    });
    none_wrong(results.into());
}
